"""The straight structure and its small motion, exactly: K - F A of springs and loads, masses, and the motions that the ends permit."""
from dataclasses import dataclass
from fractions import Fraction

import energy
import integers


@dataclass
class Straight:
    """Integer matrices on the permitted motions. K and A have one common factor; M is up to a factor."""
    stiffness: list
    load: list
    mass: list
    basis: list  # of each permitted motion a column of all unknowns
    whole: tuple  # K and A on all unknowns, unscaled, and the rows of what is held
    balanced: bool  # whether the straight line is an equilibrium at every factor
    symmetric: bool

    @property
    def size(self):
        return len(self.stiffness)

    def at(self, factor):
        """K - F A, times a positive number."""
        factor = Fraction(factor)
        return integers.combination(factor.denominator, self.stiffness, -factor.numerator, self.load)

    def negatives(self, factor):
        """Negative and zero eigenvalues of K - F A."""
        return integers.inertia(self.at(factor))[:2]


def follower_terms(statement, about, fixed):
    """Generalised forces of the followers, -P t_j . dr_j / dq: at the straight shape, and their derivatives."""
    size = about.size
    force, slope = [Fraction(0)] * size, [[Fraction(0)] * size for _ in range(size)]
    for load in (l for l in statement.loads if l.kind == "follower" and l.fixed == fixed):
        for place, direction in zip(about.nodes[load.node], about.directions[load.node - 1]):
            towards, moved, bent = direction.get((), 0), about.gradient(place), about.hessian(place)
            leans = about.gradient(direction)
            for a in range(size):
                force[a] -= load.value * towards * moved[a]
                for b in range(size):
                    slope[a][b] -= load.value * (towards * bent[a][b] + leans[b] * moved[a])
    return force, slope


def masses_of(statement, about):
    """Of the motion across."""
    result = [[Fraction(0)] * about.size for _ in range(about.size)]
    for mass, node in zip(statement.masses, about.nodes):
        for place in node[1:]:
            moved = about.gradient(place)
            for a in range(about.size):
                for b in range(about.size):
                    result[a][b] += mass * moved[a] * moved[b]
    return result


def straight(statement, twists=True):
    """Turns about the chain's own line are motions too, but for critical factors, in which docs/ends-and-loads.md leaves them out."""
    about = energy.expansion(statement)
    forces, slopes = {}, {}
    for fixed, work in ((False, about.work), (True, about.fixed_work)):
        force, slope = follower_terms(statement, about, fixed)
        forces[fixed] = [f + g for f, g in zip(force, about.gradient(work))]
        slopes[fixed] = integers.combination(1, slope, 1, about.hessian(work))
    whole = (integers.combination(1, about.hessian(about.springs), -1, slopes[True]), slopes[False])
    (stiffness, load), _ = integers.scaled(*whole)
    (mass,), _ = integers.scaled(masses_of(statement, about))
    held = [about.gradient(c) for c in about.constraints]
    if energy.shifts(statement)[1]:  # moving along the chain as one changes nothing across it
        held.append([Fraction(i == about.size - 1) for i in range(about.size)])
    if not twists:
        twisting = [turn for turn, (_, axis, _) in enumerate(energy.turns(statement)) if not any(axis[1:])]
        held += [[Fraction(i == turn) for i in range(about.size)] for turn in twisting]
    (rows,), _ = integers.scaled(held)
    basis = integers.null_space(rows, about.size)
    (reactions,), _ = integers.scaled(list(forces.values()))
    balanced = not any(x for row in integers.product(reactions, basis) for x in row)
    stiffness, load, mass = (integers.congruent(m, basis) for m in (stiffness, load, mass))
    symmetric = not any(l.kind == "follower" for l in statement.loads)
    return Straight(stiffness, load, mass, basis, (*whole, held), balanced, symmetric)
