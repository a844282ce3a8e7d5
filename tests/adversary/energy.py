"""The energy of a structure about a shape, to the second order, from the rotations of its links.

Unknowns are the turns about all axes, in the order of the file, then the base's deflection across and the shift along x of the end
that a spring holds along, where there are such. About the straight shape everything is exact, and a turn is counted in units of
1 / |axis|, so that no root is drawn; about any other shape numbers are doubles, and turns radians.
"""
import math
from dataclasses import dataclass

import series as s


@dataclass
class Expansion:
    """Series about a shape: what holds the structure, what loads it, where it is."""
    size: int
    springs: dict
    work: dict  # of the loads that the factor multiplies
    fixed_work: dict
    constraints: list  # series that stay zero
    nodes: list  # of each node, three series
    directions: list  # of each link, three series

    def gradient(self, term):
        return s.gradient(term, self.size)

    def hessian(self, term):
        return s.hessian(term, self.size)


def turns(statement):
    """(joint, axis, stiffness) of each turn."""
    return [(j, axis, k) for j, joint in enumerate(statement.joints) for axis, k in joint]


def is_spring(value):
    return value not in ("free", "held")


def shifts(statement):
    """Whether the base moves across, and whether an end is sprung along."""
    return statement.base.across != "held", is_spring(statement.base.along) or is_spring(statement.end_point.along)


def unknowns(statement):
    return len(turns(statement)) + sum(shifts(statement))


def rotated(axis, angle, vector):
    """Rodrigues' formula: three series turned about a unit axis."""
    if not angle:
        return vector
    along = s.plus(*(s.times(a, v) for a, v in zip(axis, vector)))
    return [s.plus(s.times(math.cos(angle), v), s.times(math.sin(angle), w), s.times((1 - math.cos(angle)) * a, along))
            for a, v, w in zip(axis, vector, s.cross(axis, vector))]


def turned_a_little(axis, index, vector):
    """v + d a x v + d^2 / 2 a x (a x v), d the unknown of this index."""
    once = s.cross(axis, vector)
    twice = s.cross(axis, once)
    return [s.plus(v, s.product(s.variable(index), w), {(index, index): u[()] / 2} if u.get(()) else {})
            for v, w, u in zip(vector, once, twice)]


def directions_of(statement, shape):
    """e along x, turned for each link about all axes from its own joint's last to joint 1's first."""
    every, result = turns(statement), []
    for link in range(statement.links):
        vector = [s.constant(1), {}, {}]
        for index in reversed(range(len(every))):
            joint, axis, _ = every[index]
            if joint > link:
                continue
            if shape is not None:
                norm = math.sqrt(sum(float(a) ** 2 for a in axis))
                axis = [float(a) / norm for a in axis]
                vector = rotated(axis, shape[index], vector)
            # a turn and a little more of it are about one axis: either may come first
            vector = turned_a_little(axis, index, vector)
        result.append(vector)
    return result


def nodes_of(statement, shape, directions, real):
    count = len(turns(statement))
    across, along = shifts(statement)
    base = [{}, {}, {}]
    if across:
        base[1] = s.plus(s.variable(count), s.constant(shape[count]) if shape is not None else {})
    nodes = [base]
    for length, direction in zip(statement.lengths, directions):
        nodes.append([s.plus(p, s.times(real(length), t)) for p, t in zip(nodes[-1], direction)])
    shift = {}
    if along:
        shift = s.plus(s.variable(count + across), s.constant(shape[count + across]) if shape is not None else {})
    if statement.base.along == "free":  # x is measured from the end that is held along
        shift = s.plus(shift, s.constant(real(sum(statement.lengths))), s.times(-1, nodes[-1][0]))
    return [[s.plus(x, shift), y, z] for x, y, z in nodes], shift


def angle_of_last(statement, shape):
    """The sum of all joint angles of a chain in the plane."""
    count = len(turns(statement))
    here = sum(shape[:count]) if shape is not None else 0
    return s.plus(s.constant(here), *(s.variable(i) for i in range(count)))


