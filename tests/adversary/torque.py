"""A torque T at the end point of a straight chain in space, by the virtual work of its moment in the turns about all axes.

To the first order the moment is T (e + share (psi x e)), e along x and psi the turn of the last link: share 0 keeps it along x (axial), 1
turns it with the link (tangential), and half of either is semitangential. An axis is itself turned by what comes before it. A bearing
takes the same moment off link 1, psi being the turn of that link: the two do no work about the axes of joint 1 but by what psi is more.
"""
from fractions import Fraction

import energy
import integers
import polynomials as poly

SHARE = {"axial": Fraction(0), "semitangential": Fraction(1, 2), "tangential": Fraction(1)}


def load_matrix(statement):
    """A_ab = d Q_a / d q_b of T = 1, and Q_a itself at the straight shape, turns in units of 1 / |axis|."""
    axes = [axis for _, axis, _ in energy.turns(statement)]
    borne = len(statement.joints[0]) if statement.bearing else 0
    share = SHARE[next(l.value for l in statement.loads if l.kind == "torque")]
    size = len(axes)
    slope = [[Fraction(0)] * size for _ in range(size)]
    for a, of in enumerate(axes):
        for b, by in enumerate(axes):
            turn = by[1] * of[2] - by[2] * of[1]  # e . (by x of)
            if b < a and a >= borne:
                slope[a][b] += turn
            if not a < borne > b:
                slope[a][b] -= share * turn  # (by x e) . of
    return slope, [axis[0] * (a >= borne) for a, axis in enumerate(axes)]


def pencil(statement):
    """K and A on the permitted motions, as integers with a common factor; and whether T leaves the chain straight."""
    about = energy.expansion(statement)
    slope, force = load_matrix(statement)
    (stiffness, load), _ = integers.scaled(about.hessian(about.springs), slope)
    held = [about.gradient(c) for c in about.constraints]
    (rows, forces), _ = integers.scaled(held, [force])
    basis = integers.null_space(rows, about.size)
    balanced = not any(integers.product(forces, basis)[0])
    return integers.congruent(stiffness, basis), integers.congruent(load, basis), balanced


def first_static(stiffness, load):
    """Bounds of the least T > 0 at which det(K - T A) is zero; None if there is none."""
    size = len(stiffness)
    p = poly.interpolated([integers.determinant(integers.combination(1, stiffness, -t, load)) for t in range(size + 1)])
    p = poly.square_free([int(c) for c in p])
    roots = poly.positive_roots(p)
    return poly.refined(p, *roots[0], Fraction(1, 10 ** 60)) if roots else None
