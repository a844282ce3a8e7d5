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
    yield from (None, [], True, 0.5)
    if old not in WORDS:  # an end of which nothing is said is an end
        yield {}
    if isinstance(old, int):
        yield from (-old - 1, str(old) + "0", old + 1000, 10**30)
        if key != "digits":
            yield from (old - 1, old + 1)
        return
    yield from ("", "x", "nan", "1/0", "hold", "1e999999")
    if key == "format":
        return
    if key in ("kind", "at", "above") and "chain" not in path:
        yield {"divergence": "flutter", "flutter": "divergence", "stable": "flutter", "undecided": "stable"}[old]
    elif key in ("low", "high"):
        low, high = Fraction(parent["low"]), Fraction(parent["high"])
        outwards = -1 if key == "low" else 1
        digit = unit(low, parent["digits"])
        x = Fraction(old)
        yield from (str(-x), str(x - outwards * 2 * (high - low)), str(x + outwards * digit * Fraction(6, 10)))
    elif "axes" in path:
        if not Fraction(old):  # longer, an axis would be the same
            yield "0.1"
    elif key == "at":
        yield {"end_point": "2"}.get(old, "end_point")
    elif old in ("free", "held"):
        yield from {"free": ("held", "1"), "held": ("free", "1")}[old]
    elif old in WORDS:
        yield from (word for word in WORDS if word != old)
    else:
        x = Fraction(old)
        yield from (str(x + Fraction(1, 10**30)), str(-x) if x else "-1")


WORDS = ("free", "guided", "clamped", "sprung", "pinned", "jointed")


def true_too(chain, path, new):
    """What a change leaves true: a spring along or across, in place of a rod, at the end that alone is held so; whatever
    concerns only a link that a clamp keeps from turning; and another word for the same end."""
    base, end = chain.get("base", {}), chain.get("end_point", {})
    if "joints" in chain or isinstance(base, str) or isinstance(end, str):
        return new in ("guided", "jointed") or ("joints" in chain and new == "pinned")
    links, place = len(chain["lengths"]), path[-1]
    clamped = [link for link, one in ((0, base), (links - 1, end)) if one["turn"] == "held"]
    across = {int(one["at"]): one["across"] for one in chain.get("supports", [])}
    across = [base["across"], *(across.get(i + 1, "free") for i in range(1, links)), end["across"]]
    if "along" in path:
        return new in ("held", "1") and at(chain, path[3:]) != "free"
    if path[-2:] == ("base", "across"):
        return new == "1" and all(motion == "free" for motion in across[1:])
    if "lengths" in path:
        return place in clamped and new[:1].isdigit() and new not in ("1/0", "1e999999")
    if path[-1] == "across" and "supports" in path:  # a node of a clamped link, whose other node is held
        node = int(at(chain, path[3:-1])["at"]) - 1
        return new in ("held", "1") and any("held" in across[link:link + 2] for link in clamped if node in (link, link + 1))
    return path[-1] == "at" and links - 1 in clamped and links == 2


def forgeries(document):
    chain = document["certificates"][0]["chain"]
    for path in leaves(document):
        if not rests_on_digest(path):
            for value in lies(document, path):
                if not (isinstance(value, str) and "chain" in path and true_too(chain, path, value)):
                    yield changed(document, path, value), (*path, value)
    # what a chain file may leave out, and a spring, a load or a support fewer, is another chain, but no less a statement
    for forgery, what in incomplete(document, {"changes"}, {"supports", "factors"}):
        if "chain" not in what or what[-1] == "unknown member" or "lengths" in what:
            yield forgery, what