def springs_of(statement, shape, nodes, shift, slack, real):
    """Energy of all springs."""
    energy = []
    for index, (joint, axis, stiffness) in enumerate(turns(statement)):
        if shape is None:
            deflection, stiffness = s.variable(index), stiffness * sum(a * a for a in axis)
        else:
            deflection = s.plus(s.variable(index), s.constant(shape[index] - float(statement.rest[joint])))
        energy.append(s.times(real(stiffness) / 2, s.square(deflection)))
    for node, stiffness in across_springs(statement):
        for axis in (1, 2) if statement.space else (1,):
            deflection = s.plus(nodes[node][axis], s.constant(-slack[node][axis]))
            energy.append(s.times(real(stiffness) / 2, s.square(deflection)))
    if is_spring(statement.end_point.turn):
        deflection = s.plus(angle_of_last(statement, shape), s.constant(-real(sum(statement.rest))))
        energy.append(s.times(real(statement.end_point.turn) / 2, s.square(deflection)))
    for end in (statement.base, statement.end_point):
        if is_spring(end.along):
            moved = shift if end is statement.base else s.plus(nodes[-1][0], s.constant(-slack[-1][0]))
            energy.append(s.times(real(end.along) / 2, s.square(moved)))
    return s.plus(*energy)


def across_springs(statement):
    """(node, stiffness) of all springs across the chain, the bed's among them."""
    ends = [(0, statement.base.across), (statement.links, statement.end_point.across)]
    result = [(node, k) for node, k in ends + sorted(statement.supports.items()) if is_spring(k)]
    return result + [(node, statement.bed(node)) for node in range(statement.links + 1) if statement.foundation]


def constraints_of(statement, shape, nodes, directions, slack):
    plane = (1, 2) if statement.space else (1,)
    held = [node for node, how in sorted(statement.supports.items()) if how == "held"]
    held += [statement.links] * (statement.end_point.across == "held")
    result = [s.plus(nodes[node][axis], s.constant(-slack[node][axis])) for node in held for axis in plane]
    if statement.end_point.turn == "held":
        if statement.space:
            result += [directions[-1][1], directions[-1][2]]
        else:
            result.append(s.plus(angle_of_last(statement, shape), s.constant(-sum(statement.rest))))
    if statement.base.turn == "held":
        result += [s.plus(s.variable(i), s.constant(shape[i] if shape is not None else 0))
                   for i, (joint, _, _) in enumerate(turns(statement)) if joint == 0]
    return result


def works_of(statement, shape, nodes, real):
    """Work of the dead loads: of those that the factor multiplies, and of the fixed ones."""
    works = {False: [], True: []}
    for load in statement.loads:
        if load.kind == "force":
            works[load.fixed] += [s.times(real(c), p) for c, p in zip(load.value, nodes[load.node])]
        elif load.kind == "moment":
            works[load.fixed].append(s.times(real(load.value), angle_of_last(statement, shape)))
    return s.plus(*works[False]), s.plus(*works[True])


def expansion(statement, shape=None):
    """About the straight shape, exactly; or about `shape`, a value for each unknown, in doubles."""
    real = (lambda x: x) if shape is None else float
    directions = directions_of(statement, shape)
    nodes, shift = nodes_of(statement, shape, directions, real)
    slack = slack_places(statement, real)
    springs = springs_of(statement, shape, nodes, shift, slack, real)
    work, fixed_work = works_of(statement, shape, nodes, real)
    constraints = constraints_of(statement, shape, nodes, directions, slack)
    return Expansion(unknowns(statement), springs, work, fixed_work, constraints, nodes, directions)


def slack_places(statement, real):
    """Where the nodes of the unloaded structure are."""
    if not any(statement.rest):
        places = [0]
        for length in statement.lengths:
            places.append(places[-1] + length)
        return [[real(x), 0, 0] for x in places]
    x, y, angle = 0.0, 0.0, 0.0
    places = [[x, y, 0]]
    for length, rest in zip(statement.lengths, statement.rest):
        angle += float(rest)
        x, y = x + float(length) * math.cos(angle), y + float(length) * math.sin(angle)
        places.append([x, y, 0])
    return places
