#!/usr/bin/env python3
"""Checks Plumbline certificates with integers and fractions alone. What is checked, and what that proves, stands in
certificate-format.md. Usage: check_certificates.py FILE... (exit status 0 when everything in them holds)."""
import hashlib, json, re, signal, sys
from fractions import Fraction
from itertools import accumulate
from math import ceil, floor, lcm

if hasattr(sys, "set_int_max_str_digits"): sys.set_int_max_str_digits(0)  # certificates may have any number of digits

REFUSALS = ValueError, TypeError, KeyError, IndexError, AttributeError, ArithmeticError, RecursionError

def require(holds, what):
    if not holds: raise ValueError(what)

def fields(entry, required, optional=""):
    found = set(entry) if isinstance(entry, dict) else {"no object"}
    require(set(required.split()) <= found <= set((required + " " + optional).split()), f"fields {sorted(found)}")

def once(pairs):
    """An object of which no member is stated twice: readers differ in which of the two they would take."""
    require(len({key for key, _ in pairs}) == len(pairs), f"a member stated twice among {[key for key, _ in pairs]}")
    return dict(pairs)

def inexact(text):
    raise ValueError(f"the number {text} where a whole number or text is expected: readers differ in how they round it")

def read(text):
    return json.loads(text, parse_float=inexact, parse_constant=inexact, object_pairs_hook=once)

MOST_DIGITS = 100000  # of a number, written without its exponent

def number(text):
    good = isinstance(text, str) and re.fullmatch(r"-?\d+(/0*[1-9]\d*|(\.\d+)?(e([+-]?\d{1,6}))?)", text, re.ASCII)
    require(good, f"{str(text)[:60]!r} where a decimal or a fraction is expected")
    require(len(text) + abs(int(good[4] or 0)) <= MOST_DIGITS, f"a number of more than {MOST_DIGITS} digits")
    return Fraction(text)

def unit(x, digits):
    """One unit in a significant digit of x; for x = 0 one unit in that place behind the point."""
    require(isinstance(digits, int) and 0 <= digits <= MOST_DIGITS, f"digits that are no number up to {MOST_DIGITS}")
    e = len(str(abs(x.numerator))) - len(str(x.denominator)) if x else 0
    return Fraction(10) ** (e + (x != 0 and abs(x) >= Fraction(10) ** e) - digits)

def value(polynomial, x):
    return sum(c * x**i for i, c in enumerate(polynomial))

def determinant(rows):
    i = next((i for i, row in enumerate(rows) if row[0]), None)
    if i is None or len(rows) == 1: return rows[0][0]
    rest = [[a - b * row[0] / rows[i][0] for a, b in zip(row[1:], rows[i][1:])] for row in rows[:i] + rows[i + 1:]]
    return (-1) ** i * rows[i][0] * determinant(rest)

def times(a, b):
    products = [x * y for x in a for y in b]
    return min(products), max(products)

def outward(interval, bits):
    top = max(map(abs, interval))
    grid = Fraction(2) ** (bits - top.numerator.bit_length() + top.denominator.bit_length())
    return floor(interval[0] * grid) / grid, ceil(interval[1] * grid) / grid

