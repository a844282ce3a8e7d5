"""What a trial draws: arm, bench, causes and their strengths."""
from dataclasses import dataclass

import numpy as np

from aliases import aliases
from causes import INSIDE, LOADED, OUTSIDE, PULLED, STATIC, TURNING
from experiment import clean_readings, draw_bench, held_out, strength, with_noise
from shapes import SHAPES
from truth import Truth

NONE, ONE, TWO, OUT = "no effect", "one effect", "two effects", "outside"
SHARES = {NONE: 0.15, ONE: 0.5, TWO: 0.12, OUT: 0.23}
WEAKEST, STRONGEST = 3.0, 50.0  # strengths, in standard deviations


@dataclass
class Planted:
    cause: object
    place: int
    amount: float
    seed: int
    parameters: dict
    strength: float

    def on(self, truth, shape):
        self.parameters = self.cause.plant(truth, shape, self.place, self.amount, np.random.default_rng(self.seed))


@dataclass
class Drawn:
    bench: object
    readings: list
    planted: list
    strength: float
    noise: str
    noise_scale: float
    family: str
    equivalent: list
    later: object = None  # other poses of the same bench, without noise, and what the points then do
    later_readings: list = None


def truth_with(shape, planted):
    truth = Truth(shape.size)
    for one in planted:
        one.on(truth, shape)
    return truth


def draw_place(cause, shape, random):
    places = list(cause.places(shape))
    return int(random.choice(places)) if places else None


def scaled(bench, nominal, cause, place, random):
    """The cause with an amount that gives it a drawn strength; nothing where it cannot have one."""
    shape = bench.shape
    target = float(np.exp(random.uniform(np.log(WEAKEST), np.log(STRONGEST))))
    one = Planted(cause, place, cause.typical(shape, place), int(random.integers(2**31)), {}, 0.0)
    for _ in range(2 if cause.design == TURNING else 3):
        one.strength = strength(bench, clean_readings(bench, truth_with(shape, [one])), nominal)
        if abs(np.log(max(one.strength, 1e-9) / target)) < 0.1:
            break
        one.amount = min(one.amount * target / max(one.strength, 1e-9), cause.most * cause.typical(shape, place))
    one.strength = strength(bench, clean_readings(bench, truth_with(shape, [one])), nominal)
    return one if one.strength > 0.7 * WEAKEST else None


def draw_causes(family, only, random):
    if family == NONE:
        return []
    if family == OUT:
        return [OUTSIDE[random.integers(len(OUTSIDE))]]
    rows = [cause for cause in INSIDE if not only or cause.id in only]
    return [rows[i] for i in random.choice(len(rows), 1 if family == ONE else 2, replace=False)]


def needs_of(wanted, random):
    """What the bench must have; nothing where no bench has it all."""
    needs = {c.design for c in wanted} - {STATIC}
    if TURNING in needs and needs & {PULLED, LOADED}:
        return None
    return needs or ({PULLED} if random.uniform() < 0.25 else needs)


def attempt(shape, family, only, random):
    wanted = draw_causes(family, only, random)
    needs = needs_of(wanted, random)
    places = [draw_place(c, shape, random) for c in wanted]
    if needs is None or None in places:
        return None
    bench = draw_bench(shape, needs, random)
    nominal = clean_readings(bench, Truth(shape.size))
    planted = [scaled(bench, nominal, c, p, random) for c, p in zip(wanted, places)]
    if None in planted:
        return None
    readings = clean_readings(bench, truth_with(shape, planted))
    noisy, kind, scale = with_noise(bench, readings, random)
    alike = aliases(bench, nominal, readings, planted[0]) if family == ONE else []
    later = held_out(bench, random)
    return Drawn(bench, noisy, planted, strength(bench, readings, nominal), kind, scale, family, alike, later,
                 clean_readings(later, truth_with(shape, planted), after=True))


def draw(number, seed, only=()):
    """Experiment `number` of a seed; the arms take turns. With `only`, one effect out of these ids in each."""
    shape = SHAPES[number % len(SHAPES)]
    for trial in range(200):
        random = np.random.default_rng([seed, number, trial])
        if trial == 0:
            family = ONE if only else str(random.choice(list(SHARES), p=list(SHARES.values())))
        try:
            drawn = attempt(shape, family, only, random)
        except ArithmeticError:  # a load that snaps something, a play that nothing pushes
            continue
        if drawn is not None:
            return drawn
    raise RuntimeError(f"experiment {number} of seed {seed}: nothing drawn in 200 attempts")