def kinds(certificates):
    """Short certificates that between them hold everything that one can hold."""
    def first(wanted):
        return next(c for c in certificates if 2 <= len(c["chain"]["lengths"]) <= 5 and wanted(c["chain"], c))
    rigid = ("free", "held")
    return [
        first(lambda c, _: c["end_point"]["across"] == "free" and c["end_point"]["turn"] == "free"),
        first(lambda c, _: c["end_point"]["turn"] == "held"),
        first(lambda c, _: c["base"]["across"] not in rigid and c["end_point"]["turn"] not in rigid),
        first(lambda c, _: any(x["across"] not in rigid for x in c.get("supports", []))),
        first(lambda c, _: any(x["across"] == "held" for x in c.get("supports", []))),
        first(lambda c, _: any("fixed" in load for load in c["loads"])),
        first(lambda _, whole: "loss" in whole and len(whole["chain"]["lengths"]) < 4),
    ]


def factor(mode, low, high, below, digits=1):
    return {"mode": mode, "digits": digits, "low": low, "high": high, "below_low": below[0], "below_high": below[1]}


def of(chain, factors, modes):
    return {"structure": "by hand", "chain": chain, "modes": modes, "factors": factors}


def cantilever(factors=None, modes=2, **keys):
    """Two unit links: F^2 - 3 F + 1 = 0, F = 0.38 and 2.62."""
    chain = {"lengths": ["1", "1"], "stiffness": ["1", "1"], "end_point": "free", **keys}
    return of({key: value for key, value in chain.items() if value is not None},
              [factor(1, "0.38", "0.384", (0, 1))] if factors is None else factors, modes)


def change(low, high, at_, above, digits=2):
    return {"digits": digits, "low": low, "high": high, "at": at_, "above": above}


def follower(low="2.08", high="2.1", kind="flutter", changes="one", **keys):
    """Ziegler's double pendulum with the masses 2 and 1: flutter from 7/2 - sqrt 2 = 2.0857... to 7/2 + sqrt 2 = 4.914...,
    then divergence."""
    entry = cantilever(**{"masses": ["2", "1"], "loads": [{"follower": "1"}], **keys})
    del entry["modes"], entry["factors"]
    entry["loss"] = {"kind": kind, "digits": 2, "low": low, "high": high}
    if changes == "one":
        changes = [change(low, high, "undecided", kind), change("4.91", "4.92", "undecided", "divergence")]
    if changes is not None:
        entry["changes"] = changes
    return entry


def touching(changes, kind="divergence", low="0.16666", high="0.16667", digits=4):
    """The same links and masses under a follower of 5 and a dead force of 4: det(K - F A) = (1 - 6 F)^2, so that a frequency
    is zero at 1/6 alone, and flutter sets in at 0.2287...; a frequency turns imaginary at 0.46..."""
    entry = follower(loads=[{"follower": "5"}, {"force": ["-4", "0"]}], changes=changes)
    entry["loss"] = {"kind": kind, "digits": digits, "low": low, "high": high}
    return entry


def in_space(**keys):
    """Two unit links on universal joints, the springs (2, 1) in one plane and (2, 3) in the other: F = (k_1 + 4 k_2) / 2 = 3, 7."""
    def joint(*stiffness):
        return {"axes": [axis.split() for axis in ("0 0 1", "0 1 0")], "stiffness": list(stiffness)}
    nines, zeros = "9" * 40, "0" * 39
    members = {"factors": [factor(1, f"2.{nines}", f"3.{zeros}1", (0, 1), 39), factor(2, f"6.{nines}", f"7.{zeros}1", (1, 2), 39)],
               "modes": 2, **{key: keys.pop(key) for key in ("factors", "modes") if key in keys}}
    return of({"lengths": ["1", "1"], "joints": [joint("2", "2"), joint("1", "3")], "end_point": "guided",
               "loads": [{"force": ["-1", "0", "0"]}], **keys}, members["factors"], members["modes"])


def weight_on_a_base_that_slides(low, high):
    """Half of the first link's weight stands on the base, and passes through both links to the end that is held along: the
    clamped link turns not, the other gives way at 1 / (2 / 2 + 2 / 2) = 1/2."""
    return cantilever([factor(1, low, high, (0, 1))], 1, stiffness=["0", "1"],
                      base={"along": "free", "across": "held", "turn": "held"},
                      end_point={"along": "held", "across": "free"}, loads=[{"weight": ["2", "0"], "direction": ["1", "0"]}])


