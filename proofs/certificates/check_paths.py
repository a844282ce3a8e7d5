#!/usr/bin/env python3
"""Checks Plumbline certificates of paths of equilibria with integers and fractions alone. What is checked, and what that
proves, stands in path-certificate-format.md.
Usage: check_paths.py FILE... (exit status 0 when everything in them holds)."""
from fractions import Fraction
from itertools import accumulate
from math import isqrt

from check_certificates import each, fields, main, number, require
from exact_intervals import hull, inverse, magnitude, middle, minus, opposite, plus, sign, widened, zero_in
from loaded_chain import Chain
from symmetric_crossing import Fork

class Loaded(Chain):
    """A chain under a load that grows along a ray; unknowns u: the link directions, where the end point is held the force
    on it, last the load. E(u) is one equation less than unknowns; a plane t · (u - c) = 0 makes them as many."""

    def __init__(self, entry, bits):
        super().__init__(entry, bits)
        require(entry["control"] in ("end_point", "force") and len(entry["direction"]) == 2, "control or direction")
        N, direction = self.numbers, [number(x) for x in entry["direction"]]
        require(any(direction), "direction")
        x, y = [a / max(map(abs, direction)) for a in direction]
        size = isqrt(int((x * x + y * y) * 4**N.bits)), 1 << N.bits
        self.direction = [N.over(N.of(a), (size[0], size[0] + 1)) for a in (x, y)]
        self.start = self.unloaded() if self.held else [(0, 0)] * 2
        self.unknowns = self.size + 1
        length = self.scale[0] / self.length  # what is stated as 1
        force = self.scale[1] / self.stiffness / length
        self.exact = *([number(x) for x in entry[name]] for name in ("lengths", "stiffness", "rest")), y
        self.shares = [Fraction(1)] * self.n + [force] * 2 * self.held + [length if self.held else force]

    def at(self, stated):
        """The unknowns of a point as it is stated."""
        values = [number(x) for x in stated]
        require(len(values) == self.unknowns, "a point")
        return [self.numbers.of(x * share) for x, share in zip(values, self.shares)]

    def split(self, u):
        """Link directions, force, and where the end point is held."""
        loaded = [plus(s, self.numbers.times(u[-1], d)) for s, d in zip(self.start, self.direction)]
        return (u[:self.n], u[self.n:-1], loaded) if self.held else (u[:-1], loaded, None)

    def value(self, u):
        return self.residual(*self.split(u)) + [(0, 0)]

    def bordered(self, u, normal):
        """E'(u), and the normal of the plane as last row."""
        N, (theta, force, _) = self.numbers, self.split(u)
        rows = self.derivative(theta, force)
        if self.held: last = [(0, 0)] * self.n + [opposite(d) for d in self.direction]
        else:
            last, (x, y) = [], self.direction
            for L, t in zip(self.L, theta):
                c, s = N.circle(t)
                last.append(N.times(L, minus(N.times(x, s), N.times(y, c))))
        return [row + [a] for row, a in zip(rows, last)] + [normal]

    def second(self, u, v, w):
        """E''(u) v w, and a zero for the plane."""
        N, (theta, force, _) = self.numbers, self.split(u)
        of_force = lambda a: a[self.n:-1] if self.held else [N.times(a[-1], d) for d in self.direction]
        (vx, vy), (wx, wy), result, place = of_force(v), of_force(w), [], [(0, 0)] * 2
        for i, (L, t) in enumerate(zip(self.L, theta)):
            c, s = N.circle(t)
            both = N.times(v[i], w[i])
            pull = minus(N.times(force[0], s), N.times(force[1], c))
            along = lambda x, y: plus(N.times(c, x), N.times(s, y))
            sides = plus(N.times(along(vx, vy), w[i]), N.times(along(wx, wy), v[i]))
            result.append(N.times(L, minus(sides, N.times(pull, both))))
            place = [minus(p, N.times(L, N.times(a, both))) for p, a in zip(place, (c, s))]
        return result + (place if self.held else []) + [(0, 0)]

    def has(self, symmetry):
        """Whether a map of shapes and forces takes equilibria to equilibria at the same load, exactly: link directions in
        reverse order, or changed in sign together with the lateral force, or both."""
        L, k, rest, lateral = self.exact
        mirrored, reversed = symmetry.endswith("mirrored"), symmetry.startswith("reversed")
        if mirrored and (any(rest) or lateral): return False
        if not reversed: return True
        same = L == L[::-1] and k[1:] == k[:0:-1] and rest[1:] == [-x for x in rest[:0:-1]]
        return same and self.held and self.passive[0]

