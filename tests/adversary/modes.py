"""Critical factors of dead loads, by exact counts of negative eigenvalues of K - F G, and the shapes that belong to them."""
import math
from fractions import Fraction

import numpy

import bent
import energy
import integers
from decimals import interval

NARROW = Fraction(1, 10 ** 60)
SMALLEST = 1e-30  # below this a force is none
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
    """Turns about all axes, in radians, that span the shapes at a critical factor: columns. And of each the force across that its end
    point exerts on what holds it there; None where what is held repeats itself, or the end point is free across."""
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
    shapes = numpy.array([[float(Fraction(x) / big) * norm for x, big in zip(row, largest)] for row, norm in zip(whole, norms)])
    return shapes, lateral_forces(straight, statement, factor, whole, largest)


def lateral_forces(straight, statement, factor, whole, largest):
    stiffness, load, held = straight.whole
    if statement.end_point.across != "held" or statement.space or len(integers.echelon(integers.scaled(held)[0][0])[1]) < len(held):
        return None
    pulls = integers.product(integers.combination(1, stiffness, -factor, load), whole)
    (rows,), times = integers.scaled(held)
    square = integers.product(rows, integers.transposed(rows))
    (right,), finer = integers.scaled(integers.product(rows, pulls))
    ends = [integers.solution(square, column)[bent.end_row(statement)] for column in integers.transposed(right)]
    return numpy.array([-float(end * times / (finer * big)) for end, big in zip(ends, largest)])


def fault_of_shape(turns, lateral, space, forces):
    """Whether printed turns lie in the span of the columns, and the lateral force is theirs."""
    turns = numpy.array(turns)
    part = numpy.linalg.lstsq(space, turns, rcond=1e-14)[0]
    if numpy.max(abs(turns)) == 0 or numpy.max(abs(turns - space @ part)) > CLOSE * numpy.max(abs(turns)):
        return "no shape"
    if lateral is None or forces is None:
        return ""
    force, scale = forces @ part, max(abs(forces) @ abs(part), numpy.max(abs(turns)) * SMALLEST)
    return "" if abs(float(lateral) - force) <= 1e-6 * scale else f"lateral force {lateral} for {force}"


def faults(straight, statement, printed, random):
    """Of printed modes, (number, factor as text, turns, lateral force): what is wrong, and how many factors and shapes were held against
    the truth."""
    result, total = [], count(straight)
    if [mode for mode, *_ in printed] != list(range(1, total + 1)):
        result.append(f"modes {[mode for mode, *_ in printed]} for {total}")
    right = 0
    for mode, text, turns, lateral in printed:
        low, high = interval(text)
        if mode > total or not lies_at(straight, mode, low, high):
            result.append(f"mode {mode} is not {text}")
            continue
        right += 1
        factor, exact = refined(straight, mode, low, high)
        below = straight.negatives(factor)[0]
        above = sum(straight.negatives(factor * (1 + 2 * NARROW)))
        fault = fault_of_shape(turns, lateral, *space_of_shapes(straight, statement, factor, exact, above - below, random))
        if fault:
            result.append(f"mode {mode} at {text}: {fault}")
    return result, right
