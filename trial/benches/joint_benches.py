"""Benches of a joint alone: torque against angle, force against stroke, a flexure under small weights."""
import numpy as np

from bench import Bench, Run


def between(random, low, high):
    """Log-uniform."""
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def round_to(value, digits):
    return float(f"{value:.{digits}g}")


def path(kind, amplitude, count):
    """Imposed values from rest: a ramp, there and back, or loops through both sides.

    No reading after the first is at nought, where the place of a joint with play would be anything; 0.6 of a step misses it on every way back.
    """
    turns = {"ramp": [0, 1], "back": [0, 1, 0], "loop": [0, 1, -1, 0], "two loops": [0, 1, -1, 1, -1, 0]}[kind]
    way = np.concatenate([[0], np.cumsum(np.abs(np.diff(turns)))])
    positions = np.concatenate([[0.0], np.arange(1, count) - 0.4]) * way[-1] / (count - 1)
    return amplitude * np.interp(positions, way, turns)


def draw_path(random, turning):
    kinds = ("back", "loop", "two loops") if turning else ("ramp", "back", "loop", "two loops")
    weights = np.array((0.3, 0.5, 0.2) if turning else (0.2, 0.25, 0.4, 0.15))
    return str(random.choice(kinds, p=weights / weights.sum()))


def noise_of(bench, largest, random):
    """A sensor of a thousandth to eight thousandths of the largest reading; its display has counts in three benches of ten."""
    bench.sigma = round_to(largest * between(random, 0.001, 0.008), 2)
    if random.uniform() < 0.3:
        bench.count = round_to(bench.sigma * random.uniform(0.7, 2.0), 1)
    return bench


def joint_bench(kind, joint, stiffness, amplitude, count, turning, held, loaded_by, random):
    """One run, or in a quarter of the benches a second one of half the amplitude."""
    interval = float(random.choice([0.2, 0.5, 2.0]))
    way = draw_path(random, turning)
    control = {True: {"revolute": "angle", "prismatic": "displacement"}, False: {"revolute": "torque", "prismatic": "force"}}[held][joint]
    size = amplitude if held else round_to(amplitude * stiffness, 3)
    runs = []
    for number, share in enumerate((1.0, 0.5)[:2 if random.uniform() < 0.25 else 1]):
        imposed = np.array([round_to(v, 6) for v in path(way, share * size, count)])
        runs.append(Run(f"run_{number + 1}", control, interval * np.arange(count), np.zeros((count, 1)), imposed=imposed,
                        loaded_by="" if held else loaded_by))
    bench = Bench(kind, np.array([stiffness]), runs, alone=joint, sweep=way != "ramp")
    return noise_of(bench, amplitude * stiffness if held else amplitude, random)


def loop(random, turning):
    held = random.uniform() < 0.6
    return joint_bench("loop", "revolute", round_to(between(random, 20, 5000), 2), round_to(between(random, 0.03, 0.4), 2),
                       int(random.integers(50, 141)), turning, held, str(random.choice(["servo", "weights"])), random)


def stroke(random, turning):
    held = random.uniform() < 0.6
    return joint_bench("stroke", "prismatic", round_to(between(random, 500, 50000), 2), round_to(between(random, 0.002, 0.03), 2),
                       int(random.integers(40, 121)), turning, held, str(random.choice(["servo", "weights"])), random)


def flexure(random, turning):
    """Some tenths of a milliradian."""
    held = random.uniform() < 0.25
    loaded_by = "weights" if random.uniform() < 0.75 else "servo"
    return joint_bench("flexure", "revolute", round_to(between(random, 0.3, 20), 2), round_to(between(random, 5e-5, 1e-3), 2),
                       int(random.integers(20, 71)), turning, held, loaded_by, random)
