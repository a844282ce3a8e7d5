"""Printed points of paths and censuses: shape, place of the end point, energy and stability at a factor."""
import numpy

import bent
import energy

SMALL = 1e-6  # of forces and lengths: what a point printed in double precision may be off
NEARLY_ZERO = 1e-6  # eigenvalues below this share of the largest stiffness have no sign that doubles can tell


def whole_shape(statement, turns, end_point):
    """All unknowns: what the base and a sprung end have moved follows from where the end point is."""
    across, along = energy.shifts(statement)
    shape = list(turns) + [0.0] * (across + along)
    if across or along:
        place = bent.found(statement, shape, 0).end_point
        if across:
            shape[len(turns)] = end_point[1] - place[1]
        if along:
            shape[-1] = end_point[0] - place[0]
    return shape


def reach(statement):
    return float(sum(statement.lengths))


def fault(statement, point, stable=None, at_event=False):
    """As `fault_of`, but for singular shapes of the constraints, where nothing is judged."""
    result = fault_of(statement, point, stable, at_event)
    return "" if result and bent.is_singular(statement, whole_shape(statement, point["q"], point["end_point"])) else result


def fault_of(statement, point, stable, at_event):
    """Why a point is not what it is said to be; empty if it is. `stable` is what a certified type says; at an event
    stability changes, and is not asked for."""
    shape = whole_shape(statement, point["q"], point["end_point"])
    about = bent.found(statement, shape, point["factor"])
    if about.off > SMALL * reach(statement):
        return f"off what holds it by {about.off:.1e}"
    if max(abs(a - b) for a, b in zip(about.end_point[:2], point["end_point"][:2])) > SMALL * reach(statement):
        return f"end point {point['end_point']} for {about.end_point}"
    if about.residual > SMALL:
        return f"no equilibrium: residual {about.residual:.1e}"
    if "energy" in point and abs(point["energy"] - about.energy) > SMALL * scale_of_energy(about, point):
        return f"energy {point['energy']} for {about.energy}"
    return "" if at_event else fault_of_index(about, point, stable)


def fault_of_index(about, point, stable):
    unsure = numpy.sum(abs(about.eigenvalues) < NEARLY_ZERO * about.scale)
    negative = int(numpy.sum(about.eigenvalues < -NEARLY_ZERO * about.scale))
    said = point.get("negative_directions")
    if said is not None and not negative <= said <= negative + unsure:
        return f"{said} negative directions for {negative}"
    if stable is not None and not unsure and stable != (negative == 0):
        return f"called {'stable' if stable else 'unstable'} with {negative} negative directions"
    return ""


def scale_of_energy(about, point):
    return max(1e-3 * about.scale, abs(point["energy"]))


def is_regular(statement, shape, factor, largest_force):
    """Whether an equilibrium stands alone, and the force that holds its end point across is below the largest."""
    about = bent.found(statement, list(shape), factor)
    alone = numpy.min(abs(about.eigenvalues), initial=numpy.inf) > 1e-4 * about.scale
    return bool(alone) and abs(about.force_across) < largest_force * (1 - 1e-9) + 1e-9
