"""The stand-alone checker of paths refuses every tampered certificate, and accepts those untouched.

usage: tampering_paths.test.py PROOFS CERTIFICATES

Besides what forgery.py does: documents that pass the schema and say something false: a fold left out, moved or doubled, the
stability flipped, points taken from two branches, a jump over a fold, another chain.
"""
import copy
import sys
from fractions import Fraction

sys.path.insert(0, sys.argv[1])
import check_paths as checker  # noqa: E402
from forgery import Judge, at, changed, incomplete, leaves, misspelt, published, rests_on_digest, sealed  # noqa: E402


def lies(document, path):
    """Values for a leaf that each make the certificate false, or no certificate."""
    old, key = at(document, path), path[-1]
    yield from (None, [], {}, True, 0.5)
    if isinstance(old, int):
        yield from (-old, old + 1, str(old), old + 10**6) if old else (1, -1, "0")
        return
    yield from ("", "x", "nan", "1/0")
    if key in ("control", "rest_unit"):
        yield {"end_point": "force", "force": "end_point", "rad": "pi", "pi": "rad"}[old]
    elif key == "near":
        yield from ("0", "1e-30", "-1")
    elif "folds" in path:
        yield from (str(-Fraction(old)), "9" if key == 0 else "0")
    elif "points" in path:  # farther off than `near`, or than double precision
        yield from (str(Fraction(old) + Fraction(1, 100)), str(Fraction(old) + 1))
    elif len(path) == 1:
        return
    elif path[-2] in ("lengths", "stiffness", "rest"):
        yield str(Fraction(old) + Fraction(1, 100))
    elif path[-2] == "direction" and Fraction(old):  # of any length
        yield str(-Fraction(old))


def forgeries(document):
    points = document["certificates"][0]["parts"][0]["points"]
    some = {0, len(points) // 2, len(points) - 1}  # of many points alike

    def alike(path):
        return "points" in path[:-1] and path[path.index("points") + 1] not in some

    for path in leaves(document):
        if not rests_on_digest(path) and not alike(path):
            for value in lies(document, path):
                yield changed(document, path, value), (*path, value)
    for forgery, what in incomplete(document, removable={"parts", "points"}):
        if not alike(what):
            yield forgery, what


def by_hand(entry):
    """False entries that pass the schema, with a name."""
    def with_part(i, **members):
        parts = [{**part, **members} if i == j else part for j, part in enumerate(entry["parts"])]
        return {**copy.deepcopy(entry), "parts": parts}

    for i, part in enumerate(entry["parts"]):
        points, runs, folds = part["points"], part["runs"], part["folds"]
        flipped = [[way, int(negative == 0)] for way, negative in runs]
        yield f"stability of part {i + 1} flipped", with_part(i, runs=flipped)
        yield f"part {i + 1} run backwards", with_part(i, points=points[::-1])
        yield f"a fold added to part {i + 1}", with_part(i, runs=runs + [[-runs[-1][0], runs[-1][1]]],
                                                         folds=folds + [[points[0][-1], points[-1][-1]]])
        loads = [point[:-1] + [str(Fraction(point[-1]) + Fraction(1, 1000))] for point in points]
        yield f"part {i + 1} at other loads", with_part(i, points=loads)
        if folds:
            yield "folds forgotten", with_part(i, folds=[])
            yield "one run for two", with_part(i, runs=runs[:1], folds=[])
            low, high = map(Fraction, folds[0])
            yield "a fold moved", with_part(i, folds=[[str(high), str(high + (high - low))]] + folds[1:])
            yield "a fold narrowed", with_part(i, folds=[[str((low + high) / 2), str((low + high) / 2)]] + folds[1:])
            turn = max(range(len(points)), key=lambda j: Fraction(points[j][-1]))
            skipped = points[:max(1, turn - 60)] + points[turn + 60:]
            yield "a jump over the fold", with_part(i, points=skipped)
        if len(points) > 8:
            yield "points in another order", with_part(i, points=points[:3] + points[5:2:-1] + points[6:])
            yield "one chord for all", with_part(i, points=[points[0], points[-1]])
    if len(entry["parts"]) > 1:
        first, second = entry["parts"][:2]
        joined = {**first, "points": first["points"] + second["points"], "runs": first["runs"] + second["runs"]}
        yield "two branches in one", {**copy.deepcopy(entry), "parts": [joined]}
    yield "another chain", {**copy.deepcopy(entry), "stiffness": [str(Fraction(k) * Fraction(99, 100)) for k in entry["stiffness"]]}
    turned = [entry["direction"][1], entry["direction"][0]]
    yield "another direction", {**copy.deepcopy(entry), "direction": turned}


def shortened(entry):
    """A stretch about each fold, and the beginning of what has none: the checks are the same, and quick."""
    parts = []
    for part in entry["parts"]:
        points = part["points"]
        middle = max(range(len(points)), key=lambda j: Fraction(points[j][-1])) if part["folds"] else 0
        reach = 40 if part["folds"] else 6
        parts.append({**part, "points": points[max(0, middle - reach):middle + reach]})
    return {**entry, "parts": [part for part in parts if len(part["points"]) > 1]}


def main():
    document, judge = published(sys.argv[2]), Judge(checker)

    def of_one(entry):
        return sealed({**document, "certificates": [entry]})

    for entry in map(shortened, document["certificates"]):
        judge.true(of_one(entry), entry["case"])
        if len(entry["lengths"]) == 2:
            judge.by_machine(forgeries(of_one(entry)))
        for name, false in by_hand(entry):
            judge.by_hand(of_one(false), (entry["case"], name))
    judge.by_machine(misspelt(of_one(entry)))
    judge.end()


if __name__ == "__main__":
    main()
