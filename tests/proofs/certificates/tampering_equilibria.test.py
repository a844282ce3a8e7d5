"""The stand-alone checker of equilibria refuses every tampered certificate, and accepts those untouched.

usage: tampering_equilibria.test.py PROOFS CERTIFICATES

Besides what forgery.py does: documents that pass the schema and say something false: an equilibrium left out, with and
without its boxes; the window narrowed; a ball moved, swollen or doubled; two equilibria swapped; the stability flipped; the
chain, the load or the control exchanged.
"""
import copy
import re
import sys
from fractions import Fraction

sys.path.insert(0, sys.argv[1])
import check_equilibria as checker  # noqa: E402
from forgery import Judge, at, changed, incomplete, leaves, misspelt, published, rests_on_digest, sealed  # noqa: E402


def lies(document, path):
    """Values for a leaf that each make the certificate false, or no certificate."""
    old, key = at(document, path), path[-1]
    yield from (None, [], {}, True, 0.5)
    if isinstance(old, int):
        yield from (-old - 1, str(old), old + 10**7)
        if key in ("version", "negative_directions") or "window" in path:
            yield old + 1
        if key == "digits":
            yield old + 30
        return
    yield from ("", "x", "nan", "1/0")
    if key in ("control", "rest_unit"):
        yield from {"control": {"end_point", "deflection", "force"}, "rest_unit": {"pi"}}[key] - {old}
    elif key == "covering":
        if len(old) > 200:  # less, and a checker that halves boxes itself may prove all of it
            yield "."
        yield from (old[:-1], old + ".", old[1:], "a" + old, old.replace("a", "b", 1) + ".", "q" + old[1:])
    elif re.fullmatch(r"-?\d+(\.\d+)?(e-?\d+)?", old):
        x = Fraction(old)
        if key in ("radius", "force_radius"):
            yield from ("0", "-" + old, "1e-60")
        else:
            yield from (str(x + Fraction(3, 10**39)), str(x + 1))
            if x:
                yield str(-x)


def true_too(document, path, value):
    """What a change leaves true: the rest angle of a passive joint, the unit of rest angles that are all zero."""
    entry = document["certificates"][0]
    passive = [i for i, k in enumerate(entry["stiffness"]) if k == "0"]
    idle = "rest" in path and path[-1] in passive and entry["control"] != "deflection" and isinstance(value, str)
    return idle or (path[-1] == "rest_unit" and value == "pi" and not any(map(Fraction, entry["rest"])))


def forgeries(document):
    for path in leaves(document):
        if rests_on_digest(path):
            continue
        for value in lies(document, path):
            if not true_too(document, path, value):
                yield changed(document, path, value), (*path, value if not isinstance(value, str) else value[:40])
    yield from incomplete(document)


def by_hand(entry):
    """False entries that pass the schema, with a name."""
    def with_(**members):
        return {**copy.deepcopy(entry), **members}

    def equilibrium(i, **members):
        return with_(equilibria=[{**e, **members} if i == j else e for j, e in enumerate(entry["equilibria"])])

    all_of_them = entry["equilibria"]
    for i, one in enumerate(all_of_them):
        rest = all_of_them[:i] + all_of_them[i + 1:]
        yield f"equilibrium {i + 1} left out", with_(equilibria=rest)
        yield f"equilibrium {i + 1} twice", with_(equilibria=all_of_them + [one])
        if rest:
            yield f"equilibrium {i + 1} in the place of another", with_(equilibria=[one] + rest[1:] + [one])
        if entry["stiffness"][0] == "0":
            turned = [str(Fraction(one["q"][0]) + Fraction("6.2831853071795864769252867665590057683943388"))] + one["q"][1:]
            yield f"equilibrium {i + 1} once more, turned around", with_(equilibria=all_of_them + [{**one, "q": turned}])
        yield f"stability of {i + 1} flipped", equilibrium(i, negative_directions=int(one["negative_directions"] == 0))
        moved = [str(Fraction(one["q"][0]) + Fraction(one["radius"]))] + one["q"][1:]
        yield f"ball {i + 1} moved by its radius", equilibrium(i, q=moved)
        yield f"ball {i + 1} grown over everything", equilibrium(i, radius="3")
        yield f"ball {i + 1} shrunk to nothing", equilibrium(i, radius="1e-45")
        mirrored = [str(-Fraction(x)) for x in one["q"]]
        if any(Fraction(x) for x in entry["rest"]) or Fraction(entry["load"][1]):
            yield f"equilibrium {i + 1} mirrored", equilibrium(i, q=mirrored)
    if len(all_of_them) > 1:
        first, second = all_of_them[:2]
        swapped = [{**first, "response": second["response"]}, {**second, "response": first["response"]}]
        if first["response"] != second["response"]:
            yield "responses swapped", with_(equilibria=swapped + all_of_them[2:])
        if first["energy"] != second["energy"]:
            swapped = [{**first, "energy": second["energy"]}, {**second, "energy": first["energy"]}]
            yield "energies swapped", with_(equilibria=swapped + all_of_them[2:])
    yield "no equilibrium, one box", with_(equilibria=[], covering=".")
    if len(entry["covering"]) > 200:  # a checker that halves boxes itself may prove what a short tree omits
        yield "a box that nobody looked into", with_(covering=pruned(entry["covering"]))
    if "turns" in entry:
        yield "a wider window", with_(turns=entry["turns"] + 1)
        if entry["turns"]:
            yield "the window narrowed", with_(turns=entry["turns"] - 1)
        shifted = [w + 2 if i and k != "0" else w for i, (w, k) in enumerate(zip(entry["window"], entry["stiffness"]))]
        if shifted != entry["window"]:
            yield "the window moved by a turn", with_(window=shifted)
    softer = [str(Fraction(k) * Fraction(99, 100)) for k in entry["stiffness"]]
    yield "another chain", with_(stiffness=softer)
    yield "links in another order", with_(lengths=entry["lengths"][1:] + [str(Fraction(entry["lengths"][0]) + 1)])


def pruned(tree):
    """The tree with its larger half in place of both: half of the window is never seen."""
    depth, end = 1, 1
    while depth:
        depth += 1 if tree[end] != "." else -1
        end += 1
    lower, upper = tree[1:end], tree[end:]
    return max(lower, upper, key=len)


def short(entry):
    return len(entry["covering"]) < 1500


def main():
    document, judge = published(sys.argv[2]), Judge(checker)

    def of_one(entry):
        return sealed({**document, "certificates": [entry]})

    certificates = [c for c in document["certificates"] if short(c)]
    chosen = {}
    for entry in certificates:
        chosen.setdefault((entry["control"], entry["rest_unit"], "0" in entry["stiffness"]), entry)
    for entry in chosen.values():
        judge.true(of_one(entry), entry["case"])
        judge.by_machine(forgeries(of_one(entry)))
    judge.by_machine(misspelt(of_one(entry)))
    for entry in certificates:
        for name, false in by_hand(entry):
            judge.by_hand(of_one(false), (entry["case"], name))
    judge.end()


if __name__ == "__main__":
    main()
