"""Intervals of integers, sine and cosine among them, and what matrices of such intervals certainly are. For the checkers of
certificates beside; needs Python's standard library alone."""
from fractions import Fraction

class Nothing(ValueError):
    """Here is no equilibrium."""
    def __str__(self): return "an equilibrium where none can be"

def common(a, b):
    low, high = max(a[0], b[0]), min(a[1], b[1])
    if low > high: raise Nothing
    return low, high

def plus(a, b): return a[0] + b[0], a[1] + b[1]
def minus(a, b): return a[0] - b[1], a[1] - b[0]
def opposite(a): return -a[1], -a[0]
def zero_in(a): return a[0] <= 0 <= a[1]
def middle(a): return (a[0] + a[1]) >> 1
def width(a): return a[1] - a[0]
def inside(a, b): return b[0] <= a[0] and a[1] <= b[1]
def hull(a, b): return min(a[0], b[0]), max(a[1], b[1])
def magnitude(a): return max(-a[0], a[1])
def sign(a): return 0 if zero_in(a) else 1 if a[0] > 0 else -1
def widened(centres, radii): return [(a[0] - r, a[1] + r) for a, r in zip(centres, radii)]

class Numbers:
    """Intervals (low, high) of integers: from low / 2^bits to high / 2^bits. Every result contains the true one."""
    GUARD = 32

    def __init__(self, bits):
        self.bits, self.one, self.points = bits, 1 << bits, {}
        fine = bits + self.GUARD
        machin = 16 * self.arctan(5, fine) - 4 * self.arctan(239, fine)
        self.quarter, self.slack = machin >> 1, 40 * fine  # pi / 2, and by how much it may be off
        self.pi = self.coarse(2 * self.quarter, 2 * self.slack)

    @staticmethod
    def arctan(m, bits):
        """arctan(1/m); every term is off by less than three units, and there are fewer terms than bits."""
        term, total, k = (1 << bits) // m, 0, 1
        while term: total, term, k = total + (term // k if k % 4 == 1 else -(term // k)), term // (m * m), k + 2
        return total

    def coarse(self, value, error):
        return (value - error) >> self.GUARD, -(-(value + error) >> self.GUARD)

    def multiple(self, a, m):
        return (m * a[0], m * a[1]) if m >= 0 else (m * a[1], m * a[0])

    def of(self, x):
        x = Fraction(x)
        low = (x.numerator << self.bits) // x.denominator
        return low, low + (low * x.denominator != x.numerator << self.bits)

    def times(self, a, b):
        p, q, r, s = a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]
        return min(p, q, r, s) >> self.bits, -(-max(p, q, r, s) >> self.bits)

    def over(self, a, b):
        ends = [(x << self.bits, y) for x in a for y in b]
        return min(x // y for x, y in ends), max(-(-x // y) for x, y in ends)

    def weighted(self, weights, values):
        """The sum of values with exact weights."""
        low = high = 0
        for w, (a, b) in zip(weights, values):
            if w > 0: low, high = low + w * a, high + w * b
            elif w: low, high = low + w * b, high + w * a
        return low >> self.bits, -(-high >> self.bits)

    def point(self, x):
        """Cosine and sine of x / 2^bits by Taylor's series about the nearest quarter turn."""
        if x in self.points: return self.points[x]
        fine, full = self.bits + self.GUARD, x << self.GUARD
        turns = (2 * full + self.quarter) // (2 * self.quarter)
        r = full - turns * self.quarter
        square, sums, k = r * r >> fine, [], 0
        for term, k in ((1 << fine, 0), (r, 1)):
            total = 0
            while term: total, term, k = total + term, -(term * square >> fine) // ((k + 1) * (k + 2)), k + 2
            sums.append(total)
        error = 4 * k + 8 + abs(turns) * self.slack  # at most two units a term, and what is left out is less than the last
        c, s = sums
        for _ in range(turns % 4): c, s = -s, c
        clip = lambda a: (max(a[0], -self.one), min(a[1], self.one))
        if len(self.points) > 500000: self.points.clear()
        self.points[x] = result = clip(self.coarse(c, error)), clip(self.coarse(s, error))
        return result

    def circle(self, a):
        """Cosine and sine of every angle in an interval."""
        if width(a) >= 2 * self.pi[0]: return ((-self.one, self.one),) * 2
        ends = self.point(a[0]), self.point(a[1])
        (cl, ch), (sl, sh) = [(min(p[0], q[0]), max(p[1], q[1])) for p, q in zip(*ends)]
        for turn in range(2 * a[0] // self.pi[0] - 1, 2 * a[1] // self.pi[0] + 2):
            extreme = self.coarse(turn * self.quarter, abs(turn) * self.slack)
            if extreme[1] < a[0] or extreme[0] > a[1]: continue
            if turn % 4 == 0: ch = self.one
            elif turn % 4 == 1: sh = self.one
            elif turn % 4 == 2: cl = -self.one
            else: sl = -self.one
        return (cl, ch), (sl, sh)

def inverse(rows, numbers):
    """Close to the inverse of a matrix of integers; nothing where it is singular. How close need not be known."""
    size, bits = len(rows), numbers.bits
    rows = [row + [numbers.one * (i == j) for j in range(size)] for i, row in enumerate(rows)]
    for k in range(size):
        best = max(range(k, size), key=lambda i: abs(rows[i][k]))
        if not rows[best][k]: return None
        rows[k], rows[best] = rows[best], rows[k]
        pivot = rows[k][k]
        rows[k] = [(x << bits) // pivot for x in rows[k]]
        for i in range(size):
            if i != k and rows[i][k]:
                factor = rows[i][k]
                rows[i] = [x - (factor * y >> bits) for x, y in zip(rows[i], rows[k])]
    return [row[size:] for row in rows]

def negative_eigenvalues(rows, numbers):
    """Of every symmetric matrix within the bounds (Sylvester: elimination does not change their number)."""
    negative = 0
    while rows:
        size = range(len(rows))
        i = max(size, key=lambda i: max(rows[i][i][0], -rows[i][i][1]))
        if zero_in(rows[i][i]):  # then from e_i to e_i + e_j
            i, j = max(((i, j) for i in size for j in size if i != j), default=(0, 0),
                       key=lambda p: max(rows[p[0]][p[1]][0], -rows[p[0]][p[1]][1]))
            rows[i] = [plus(a, b) for a, b in zip(rows[i], rows[j])]
            for row in rows: row[i] = plus(row[i], row[j])
        pivot = rows[i][i]
        if zero_in(pivot): raise ValueError("the number of negative directions stays open")
        negative += pivot[1] < 0
        ratio = [numbers.over(row[i], pivot) for row in rows]
        rows = [[minus(rows[a][b], numbers.times(ratio[a], rows[i][b])) for b in size if b != i] for a in size if a != i]
    return negative
