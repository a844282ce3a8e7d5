#!/usr/bin/env python3
"""Checks Plumbline's certificates of the critical load factors of straight structures with fractions alone. What is
checked, and what that proves, stands in structure-certificate-format.md.
Usage: check_structures.py FILE... [--of CHAIN.toml] (exit status 0 when everything in them holds; with --of, when they
are of that chain file too)."""
import sys
from fractions import Fraction
from math import gcd, lcm

from check_certificates import determinant, each, fields, main, number, require, unit
from stated_chain import assembled, canonical, read_chain_file

MOST_UNKNOWNS = 8  # up to which all changes of motion are looked for again

def inertia(rows):
    """Negative and positive eigenvalues of a symmetric matrix of fractions, a dictionary a row, by congruence: Sylvester's law."""
    negative = positive = 0
    rows = [dict(row) for row in rows]
    for i in range(len(rows)):
        if not rows[i].get(i):
            j = next((j for j, x in rows[i].items() if j > i and x), None)
            if j is None: continue  # an eigenvalue that is zero
            sign = 1 if 2 * rows[i][j] + rows[j].get(j, 0) else -1
            for column, x in list(rows[j].items()):  # adds row and column j to row and column i
                if column < i: continue
                rows[i][column] = rows[i].get(column, 0) + sign * x
            add = {k: row.get(j, 0) for k, row in enumerate(rows) if k >= i and row.get(j)}
            for k, x in add.items(): rows[k][i] = rows[k].get(i, 0) + sign * x
        pivot = rows[i][i]
        negative, positive = negative + (pivot < 0), positive + (pivot > 0)
        for j, x in list(rows[i].items()):
            if j <= i or not x: continue
            share = x / pivot
            for column, y in rows[i].items():
                if column > i: rows[j][column] = rows[j].get(column, 0) - share * y
            rows[j].pop(i, None)
    return negative, positive

def interpolated(values):
    """The coefficients of the polynomial with these values at 0, 1, 2, ..."""
    d = list(values)
    for order in range(1, len(d)):
        for i in range(len(d) - 1, order - 1, -1): d[i] = (d[i] - d[i - 1]) / order
    p = []
    for i in range(len(d) - 1, -1, -1):  # p (x - i) + d[i]
        p = [a - i * b for a, b in zip([0] + p, p + [0])] if p else []
        p = [p[0] + d[i]] + p[1:] if p else [d[i]]
    return p

def real_roots(p):
    """The numbers of distinct negative and positive roots, by Sturm's theorem; zero is no root."""
    def trimmed(q):
        while q and not q[-1]: q = q[:-1]
        return q
    sequence = [trimmed(p), [i * c for i, c in enumerate(p)][1:]]
    while sequence[-1]:
        rest, by = list(sequence[-2]), sequence[-1]
        while len(rest) >= len(by):
            share, shift = rest[-1] / by[-1], len(rest) - len(by)
            for i, c in enumerate(by): rest[i + shift] -= share * c
            rest = trimmed(rest[:-1])
        sequence.append([-c / abs(rest[-1]) for c in rest])
    def changes(signs):
        signs = [s > 0 for s in signs if s]
        return sum(a != b for a, b in zip(signs, signs[1:]))
    terms = sequence[:-1]
    at_zero = changes([t[0] for t in terms])
    left = changes([t[-1] * (-1) ** (len(t) - 1) for t in terms])
    return left - at_zero, at_zero - changes([t[-1] for t in terms])