def statements():
    """Pairs of certificates about another chain than the one that the factors are of: (true, forged, name)."""
    true = cantilever()
    for key, value in {"lengths": ["1", "2"], "stiffness": ["1", "2"], "end_point": "guided", "supports": [{"at": "2", "across": "1"}], "foundation": "1", "rest": ["0", "0.1"], "masses": ["1"],
                       "loads": [{"weight": "1"}], "beam": {"EI": "1", "length": "2", "links": "2"}}.items():
        yield true, cantilever(**{key: value}), f"another {key}"
    for load in ({"force": ["-2", "0"]}, {"force": ["-1", "0"], "at": "2"}, {"force": ["-1", "0"], "fixed": 1}, {"force": ["-1", "1"]},
                 {"force": ["1", "0"]}, {"force": ["-1"]}, {"force": "-1"}, {"force": ["-1", "0"], "fixed": 2},
                 {"force": ["-1", "0"], "at": "1"}, {"force": ["-1", "0"], "at": "3"}, {"force": ["-1", "0"], "at": "1.5"}, {"follower": "1"}, {"moment": "1"},
                 {"weight": "1", "at": "2"}, {"weight": ["1"]}, {"weight": "1", "direction": ["0", "-1"]}, {"weight": "1", "direction": ["-0.5", "0"]},
                 {"force": ["-1", "0"], "weight": "1"}, {"force": ["-1", "0"], "direction": ["-1", "0"]}, {}):
        yield true, cantilever(loads=[load]), f"the load {load}"
    for support in ([{"at": "2", "across": "held"}], [{"at": "end_point", "across": "1"}], [{"at": "2"}], [{"across": "1"}],
                    [{"at": "2", "across": "free"}, {"at": "2", "across": "1"}], [{"at": "2", "across": "-1"}]):
        yield true, cantilever(supports=support), f"the supports {support}"
    for end in ("clamped", "welded", {"across": "held"}, {"turn": "held"}, {"along": "held"}, {"sideways": "held"}, "free "):
        yield true, cantilever(end_point=end), f"the end point {end}"
    for base in ("clamped", "pinned", {"along": "free"}, {"turn": "1"}, {"turn": "held"}, "jointed"):
        yield true, cantilever(base=base), f"the base {base}"
    yield weight_on_a_base_that_slides("0.49", "0.51"), weight_on_a_base_that_slides("0.99", "1.01"), "the base's half of a weight left out"
    yield true, cantilever(lengths=None), "no lengths"


