"""Bent shapes under given loads: whether one is an equilibrium, its energy and how many ways lead down from it."""
from dataclasses import dataclass

import numpy
import scipy.linalg

import energy

FREE = 1e-9  # singular values of constraints below this share of the largest are none


@dataclass
class Found:
    """About a shape."""
    residual: float  # of the forces on the permitted motions, relative to the largest that is added up, and to those of a turn by 1
    off: float  # how far constraints are from held, lengths taken as one
    energy: float
    eigenvalues: numpy.ndarray  # of the second variation on the permitted motions
    scale: float  # of its entries
    end_point: tuple
    force_across: float  # that holds the end point


def held(about):
    rows = numpy.array([about.gradient(c) for c in about.constraints], dtype=float).reshape(-1, about.size)
    return rows, numpy.array([c.get((), 0.0) for c in about.constraints], dtype=float)


def motions(rows, size):
    """An orthonormal basis of what `rows` permits."""
    if not len(rows):
        return numpy.eye(size)
    _, values, right = numpy.linalg.svd(rows)
    return right[int(numpy.sum(values > FREE * max(values[0], 1e-300))):].T


def array(about, what, term):
    return numpy.array(what(term), dtype=float)


def found(statement, shape, factor):
    about = energy.expansion(statement, [float(q) for q in shape])
    pulls = [array(about, about.gradient, t) for t in (about.springs, about.work, about.fixed_work)]
    force = pulls[0] - factor * pulls[1] - pulls[2]
    rows, off = held(about)
    basis = motions(rows, about.size)
    multipliers = numpy.linalg.lstsq(rows.T, force, rcond=None)[0] if len(rows) else numpy.zeros(0)
    second = (array(about, about.hessian, about.springs) - factor * array(about, about.hessian, about.work)
              - array(about, about.hessian, about.fixed_work))
    for multiplier, constraint in zip(multipliers, about.constraints):
        second = second - multiplier * array(about, about.hessian, constraint)
    scale = max(float(numpy.max(abs(p), initial=1e-300)) for p in (pulls[0], factor * pulls[1], pulls[2], second))
    across = float(multipliers[end_row(statement)]) if statement.end_point.across == "held" else 0.0
    value = about.springs.get((), 0.0) - factor * about.work.get((), 0.0) - about.fixed_work.get((), 0.0)
    return Found(float(numpy.linalg.norm(basis.T @ force)) / scale if basis.size else 0.0, float(max(abs(off), default=0.0)), float(value),
                 scipy.linalg.eigvalsh(basis.T @ second @ basis) if basis.size else numpy.zeros(0), float(numpy.max(abs(second), initial=1e-300)),
                 tuple(float(c.get((), 0.0)) for c in about.nodes[-1]), across)


def end_row(statement):
    """Which constraint holds the end point across: after those of the supports."""
    return sum(how == "held" for how in statement.supports.values()) * (2 if statement.space else 1)


def why_singular(statement):
    """That no small motion tells whether the straight line is stable; in the plane constraints are dependent at every shape or at none."""
    singular = statement.space and is_singular(statement, [0.0] * energy.unknowns(statement))
    return "a line at which alone constraints are dependent" if singular else ""


def rank(rows):
    values = numpy.linalg.svd(rows, compute_uv=False) if len(rows) else numpy.zeros(0)
    return int(numpy.sum(values > 1e-7 * max(values, default=0.0)))


def is_singular(statement, shape, step=1e-2):
    """Whether more constraints are independent beside a shape, on what they permit, than at it: no multipliers need exist there, and no
    second variation tells what is stable."""
    shape = numpy.array(shape, dtype=float)
    rows, _ = held(energy.expansion(statement, list(shape)))
    here, basis = rank(rows), motions(rows, len(shape))
    if here == len(rows) or not basis.size:
        return False
    beside = shape + step * basis @ numpy.cos(numpy.arange(1, basis.shape[1] + 1))  # some motion among those permitted
    for _ in range(8):
        rows, off = held(energy.expansion(statement, list(beside)))
        beside = beside - numpy.linalg.pinv(rows, rcond=1e-6) @ off
    return rank(rows) > here
