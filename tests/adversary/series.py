"""Polynomials in small displacements, cut off beyond the second order: what a second variation is made of.

A series is a dictionary from the indices of its factors, () or (i,) or (i, j) with i <= j, to a coefficient of any number type.
"""


def constant(value):
    return {(): value} if value else {}


def variable(index, coefficient=1):
    return {(index,): coefficient}


def plus(*terms):
    result = {}
    for term in terms:
        for key, value in term.items():
            result[key] = result.get(key, 0) + value
    return result


def times(factor, term):
    return {key: factor * value for key, value in term.items()} if factor else {}


def product(left, right):
    result = {}
    for a, x in left.items():
        for b, y in right.items():
            if len(a) + len(b) <= 2:
                key = a + b if len(a) < 1 or len(b) < 1 or a[0] <= b[0] else b + a
                result[key] = result.get(key, 0) + x * y
    return result


def square(term):
    return product(term, term)


def cross(vector, terms):
    """vector x terms, of a constant vector and three series."""
    (a, b, c), (x, y, z) = vector, terms
    return [plus(times(b, z), times(-c, y)), plus(times(c, x), times(-a, z)), plus(times(a, y), times(-b, x))]


def gradient(term, size):
    return [term.get((i,), 0) for i in range(size)]


def hessian(term, size):
    return [[term.get((min(i, j), max(i, j)), 0) * (2 if i == j else 1) for j in range(size)] for i in range(size)]