def by_hand():
    """Pairs of certificates, the first true and the second a forgery, with a name."""
    true = cantilever()
    both = [factor(1, "0.38", "0.384", (0, 1)), factor(2, "2.6", "2.63", (1, 2))]
    yield cantilever(both), cantilever([factor(1, "2.6", "2.63", (1, 2))]), "the second factor called the first"
    yield cantilever(both), cantilever(both[1:]), "the lowest mode left out"
    yield cantilever(both), cantilever([]), "no factor at all"
    yield true, cantilever(modes=1), "a number of modes that is too small"
    yield true, cantilever(true["factors"] * 2), "one factor twice"
    yield cantilever(both), cantilever(both[::-1]), "factors in another order"
    yield true, cantilever([], 1, stiffness=["0", "1"]), "a mechanism"
    yield cantilever([factor(1, "0.28", "0.284", (0, 1))], loads=[{"force": ["-1", "0"]}, {"force": ["-0.1", "0"], "fixed": 1}]), \
        cantilever([factor(2, "1.6", "1.63", (1, 2))], loads=[{"force": ["-1", "0"]}, {"force": ["-1", "0"], "fixed": 1}]), \
        "unstable before the loads grow"
    clamp = dict(base="clamped", stiffness=["0", "1"])
    yield cantilever([factor(1, "0.99", "1.01", (0, 1))], 1, **clamp), \
        cantilever([factor(1, "0.99", "1.01", (0, 1))], 1, base="clamped"), "a clamped base with a spring at joint 1"
    stiff = in_space()["chain"]["joints"]
    yield in_space(), in_space(joints=[stiff[0], {**stiff[1], "stiffness": stiff[1]["stiffness"][::-1]}], factors=in_space()["factors"][:1], modes=1), \
        "the planes of one joint exchanged"
    yield in_space(), in_space(joints=[stiff[0], {**stiff[1], "axes": [["0", "0", "1"]] * 2}]), "one axis twice"
    yield in_space(), in_space(end_point="free"), "another end in space"
    yield in_space(), in_space(base="clamped"), "a clamped base with springs, in space"
    yield in_space(), in_space(loads=[{"torque": "axial"}]), "a torque"
    # half of the compression fixed: (3 - 1/2) and (7 - 1/2) remain
    half = [{"force": ["-1", "0", "0"]}, {"force": ["-0.5", "0", "0"], "fixed": 1}]
    yield in_space(loads=half, factors=[factor(1, "2.49", "2.51", (0, 1))]), in_space(factors=[factor(1, "2.49", "2.51", (0, 1))]), \
        "a fixed load left out"
    flutter = follower()
    yield flutter, follower(kind="divergence"), "flutter called divergence"
    yield flutter, follower("2.06", "2.08"), "a loss below the first"
    yield flutter, follower("2.2", "2.22"), "a loss within flutter"
    yield flutter, follower(masses=["1", "2"]), "masses exchanged"
    yield flutter, follower(masses=["2", "0"]), "a place without a mass"
    yield flutter, follower(changes=flutter["changes"][:1]), "a change left out"
    yield flutter, follower(changes=flutter["changes"][1:]), "the first change left out"
    yield flutter, follower(changes=[]), "no change at all"
    yield flutter, follower(changes=flutter["changes"][::-1]), "changes in another order"
    # the force that keeps its direction instead: divergence at 0.38, and two negative squares from 2.62 on
    dead = [change("0.38", "0.384", "divergence", "divergence"), change("2.61", "2.62", "divergence", "divergence")]
    yield follower("0.38", "0.384", "divergence", dead[:1], loads=[{"force": ["-1", "0"]}]), \
        follower("0.38", "0.384", "divergence", dead[:1]), "a dead force called one that follows"
    zero = change("0.16666", "0.16667", "divergence", "stable", 4)
    later = [change("0.228", "0.229", "undecided", "flutter"), change("0.461", "0.463", "undecided", "divergence")]
    yield touching([zero, *later]), touching(later, "flutter", "0.228", "0.229", 2), "a frequency that touches zero passed over"
    yield touching([zero, *later]), touching([{**zero, "at": "stable"}, *later]), "a zero frequency called stable"
    yield touching([zero, *later]), touching([{**zero, "above": "divergence"}, *later]), "stable again, denied"
    yield touching([zero, *later]), touching([zero, *later], "flutter", "0.228", "0.229", 2), "the second loss called the first"


def main():
    document, judge = published(sys.argv[2]), Judge(checker)

    def of_one(entry):
        return sealed({**document, "certificates": [entry]})

    for certificate in [*kinds(document["certificates"]), in_space()]:
        judge.true(of_one(certificate), certificate["structure"])
        judge.by_machine(forgeries(of_one(certificate)))
    judge.by_machine(misspelt(of_one(certificate)))
    judge.by_hand(sealed({**document, "certificates": []}), "no certificate")
    for true, false, name in (*statements(), *by_hand()):
        if not judge.holds(of_one(true)):
            judge.misjudged.append(("refused although true, beside", name))
        judge.by_hand(of_one(false), name)
    judge.end()


if __name__ == "__main__":
    main()
