"""The stand-alone checker of other ends and loads refuses every tampered certificate, and accepts those untouched.

usage: tampering_structures.test.py PROOFS CERTIFICATES

Besides what forgery.py does: documents that pass the schema and say something false, made by hand, each beside a true one.
"""
import sys
from fractions import Fraction

sys.path.insert(0, sys.argv[1])
import check_structures as checker  # noqa: E402
from check_certificates import unit  # noqa: E402
from forgery import Judge, at, changed, incomplete, leaves, misspelt, published, rests_on_digest, sealed  # noqa: E402


def lies(document, path):
    """Values for a leaf that each make the certificate false, or no certificate."""
    old, parent, key = at(document, path), at(document, path[:-1]), path[-1]
    yield from (None, [], {}, True, 0.5)
    if isinstance(old, int):
        yield from (-old - 1, str(old), old + 1000)
        if key != "digits":
            yield from (old - 1, old + 1)
        return
    yield from ("", "x", "nan", "1/0", "hold")
    if key == "format":
        return
    if key == "kind":
        yield {"divergence": "flutter", "flutter": "divergence"}[old]
    elif key in ("low", "high"):
        low, high = Fraction(parent["low"]), Fraction(parent["high"])
        outwards = -1 if key == "low" else 1
        digit = unit(low, parent["digits"])
        x = Fraction(old)
        yield from (str(-x), str(x - outwards * 2 * (high - low)), str(x + outwards * digit * Fraction(6, 10)))
    elif path[-2] == "axis":
        yield "-1/0"
        if not Fraction(old):  # longer, an axis would be the same
            yield "0.1"
    elif path[-2] in ("lengths", "stiffness", "masses", "fixed", "multiplied") or key in ("force", "stiffness"):
        x = Fraction(old)
        yield from (str(x + Fraction(1, 10**30)), str(-x) if x else "-1")
    else:  # a restraint
        yield "-1"
        others = {"free": ("held", "1"), "held": ("free", "1")}.get(old, ("free", "held", old + "1"))
        yield from others


def true_too(entry, path, old, new):
    """What a change leaves true: a spring along or across, in place of a rod, at the end that alone is held so; and whatever
    concerns only a link that a clamp keeps from turning."""
    if "joints" in entry:
        return False
    links, place = len(entry["lengths"]), path[-1]
    clamped = [link for link, end in ((0, "base"), (links - 1, "end_point")) if entry[end]["turn"] == "held"]
    across = [entry["base"]["across"], *entry["across"], entry["end_point"]["across"]]
    if "along" in path:
        return new in ("held", "1") and old != "free"
    if path[-2:] == ("base", "across"):
        return new == "1" and all(motion == "free" for motion in across[1:])
    if "lengths" in path:
        return place in clamped and new != str(-Fraction(old))
    if path[-2:-1] == ("across",):  # a node of a clamped link, whose other node is held
        return new in ("held", "1") and any("held" in across[link:link + 2] for link in clamped if place + 1 in (link, link + 1))
    return path[-1] == "at" and links - 1 in clamped and new == links - 1


def forgeries(document):
    entry = document["certificates"][0]
    for path in leaves(document):
        if not rests_on_digest(path):
            for value in lies(document, path):
                old = at(document, path)
                if not (isinstance(value, (str, int)) and true_too(entry, path, old, value)):
                    yield changed(document, path, value), (*path, value)
    yield from incomplete(document, set(), {"factors"})


def kinds(certificates):
    """Short certificates that between them hold everything that one can hold."""
    def first(wanted):
        return next(c for c in certificates if 2 <= len(c["lengths"]) <= 5 and wanted(c))
    sprung = ("free", "held")
    return [
        first(lambda c: c["end_point"]["across"] == "free" and c["end_point"]["turn"] == "free"),
        first(lambda c: c["end_point"]["turn"] == "held"),
        first(lambda c: c["base"]["across"] not in sprung and c["end_point"]["turn"] not in sprung),
        first(lambda c: any(x not in sprung for x in c["across"])),
        first(lambda c: "held" in c["across"]),
        first(lambda c: any(not load["multiplied"] for load in c["loads"])),
        first(lambda c: "loss" in c),
    ]


def load(at, force, multiplied=1, follows=0):
    return {"at": at, "force": force, "multiplied": multiplied, "follows": follows}


def factor(mode, low, high, below, digits=1):
    return {"mode": mode, "digits": digits, "low": low, "high": high, "below_low": below[0], "below_high": below[1]}


FREE = {"along": "free", "across": "free", "turn": "free"}
BASE = {"along": "held", "across": "held", "turn": "free"}
GUIDED = {"along": "free", "across": "held", "turn": "free"}


def cantilever(**members):
    """Two unit links: F^2 - 3 F + 1 = 0, F = 0.38 and 2.62."""
    return {"structure": "by hand", "lengths": ["1", "1"], "stiffness": ["1", "1"], "base": BASE, "end_point": FREE,
            "across": ["free"], "loads": [load(2, "-1")], "modes": 2,
            "factors": [factor(1, "0.38", "0.384", (0, 1))], **members}


def follower(low, high, kind="flutter", **members):
    """Ziegler's double pendulum with the masses 2 and 1: flutter from 7/2 - sqrt 2 = 2.0857... on."""
    entry = cantilever(masses=["2", "1"], loads=[load(2, "-1", follows=1)],
                       loss={"kind": kind, "digits": 2, "low": low, "high": high}, **members)
    del entry["modes"], entry["factors"]
    return entry


