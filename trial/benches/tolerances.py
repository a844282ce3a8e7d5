"""Manufacturing tolerances at every joint or link, which imitate small effects (docs/effects.md)."""
from itertools import combinations, product

import numpy as np
from scipy.optimize import least_squares

from catalogue import ROWS, key

# Rows of tolerances, effects of single joints or links that they contain, others that they contain, and the tolerances.
TOLERANCES = (("stiffness_spread", "joint_stiffness", "stiffness_scale", 0.1), ("length_spread", "link_length", "length_scale", 0.01),
              ("rest_spread", "rest_angle", "rest_offset", 0.02), ("play", "backlash", "", 0.02))
TOGETHER = ("stiffness_spread", "length_spread", "rest_spread")  # they count as one cause
MOST = 2.0  # tolerances: a value beyond is none
WEAK = 0.2  # standard deviations of all readings together that a value of one tolerance costs a fit
HOPELESS = 0.4  # of a change that a linear forecast of tolerances may leave


def within_tolerance(bench, row, x):
    """The row of tolerances that contains an effect of this size; nothing where there is none."""
    if bench.size > 1:
        for id, single, common, tolerance in TOLERANCES:
            if row.id in (single, common) and abs(x[0]) <= MOST * tolerance:
                return id
    return None


def with_others(keys):
    """The keys, and them with further tolerances of those that are tried together."""
    others = [id for id in TOGETHER if id not in keys]
    return {tuple(sorted({*keys, *extra})) for n in range(len(others) + 1) for extra in combinations(others, n)}


def with_tolerances(bench, fit):
    """A fit's keys, and those with some or all of its effects as tolerances."""
    choices = [[key(*row), within_tolerance(bench, row[0], x)] for row, x in zip(fit.rows, fit.values)]
    found = set()
    for picks in product(*([one for one in choice if one] for choice in choices)):
        found |= with_others(picks) if any(pick in TOGETHER for pick in picks) else {tuple(sorted(set(picks)))}
    return found


def row_of_each(id):
    return next(row for row in ROWS if row.id == id)


def imitating_tolerances(readings, change, known, enough):
    """Keys of tolerances that, beside a known fit or nothing, leave less than enough of a change with values within their bounds."""
    bench = readings.bench
    if bench.alone or bench.size < 2:
        return set()
    found = set()
    for ids in [(id,) for id in TOGETHER] + [TOGETHER]:
        kinds = [(row_of_each(single), tolerance) for id, single, _, tolerance in TOLERANCES if id in ids]
        rows = [(row, j) for row, _ in kinds for j in range(bench.size)]
        sizes = np.array([tolerance for _, tolerance in kinds for _ in range(bench.size)])

        def model(u):
            return readings.of_rows([*known.rows, *rows], [*known.values, *([v] for v in u * sizes)])
        start = np.zeros(len(rows))
        base, h = model(start), 0.05
        columns = np.stack([(model(h * e) - base) / h for e in np.eye(len(rows))], axis=1)
        rest = change - base
        best = np.linalg.lstsq(np.vstack([columns, WEAK * np.eye(len(rows))]), np.concatenate([rest, start]), rcond=None)[0]
        if np.linalg.norm(rest - columns @ best) > HOPELESS * np.linalg.norm(rest) or np.max(np.abs(best)) > 2 * MOST:
            continue
        u = least_squares(lambda v: np.concatenate([model(v) - change, WEAK * v]), best, max_nfev=6).x
        if np.max(np.abs(u)) <= MOST and np.linalg.norm(model(u) - change) < enough:
            found |= with_others([key(*row) for row in known.rows] + list(ids))
    return found