def whole(p):
    """A positive multiple of a polynomial, with integers that have no common factor."""
    while p and not p[-1]: p = p[:-1]
    scale = lcm(*(Fraction(c).denominator for c in p)) if p else 1
    p = [int(c * scale) for c in p]
    common = gcd(*p) or 1
    return [c // common for c in p]

def squarefree(p):
    """The polynomial with the roots of p, each once."""
    f, g = whole(p), whole([i * c for i, c in enumerate(p)][1:])
    while g:  # their greatest common divisor
        rest = list(f)
        while len(rest) >= len(g):
            top, shift = rest[-1], len(rest) - len(g)
            rest = [g[-1] * c for c in rest]
            for i, c in enumerate(g): rest[i + shift] -= top * c
            rest.pop()
        f, g = g, whole(rest)
    rest, quotient = [Fraction(c) for c in p], []
    while len(rest) >= len(f):
        quotient.append(rest[-1] / f[-1])
        shift = len(rest) - len(f)
        for i, c in enumerate(f): rest[i + shift] -= quotient[-1] * c
        rest.pop()
    return whole(quotient[::-1])

def value(p, x):
    result = Fraction(0)
    for c in reversed(p): result = result * x + c
    return result

def variations(p, low, high):
    """Descartes' bound on the number of roots between two numbers: exact where it is 0 or 1."""
    n, width, shifted = len(p) - 1, high - low, [Fraction(c) for c in p]
    for i in range(n):  # p(low + x)
        for j in range(n - 1, i - 1, -1): shifted[j] += low * shifted[j + 1]
    q = whole([c * width**i for i, c in enumerate(shifted)][::-1])
    q += [0] * (n + 1 - len(q))
    for i in range(n):  # (1 + x)^n p(low + width / (1 + x))
        for j in range(n - 1, i - 1, -1): q[j] += q[j + 1]
    signs = [c > 0 for c in q if c]
    return sum(a != b for a, b in zip(signs, signs[1:]))

def positive_roots(p):
    """Ascending bounds around the positive roots of a polynomial that has each once; no bound is a root."""
    end = 2 + max(abs(Fraction(c, p[-1])) for c in p)
    open_, found = [(Fraction(0), end)], []
    while open_:
        low, high = open_.pop()
        count = variations(p, low, high)
        if count == 1 and low > 0: found.append((low, high))
        if count == 0 or (count == 1 and low > 0): continue
        middle = (low + high) / 2
        while not value(p, middle): middle = (low + 2 * middle) / 3
        open_ += [(low, middle), (middle, high)]
    return sorted(found)

def polynomial_of(structure, factor):
    """det(K - factor A - x M) in x."""
    rows, mass = structure.motion(factor)
    values = [determinant([[k - x * m * (i == j) for j, k in enumerate(row)] for i, (row, m) in enumerate(zip(rows, mass))])
              for x in map(Fraction, range(structure.size + 1))]
    return interpolated(values)

def is_symmetric(structure):
    rows = structure.motion(Fraction(1))[0]
    return rows == [list(column) for column in zip(*rows)]

def shapes_suffice(structure, factor, p):
    """Whether there are as many independent shapes as unknowns: the polynomial with each root once annuls M^-1 (K - F A)."""
    rows, mass = structure.motion(factor)
    B = [[k / m for k in row] for row, m in zip(rows, mass)]
    total, size = [[Fraction(0)] * structure.size for _ in B], range(structure.size)
    for c in reversed(squarefree(p)):
        total = [[sum(total[i][k] * B[k][j] for k in size) + c * (i == j) for j in size] for i in size]
    return not any(map(any, total))

def motion_at(structure, factor):
    p = polynomial_of(structure, factor)
    if not p[0]: return "divergence"
    negative, positive = real_roots(p)
    if negative: return "divergence"
    if positive + 1 < len(squarefree(p)): return "flutter"
    enough = positive == structure.size or is_symmetric(structure) or shapes_suffice(structure, factor, p)
    return "stable" if enough else "flutter"

def distinctness(p, count):
    """A number that is zero where fewer than so many roots are distinct (Hermite): the minor of the sums of their powers."""
    n, sums = len(p) - 1, [Fraction(len(p) - 1)]
    for k in range(1, 2 * n - 1):
        sums.append(-(k * p[n - k] * (k <= n) + sum(p[n - j] * sums[k - j] for j in range(1, min(k - 1, n) + 1))) / p[n])
    return determinant([[sums[i + j] for j in range(count)] for i in range(count)])

def all_changes(structure):
    """Bounds around every factor at which the motion changes, or may be another than to either side, where it is stable: with the
    motions below and above, and whether a frequency is zero there. And a polynomial that has each of these roots once."""
    n = structure.size
    samples = [polynomial_of(structure, Fraction(i)) for i in range(n * (n - 1) + 2)]
    distinct = max(len(squarefree(p)) for p in samples) - 1
    symmetric = is_symmetric(structure)
    require(distinct == n or symmetric, "two equal frequencies at every factor")
    zero = squarefree(interpolated([p[0] for p in samples[:n + 1]]))
    equal = interpolated([distinctness(p, distinct) for p in samples])
    below, changes = "stable", []
    both = squarefree(product(zero, equal))
    for low, high in positive_roots(both):
        above, is_zero = motion_at(structure, high), value(zero, low) * value(zero, high) < 0
        if below != above or (below == "stable" and (is_zero or not symmetric)): changes.append((low, high, below, above, is_zero))
        below = above
    return changes, both

def product(p, q):
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q): result[i + j] += a * b
    return result

