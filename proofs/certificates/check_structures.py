#!/usr/bin/env python3
"""Checks Plumbline's certificates of the critical load factors of straight structures with fractions alone. What is
checked, and what that proves, stands in structure-certificate-format.md.
Usage: check_structures.py FILE... (exit status 0 when everything in them holds)."""
from fractions import Fraction

from check_certificates import determinant, each, fields, main, number, require, unit

class Motion:
    """One motion of one place: free, held, or against a spring."""
    def __init__(self, text):
        self.held = text == "held"
        self.spring = Fraction(0) if text in ("held", "free") else number(text)
        require(self.spring >= 0, "a negative spring")

class Support:
    def __init__(self, entry):
        fields(entry, "along across turn")
        self.along, self.across, self.turn = (Motion(entry[name]) for name in ("along", "across", "turn"))
    def holds_along(self):
        return self.along.held or self.along.spring > 0

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

class Structure:
    def __init__(self, entry):
        self.L, self.k = [number(x) for x in entry["lengths"]], [number(x) for x in entry["stiffness"]]
        self.n = len(self.L)
        require(self.n == len(self.k) > 0 and min(self.L) > 0 <= min(self.k), "no such chain")
        self.base, self.end = Support(entry["base"]), Support(entry["end_point"])
        self.across = [self.base.across] + [Motion(x) for x in entry["across"]] + [self.end.across]
        require(len(self.across) == self.n + 1, "across")
        require(self.base.turn.spring == 0 and not (self.base.turn.held and self.k[0]), "the spring of joint 1")
        self.fixed, self.multiplied = self.compression(entry["loads"])
        self.number_unknowns()

    def compression(self, loads):
        from_base = self.base.holds_along()
        require(from_base != self.end.holds_along(), "held along at one end")
        sums = [[Fraction(0)] * self.n, [Fraction(0)] * self.n]
        for load in loads:
            fields(load, "at force multiplied follows")
            require(1 <= load["at"] <= self.n and {load["multiplied"], load["follows"]} <= {0, 1}, "load")
            for i in range(self.n):
                if from_base and i < load["at"]: sums[load["multiplied"]][i] -= number(load["force"])
                if not from_base and i >= load["at"]: sums[load["multiplied"]][i] += number(load["force"])
        return sums

    def number_unknowns(self):
        """The deflections of the nodes: a held one is none, those of a clamped link are one."""
        leader = list(range(self.n + 1))
        if self.base.turn.held: leader[1] = leader[0]
        if self.end.turn.held: leader[self.n] = leader[self.n - 1]
        held = {leader[i] for i, motion in enumerate(self.across) if motion.held}
        free = [i for i in sorted(set(leader)) if i not in held]
        self.size, self.unknown = len(free), [free.index(i) if i in free else None for i in leader]

    def matrix(self, springs, factor):
        """Of springs (as they are, times `springs`) and loads: fixed ones times `springs`, the others times `factor`."""
        rows = [{} for _ in range(self.size)]
        def add(terms, times):
            for i, a in terms:
                for j, b in terms:
                    if times and i is not None and j is not None: rows[i][j] = rows[i].get(j, 0) + times * a * b
        def slope(link, times=1):
            return [(self.unknown[link], -times / self.L[link]), (self.unknown[link + 1], times / self.L[link])]
        for i in range(self.n):
            if i: add(slope(i) + slope(i - 1, -1), springs * self.k[i])
            elif not self.base.turn.held: add(slope(0), springs * self.k[0])
            add(slope(i), -self.L[i] * (springs * self.fixed[i] + factor * self.multiplied[i]))
        add(slope(self.n - 1), springs * self.end.turn.spring)
        for i, motion in enumerate(self.across): add([(self.unknown[i], 1)], springs * motion.spring)
        return rows

    def motion(self, entry, factor):
        """The polynomial det(K - factor A - x M) in x: with loads that follow their link, K - factor A is not symmetric."""
        rows, mass = self.matrix(1, factor), [Fraction(0)] * self.size
        for load in entry["loads"]:
            at, before = self.unknown[load["at"]], self.unknown[load["at"] - 1]
            if not load["follows"] or at is None: continue
            push = -number(load["force"]) / self.L[load["at"] - 1] * (factor if load["multiplied"] else 1)
            rows[at][at] = rows[at].get(at, 0) + push
            if before is not None: rows[at][before] = rows[at].get(before, 0) - push
        masses = [number(x) for x in entry["masses"]]
        require(len(masses) == self.n, "masses")
        for node, m in enumerate(masses, 1):
            if self.unknown[node] is not None: mass[self.unknown[node]] += m
        require(min(mass) > 0, "a place without a mass")
        values = [determinant([[row.get(j, 0) - (x * mass[i] if i == j else 0) for j in range(self.size)]
                               for i, row in enumerate(rows)]) for x in map(Fraction, range(self.size + 1))]
        return interpolated(values)

