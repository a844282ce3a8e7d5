#!/usr/bin/env python3
"""Makes pairs of experiments: one device before and after, on the benches and by the mechanics of trial/benches.

    generate.py OUT --seed S --count N

writes OUT/pairs-S/NAME/before and NAME/after, and apart from them OUT/pairs-S-labels/NAME.json. A half of the devices lack an effect of their
nominal model in both states; a third of the pairs are unchanged. The effect that differs came or went, with even chances.
"""
import argparse
import copy
import json
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "benches"))

from aliases import Readings, aliases  # noqa: E402
from draw import ATTEMPTS, BENCHES, draw_row, effect, plantable  # noqa: E402
from noise import with_noise  # noqa: E402
from outside import CAUSES  # noqa: E402
from recipe import NONE, ONE, OUT, Recipe  # noqa: E402
from statics import clean_readings  # noqa: E402
from truth import Truth  # noqa: E402
from write_experiment import write_experiment  # noqa: E402

CHANGES = {NONE: 1 / 3, ONE: 0.5, OUT: 1 / 6}
LACKS = {NONE: 0.5, ONE: 0.3, OUT: 0.2}
# A change is seen against twice the variance of the noise: strengths are those of a trial of single benches, times the root of two.
CHANGE = Recipe({}, 3.1, 7.0, 70.0, {"declared": 1.0}, (1.5, 1.5), 0.02, True)
LACK = Recipe({}, 4.0, 4.0, 40.0, {"declared": 1.0}, (1.5, 1.5), 0.02, True)


class Drawn:
    def __init__(self, bench, readings):
        self.bench, self.readings = bench, readings


def strength(bench, truth, beside):
    """Of a truth beside another one, in standard deviations of a reading."""
    flat = [np.concatenate([r.ravel() for r in clean_readings(bench, one)]) for one in (truth, beside)]
    return float(np.sqrt(np.mean((flat[0] - flat[1]) ** 2)) / bench.noise)


def put_row(drawn):
    row, place, values, _ = drawn
    return lambda truth, bench: row.put(truth, bench, place, list(values))


def draw_cause(bench, readings, family, recipe, random, without=None):
    """A function that puts a cause into a truth, its effect for the label, aliases, words, whether it has one sign; nothing where none is drawn."""
    if family == ONE:
        by_id = plantable(bench)
        ids = sorted(id for id, rows in by_id.items() if id != without)
        drawn = draw_row(readings, random, by_id[ids[random.integers(len(ids))]], recipe)
        if drawn is None:
            return None
        row, place, values, size = drawn
        return put_row(drawn), [effect(row.id, place, row.names, values, size)], aliases(bench, [drawn[:3]]), row.id, row.positive
    causes = [cause for cause in CAUSES if cause.possible(bench)]
    cause = causes[random.integers(len(causes))]
    place, seed = int(random.choice(list(cause.places(bench)))), int(random.integers(2**31))
    factor = float(np.exp(random.uniform(np.log(0.3), np.log(3))))

    def put(truth, bench):
        cause.put(truth, bench, place, min(factor, cause.most) * cause.size(bench, place), np.random.default_rng(seed))
    return put, [effect("unknown", place, (), (), 0.0)], [], cause.words, False


def attempt(make, change, lack, random):
    bench = make(random, True)
    readings = Readings(bench)
    shared = draw_cause(bench, readings, lack, LACK, random) if lack != NONE else (lambda truth, bench: None, [], [], "", False)
    if shared is None:
        return None
    moved = draw_cause(bench, readings, change, CHANGE, random, shared[3]) if change != NONE else (lambda truth, bench: None, [], [], "", False)
    if moved is None:
        return None
    common, altered = Truth.none(bench.size), Truth.none(bench.size)
    shared[0](common, bench), shared[0](altered, bench)
    moved[0](altered, bench)
    size, lacking = strength(bench, altered, common), strength(bench, common, Truth.none(bench.size))
    if change != NONE and not CHANGE.weakest < size < CHANGE.strongest or lack != NONE and not LACK.weakest < lacking < 2 * LACK.strongest:
        return None
    if change == OUT and size < CHANGE.weakest_outside:
        return None
    came = bool(random.uniform() < 0.5)
    states = []
    for truth in (common, altered) if came else (altered, common):
        one = copy.deepcopy(bench)
        noisy, _ = with_noise(one, clean_readings(one, truth), random, CHANGE)
        states.append(Drawn(one, noisy))
    label = {"effects": moved[1], "equivalent": moved[2], "strength_sigma": round(size, 3), "came": came, "one_sided": moved[4], "lack": shared[3],
             "lack_sigma": round(lacking, 3), "description": moved[3] if change == OUT else "",
             "family": f"{change}, " + ("on a device as modelled" if lack == NONE else "on a device that lacks an effect")}
    return states, label


def draw(number, seed):
    make = BENCHES[number % len(BENCHES)]
    for trial in range(ATTEMPTS):
        random = np.random.default_rng([seed, number, trial])
        if trial == 0:
            change, lack = (str(random.choice(list(shares), p=list(shares.values()))) for shares in (CHANGES, LACKS))
        try:
            drawn = attempt(make, change, lack, random)
        except (ArithmeticError, ValueError):  # no equilibrium
            continue
        if drawn is not None:
            return drawn
    raise RuntimeError(f"pair {number} of seed {seed}: nothing drawn in {ATTEMPTS} attempts")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    a = parser.parse_args()
    out, labels = a.out / f"pairs-{a.seed}", a.out / f"pairs-{a.seed}-labels"
    for folder in (out, labels):
        folder.mkdir(parents=True)
    for number in range(a.count):
        states, label = draw(number, a.seed)
        name = f"{states[0].bench.kind}-{number:03d}"
        for state, drawn in zip(("before", "after"), states):
            write_experiment(out / name / state, f"{name} {state}", drawn)
        (labels / f"{name}.json").write_text(json.dumps({"name": name, **label}, indent=1) + "\n")


if __name__ == "__main__":
    main()
