"""Polynomials with integer coefficients, the constant first: their distinct real roots, isolated and counted exactly."""
from fractions import Fraction
from math import comb, gcd

import integers

PRIME = (1 << 61) - 1


def trimmed(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def primitive(p):
    """Divided by the positive common factor of its coefficients."""
    p = trimmed(p)
    common = gcd(*p) or 1
    return [c // common for c in p]


def value(p, x):
    result = 0
    for c in reversed(p):
        result = result * x + c
    return result


def derivative(p):
    return [i * c for i, c in enumerate(p)][1:]


def remainder(p, q):
    """A positive multiple of the remainder of p divided by q."""
    p = list(p)
    while len(p) >= len(q):
        head, lead = p[-1], q[-1]
        shift = len(p) - len(q)
        p = [c * abs(lead) for c in p]
        sign = head if lead > 0 else -head
        for i, c in enumerate(q):
            p[shift + i] -= sign * c
        p = trimmed(p)
    return primitive(p)


def common_divisor(p, q):
    p, q = primitive(p), primitive(q)
    while q:
        p, q = q, remainder(p, q)
    return p


def quotient(p, q):
    """p / q, where that leaves nothing, up to a constant."""
    p, result = [Fraction(c) for c in p], []
    while len(p) >= len(q):
        head = p.pop() / q[-1]
        result.append(head)
        for i in range(1, len(q)):
            p[-i] -= head * q[-1 - i]
    (whole,), _ = integers.scaled([result[::-1]])
    return primitive(whole[0])


def coprime_modulo_prime(p, q):
    """Whether p and q have no common root modulo a prime: then they have none at all (not conversely)."""
    p, q = ([c % PRIME for c in r] for r in (p, q))
    if p[-1] == 0 or q[-1] == 0:
        return False
    while True:
        q = trimmed(q)
        if not q:
            return len(p) == 1
        inverse = pow(q[-1], -1, PRIME)
        while len(p) >= len(q):
            head, shift = p[-1] * inverse % PRIME, len(p) - len(q)
            p = trimmed([c if i < shift else (c - head * q[i - shift]) % PRIME for i, c in enumerate(p)])
        p, q = q, p


def square_free(p):
    p = primitive(p)
    if len(p) < 3 or coprime_modulo_prime(p, derivative(p)):
        return p
    return quotient(p, common_divisor(p, derivative(p)))


def interpolated(values):
    """The polynomial that takes `values` at 0, 1, 2, ...: by Newton's differences."""
    differences, heads = [Fraction(v) for v in values], []
    for k in range(len(values)):
        heads.append(differences[0])
        differences = [(b - a) / (k + 1) for a, b in zip(differences, differences[1:])]
    result = [Fraction(0)]
    for k in reversed(range(len(heads))):
        shifted = [Fraction(0)] + result
        result = [s - k * r for s, r in zip(shifted, result + [Fraction(0)])]
        result[0] += heads[k]
    return trimmed(result)


def subresultant(p, q, order):
    """The principal one of this order: the first that is not zero is that of the degree of the common divisor."""
    n, m = len(p) - 1, len(q) - 1
    width = n + m - 2 * order
    rows = [[0] * i + p[::-1] + [0] * (m + n) for i in range(m - order)] + [[0] * i + q[::-1] + [0] * (m + n) for i in range(n - order)]
    return integers.determinant([row[:width] for row in rows])


def sign_changes(sequence):
    signs = [s > 0 for s in sequence if s]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def roots_between(p, low, high):
    """How many distinct roots lie in (low, high], by Sturm's theorem; None stands for infinity."""
    chain = [primitive(p), primitive(derivative(p))]
    while len(chain[-1]) > 1:
        rest = remainder(chain[-2], chain[-1])
        if not rest:
            break
        chain.append([-c for c in rest])

    def changes(x):
        return sign_changes([q[-1] if x is None else value(q, x) for q in chain if q])
    return changes(low) - changes(high)


def at_shift(p):
    """p(x + 1)."""
    p = list(p)
    for i in range(len(p) - 1):
        for j in range(len(p) - 2, i - 1, -1):
            p[j] += p[j + 1]
    return p


def positive_roots(p):
    """Open intervals, one for each positive root of the square-free p, ascending; a root that is met exactly has low = high.
    By Descartes' rule and bisection (Vincent, Collins, Akritas)."""
    p = trimmed(p)
    while p and p[0] == 0:
        p = p[1:]
    if len(p) < 2:
        return []
    lead = abs(p[-1])
    bound, degree = 1, len(p) - 1
    # each positive root is below 2 max |a_i / a_n|^(1 / (n - i))
    power = max((-(-(abs(c).bit_length() - lead.bit_length() + 1) // (degree - i)) for i, c in enumerate(p[:-1]) if c), default=0) + 1
    bound = Fraction(2) ** power
    (scaled,), _ = integers.scaled([[c * bound ** i for i, c in enumerate(p)]])
    found, open_parts = [], [(primitive(scaled[0]), Fraction(0), bound)]
    while open_parts:
        q, low, width = open_parts.pop()
        if q[0] == 0:
            found.append((low, low))
            q = q[1:]
        changes = sign_changes(at_shift(q[::-1]))
        if changes == 1:
            found.append((low, low + width))
        elif changes > 1:
            half = primitive([c << (len(q) - 1 - i) for i, c in enumerate(q)])
            open_parts += [(half, low, width / 2), (at_shift(half), low + width / 2, width / 2)]
    return [refined(p, *interval, None) for interval in sorted(found)]


def refined(p, low, high, width):
    """The open isolating interval of a square-free p, made narrower than `width` relative to its upper end, and free of roots at its
    ends; with low = high where the root is met."""
    if low == high:
        return low, high
    sign = value(p, high) or -value(derivative(p), high)  # just below `high`
    while value(p, low) == 0 or value(p, high) == 0 or (width is not None and high - low > width * high):
        middle = (low + high) / 2
        at = value(p, middle)
        if at == 0:
            return middle, middle
        if (at > 0) == (sign > 0):
            high = middle
        else:
            low = middle
    return low, high


def multiplied(p, q):
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return result


def vanishes_between(p, low, high):
    """Whether a square-free p has a root in [low, high], which holds one of its roots at most."""
    at_low, at_high = value(p, low), value(p, high)
    return at_low == 0 or at_high == 0 or (at_low > 0) != (at_high > 0)
