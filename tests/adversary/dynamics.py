"""Small motion under loads without energy: det(K - F A - x M), x the square of a circular frequency, at every factor F > 0.

The state can change only where x = 0 is a root or two roots meet. Both are roots of integer polynomials in F, which are isolated; the
state between two of them is counted by Sturm's theorem, and at a meeting the rank says whether a motion grows.
"""
from dataclasses import dataclass
from fractions import Fraction

from mpmath import mp

import integers
import polynomials as poly

NARROW = Fraction(1, 10 ** 90)


@dataclass
class Event:
    """A factor in [low, high] at which the state changes, or is another than around it."""
    low: Fraction
    high: Fraction
    before: str  # "stable", "divergence" or "flutter"
    at: str
    above: str


def characteristic(straight, factor):
    """det(K - F A - x M) in x, the constant first; times a positive number where F is no integer."""
    matrix, size = straight.at(factor), straight.size
    values = [integers.determinant(integers.combination(1, matrix, -x, straight.mass)) for x in range(size + 1)]
    return [int(c) for c in poly.interpolated(values)]


def has_masses(straight):
    return integers.determinant(straight.mass) != 0


def state(straight, factor):
    """Of the straight line at a factor that is no event."""
    p = characteristic(straight, factor)
    distinct = poly.square_free(p)
    count = len(distinct) - 1
    if p[0] == 0:
        return "divergence"
    positive = poly.roots_between(distinct, 0, None)
    if positive == count:
        return "stable" if count == straight.size or is_semisimple(straight, factor, distinct) else "flutter"
    bound = 1 + max(abs(Fraction(c, distinct[-1])) for c in distinct)
    return "divergence" if poly.roots_between(distinct, -bound, None) > positive else "flutter"


def is_semisimple(straight, factor, distinct):
    """Whether M^-1 (K - F A) is a root of a polynomial without double roots."""
    columns = [integers.solution(straight.mass, column) for column in integers.transposed(straight.at(factor))]
    matrix, size = integers.transposed(columns), straight.size
    # p is of K - F A times the denominator of F, as the matrix is
    power = [[Fraction(0)] * size for _ in range(size)]
    for c in reversed(distinct):
        power = integers.product(power, matrix)
        for i in range(size):
            power[i][i] += c
    return not any(x for row in power for x in row)


def events_polynomial(straight):
    """Its positive roots are the factors at which a frequency is zero or two meet that are not one at every factor."""
    size = straight.size
    zero = poly.interpolated([integers.determinant(straight.at(f)) for f in range(size + 1)])
    every = [characteristic(straight, f) for f in range(size * (size - 1) + 1)]
    order = 0
    while True:
        meet = poly.interpolated([poly.subresultant(p, poly.derivative(p), order) for p in every])
        if meet:
            break
        order += 1
    (zero, meet), _ = integers.scaled([zero], [meet])
    zero, meet = (poly.square_free(p) for (p,) in (zero, meet))
    shared = [1] if poly.coprime_modulo_prime(zero, meet) else poly.common_divisor(zero, meet)
    meet = poly.quotient(meet, shared)
    return poly.multiplied(zero, meet), zero


def events(straight):
    """All events at F > 0, ascending, and the state at F = 0+; masses everywhere are presumed."""
    if not straight.size or not any(integers.determinant(straight.at(f)) for f in range(straight.size + 1)):
        return [], "divergence" if straight.size else "stable"  # what may move freely at every factor
    polynomial, zero = events_polynomial(straight)
    roots = poly.positive_roots(polynomial)
    if not roots:
        return [], state(straight, Fraction(1))
    ends = [Fraction(0)] + [x for root in roots for x in root] + [2 * roots[-1][1]]
    between = [(a + b) / 2 for a, b in zip(ends[::2], ends[1::2])]
    states = [state(straight, factor) for factor in between]
    result = []
    for root, before, above in zip(roots, states, states[1:]):
        if before == above != "stable":
            continue
        low, high = poly.refined(polynomial, *root, NARROW)
        at = "divergence" if poly.vanishes_between(zero, low, high) else "flutter"
        if before == above and at == "flutter" and not grows_at(straight, (low + high) / 2):
            at = "stable"
        result.append(Event(low, high, before, at, above))
    return result, states[0]


def grows_at(straight, factor):
    """Whether a motion grows, linearly in time, where two frequencies meet: they share one motion then."""
    mp.dps = 90
    roots = sorted(mp.polyroots([mp.mpf(c) for c in reversed(characteristic(straight, factor))], maxsteps=500, extraprec=2000),
                   key=lambda x: abs(x))
    closest = min(range(1, len(roots)), key=lambda i: abs(roots[i] - roots[i - 1]) / abs(roots[i]))
    x = mp.re(roots[closest] + roots[closest - 1]) / 2
    matrix = mp.matrix(straight.at(factor)) - x * mp.matrix(straight.mass)
    values = mp.svd_r(matrix, compute_uv=False)
    return values[straight.size - 2] > mp.mpf(10) ** -20 * values[0]


def first_loss(straight):
    """The first event at which the line is not stable at it or just above; None if there is none. Presumes that it is stable at 0+."""
    found, _ = events(straight)
    return next((e for e in found if "stable" != e.at or "stable" != e.above), None)
