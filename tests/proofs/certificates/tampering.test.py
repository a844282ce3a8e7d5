"""The stand-alone checker refuses every tampered certificate of critical forces, and accepts those untouched.

usage: tampering.test.py PROOFS CERTIFICATES

Besides what forgery.py does: documents that pass the schema and say something false, made by hand, each beside a true one.
"""
import json
import sys
from fractions import Fraction
from random import Random

sys.path.insert(0, sys.argv[1])
import check_certificates as checker  # noqa: E402
from forgery import Judge, at, changed, incomplete, leaves, misspelt, published, rests_on_digest, sealed  # noqa: E402


def lies(document, path):
    """Values for a leaf that each make the certificate false."""
    old, parent, key = at(document, path), at(document, path[:-1]), path[-1]
    yield from (None, [], {}, True, 0.5)
    if isinstance(old, int):
        yield from (old + 1000 if key == "digits" else old + 1, -old - 1, str(old))
        if key != "digits":
            yield old - 1
        return
    yield from ("", "x", "nan", "1/0", old + "0x")
    if key in ("format", "sha256"):
        return
    x = Fraction(old)
    if key in ("low", "high"):
        width = Fraction(parent["high"]) - Fraction(parent["low"])
        beyond = x + 2 * width if key == "low" else x - 2 * width
        yield from (str(beyond), str(-x))
        if "digits" in parent:  # farther out: true still, but not to so many digits
            yield str(x + (x - beyond) * 10**30)
            unit = checker.unit(Fraction(parent["low"]), parent["digits"])  # farther out by less than a unit
            yield str(x - unit * Fraction(6, 10) if key == "low" else x + unit * Fraction(6, 10))
    elif "q" in path:
        digits = parent_digits(document, path)
        yield from (str(x + 3 * checker.unit(x, digits) * (-1 if x > 0 else 1)), str(-x) if x else "0.1")
    elif path[-2] in ("lengths", "stiffness"):
        yield from (str(x + Fraction(1, 10**30)), str(-x) if x else "-1")
    else:  # coefficients of polynomials
        yield from (str(x + 1), str(x + Fraction(1, 10**30)))


def parent_digits(document, path):
    return at(document, path[:-2])["digits"]


def kinds(certificates):
    """Short certificates that between them hold everything that one can hold."""
    def first(wanted):
        return next(c for c in certificates if len(c["lengths"]) <= 6 and wanted(c))
    return [
        first(lambda c: "matrices" in c and "shape" in c["forces"][0] and len(c["lengths"]) == 4),
        first(lambda c: "ties" in c and "shape" in c["forces"][0]),
        first(lambda c: "ties" in c and len(c["ties"]) == 2),
        first(lambda c: "shape" in c["forces"][0] and c["chain"].startswith("geometric-0.1-10")),
    ]


def forgeries(document):
    """Documents, each of which says something false or lacks something, and what was done to them."""
    for path in leaves(document):
        if not rests_on_digest(path):
            for value in lies(document, path):
                yield changed(document, path, value), (*path, value)
    yield from incomplete(document, {"shape", "ties", "matrices"}, {"forces", "ties"})


def force(mode, low, high, below, digits=1, shape=None):
    entry = {"mode": mode, "digits": digits, "low": low, "high": high, "below_low": below[0], "below_high": below[1]}
    return {**entry, "shape": shape} if shape else entry


def bend(first, last, q, digits=2):
    return {"first": first, "last": last, "digits": digits, "q": q.split()}


def chain(lengths, stiffness, *forces, **more):
    return {"chain": "by hand", "lengths": lengths.split(), "stiffness": stiffness.split(), "forces": list(forces), **more}


def product(*factors):
    """Of polynomials, coefficients from the constant up."""
    result = [Fraction(1)]
    for factor in factors:
        longer = [Fraction(0)] * (len(result) + len(factor) - 1)
        for i, a in enumerate(result):
            for j, b in enumerate(factor):
                longer[i + j] += a * Fraction(b)
        result = longer
    return [str(c) for c in result]


