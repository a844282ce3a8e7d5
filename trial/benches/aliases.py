"""Rows of the catalogue that nobody could tell from a planted cause at these readings: their best fit leaves less than the noise can show."""
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from catalogue import CONTAINS, key, rows_at
from noise import Noise
from statics import clean_readings
from tolerances import imitating_tolerances, with_tolerances
from truth import Truth

UNTOLD = 2.0  # standard deviations of all readings together: two nats of likelihood
NEAR = 0.6  # of the change that a start may leave, scaled, for a fit to be tried
NEAR_BESIDE = 0.9  # the same of a second row, of what the first leaves
FIRST = 3  # rows that are extended by every other, where two effects or a cause outside the catalogue are planted
EVALUATIONS = 25


@dataclass
class Fit:
    rows: tuple  # (row, place)
    values: list  # by row
    left: float  # standard deviations of all readings together

    @property
    def keys(self):
        return [key(row, place) for row, place in self.rows]


class Readings:
    """Changes of a bench's readings by rows, in independent standard deviations of the noise."""

    def __init__(self, bench, noise=Noise()):
        self.bench, self.noise = bench, noise
        self.nominal = clean_readings(bench, Truth.none(bench.size))

    def of(self, truth):
        return np.concatenate([self.noise.told(self.bench, nominal, read - nominal).ravel()
                               for nominal, read in zip(self.nominal, clean_readings(self.bench, truth))])

    def of_rows(self, rows, values):
        truth = Truth.none(self.bench.size)
        for (row, place), x in zip(rows, values):
            row.put(truth, self.bench, place, list(x))
        return self.of(truth)

    def of_rows_or_none(self, rows, values):
        try:
            return self.of_rows(rows, values)
        except (ArithmeticError, ValueError, OverflowError, FloatingPointError):
            return None

    def fit(self, change, rows, starts):
        """Least squares over the parameters of rows from one start."""
        sizes = np.concatenate([np.maximum(np.abs(x), 1e-12) for x in starts])
        low = np.concatenate([[0.0 if row.positive else -np.inf] * len(x) for (row, _), x in zip(rows, starts)])
        at = np.cumsum([len(x) for x in starts])[:-1]

        def left(u):
            model = self.of_rows_or_none(rows, np.split(u * sizes, at))
            return np.full(len(change), 1e3) if model is None else model - change
        begin = np.maximum(np.concatenate(starts) / sizes, np.where(np.isfinite(low), 1e-6, -np.inf))
        found = least_squares(left, begin, bounds=(low, np.inf), max_nfev=EVALUATIONS, diff_step=1e-4, xtol=1e-6, ftol=1e-6)
        return Fit(tuple(rows), np.split(found.x * sizes, at), float(np.sqrt(2 * found.cost)))

    def starts_near(self, row, place, change, near):
        """Starts of a row whose change has the direction of a given one, scaled to it."""
        found = []
        for x in row.starts(self.bench, place):
            model = self.of_rows_or_none([(row, place)], [x])
            if model is None or not np.any(model):
                continue
            share = float(model @ change) / float(model @ model)
            if row.positive and share < 0:
                continue
            if np.linalg.norm(change - share * model) < near * np.linalg.norm(change):
                scaled = [share * v if i in row.scaled else v for i, v in enumerate(x)]
                found.append(scaled if self.of_rows_or_none([(row, place)], [scaled]) is not None else x)
        return found

    def best_of(self, row, place, change, near):
        fits = [self.fit(change, [(row, place)], [x]) for x in self.starts_near(row, place, change, near)]
        return min(fits, key=lambda fit: fit.left, default=None)

    def singles(self, change, near=NEAR):
        """Fits of every row alone that comes near, best first."""
        fits = [self.best_of(row, place, change, near) for row, place in rows_at(self.bench)]
        return sorted((fit for fit in fits if fit), key=lambda fit: fit.left)

    def beside(self, first, change, enough):
        """The fits of one row's fit and every other together that leave less than enough."""
        found = []
        rest = change - self.of_rows(first.rows, first.values)
        for row, place in rows_at(self.bench):
            if (row, place) in first.rows:
                continue
            for x in self.starts_near(row, place, rest, NEAR_BESIDE)[:1]:
                both = self.fit(change, [*first.rows, (row, place)], [*first.values, np.array(x)])
                if both.left < enough:
                    found.append(both)
        return found


def contain(keys, true_keys):
    """Whether an explanation has a richer row in the place of a true one that it contains."""
    return any((one, true) in CONTAINS and one not in true_keys for one in keys for true in true_keys)


def aliases(bench, planted, noise=Noise()):
    """Explanations, each a list of keys, that leave no more than nobody could tell. `planted` is a list of (row, place, values)."""
    readings = Readings(bench, noise)
    true = Fit(tuple((row, place) for row, place, _ in planted), [np.array(x) for _, _, x in planted], 0.0)
    change = readings.of_rows(true.rows, true.values)
    single = readings.singles(change, NEAR if len(planted) == 1 else NEAR_BESIDE)
    fits = [fit for fit in single if fit.left < UNTOLD]
    keys = imitating_tolerances(readings, change, Fit((), [], 0.0), UNTOLD)
    if len(planted) == 2:
        for known in (Fit((row,), [x], 0.0) for row, x in zip(true.rows, true.values)):
            fits += readings.beside(known, change, UNTOLD)
            keys |= imitating_tolerances(readings, change, known, UNTOLD)
        fits += both_replaced(readings, true, change)
        for first in single[:FIRST]:
            fits += readings.beside(first, change, UNTOLD)
    keys = keys.union(*(with_tolerances(bench, fit) for fit in [true, *fits]))
    return [list(one) for one in sorted(keys - {tuple(sorted(true.keys))}) if not contain(one, true.keys)]


def both_replaced(readings, true, change):
    """Pairs of an alias of each."""
    own = [[fit for fit in readings.singles(readings.of_rows([row], [x])) if fit.left < UNTOLD and fit.rows[0] != row]
           for row, x in zip(true.rows, true.values)]
    found = []
    for first in own[0]:
        for second in own[1]:
            if first.rows != second.rows:
                both = readings.fit(change, [*first.rows, *second.rows], [*first.values, *second.values])
                if both.left < UNTOLD:
                    found.append(both)
    return found


def is_imitated(bench, truth, enough):
    """Whether a row, or two rows, of the catalogue leave less than `enough` of a cause outside it."""
    readings = Readings(bench)
    change = readings.of(truth)
    single = readings.singles(change, NEAR_BESIDE)
    if single and single[0].left < enough:
        return True
    if imitating_tolerances(readings, change, Fit((), [], 0.0), enough):
        return True
    return any(readings.beside(first, change, enough) for first in single[:FIRST])
