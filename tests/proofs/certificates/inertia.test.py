"""How the checkers count the directions in which an energy falls, on small matrices of integers, many of them with zeros on
the diagonal: compared with the signs of the roots of the characteristic polynomial.

usage: inertia.test.py PROOFS
"""
import sys
from fractions import Fraction
from random import Random

sys.path.insert(0, sys.argv[1])
from check_structures import inertia  # noqa: E402
from exact_intervals import Numbers, negative_eigenvalues  # noqa: E402


def characteristic(matrix):
    """Its coefficients from the highest power on, by Faddeev and Le Verrier: of integers they are integers."""
    size = len(matrix)
    coefficients, product = [1], [[0] * size for _ in matrix]
    for k in range(1, size + 1):
        for i in range(size):
            product[i][i] += coefficients[-1]
        product = [[sum(a * b for a, b in zip(row, column)) for column in zip(*product)] for row in matrix]
        coefficients.append(-sum(product[i][i] for i in range(size)) // k)
    return coefficients


def changes(coefficients):
    """Of sign: all roots are real, so that Descartes' rule counts those that are positive."""
    signs = [c > 0 for c in coefficients if c]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def random_matrix(random, size):
    matrix = [[0] * size for _ in range(size)]
    for i in range(size):
        for j in range(i):
            matrix[i][j] = matrix[j][i] = random.choice((-2, -1, 0, 0, 1, 3))
        matrix[i][i] = random.choice((-1, 0, 0, 1, 2))
    return matrix


def main():
    random, numbers, singular = Random(1), Numbers(200), 0
    for trial in range(2000):
        matrix = random_matrix(random, 1 + trial % 6)
        polynomial = characteristic(matrix)
        positive = changes(polynomial)
        negative = changes([c if power % 2 == 0 else -c for power, c in enumerate(reversed(polynomial))])
        rows = [{j: Fraction(x) for j, x in enumerate(row) if x} for row in matrix]
        assert inertia(rows) == (negative, positive), matrix
        intervals = [[numbers.of(x) for x in row] for row in matrix]
        try:
            found = negative_eigenvalues(intervals, numbers)
        except (ValueError, ZeroDivisionError):
            found = None
        if polynomial[-1] == 0:
            singular += 1
            assert found is None, matrix
        else:
            assert found == negative, matrix
    assert 100 < singular < 1900
    print("2000 matrices")


if __name__ == "__main__":
    main()
