"""Critical factors of dead loads, by exact counts of negative eigenvalues of K - F G, and the shapes that belong to them."""
import math
from fractions import Fraction

import numpy

import energy
import integers
from decimals import interval

NARROW = Fraction(1, 10 ** 60)
CLOSE = 1e-9  # of a printed shape, of which some ten figures are right


def count(straight):
    """How many positive critical factors there are, where K is positive definite."""
    return integers.inertia(straight.load)[2]


def is_stable_unloaded(straight):
    return straight.negatives(0) == (0, 0)


def lies_at(straight, mode, low, high):
    """Whether the critical factor of this number, from 1, is in [low, high]."""
    below, _ = straight.negatives(low)
    above, at = straight.negatives(high)
    return below < mode <= above + at


def refined(straight, mode, low, high):
    """A factor below the critical one by a share of 1e-60 at most, from an interval that holds it."""
    while high - low > NARROW * high:
        middle = (low + high) / 2
        negative, zero = straight.negatives(middle)
        if negative < mode <= negative + zero:
            return middle, True
        low, high = (low, middle) if negative >= mode else (middle, high)
    return low, False


def space_of_shapes(straight, statement, factor, exact, multiplicity, random):
    """Turns about all axes, in radians, that span the shapes at a critical factor: columns."""
    matrix = straight.at(factor)
    if exact:
        within = integers.null_space(matrix, straight.size)
    else:
        columns = []
        for _ in range(multiplicity):
            start = [[random.randint(-99, 99)] for _ in range(straight.size)]
            column = integers.solution(matrix, [row[0] for row in integers.product(straight.load, start)])
            largest = max(abs(x) for x in column)
            columns.append([x / largest for x in column])
        within = integers.transposed(columns)
    whole = integers.product(straight.basis, within)
    norms = [math.sqrt(sum(float(a) ** 2 for a in axis)) for _, axis, _ in energy.turns(statement)]
    largest = [max(abs(x) for x in column[:len(norms)]) or 1 for column in integers.transposed(whole)]
    return numpy.array([[float(Fraction(x) / big) * norm for x, big in zip(row, largest)] for row, norm in zip(whole, norms)])


def is_shape(turns, space):
    """Whether printed turns lie in the span of the columns."""
    turns = numpy.array(turns)
    part = numpy.linalg.lstsq(space, turns, rcond=1e-14)[0]
    return bool(numpy.max(abs(turns - space @ part)) <= CLOSE * numpy.max(abs(turns))) and bool(numpy.max(abs(turns)) > 0)


def faults(straight, statement, printed, random):
    """Of printed modes, (number, factor as text, turns): what is wrong, and how many factors and shapes were held against the truth."""
    result, total = [], count(straight)
    if [mode for mode, _, _ in printed] != list(range(1, total + 1)):
        result.append(f"modes {[mode for mode, _, _ in printed]} for {total}")
    right = 0
    for mode, text, turns in printed:
        low, high = interval(text)
        if mode > total or not lies_at(straight, mode, low, high):
            result.append(f"mode {mode} is not {text}")
            continue
        right += 1
        factor, exact = refined(straight, mode, low, high)
        below = straight.negatives(factor)[0]
        above = sum(straight.negatives(factor * (1 + 2 * NARROW)))
        space = space_of_shapes(straight, statement, factor, exact, above - below, random)
        if not is_shape(turns, space):
            result.append(f"mode {mode}: no shape at {text}")
    return result, right
