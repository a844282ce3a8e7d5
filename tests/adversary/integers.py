"""Exact linear algebra on integers: determinants, ranks and signs without a rounding.

A matrix is a list of rows. Elimination is Bareiss's: every entry stays a minor of the matrix it began with, so that no fraction
arises and no number grows beyond such a minor.
"""
from fractions import Fraction
from math import gcd, lcm


def scaled(*matrices):
    """The matrices times one positive number, the smallest that makes all their entries integers; and that number."""
    factor = lcm(*(Fraction(x).denominator for matrix in matrices for row in matrix for x in row), 1)
    return [[[int(x * factor) for x in row] for row in matrix] for matrix in matrices], factor


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def product(left, right):
    columns = transposed(right)
    return [[sum(a * b for a, b in zip(row, column)) for column in columns] for row in left]


def congruent(matrix, basis):
    """B^T A B, the form A on the columns of B."""
    return product(transposed(basis), product(matrix, basis))


def combination(a, left, b, right):
    """a L + b R."""
    return [[a * x + b * y for x, y in zip(*rows)] for rows in zip(left, right)]


def determinant(matrix):
    rows, sign, before = [list(row) for row in matrix], 1, 1
    for k in range(len(rows)):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            rows[k], rows[pivot], sign = rows[pivot], rows[k], -sign
        for row in rows[k + 1:]:
            head = row[k]
            for j in range(k + 1, len(rows)):
                row[j] = (row[j] * rows[k][k] - head * rows[k][j]) // before
        before = rows[k][k]
    return sign * before if rows else 1


def inertia(symmetric):
    """How many negative, zero and positive eigenvalues a symmetric matrix has: the signs of a congruent diagonal (Sylvester)."""
    rows, before, negative, positive = [list(row) for row in symmetric], 1, 0, 0
    while rows:
        size = len(rows)
        pivot = next((i for i in range(size) if rows[i][i]), None)
        if pivot is None:
            pair = next(((i, j) for i in range(size) for j in range(i) if rows[i][j]), None)
            if pair is None:
                break
            pivot, other = pair  # x_j becomes x_i + x_j: the diagonal gets 2 a_ij, which is not zero
            rows[pivot] = [a + b for a, b in zip(rows[pivot], rows[other])]
            for row in rows:
                row[pivot] += row[other]
        value, line = rows[pivot][pivot], rows[pivot]
        if (value > 0) == (before > 0):
            positive += 1
        else:
            negative += 1
        rest = [i for i in range(size) if i != pivot]
        rows = [[(rows[i][j] * value - line[i] * line[j]) // before for j in rest] for i in rest]
        before = value
    return negative, len(rows), positive


def echelon(matrix):
    """The reduced echelon form, each row divided by its common factor, and the columns of the pivots."""
    rows, pivots = [list(row) for row in matrix], []
    for column in range(len(rows[0]) if rows else 0):
        at = len(pivots)
        pivot = next((i for i in range(at, len(rows)) if rows[i][column]), None)
        if pivot is None:
            continue
        rows[at], rows[pivot] = rows[pivot], rows[at]
        head = rows[at]
        for i, row in enumerate(rows):
            if i != at and row[column]:
                row = [a * head[column] - b * row[column] for a, b in zip(row, head)]
                common = gcd(*row) or 1
                rows[i] = [a // common for a in row]
        pivots.append(column)
    return rows[:len(pivots)], pivots


def null_space(matrix, size):
    """Columns that span what `matrix` sends to zero, as a matrix of `size` rows."""
    rows, pivots = echelon(matrix)
    columns = []
    for free in (j for j in range(size) if j not in pivots):
        scale = lcm(*(rows[i][p] for i, p in enumerate(pivots)), 1)
        column = [0] * size
        column[free] = scale
        for i, p in enumerate(pivots):
            column[p] = -scale // rows[i][p] * rows[i][free]
        columns.append(column)
    return transposed(columns) if columns else [[] for _ in range(size)]


def solution(matrix, right):
    """x with A x = b, of fractions; None where A is singular."""
    size = len(matrix)
    rows, pivots = echelon([row + [b] for row, b in zip(matrix, right)])
    if pivots != list(range(size)):
        return None
    return [Fraction(rows[i][size], rows[i][i]) for i in range(size)]
