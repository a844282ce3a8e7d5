"""The equilibrium equations of a loaded chain over intervals of integers. For the checkers of certificates beside; needs
Python's standard library alone."""
from fractions import Fraction
from itertools import accumulate, combinations

from check_certificates import number, require
from exact_intervals import Numbers, common, inverse, middle, minus, negative_eigenvalues, opposite, plus, width, zero_in

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
        require(n == len(k) == len(rest) and 0 < n <= 16 and min(L) > 0 <= min(k), "no such chain")
        self.length, self.stiffness = unit_above(L), unit_above(k)
        require(entry["control"] in ("end_point", "deflection", "force"), "control")
        require(entry["rest_unit"] in ("rad", "pi") and len(entry["load"]) == 2, "rest_unit or load")
        self.scale = max(L), max(k) or Fraction(1)  # of what is right to so many digits
        spread = max(self.length / min(L), self.stiffness / min([x for x in k if x] or [self.stiffness]))
        N = self.numbers = Numbers(bits + int(spread).bit_length())
        self.held, self.passive = entry["control"] != "force", [not x for x in k]
        self.L, self.k = [N.of(x / self.length) for x in L], [N.of(x / self.stiffness) for x in k]
        self.rest = [N.times(N.of(x), N.pi) if entry["rest_unit"] == "pi" else N.of(x) for x in rest]
        self.load = self.loaded([number(x) for x in entry["load"]], entry["control"])
        self.size = n + 2 * self.held
        self.range = [self.around(i, entry) for i in range(n)]

    def loaded(self, load, control):
        if control == "force": return [self.numbers.of(x * self.length / self.stiffness) for x in load]
        place = [self.numbers.of(x / self.length) for x in load]
        if control == "end_point": return place
        x, y = self.end_point([self.numbers.circle(t) for t in accumulate(self.rest, plus)])
        return [minus(x, place[0]), plus(y, place[1])]

    def end_point(self, circles):
        x = y = (0, 0)
        for L, (c, s) in zip(self.L, circles): x, y = plus(x, self.numbers.times(L, c)), plus(y, self.numbers.times(L, s))
        return x, y

    def around(self, i, entry):
        """The joint angles counted; of a passive joint one turn, of which there are no others."""
        N, pi = self.numbers, self.numbers.pi
        if not self.held:
            require("window" not in entry and "turns" not in entry, "a window under a force")
        else:
            turns, nearest = entry["turns"], entry["window"][i]
            require(isinstance(turns, int) and 0 <= turns <= 100 and isinstance(nearest, int), "turns or window")
            require(len(entry["window"]) == self.n and abs(nearest) < 10**6, "window")
            if i == 0 or self.passive[i]: require(nearest == 0, "window")
            centre = N.multiple(pi, nearest)
            off, tie = minus(self.rest[i], centre), pi[1] // 2 + (N.one >> 30)
            if i and not self.passive[i]: require(-tie <= off[0] and off[1] <= tie, "window")
        if self.passive[i]: return plus(N.of(Fraction("0.1234567")), (-pi[1], pi[1]))
        if self.held:
            half = pi[1] * (2 * turns + 1)
            return plus(self.rest[i] if i == 0 else centre, (-half, half))
        force, beyond = sum(max(map(abs, f)) for f in self.load), (0, sum(L[1] for L in self.L[i:]))
        turn = N.over(N.times((0, force), beyond), self.k[i])[1]
        return plus(self.rest[i], (-turn, turn))

    def everywhere(self):
        return list(accumulate(self.range, plus))

    def torques(self, theta):
        N, before, T = self.numbers, (0, 0), []
        for i, t in enumerate(theta):
            q, before = common(minus(t, before), self.range[i]), t
            T.append((0, 0) if self.passive[i] else N.times(self.k[i], minus(q, self.rest[i])))
        return T + [(0, 0)]

    def narrow(self, theta):
        """What is left of a box of link directions, with the forces there. Raises Nothing where nothing is."""
        theta, force = list(theta), None if self.held else self.load
        for _ in range(8):
            size = sum(map(width, theta))
            self.keep_in_range(theta)
            force = self.balance(theta, force)
            if force and max(map(width, theta)) < 2 * self.numbers.one: theta, force = self.newton(theta, force)
            if 10 * sum(map(width, theta)) > 8 * size: break
        return theta, force

    def keep_in_range(self, theta):
        theta[0] = common(theta[0], self.range[0])
        for i in range(1, self.n): theta[i] = common(theta[i], plus(theta[i - 1], self.range[i]))
        for i in range(self.n - 1, 0, -1): theta[i - 1] = common(theta[i - 1], minus(theta[i], self.range[i]))

    def balance(self, theta, force):
        """Narrows theta and the force by the moments of link after link."""
        N, n, T = self.numbers, self.n, self.torques(theta)
        circles = [N.circle(t) for t in theta]
        if self.held:
            for given, found in zip(self.load, self.end_point(circles)): common(given, found)
            x, y = self.load
            rows = [(opposite(y), x, T[0])]  # a Fx + b Fy = m: about the base, and of each link
            for i, (c, s) in enumerate(circles):
                rows.append((N.times(self.L[i], s), opposite(N.times(self.L[i], c)), minus(T[i + 1], T[i])))
            force = self.bounded(rows, force)
            if not force: return None
        gain = []
        for L, (c, s) in zip(self.L, circles): gain.append(N.times(L, minus(N.times(force[1], c), N.times(force[0], s))))
        if self.held: T[0] = common(T[0], minus(N.times(self.load[0], force[1]), N.times(self.load[1], force[0])))
        for i in range(n):
            self.turn(theta, T, i)
            T[i + 1] = common(T[i + 1], minus(T[i], gain[i]))
        for i in range(n - 1, -1, -1):
            T[i] = common(T[i], plus(T[i + 1], gain[i]))
            self.turn(theta, T, i)
        return force

    def bounded(self, rows, force):
        """Bounds of a force that all rows allow; nothing where no two of them bound it."""
        N = self.numbers
        if not force:
            for (a, b, m), (c, d, p) in combinations(rows, 2):
                det = minus(N.times(a, d), N.times(b, c))
                if zero_in(det): continue
                x = N.over(minus(N.times(m, d), N.times(b, p)), det)
                y = N.over(minus(N.times(a, p), N.times(m, c)), det)
                force = [common(force[0], x), common(force[1], y)] if force else [x, y]
            if not force: return None
        x, y = force
        for a, b, m in rows:
            if not zero_in(a): x = common(x, N.over(minus(m, N.times(b, y)), a))
            if not zero_in(b): y = common(y, N.over(minus(m, N.times(a, x)), b))
        return [x, y]

    def turn(self, theta, T, i):
        """What the moment says of the directions on both sides of joint i."""
        if self.passive[i]: return
        q = plus(self.rest[i], self.numbers.over(T[i], self.k[i]))
        if i == 0: theta[0] = common(theta[0], q)
        else:
            theta[i] = common(theta[i], plus(theta[i - 1], q))
            theta[i - 1] = common(theta[i - 1], minus(theta[i], q))

    def residual(self, theta, force):
        N, before, T = self.numbers, (0, 0), []
        for k, t, rest in zip(self.k, theta, self.rest): T, before = T + [N.times(k, minus(minus(t, before), rest))], t
        T.append((0, 0))
        circles = [N.circle(t) for t in theta]
        pull = [N.times(L, minus(N.times(force[0], s), N.times(force[1], c))) for L, (c, s) in zip(self.L, circles)]
        f = [plus(minus(T[i], T[i + 1]), pull[i]) for i in range(self.n)]
        if self.held: f += [minus(a, p) for a, p in zip(self.end_point(circles), self.load)]
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

    def newton(self, theta, force):
        """One step of Newton's method in intervals: f(x) = f(m) + A (x - m) with A somewhere in A(box)."""
        N, n = self.numbers, self.n
        x = theta + force if self.held else theta
        m = [(middle(a),) * 2 for a in x]
        A = self.derivative(theta, force)
        Y = inverse([[middle(a) for a in row] for row in A], N)
        if not Y: return theta, force
        f, columns = self.residual(m[:n], m[n:] or force), [*zip(*A)]
        for i in range(self.size):
            total, G = N.weighted(Y[i], f), [N.weighted(Y[i], column) for column in columns]
            for j in range(self.size):
                if j != i: total = plus(total, N.times(G[j], minus(x[j], m[j])))
            if not zero_in(G[i]): x[i] = common(x[i], minus(m[i], N.over(total, G[i])))
        return x[:n], x[n:] or force

    def krawczyk(self, m, x):
        """Krawczyk's operator over the box x around m: maps x into its inside where x holds exactly one equilibrium."""
        N, n, force = self.numbers, self.n, self.load
        Y = inverse([[middle(a) for a in row] for row in self.derivative(m[:n], m[n:] or force)], N)
        require(Y, "a ball around a singular point")
        f, columns = self.residual(m[:n], m[n:] or force), [*zip(*self.derivative(x[:n], x[n:] or force))]
        image = []
        for i in range(self.size):
            total = minus(m[i], N.weighted(Y[i], f))
            for j in range(self.size):
                defect = minus((N.one * (i == j),) * 2, N.weighted(Y[i], columns[j]))
                total = plus(total, N.times(defect, minus(x[j], m[j])))
            image.append(total)
        return image

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
