"""The equilibrium equations of a loaded chain over intervals of integers. For the checkers of certificates beside; needs
Python's standard library alone."""
from fractions import Fraction
from itertools import accumulate, combinations

from check_certificates import number, require
from exact_intervals import Numbers, minus, negative_eigenvalues, opposite, plus, zero_in

def unit_above(values):
    """A power of two above them; one where all are zero."""
    top = max(values)
    return Fraction(2) ** (top.numerator.bit_length() - top.denominator.bit_length() + 1) if top else Fraction(1)

class Chain:
    """A loaded chain in units of its own, with its equations for the link directions theta and, where the end point is
    held, the force:  T_i - T_(i+1) + L_i (Fx sin theta_i - Fy cos theta_i) = 0,  T_i = k_i (q_i - rest_i),
    q_i = theta_i - theta_(i-1),  sum L_i (cos, sin) theta_i = p."""

    def __init__(self, entry, bits):
        L, k, rest = ([number(x) for x in entry[name]] for name in ("lengths", "stiffness", "rest"))
        n = self.n = len(L)
        require(n == len(k) == len(rest) > 0 and min(L) > 0 <= min(k), "no such chain")
        require(entry["rest_unit"] in ("rad", "pi"), "rest_unit")
        self.length, self.stiffness = unit_above(L), unit_above(k)
        self.scale = max(L), max(k) or Fraction(1)  # of what is right to so many digits
        spread = max(self.length / min(L), self.stiffness / min([x for x in k if x] or [self.stiffness]))
        N = self.numbers = Numbers(bits + int(spread).bit_length())
        self.held, self.passive = entry["control"] != "force", [not x for x in k]
        self.size = n + 2 * self.held
        self.L, self.k = [N.of(x / self.length) for x in L], [N.of(x / self.stiffness) for x in k]
        self.rest = [N.times(N.of(x), N.pi) if entry["rest_unit"] == "pi" else N.of(x) for x in rest]

    def unloaded(self):
        """The end point without load."""
        return self.end_point([self.numbers.circle(t) for t in accumulate(self.rest, plus)])

    def end_point(self, circles):
        x = y = (0, 0)
        for L, (c, s) in zip(self.L, circles): x, y = plus(x, self.numbers.times(L, c)), plus(y, self.numbers.times(L, s))
        return x, y

    def residual(self, theta, force, place):
        N, before, T = self.numbers, (0, 0), []
        for k, t, rest in zip(self.k, theta, self.rest): T, before = T + [N.times(k, minus(minus(t, before), rest))], t
        T.append((0, 0))
        circles = [N.circle(t) for t in theta]
        pull = [N.times(L, minus(N.times(force[0], s), N.times(force[1], c))) for L, (c, s) in zip(self.L, circles)]
        f = [plus(minus(T[i], T[i + 1]), pull[i]) for i in range(self.n)]
        if self.held: f += [minus(a, p) for a, p in zip(self.end_point(circles), place)]
        return f

    def derivative(self, theta, force):
        N, n, zero = self.numbers, self.n, (0, 0)
        A = [[zero] * self.size for _ in range(self.size)]
        for i, t in enumerate(theta):
            c, s = N.circle(t)
            x, y = N.times(self.L[i], c), N.times(self.L[i], s)
            A[i][i] = plus(self.k[i], plus(N.times(x, force[0]), N.times(y, force[1])))
            if i + 1 < n:
                A[i][i] = plus(A[i][i], self.k[i + 1])
                A[i][i + 1] = A[i + 1][i] = opposite(self.k[i + 1])
            if self.held: A[i][n], A[i][n + 1], A[n][i], A[n + 1][i] = y, opposite(x), opposite(y), x
        return A

    def negative_directions(self, theta, force):
        """Of the energy's Hessian, where the end point is held on the shapes that keep it there."""
        N, n, A = self.numbers, self.n, self.derivative(theta, force)
        if not self.held: return negative_eigenvalues(A, N)
        x, y = A[n + 1][:n], A[n][:n]
        cross = lambda i, j: minus(N.times(x[i], y[j]), N.times(x[j], y[i]))
        a, b = max(combinations(range(n), 2), key=lambda p: max(cross(*p)[0], -cross(*p)[1]))
        require(not zero_in(cross(a, b)), "all links in one line")
        basis = []
        for j in set(range(n)) - {a, b}:
            v = [(0, 0)] * n
            v[j] = (N.one,) * 2
            v[a], v[b] = N.over(cross(b, j), cross(a, b)), N.over(cross(j, a), cross(a, b))
            basis.append(v)
        dot = lambda u, v: (sum(p[0] for p in w), sum(p[1] for p in w)) if (w := [*map(N.times, u, v)]) else (0, 0)
        images = [[dot(row[:n], v) for row in A[:n]] for v in basis]
        return negative_eigenvalues([[dot(u, w) for w in images] for u in basis], N)

    def energy(self, q):
        N, total = self.numbers, (0, 0)
        for k, angle, rest in zip(self.k, q, self.rest):
            off = minus(angle, rest)
            top = max(map(abs, off))
            square = (0, top) if zero_in(off) else (min(map(abs, off)), top)
            total = plus(total, N.times(k, N.times(square, square)))
        return total[0] >> 1, -(-total[1] >> 1)
