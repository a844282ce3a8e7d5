"""The stand-alone checker of paths refuses every tampered certificate, and accepts those untouched.

usage: tampering_paths.test.py PROOFS CERTIFICATES

Besides what forgery.py does: documents that pass the schema and say something false: a fold left out, moved or doubled, the
stability flipped, points taken from two branches, a jump over a fold, a pitchfork
moved, or of a chain that is not symmetric, another chain.
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
    if len(path) == 1:
        return
    if key in ("control", "rest_unit"):
        yield {"end_point": "force", "force": "end_point", "rad": "pi", "pi": "rad"}[old]
    elif "pitchforks" in path and old in ("first", "last"):
        yield {"first": "last", "last": "first"}[old]
    elif key == "symmetry":
        yield from {"reversed", "mirrored", "reversed and mirrored"} - {old}
    elif path[-2] == "load":
        yield "9" if key == 0 else "0"
    elif key == "near":
        yield from ("0", "1e-30", "-1")
    elif "folds" in path:
        yield from (str(-Fraction(old)), "9" if key == 0 else "0")
    elif "points" in path:  # farther off than `near`, or than double precision
        yield from (str(Fraction(old) + Fraction(1, 100)), str(Fraction(old) + 1))
    elif path[-2] in ("lengths", "stiffness", "rest"):
        yield str(Fraction(old) + Fraction(1, 100))
    elif path[-2] == "direction" and Fraction(old):  # of any length
        yield str(-Fraction(old))


def true_too(document, path, value):
    """What a change leaves true: the unit of rest angles that are all zero; and near a straight chain's pitchfork every end
    of a part, and straight points in between under any force in their order."""
    entry = document["certificates"][0]
    if any(map(Fraction, entry["rest"])):
        return False
    straight = "points" in path and path[3] == 0 and path[-1] == len(entry["lengths"]) and isinstance(value, str) and value > "0"
    return (path[-1] == "rest_unit" and value == "pi") or value in ("first", "last") or straight


def forgeries(document):
    points = document["certificates"][0]["parts"][0]["points"]
    some = {0, len(points) // 2, len(points) - 1}  # of many points alike

    def alike(path):
        return "points" in path[:-1] and path[path.index("points") + 1] not in some

    for path in leaves(document):
        if not rests_on_digest(path) and not alike(path):
            for value in lies(document, path):
                if true_too(document, path, value):
                    continue
                yield changed(document, path, value), (*path, value)
    for forgery, what in incomplete(document, removable={"parts", "points", "pitchforks", "symmetric"}):
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
    yield "another chain", {**copy.deepcopy(entry), "stiffness": entry["stiffness"][:-1] + [str(Fraction(entry["stiffness"][-1]) * Fraction(9, 10))]}
    for i, fork in enumerate(entry["pitchforks"]):
        def with_fork(**members):
            return {**copy.deepcopy(entry), "pitchforks": [{**f, **members} if i == j else f for j, f in enumerate(entry["pitchforks"])]}

        low, high = map(Fraction, fork["load"])
        yield "a pitchfork moved", with_fork(load=[str(high + (high - low) / 100), str(2 * high - low)])
        yield "a pitchfork narrowed", with_fork(load=[str(low), str(low + (high - low) / 100)])
        yield "a bent end called symmetric", with_fork(symmetric=fork["symmetric"] + fork["bent"])
        yield "a symmetric end called bent", with_fork(bent=fork["bent"] + fork["symmetric"])
        yield "branches exchanged", with_fork(symmetric=fork["bent"], bent=fork["symmetric"])
        yield "no bent branch", with_fork(bent=[])
        bent = [str(Fraction(x) + Fraction(1, 10**30) * (j == 1)) for j, x in enumerate(entry["rest"])]
        yield "a pitchfork of a chain that is bent by 1e-30", {**with_fork(), "rest": bent}
        aside = [entry["direction"][0], "1e-30"]
        yield "a pitchfork under a load aside by 1e-30", {**with_fork(), "direction": aside}
    turned = [entry["direction"][1], entry["direction"][0]]
    yield "another direction", {**copy.deepcopy(entry), "direction": turned}


def shortened(entry):
    """A stretch about each fold, what is next to a pitchfork, and the beginning of all else: the checks are the same, and quick."""
    ends = [end for fork in entry["pitchforks"] for end in fork["symmetric"] + fork["bent"]]
    parts = []
    for number, part in enumerate(entry["parts"], 1):
        points = part["points"]
        middle = len(points) if [number, "last"] in ends else 0
        if part["folds"]:
            middle = max(range(len(points)), key=lambda j: Fraction(points[j][-1]))
        reach = 40 if part["folds"] else 6
        parts.append({**part, "points": points[max(0, middle - reach):middle + reach]})
    return {**entry, "parts": parts}


def main():
    document, judge = published(sys.argv[2]), Judge(checker)

    def of_one(entry):
        return sealed({**document, "certificates": [entry]})

    for entry in map(shortened, document["certificates"]):
        judge.true(of_one(entry), entry["case"])
        if len(entry["lengths"]) == 2 or entry["pitchforks"]:
            judge.by_machine(forgeries(of_one(entry)))
        for name, false in by_hand(entry):
            judge.by_hand(of_one(false), (entry["case"], name))
    judge.by_machine(misspelt(of_one(entry)))
    judge.end()


if __name__ == "__main__":
    main()