def check_bounds(entry):
    low, high = number(entry["low"]), number(entry["high"])
    require(0 < low < high and 2 * (high - low) < unit(low, entry["digits"]) <= low, "bounds too wide")
    return low, high

def holds_root(p, around, bounds):
    """Whether the one root of p, which has each once, within two numbers that are none lies above the first bound and not above
    the second."""
    low, high = around
    if not value(p, bounds[1]): return low < bounds[1] < high
    require(value(p, bounds[0]) != 0, "a bound at the change")
    while not (bounds[0] < low and high < bounds[1]):
        if high <= bounds[0] or bounds[1] <= low: return False
        middle = (low + high) / 2
        if not value(p, middle): return bounds[0] < middle < bounds[1]
        if value(p, low) * value(p, middle) < 0: high = middle
        else: low = middle
    return True

def simplest(low, high):
    """The fraction of the smallest denominator between two positive numbers."""
    whole = Fraction(low // 1)
    if whole + 1 < high: return whole + 1
    if low == whole: return whole + Fraction(1, 1 / (high - whole) // 1 + 1)
    return whole + 1 / simplest(1 / (high - whole), 1 / (low - whole))

def check_changes(structure, stated):
    """That the stated changes are all, each around its factor."""
    require(structure.size <= MOST_UNKNOWNS, "changes of more than 8 unknowns")
    found, both = all_changes(structure)
    require(len(found) == len(stated), "changes of motion that are missing, or none")
    for one, (low, high, below, above, is_zero) in zip(stated, found):
        fields(one, "digits low high at above")
        bounds = check_bounds(one)
        require(holds_root(both, (low, high), bounds), "no change within the bounds")
        require(one["above"] == above, "another motion above a change")
        if is_zero: require(one["at"] == "divergence", "a frequency that is zero at a change")
        elif one["at"] != "undecided":
            factor = bounds[1] if not value(both, bounds[1]) else simplest(*bounds)
            require(not value(both, factor) and motion_at(structure, factor) == one["at"], "the motion at a change")

def check_loss(entry):
    fields(entry, "structure chain loss", "changes")
    structure, loss = assembled(entry["chain"]), entry["loss"]
    fields(loss, "kind digits low high")
    low, high = check_bounds(loss)
    require(motion_at(structure, Fraction(0)) == "stable", "not stable before the loads grow")
    require(motion_at(structure, low) == "stable", "not stable at low")
    if "changes" not in entry:
        require(motion_at(structure, high) == loss["kind"] != "stable", "not lost at high")
        return
    check_changes(structure, entry["changes"])
    def kind(one):
        return one["above"] if one["above"] != "stable" else one["at"]
    first = next(one for one in entry["changes"] if kind(one) not in ("stable", "undecided"))
    require({**first, "kind": kind(first)} == {**loss, "at": first["at"], "above": first["above"]}, "not the first loss")

def check_factors(entry):
    fields(entry, "structure chain modes factors")
    structure = assembled(entry["chain"])
    require("joints" in entry["chain"] or not structure.followers, "a load without energy")
    require(inertia(structure.matrix(1, 0)) == (0, structure.size), "not stable before the loads grow")
    require(inertia(structure.matrix(0, 1))[0] == entry["modes"] > 0, "modes")
    modes = [factor["mode"] for factor in entry["factors"]]
    require(modes and modes == list(range(1, len(modes) + 1)), "not the lowest factors, each once")
    for factor in entry["factors"]:
        fields(factor, "mode digits low high below_low below_high")
        low, high = check_bounds(factor)
        below = [inertia(structure.matrix(1, x))[0] for x in (low, high)]
        require(below == [factor["below_low"], factor["below_high"]], "counts")
        require(below[0] < factor["mode"] <= below[1], "mode not within the bounds")

def check_structure(entry):
    check_loss(entry) if "loss" in entry else check_factors(entry)
    return entry["chain"]

def check(document):
    return each(document, "plumbline-structure-certificates", "structure", check_structure)

def check_of(path):
    """As check(), and that each certificate is of the chain file."""
    wanted = read_chain_file(path)
    def check_all(document):
        chains = check(document)
        require(chains and all(canonical(chain) == wanted for chain in chains), f"a certificate of another chain than {path}")
        return chains
    return check_all

if __name__ == "__main__":
    of = None
    if "--of" in sys.argv[:-1]:
        at = sys.argv.index("--of")
        of = sys.argv[at + 1]
        del sys.argv[at:at + 2]
    main(check_of(of) if of else check, lambda structures: f"{len(structures)} structures")