class SpaceStructure:
    """A chain in space, in the turns about the axes that bend it: a sum of squares of linear forms in them."""
    def __init__(self, entry):
        L, axes = [number(x) for x in entry["lengths"]], []
        n = len(L)
        require(n == len(entry["joints"]) > 0 and min(L) > 0 and entry["clamped"] in (0, 1), "no such chain")
        for i, joint in enumerate(entry["joints"]):
            require(1 <= len(joint) <= 3, "axes")
            for axis in joint:
                fields(axis, "axis stiffness")
                a, k = [number(x) for x in axis["axis"]], number(axis["stiffness"])
                require(len(a) == 3 and any(a) and k >= 0, "no such axis")
                if a[1:] != [0, 0] and not (i == 0 and entry["clamped"]):
                    axes.append((i, k * sum(x * x for x in a), (a[2], -a[1])))
        fields(entry["end_point"], "across turn")
        fields(entry["compression"], "fixed multiplied")
        N = [[number(x) for x in entry["compression"][kind]] for kind in ("fixed", "multiplied")]
        across = [Motion(x) for x in entry["across"] + [entry["end_point"]["across"]]]
        require(len(across) == n == len(N[0]) == len(N[1]) and entry["end_point"]["turn"] in ("free", "held"), "ends and loads")
        slopes = [[[lean[d] * (joint <= i) for joint, _, lean in axes] for d in (0, 1)] for i in range(n)]
        deflections = [[[sum(L[j] * slopes[j][d][a] for j in range(i + 1)) for a in range(len(axes))] for d in (0, 1)] for i in range(n)]
        held = [w for i in range(n) if across[i].held for w in deflections[i]]
        basis = kernel(held + (slopes[-1] if entry["end_point"]["turn"] == "held" else []), len(axes))
        squares = [(k, 0, [Fraction(a == b) for b in range(len(axes))]) for a, (_, k, _) in enumerate(axes)]
        for i in range(n):
            squares += [(across[i].spring, 0, w) for w in deflections[i]]
            squares += [(-L[i] * N[0][i], -L[i] * N[1][i], t) for t in slopes[i]]
        self.size = len(basis)
        self.squares = [(c, d, [sum(x * y for x, y in zip(form, b)) for b in basis]) for c, d, form in squares if c or d]

    def matrix(self, springs, factor):
        """As that of Structure."""
        return [{j: sum((springs * c + factor * d) * form[i] * form[j] for c, d, form in self.squares) for j in range(self.size)}
                for i in range(self.size)]

def kernel(rows, columns):
    """A basis of what the rows map to zero."""
    pivots = []
    for column in range(columns):
        row = next((row for row in rows if row[column]), None)
        if row is None: continue
        pivot = [x / row[column] for x in row]
        eliminated = [[x - other[column] * y for x, y in zip(other, pivot)] for other in rows if other is not row]
        pivots = [(at, [x - other[column] * y for x, y in zip(other, pivot)]) for at, other in pivots] + [(column, pivot)]
        rows = eliminated
    basis, leading = [], {at for at, _ in pivots}
    for column in range(columns):
        if column in leading: continue
        vector = [Fraction(i == column) for i in range(columns)]
        for at, pivot in pivots: vector[at] = -pivot[column]
        basis.append(vector)
    return basis

def check_loss(entry):
    fields(entry, "structure lengths stiffness base end_point across loads masses loss")
    structure, loss = Structure(entry), entry["loss"]
    fields(loss, "kind digits low high")
    low, high = number(loss["low"]), number(loss["high"])
    require(0 < low < high and 2 * (high - low) < unit(low, loss["digits"]) <= low, "bounds too wide")
    require(real_roots(structure.motion(entry, Fraction(0))) == (0, structure.size), "not stable before the loads grow")
    require(real_roots(structure.motion(entry, low)) == (0, structure.size), "not stable at low")
    negative, positive = real_roots(structure.motion(entry, high))
    require(positive < structure.size and loss["kind"] == ("divergence" if negative else "flutter"), "not lost at high")

def check_structure(entry):
    if "loss" in entry: return check_loss(entry)
    if "joints" in entry:
        fields(entry, "structure lengths joints clamped end_point across compression modes factors")
        structure = SpaceStructure(entry)
    else:
        fields(entry, "structure lengths stiffness base end_point across loads modes factors")
        structure = Structure(entry)
        require(not any(load["follows"] for load in entry["loads"]), "a load without energy")
    require(inertia(structure.matrix(1, 0)) == (0, structure.size), "not stable before the loads grow")
    require(inertia(structure.matrix(0, 1))[0] == entry["modes"] > 0, "modes")
    modes = [factor["mode"] for factor in entry["factors"]]
    require(modes == sorted(set(modes)), "modes out of order")
    for factor in entry["factors"]:
        fields(factor, "mode digits low high below_low below_high")
        low, high = number(factor["low"]), number(factor["high"])
        require(0 < low < high and 2 * (high - low) < unit(low, factor["digits"]) <= low, "bounds too wide")
        below = [inertia(structure.matrix(1, x))[0] for x in (low, high)]
        require(below == [factor["below_low"], factor["below_high"]], "counts")
        require(below[0] < factor["mode"] <= below[1], "mode not within the bounds")

def check(document):
    return each(document, "plumbline-structure-certificates", "structure", check_structure)

if __name__ == "__main__":
    main(check, lambda structures: f"{len(structures)} structures")
