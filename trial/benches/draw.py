"""One experiment of a trial: a bench, hidden causes and their strengths, noise."""
from dataclasses import dataclass, field

import numpy as np

from aliases import Fit, Readings, aliases, is_imitated
from catalogue import rows_at
from chain_benches import finger, hung, poses, pressed, sweep
from joint_benches import flexure, loop, stroke
from noise import with_noise
from outside import CAUSES
from recipe import NONE, ONE, OUT, PLAIN, TWO
from statics import clean_readings
from tolerances import imitating_tolerances
from truth import Truth

TOLD = 4.0  # standard deviations of all readings together that a cause outside the catalogue leaves at least of any two rows
NEEDED = 5.0  # the same, that a single row, or tolerances, leave of two effects
BENCHES = (loop, poses, finger, flexure, stroke, sweep, loop, flexure, pressed, poses, stroke, sweep, hung, finger)
ATTEMPTS = 400


@dataclass
class Drawn:
    bench: object
    readings: list  # as they are written
    effects: list  # of the label
    strength: float
    family: str
    noise: str
    noise_scale: float
    equivalent: list = field(default_factory=list)
    words: str = ""


def strength(readings, truth):
    return float(np.sqrt(np.mean(readings.of(truth) ** 2)))


def scaled(readings, put, first, most, weakest, strongest, random):
    """The amount, a factor, at which a cause has a drawn strength, and that strength; nothing where it cannot have it."""
    target, factor = float(np.exp(random.uniform(np.log(weakest), np.log(strongest)))), first
    for _ in range(6):
        reached = strength(readings, put(factor))
        if abs(np.log(max(reached, 1e-9) / target)) < 0.1:
            break
        factor = min(factor * min(10.0, target / max(reached, 1e-9)), most)
    reached = strength(readings, put(factor))
    return (factor, reached) if 0.98 * weakest < reached < 1.2 * strongest else None


def draw_row(readings, random, rows, recipe):
    """A row with values that have a drawn strength."""
    bench = readings.bench
    row, place = rows[random.integers(len(rows))]
    drawn = row.drawn(bench, place, random)

    def values(factor):
        return [float(v) * (factor if i in row.scaled else 1.0) for i, v in enumerate(drawn)]

    def put(factor):
        truth = Truth.none(bench.size)
        row.put(truth, bench, place, values(factor))
        return truth
    found = scaled(readings, put, 1.0, row.most, recipe.weakest, recipe.strongest, random)
    return (row, place, values(found[0]), found[1]) if found else None


def plantable(bench):
    """Rows by id first, so that an effect of one joint is drawn no more often than others."""
    by_id = {}
    for row, place in rows_at(bench):
        if row.planted and (bench.sweep or "friction" not in row.id):
            by_id.setdefault(row.id, []).append((row, place))
    return by_id


def draw_inside(readings, count, random, recipe):
    by_id = plantable(readings.bench)
    ids = sorted(id for id, rows in by_id.items() if count == 1 or not rows[0][0].alone)
    if len(ids) < count:
        return None
    planted = [draw_row(readings, random, by_id[ids[i]], recipe) for i in random.choice(len(ids), count, replace=False)]
    return None if None in planted else planted


def effect(id, place, names, values, one_strength):
    return {"id": id, "joint": place + 1 if place >= 0 else None, "parameters": dict(zip(names, map(float, values))),
            "strength_sigma": round(one_strength, 3)}


def both_are_needed(readings, planted):
    """Whether no row alone, and no tolerances, come near to what two effects change."""
    rows = [(row, place) for row, place, _, _ in planted]
    whole = readings.of_rows(rows, [x for _, _, x, _ in planted])
    single = readings.singles(whole)
    return (not single or single[0].left > NEEDED) and not imitating_tolerances(readings, whole, Fit((), [], 0.0), NEEDED)


def with_effects(readings, family, random, recipe):
    bench = readings.bench
    planted = draw_inside(readings, 1 if family == ONE else 2, random, recipe)
    if planted is None or (recipe.selected and family == TWO and not both_are_needed(readings, planted)):
        return None
    if any(row.id == "gravity" for row, _, _, _ in planted) and random.uniform() < 0.5 and bench.kind in ("poses", "sweep") and family == ONE:
        bench.mass, bench.scales = None, None  # a nominal model without weights lacks them all
        readings = Readings(bench)
    truth = Truth.none(bench.size)
    for row, place, values, _ in planted:
        row.put(truth, bench, place, values)
    effects = [effect(row.id, place, row.names, values, one) for row, place, values, one in planted]
    return truth, effects, [one[:3] for one in planted], ""


def with_outside(readings, random, recipe):
    bench = readings.bench
    causes = [cause for cause in CAUSES if cause.possible(bench)]
    cause = causes[random.integers(len(causes))]
    places = cause.places(bench)
    place, seed = int(places[random.integers(len(places))]), int(random.integers(2**31))

    def put(factor):
        truth = Truth.none(bench.size)
        cause.put(truth, bench, place, factor * cause.size(bench, place), np.random.default_rng(seed))
        return truth
    found = scaled(readings, put, 1.0, cause.most, recipe.weakest_outside, recipe.strongest, random)
    if found is None or (recipe.selected and is_imitated(bench, put(found[0]), TOLD)):
        return None
    return put(found[0]), [effect("unknown", place, (), (), found[1])], [], cause.words


def attempt(make, family, random, recipe):
    turning = family == OUT or random.uniform() < 0.6
    bench = make(random, turning)
    readings = Readings(bench)
    if family == NONE:
        found = Truth.none(bench.size), [], [], ""
    else:
        found = with_outside(readings, random, recipe) if family == OUT else with_effects(readings, family, random, recipe)
    if found is None:
        return None
    truth, effects, planted, words = found
    whole = strength(Readings(bench), truth)
    noisy, noise = with_noise(bench, clean_readings(bench, truth), random, recipe)
    equivalent = aliases(bench, planted, noise) if planted else []
    return Drawn(bench, noisy, effects, whole, f"outside: {words}" if words else family, noise.kind, noise.scale, equivalent, words)


def draw(number, seed, recipe=PLAIN):
    """Experiment `number` of a seed; the kinds of benches take turns."""
    make = BENCHES[number % len(BENCHES)]
    for trial in range(ATTEMPTS):
        random = np.random.default_rng([seed, number, trial])
        if trial == 0:
            family = str(random.choice(list(recipe.shares), p=list(recipe.shares.values())))
        try:
            drawn = attempt(make, family, random, recipe)
        except (ArithmeticError, ValueError):  # no equilibrium: a load that snaps something
            continue
        if drawn is not None:
            return drawn
    raise RuntimeError(f"experiment {number} of seed {seed}: nothing drawn in {ATTEMPTS} attempts")