class Chain:
    def __init__(self, lengths, stiffness):
        self.L, self.k = [number(x) for x in lengths], [number(x) for x in stiffness]
        n = self.n = len(self.L)
        require(n == len(self.k) > 1 and min(self.L) > 0 <= min(self.k) and self.k.count(0) < 2, "no such chain")
        self.z = list(accumulate(self.L[::-1]))[::-1]
        passive = self.k.index(0) if 0 in self.k else 0
        self.blocks = [(0, passive), (passive, n - 1)] if passive else [(0, n - 1)]
        dL, dk = lcm(*(x.denominator for x in self.L)), lcm(*(x.denominator for x in self.k))
        self.whole = [[int(x * d) for x in values] for values, d in ((self.L, dL), (self.z, dL), (self.k, dk))]
        self.per_force = Fraction(dk, dL)

    def recursion(self, block, force):
        """The sign changes in h_first ... h_last, and h_last up to a positive factor that is the same for every
        integer force / per_force; a part that ends in a passive joint has g_last in place of h_last."""
        (L, z, k), (P, D) = self.whole, (force * self.per_force).as_integer_ratio()
        h, m, count, positive = z[block[0]], k[block[0]], 0, True
        for i in range(*block):
            t = D * z[i + 1] * m - P * L[i] * h
            h, m = (D * z[i] * k[i + 1] * h + z[i + 1] * t, k[i + 1] * t) if k[i + 1] else (t, 0)
            count, positive = (count + ((h > 0) != positive), h > 0) if h else (count, positive)
        return count, h

    def shape(self, block, force):
        """Intervals around the joint angles of the buckling mode of a part, for an interval of forces."""
        bits, first, zero = int(force[1] / (force[1] - force[0])).bit_length() + 64, block[0], Fraction(0)
        h, g, q = (zero + 1,) * 2, (self.k[first] / self.z[first] ** 2,) * 2, [(zero, zero)] * self.n
        q[first] = (1 / self.z[first],) * 2
        for i in range(*block):
            load, z, k = times(force, h)[::-1], self.z[i + 1], self.k[i + 1]
            g = outward([a - b * self.L[i] / (self.z[i] * z) for a, b in zip(g, load)], bits)
            q[i + 1] = tuple(a * z / k for a in g) if k else tuple(-a / z for a in h[::-1])
            h = outward([a + z * b for a, b in zip(h, q[i + 1])], bits)
        return q

    def check_force(self, entry, tied):
        """`tied` has the modes that equal another one, as proved by ties."""
        fields(entry, "mode digits low high below_low below_high", "shape")
        mode, low, high = entry["mode"], number(entry["low"]), number(entry["high"])
        require(0 < low < high and 2 * (high - low) < unit(low, entry["digits"]) <= low, "bounds too wide")
        counts = [[self.recursion(block, force)[0] for block in self.blocks] for force in (low, high)]
        below = [*map(sum, counts)]
        require([entry["below_low"], entry["below_high"]] == below, "counts")
        require(below[0] < mode <= below[1], "mode not within the bounds")
        if "shape" not in entry: return
        require(below[1] == below[0] + (2 if mode in tied else 1), "a shape where the bounds hold another mode too")
        self.check_shape(entry["shape"], (low, high), counts)

    def check_shape(self, shape, force, counts):
        fields(shape, "first last digits q")
        block, digits = (shape["first"] - 1, shape["last"] - 1), shape["digits"]
        part, one, q = self.blocks.index(block), shape["q"].index("1"), self.shape(block, force)
        require(counts[1][part] == counts[0][part] + 1, "not one mode of this part of the chain within the bounds")
        require(digits > 1 and len(shape["q"]) == self.n and q[one][0] * q[one][1] > 0, "q")
        for text, angle in zip(shape["q"], q):
            v, (low, high) = number(text), times(angle, (1 / q[one][1], 1 / q[one][0]))
            require(abs(v) <= 1 and low <= 1 and high >= -1, "an angle larger than the one that is 1")
            require(v - unit(v, digits) <= low <= high <= v + unit(v, digits), f"q {text}")

    def check_tie(self, tie):
        fields(tie, "mode low high factor cofactors")
        low, high, d = number(tie["low"]), number(tie["high"]), [number(x) for x in tie["factor"]]
        ends = [sum(self.recursion(block, force)[0] for block in self.blocks) for force in (low, high)]
        require(0 < low < high and ends == [tie["mode"] - 1, tie["mode"] + 1], "not two modes from this on")
        require(value(d, low) * value(d, high) < 0 and len(self.blocks) == len(tie["cofactors"]) == 2, "no common root")
        for block, cofactor in zip(self.blocks, tie["cofactors"]):
            e, degree, start = [number(x) for x in cofactor], block[1] - block[0], self.recursion(block, 0)[1]
            require(len(d) + len(e) <= degree + 2, "degree")
            for x in (i / self.per_force for i in range(degree + 1)):
                require(value(d, x) * value(e, x) * start == self.recursion(block, x)[1], "the factor does not divide")

    def check_matrices(self, entry, forces):
        fields(entry, "rank_A rank_B zero_algebraic zero_geometric characteristic")
        n, c = self.n, [number(x) for x in entry["characteristic"]]
        A = [[-self.z[max(i, j)] for j in range(n)] + [0] for i in range(n)] + [[0] * (n + 1)]
        B = [[self.k[i] * (i == j) for j in range(n)] + [self.z[i]] for i in range(n)] + [self.z + [0]]
        for x in map(Fraction, range(n + 2)):
            pencil = [[x * b - a for a, b in zip(*rows)] for rows in zip(A, B)]
            require(len(c) == n + 2 and value(c, x) == determinant(pencil), "characteristic polynomial")
        require(c[-1] and c[2] and not c[1] and not c[0] and determinant([row[:n] for row in A[:n]]), "degenerate")
        stated = [entry[name] for name in ("rank_A", "rank_B", "zero_algebraic", "zero_geometric")]
        require(stated == [n, n + 1, 2, 1], "ranks or multiplicities")
        for f in forces:  # the bounds once more, from the determinant itself: no recursion, no theorem
            ends = [value(c, -1 / number(f[end])) for end in ("low", "high")]
            require(f["below_high"] - f["below_low"] > 1 or ends[0] * ends[1] < 0, "no eigenvalue within the bounds")