def by_hand():
    """Pairs of certificates, the first true and the second a forgery, with a name."""
    # joints 1-2 of (6, 0, 2.2) give F = 4, joints 2-3 give 4.4
    u, v = bend(1, 2, "-0.67 1 0"), bend(2, 3, "0 -0.5 1")
    two = "1 1 1", "6 0 2.2"
    low, high = force(1, "3.98", "4.02", (0, 1)), force(2, "4.38", "4.42", (1, 2))
    yield "shapes swapped within common bounds", \
        chain(*two, {**low, "shape": u}, {**high, "shape": v}), \
        chain(*two, force(1, "3.98", "4.42", (0, 2), shape=v), force(2, "3.98", "4.42", (0, 2), shape=u))
    yield "a shape within bounds that hold two modes", chain(*two, {**low, "shape": u}), \
        chain(*two, force(1, "3.98", "4.42", (0, 2), shape=u))
    yield "\"1\" at an angle that is not the largest", chain(*two, low, {**high, "shape": v}), \
        chain(*two, low, {**high, "shape": bend(2, 3, "0 1 -2")})
    yield "\"1\" at a joint that stays straight", chain(*two, {**low, "shape": u}), \
        chain(*two, {**low, "shape": bend(1, 2, "0 0 1")})
    yield "two passive joints", chain("1 1 1", "0 1 1", force(1, "0.99", "1.01", (0, 1))), \
        chain("1 1 1", "0 1 0", force(1, "0.99", "1.01", (0, 1)), force(2, "1.99", "2.01", (1, 2)))  # what the recursion counts there
    # three unit links, k = (0, 1, 1): F = 1 and 3; a bound that is itself a critical force: low <= F_m < high
    yield "an upper bound that is the force itself", chain("1 1 1", "0 1 1", force(1, "1", "1.04", (0, 1))), \
        chain("1 1 1", "0 1 1", force(1, "0.98", "1", (0, 1)))
    # (3, 0, 1): both parts have F = 2 alone
    equal, tie = ("1 1 1", "3 0 1", force(1, "1.98", "2.02", (0, 2))), {"mode": 1, "low": "1.9", "high": "2.1"}
    part = ["1", "-1/2"]
    good = {**tie, "factor": ["-2", "1"], "cofactors": [["-1/2"], ["-1/2"]]}
    yield "a tie without a common root", chain(*equal, ties=[good]), \
        chain(*equal, ties=[{**tie, "factor": ["1"], "cofactors": [part, part]}])
    off, at_zero, at_one = ["-41/20", "1"], Fraction(-20, 41), Fraction(-10, 21)  # root 2.05; 1 - F/2 is to be made
    yield "a factor that divides at zero alone", chain(*equal, ties=[good]), \
        chain(*equal, ties=[{**tie, "factor": off, "cofactors": [[str(at_zero)]] * 2}])
    yield "a cofactor of too high a degree that agrees at the tested forces", chain(*equal, ties=[good]), \
        chain(*equal, ties=[{**tie, "factor": off, "cofactors": [[str(at_zero), str(at_one - at_zero)]] * 2}])
    yield "a tie of unequal forces", chain(*equal, ties=[good]), chain("1 1 1", "3 0 1.01", force(1, "1.98", "2.01", (0, 1)), ties=[good])
    shapes = [force(m, "1.98", "2.02", (0, 2), shape=s) for m, s in ((1, u), (2, v))]
    yield "one shape for both modes of a tie", chain(*equal[:2], *shapes, ties=[good]), \
        chain(*equal[:2], shapes[0], {**shapes[0], "mode": 2}, ties=[good])
    yield "the lowest force left out", chain(*two, low, high), chain(*two, high)
    yield "no force at all", chain(*two, low), chain(*two)
    # two unit links, k = (0, 1): F = 2, det(lambda B - A) = -2 lambda^2 - 4 lambda^3
    right = ["0", "0", "-2", "-4"]
    straight, one = ("1 1", "0 1"), force(1, "1.98", "2.02", (0, 1))
    matrices = {"rank_A": 2, "rank_B": 3, "zero_algebraic": 2, "zero_geometric": 1, "characteristic": right}
    wrong = [str(Fraction(a) + Fraction(b)) for a, b in
             zip(right, product(*([str(-i), "1"] for i in range(3))))]
    yield "a characteristic polynomial that is right at all places but one", chain(*straight, one, matrices=matrices), \
        chain(*straight, one, matrices={**matrices, "characteristic": wrong})


def judge_by_hand(judge, of_one):
    for name, true, false in by_hand():
        if not judge.holds(of_one(true)):
            judge.misjudged.append(("refused although true, beside", name))
        judge.by_hand(of_one(false), name)
    # one text, two readings: the second member of a name hides the first
    text = json.dumps(of_one(chain("1 1 1", "6 0 2.2", force(1, "3.98", "4.02", (0, 1)))))
    judge.by_hand(text.replace('"stiffness":', '"stiffness": ["1", "1", "1"], "stiffness":'), "a member stated twice")
    long = "1." + "0" * 5000 + "1"
    if not judge.holds(of_one(chain(f"{long} 1", "0 1", force(1, "1.98", "2.02", (0, 1))))):
        judge.misjudged.append("refused although true: five thousand digits")


def judge_rounding(judge):
    """Fractions that a shape is computed with are rounded outwards, to few bits as well."""
    random = Random(1)
    for _ in range(300):
        ends = sorted(Fraction(random.randint(-10**9, 10**9), random.randint(1, 10**6)) for _ in range(2))
        for bits in (4, 64):
            low, high = checker.outward(ends, bits) if any(ends) else (0, 0)
            if not low <= ends[0] <= ends[1] <= high:
                judge.misjudged.append(("rounded inwards", *ends, bits))


def main():
    document, judge = published(sys.argv[2]), Judge(checker)

    def of_one(entry):
        return sealed({**document, "certificates": [entry]})

    for certificate in kinds(document["certificates"]):
        judge.true(of_one(certificate), certificate["chain"])
        judge.by_machine(forgeries(of_one(certificate)))
    judge.by_machine(misspelt(of_one(certificate)))
    judge_by_hand(judge, of_one)
    judge_rounding(judge)
    judge.end()


if __name__ == "__main__":
    main()