class Tube:
    """|w_i| < radius_i about all centres, in which w -> w - Y (E(c + w); t · w) is a contraction: in each plane with this
    normal exactly one equilibrium is in it, and they are one analytic curve. `image`: so near it is to the centres."""
    ROUNDS = 12

    def __init__(self, chain, centres, normal, margin, offset):
        N = self.numbers = chain.numbers
        self.inverse = inverse([[middle(a) for a in row] for row in chain.bordered(centres, normal)], N)
        require(self.inverse, "no regular branch")
        z = [magnitude(a) for a in offset(self.inverse)]
        wider = lambda m: [margin * (x + (N.one >> 50)) // 4 for x in m]
        self.radius = wider(z)
        for _ in range(self.ROUNDS):
            columns = [*zip(*chain.bordered(widened(centres, self.radius), normal))]
            self.defect = [[magnitude(minus((N.one * (i == j),) * 2, N.weighted(row, column)))
                            for j, column in enumerate(columns)] for i, row in enumerate(self.inverse)]
            self.image = [a + b for a, b in zip(self.bound(self.radius), z)]
            if all(a < b for a, b in zip(self.image, self.radius)): return
            self.radius = wider(self.image)
        raise ValueError("no tube that holds one regular branch")

    def bound(self, sizes):
        return [-(-sum(a * x for a, x in zip(row, sizes)) >> self.numbers.bits) for row in self.defect]

    def solved(self, preconditioned):
        """The solution x of M x = y for every M in the tube, from an enclosure of Y y: |x - Y y| <= R |Y y| + R |x - Y y|."""
        N = self.numbers
        r, Rm = self.bound([magnitude(a) for a in preconditioned]), self.bound(self.radius)
        factor = max(-(-(a << N.bits) // (m - b)) for a, m, b in zip(r, self.radius, Rm))
        v = [-(-factor * m >> N.bits) for m in self.radius]
        for _ in range(self.ROUNDS): v = [min(a, b + c) for a, b, c in zip(v, r, self.bound(v))]
        return widened(preconditioned, v)

    def tangent(self):
        return self.solved([(row[-1],) * 2 for row in self.inverse])

class Segment:
    """The tube from one point to the next, and which way the load goes in it."""

    def __init__(self, chain, a, b):
        N = self.numbers = chain.numbers
        step, both = [minus(y, x) for x, y in zip(a, b)], [*map(hull, a, b)]
        flat = [middle(d) for d in step[:chain.n]] + [0] * 2 * chain.held + [middle(step[-1])]
        size = isqrt(sum(x * x for x in flat))
        require(size > 0, "the same point again")
        self.normal = [((x << N.bits) // size,) * 2 for x in flat]
        ends, bend, share = (chain.value(a), chain.value(b)), chain.second(both, step, step), (0, N.one >> 3)
        def offset(Y):  # E between the ends is their mean but for s (1 - s) / 2 E''
            first, last, between = ([N.weighted(row, x) for row in Y] for x in (*ends, bend))
            return [minus(hull(x, y), N.times(share, z)) for x, y, z in zip(first, last, between)]
        self.tube = Tube(chain, both, self.normal, 16, offset)
        everywhere = widened(both, self.tube.image)
        self.load, first = everywhere[-1], self.tube.tangent()
        self.way = sign(first[-1])
        if self.way == 0:
            right = [opposite(x) for x in chain.second(everywhere, first, first)]
            self.bend = sign(self.tube.solved([N.weighted(row, right) for row in self.tube.inverse])[-1])
            require(self.bend, "whether the load turns stays open")

class Part:
    """One curve through all points; runs between turns of the load, with their way and type."""

    def __init__(self, chain, stated):
        fields(stated, "points runs folds near")
        near = number(stated["near"])
        self.chain, self.near = chain, [chain.numbers.of(near * share)[0] for share in chain.shares]
        self.runs, self.folds, self.pending = [], [], None
        points = [chain.at(point) for point in stated["points"]]
        require(len(points) > 1, "points")
        segments = [Segment(chain, a, b) for a, b in zip(points, points[1:])]
        for i, point in enumerate(points):
            before, after = segments[max(i - 1, 0)], segments[min(i, len(segments) - 1)]
            self.join(point, before, after)
            if i < len(segments): self.account(after)
        require(not self.pending, "whether the load turns stays open")
        require(stated["runs"] == self.runs, f"runs {self.runs}")
        require(len(stated["folds"]) == len(self.folds), "folds")
        for bounds, load in zip(stated["folds"], self.folds):
            low, high = (chain.numbers.of(number(x) * chain.shares[-1]) for x in bounds)
            require(low[1] <= load[0] and load[1] <= high[0], "a fold")
        self.count, self.ends = len(segments), {"first": points[0], "last": points[-1]}

    def join(self, point, before, after):
        """The tubes on both sides hold the same curve, which passes the point nearby."""
        chain, N = self.chain, self.chain.numbers
        value = chain.value(point)
        box = Tube(chain, point, [*map(hull, before.normal, after.normal)], 5,
                   lambda Y: [N.weighted(row, value) for row in Y])
        for tube in (before.tube, after.tube):
            require(all(a <= b for a, b in zip(box.image, tube.radius)), "the curves before and after may not be one")
        require(all(a <= b for a, b in zip(box.image, self.near)), "a point that is not on the curve")
        way = sign(box.tangent()[-1])
        if not way: return
        self.settle(way)
        if self.runs[-1][1] is None:
            theta, force, _ = chain.split(widened(point, box.image))
            try: self.runs[-1][1] = chain.negative_directions(theta, force)
            except ValueError: pass

    def account(self, segment):
        if segment.way: return self.settle(segment.way)
        same = not self.pending or self.pending[0] == segment.bend
        require(same, "whether the load turns stays open")
        self.pending = segment.bend, hull(self.pending[1], segment.load) if self.pending else segment.load

    def settle(self, way):
        if not self.runs or self.runs[-1][0] != way:
            require(bool(self.runs) == bool(self.pending), "whether the load turns stays open")
            if self.runs: self.folds.append(self.pending[1])
            self.runs.append([way, None])
        self.pending = None

def check_path(entry):
    """How many segments, and how many pitchforks."""
    fields(entry, "case lengths stiffness rest rest_unit control direction parts pitchforks")
    chain = Loaded(entry, 96)
    require(entry["parts"], "parts")
    parts = [Part(chain, part) for part in entry["parts"]]
    for fork in entry["pitchforks"]: Fork(chain, fork, parts)
    return sum(part.count for part in parts), len(entry["pitchforks"])

def check(document):
    return each(document, "plumbline-path-certificates", "case", check_path)

if __name__ == "__main__":
    main(check, lambda found: f"{len(found)} cases, {sum(n for n, _ in found)} segments, {sum(n for _, n in found)} pitchforks")