def each(document, format, name, check_entry):
    """What check_entry says of every entry of a file whose envelope holds; an entry is called by its member `name`."""
    fields(document, "format version licence provenance certificates sha256")
    text = json.dumps({**document, "sha256": ""}, sort_keys=True, separators=(",", ":"))
    require(hashlib.sha256(text.encode()).hexdigest() == document["sha256"], "sha256: the file has been changed")
    require(not re.search(r"[:,\[](true|false|null)[],}]", text), "true, false or null")
    fields(document["provenance"], "command program seed")
    found = [document["format"], document["version"]]
    require(found == [format, 1], f"format and version {found} where {[format, 1]} are expected")
    require(isinstance(document["certificates"], list) and document["certificates"], "no certificates")
    results = []
    for entry in document["certificates"]:
        try: results.append(check_entry(entry))
        except REFUSALS as error: raise ValueError(f"{name} {entry[name]}: {error}") from None
    return results

def check_chain(entry):
    fields(entry, "chain lengths stiffness forces", "ties matrices")
    chain, modes = Chain(entry["lengths"], entry["stiffness"]), [force["mode"] for force in entry["forces"]]
    require(modes and modes == list(range(1, len(modes) + 1)), "not the lowest forces, each once")
    for tie in entry.get("ties", []): chain.check_tie(tie)
    tied = {mode: tie["mode"] for tie in entry.get("ties", []) for mode in (tie["mode"], tie["mode"] + 1)}
    for force in entry["forces"]: chain.check_force(force, tied)
    bent = [(tied[f["mode"]], f["shape"]["first"]) for f in entry["forces"] if f["mode"] in tied and "shape" in f]
    require(len(bent) == len(set(bent)), "two shapes of equal forces in one part")
    if "matrices" in entry: chain.check_matrices(entry["matrices"], entry["forces"])

def check(document):
    return each(document, "plumbline-certificates", "chain", check_chain)

BUDGET = 600  # seconds for each file

def out_of_time(*_):
    raise TimeoutError(f"not done after {BUDGET} seconds, the budget of a file")

def main(check, summary):
    """Checks the files that the command line names. `summary` tells what was in a file that holds."""
    if len(sys.argv) < 2: sys.exit(f"usage: {sys.argv[0]} FILE...")
    if hasattr(signal, "alarm"): signal.signal(signal.SIGALRM, out_of_time)
    for name in sys.argv[1:]:
        if hasattr(signal, "alarm"): signal.alarm(BUDGET)
        try:
            with open(name, encoding="utf-8") as file: results = check(read(file.read()))
        except (OSError, *REFUSALS) as error: sys.exit(f"{name}: {error}")
        print(f"{name}: {summary(results)}: every statement holds")

if __name__ == "__main__":
    main(check, lambda chains: f"{len(chains)} chains")
