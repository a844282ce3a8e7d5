"""Pitchforks of symmetric chains by the method of Lyapunov and Schmidt, over intervals of integers. For check_paths.py beside;
needs Python's standard library alone."""
from check_certificates import fields, number, require
from exact_intervals import hull, inside, inverse, magnitude, middle, minus, plus, widened, zero_in

ROUNDS = 12

class Fork:
    """Where a symmetric branch and a bent one cross, in coordinates of the means m, S m = m, and of the bends v,
    S v = -v: the equilibria m + a v, l · v = 1, of all amplitudes a from 0 on. The unknowns are m, the load and v."""
    SYMMETRIES = "reversed", "mirrored", "reversed and mirrored"

    def __init__(self, chain, stated, parts):
        fields(stated, "symmetry load symmetric bent")
        require(stated["symmetry"] in self.SYMMETRIES and chain.has(stated["symmetry"]), "symmetry")
        self.chain, N = chain, chain.numbers
        self.means, self.bends = (self.basis(stated["symmetry"], sign) for sign in (1, -1))
        symmetric, bent = ([self.end(parts, *end) for end in stated[name]] for name in ("symmetric", "bent"))
        require(bent, "no bent branch")
        ends = symmetric + bent
        size = max(magnitude(x) for x in self.in_basis(self.bends, bent[0]))
        require(size > 0, "no bent branch")
        self.l = [(middle(x) << N.bits) // size for x in self.in_basis(self.bends, bent[0])]
        square = sum(x * x for x in self.l) >> N.bits
        bent = [self.on_bent_branch(u) for u in bent]
        centre = [middle(x) for x in self.in_basis(self.means, ends[0])]
        centre += [sum(number(x) * chain.shares[-1] for x in stated["load"]) * N.one // 2] + [(x << N.bits) // square for x in self.l]
        centre = newton(N, lambda w: self.bent(w, (0, 0)), [int(x) for x in centre])
        top = max(magnitude(a) for a, _ in bent)
        crossing = isolated(N, lambda w: self.bent(w, (0, 0)), centre, [])
        branch = isolated(N, lambda w: self.bent(w, (0, top)), centre, [w for _, w in bent] + [crossing])
        require(all(map(inside, crossing, branch)), "no crossing")
        require(all(all(map(inside, w, branch)) for _, w in bent), "an end that is not on the bent branch")
        load, count = crossing[len(self.means)], len(self.means)
        low, high = (N.of(number(x) * chain.shares[-1]) for x in stated["load"])
        require(low[1] <= load[0] and load[1] <= high[0], "the load of a pitchfork")
        loads, shapes = load, [self.in_basis(self.means, u) for u in symmetric]
        for u in symmetric: loads = hull(loads, u[-1])
        straight = isolated(N, lambda x: self.symmetric(x, loads), centre[:count], [*shapes, crossing[:count]])
        require(all(all(map(inside, x, straight)) for x in [*shapes, crossing[:count]]), "an end that is not on the symmetric branch")
        for u in symmetric: self.is_symmetric(u)

    def basis(self, symmetry, sign):
        """Vectors that span the shapes and forces with S u = sign u."""
        n, size, mirrored = self.chain.n, self.chain.size, symmetry.endswith("mirrored")
        own, unit = -sign if mirrored else sign, lambda i: [int(i == j) for j in range(size)]
        if symmetry == "mirrored": columns = [unit(i) for i in range(n) if own > 0]
        else:
            pairs = [(i, n - 1 - i) for i in range((n + 1) // 2)]
            columns = [unit(i) if i == j else [a + own * b for a, b in zip(unit(i), unit(j))] for i, j in pairs if i != j or own > 0]
        if not self.chain.held: return columns
        return columns + [unit(n + a) for a in (0, 1) if sign == (-1 if mirrored and a else 1)]

    def end(self, parts, part, which):
        """An equilibrium of a part is in this box."""
        require(isinstance(part, int) and 0 < part <= len(parts), "a part")
        return widened(parts[part - 1].ends[which], parts[part - 1].near)

    def in_basis(self, basis, u):
        N = self.chain.numbers
        return [N.over(N.weighted([x << N.bits for x in v], u), (sum(x * x for x in v) << N.bits,) * 2) for v in basis]

    def vector(self, basis, coordinates):
        N = self.chain.numbers
        return [N.weighted([v[i] << N.bits for v in basis], coordinates) for i in range(self.chain.size)]

    def on_bent_branch(self, u):
        """Amplitude and unknowns."""
        bend = self.in_basis(self.bends, u)
        a = self.chain.numbers.weighted(self.l, bend)
        require(not zero_in(a), "an end that may not be bent")
        return a, self.in_basis(self.means, u) + [u[-1]] + [self.chain.numbers.over(x, a) for x in bend]

    def symmetric(self, x, load):
        """Value and derivative of the equations of symmetric shapes at a load."""
        u = self.vector(self.means, x) + [load]
        return self.projected(self.means, self.chain.value(u)), self.derivative(u, self.means, self.means)

    def derivative(self, u, rows, columns):
        J = self.jacobian(u)
        return [*zip(*[self.projected(rows, self.product(J, v)) for v in columns])]

    def jacobian(self, u):
        return self.chain.bordered(u, None)[:-1]

    def product(self, J, v):
        N = self.chain.numbers
        return [N.weighted([x << N.bits for x in v], row) for row in J]

    def projected(self, basis, values):
        N = self.chain.numbers
        return [N.weighted([x << N.bits for x in v], values) for v in basis]

    def bent(self, w, a):
        """Value and derivative of: the even part of E(m + a v), its odd part over a, and l · v - 1. The odd part over a is
        the mean of E'(m + s a v) v over 0 <= s <= 1, and so is within what E' v is anywhere on the way."""
        N, chain, means = self.chain.numbers, self.chain, len(self.means)
        zero, load = (0, 0), w[means]
        v, way = self.vector(self.bends, w[means + 1:]), (0, max(magnitude(a), 0))
        u = [plus(m, N.times(way, x)) for m, x in zip(self.vector(self.means, w[:means]), v)] + [load]
        J = self.jacobian(u)
        along = [sum_of(N.times(x, y) for x, y in zip(row, v)) for row in J]
        second = lambda x: chain.second(u, v + [zero], x)
        value = self.projected(self.means, chain.value(u)) + self.projected(self.bends, along)
        value.append(minus(N.weighted(self.l, w[means + 1:]), (N.one,) * 2))
        columns = []
        for m in self.means:
            columns.append(self.projected(self.means, self.product(J, m)) + self.projected(self.bends, second(exact(N, m) + [zero])) + [zero])
        by_load = second([zero] * chain.size + [(N.one,) * 2])
        columns.append(self.projected(self.means, [row[-1] for row in J]) + self.projected(self.bends, by_load) + [zero])
        for b, l in zip(self.bends, self.l):
            slope = self.product(J, b)
            odd = [plus(x, N.times(way, y)) for x, y in zip(slope, second(exact(N, b) + [zero]))]
            columns.append([N.times(way, x) for x in self.projected(self.means, slope)] + self.projected(self.bends, odd) + [(l, l)])
        return value, [*zip(*columns)]

    def is_symmetric(self, u):
        """An equilibrium in this box is its own image, for it is the only one at its load in a box that S keeps."""
        N, both = self.chain.numbers, self.means + self.bends
        x = self.in_basis(self.means, u) + [(-magnitude(b), magnitude(b)) for b in self.in_basis(self.bends, u)]
        def equations(x):
            at = self.vector(both, x) + [u[-1]]
            return self.projected(both, self.chain.value(at)), self.derivative(at, both, both)
        alone = isolated(N, equations, [middle(a) for a in x], [x])
        require(all(map(inside, x, alone)), "an end that may not be symmetric")

def sum_of(values):
    low = high = 0
    for a, b in values: low, high = low + a, high + b
    return low, high

def exact(numbers, v): return [(x << numbers.bits,) * 2 for x in v]

def newton(numbers, equations, x):
    for _ in range(8):
        value, A = equations([(a, a) for a in x])
        Y = inverse([[middle(a) for a in row] for row in A], numbers)
        require(Y is not None, "a singular point")
        x = [a - middle(numbers.weighted(row, value)) for a, row in zip(x, Y)]
    return x

def isolated(numbers, equations, centre, contents):
    """A box around a centre, and around what is to be in it, in which Krawczyk's operator proves one root for every
    parameter of the equations: its image, or the box itself where contents are given."""
    N = numbers
    value, A = equations([(a, a) for a in centre])
    Y = inverse([[middle(a) for a in row] for row in A], N)
    require(Y is not None, "a singular point")
    z = [magnitude(N.weighted(row, value)) for row in Y]
    least = [max([N.one >> 50] + [2 * magnitude(minus(x[i], (c, c))) for x in contents]) for i, c in enumerate(centre)]
    radius = [max(2 * a, b) for a, b in zip(z, least)]
    for _ in range(ROUNDS):
        box = widened([(c, c) for c in centre], radius)
        columns = [*zip(*equations(box)[1])]
        image = []
        for i, (row, a) in enumerate(zip(Y, z)):
            defect = [magnitude(minus((N.one * (i == j),) * 2, N.weighted(row, column))) for j, column in enumerate(columns)]
            image.append(a - (-sum(map(lambda x, y: x * y, defect, radius)) >> N.bits))
        if all(a < b for a, b in zip(image, radius)): return box if contents else widened([(c, c) for c in centre], image)
        radius = [max(2 * a, b) for a, b in zip(image, least)]
    raise ValueError("not one root in a box")