def in_space(**members):
    """Two unit links on universal joints, the springs (2, 1) in one plane and (2, 3) in the other: F = (k_1 + 4 k_2) / 2 = 3, 7."""
    def joint(*stiffness):
        return [{"axis": axis.split(), "stiffness": k} for axis, k in zip(("0 0 1", "0 1 0"), stiffness)]
    nines, zeros = "9" * 40, "0" * 39
    return {"structure": "by hand", "lengths": ["1", "1"], "joints": [joint("2", "2"), joint("1", "3")], "clamped": 0,
            "end_point": {"across": "held", "turn": "free"}, "across": ["free"],
            "compression": {"fixed": ["0", "0"], "multiplied": ["1", "1"]}, "modes": 2,
            "factors": [factor(1, f"2.{nines}", f"3.{zeros}1", (0, 1), 39), factor(2, f"6.{nines}", f"7.{zeros}1", (1, 2), 39)], **members}


def by_hand():
    """Pairs of certificates, the first true and the second a forgery, with a name."""
    true = cantilever()
    yield "the second factor called the first", true, cantilever(factors=[factor(1, "2.6", "2.63", (1, 2))])
    yield "a number of modes that is too small", true, cantilever(modes=1)
    yield "one factor twice", true, cantilever(factors=true["factors"] * 2)
    yield "factors in another order", cantilever(factors=[factor(1, "0.38", "0.384", (0, 1)), factor(2, "2.6", "2.63", (1, 2))]), \
        cantilever(factors=[factor(2, "2.6", "2.63", (1, 2)), factor(1, "0.38", "0.384", (0, 1))])
    yield "a mechanism", true, cantilever(stiffness=["0", "1"], factors=[], modes=1)
    yield "unstable before the loads grow", cantilever(loads=[load(2, "-1"), load(2, "-0.1", 0)],
                                                       factors=[factor(1, "0.28", "0.284", (0, 1))]), \
        cantilever(loads=[load(2, "-1"), load(2, "-1", 0)], factors=[factor(2, "1.6", "1.63", (1, 2))])
    yield "loads that only pull", true, cantilever(loads=[load(2, "1")], modes=0, factors=[])
    yield "a load that follows, among those with an energy", true, cantilever(loads=[load(2, "-1", follows=1)])
    yield "both ends held along", true, cantilever(end_point={**FREE, "along": "held"})
    yield "neither end held along", true, cantilever(base={**BASE, "along": "free"})
    yield "a clamped base with a spring at joint 1", \
        cantilever(base={**BASE, "turn": "held"}, stiffness=["0", "1"], modes=1, factors=[factor(1, "0.99", "1.01", (0, 1))]), \
        cantilever(base={**BASE, "turn": "held"}, modes=1, factors=[factor(1, "0.99", "1.01", (0, 1))])
    # the middle joint held: joint 2 and the last link alone, F = 1 beside k_1's own
    yield "a support left out", \
        cantilever(across=["held"], modes=1, factors=[factor(1, "1.99", "2.01", (0, 1))], end_point=FREE, stiffness=["0", "2"]), \
        cantilever(across=["free"], modes=1, factors=[factor(1, "1.99", "2.01", (0, 1))], end_point=FREE, stiffness=["0", "2"])
    stiff = in_space()["joints"]
    yield "the planes of one joint exchanged", in_space(), in_space(joints=[stiff[0], stiff[1][::-1]], factors=in_space()["factors"][:1], modes=1)
    yield "one axis twice", in_space(), in_space(joints=[stiff[0], [stiff[1][0]] * 2])
    # half of the compression fixed: (3 - 1/2) and (7 - 1/2) remain
    half = {"fixed": ["0.5", "0.5"], "multiplied": ["1", "1"]}
    yield "a fixed load left out", in_space(compression=half, factors=[factor(1, "2.49", "2.51", (0, 1))]), \
        in_space(factors=[factor(1, "2.49", "2.51", (0, 1))])
    flutter = follower("2.08", "2.1")
    yield "flutter called divergence", flutter, follower("2.08", "2.1", "divergence")
    yield "a loss below the first", flutter, follower("2.06", "2.08")
    yield "a loss within flutter", flutter, follower("2.2", "2.22")
    yield "masses exchanged", flutter, {**flutter, "masses": ["1", "2"]}
    yield "a place without a mass", flutter, {**flutter, "masses": ["2", "0"]}
    # the force that keeps its direction instead: divergence at 0.38
    yield "a dead force called one that follows", {**follower("0.38", "0.384", "divergence"), "loads": [load(2, "-1")]}, \
        follower("0.38", "0.384", "divergence")


def main():
    document, judge = published(sys.argv[2]), Judge(checker)

    def of_one(entry):
        return sealed({**document, "certificates": [entry]})

    for certificate in [*kinds(document["certificates"]), in_space()]:
        judge.true(of_one(certificate), certificate["structure"])
        judge.by_machine(forgeries(of_one(certificate)))
    judge.by_machine(misspelt(of_one(certificate)))
    for name, true, false in by_hand():
        if not judge.holds(of_one(true)):
            judge.misjudged.append(("refused although true, beside", name))
        judge.by_hand(of_one(false), name)
    judge.end()


if __name__ == "__main__":
    main()
