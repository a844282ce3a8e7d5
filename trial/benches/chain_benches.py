"""Benches of chains: servo arms in a vertical plane, a finger on its tendon, joints under pressure, a weight on a link."""
import numpy as np

from bench import GRAVITY, Bench, Run
from joint_benches import between, path, round_to
from loads import moments, shape

ENCODERS = (2 * np.pi / 4096, 2 * np.pi / 16384)  # counts of a turn, rad


def rounded(values, digits=2):
    return np.array([round_to(v, digits) for v in values])


def encoder(bench, random, low, high):
    """Reached angles by an encoder, in half of the benches with counts that show."""
    bench.sigma = round_to(between(random, low, high), 2)
    if random.uniform() < 0.5:
        bench.count = float(random.choice(ENCODERS)) if bench.sigma > 3e-4 else round_to(bench.sigma, 1)
    return bench


def servo_arm(random, most):
    """Lengths, masses, and gains under which the level arm with its weight sags by one to four degrees a joint."""
    n = int(random.integers(1, most + 1))
    length = rounded(random.uniform(0.15, 0.4, n))
    mass = rounded(random.uniform(0.3, 1.2, n) * np.linspace(1, 0.6, n))
    weight = round_to(random.uniform(0.3, 1.0) * mass.sum(), 2)
    level = shape(np.zeros((1, n)), length)[1]
    held = np.abs(moments(level, level[:, -1], np.array([[0.0, -GRAVITY * weight]]), n - 1)[0])
    for j in range(n):
        held += np.abs(moments(level, (level[:, j] + level[:, j + 1]) / 2, np.array([[0.0, -GRAVITY * mass[j]]]), j)[0])
    return length, mass, weight, rounded(held / np.radians(random.uniform(1, 4, n)))


def weights(kilograms, count):
    return np.stack([np.zeros(count), np.round(-GRAVITY * np.broadcast_to(kilograms, count), 3)], axis=1)


def poses(random, turning):
    length, mass, weight, stiffness = servo_arm(random, 3)
    n, count = len(length), int(random.integers(16, 41))
    commands = np.round(np.column_stack([random.uniform(-0.8, 1.2, count)] + [random.uniform(-1.5, 1.5, count) for _ in range(n - 1)]), 3)
    time = 20.0 * np.arange(count)
    kind = random.uniform()
    runs = [Run("unloaded", "command", time, commands)]
    if kind > 0.4:
        runs.append(Run("loaded", "command", time, commands, force=weights(weight, count), loaded_by="weights"))
    if kind > 0.8:
        each = np.round(weight * random.choice([0, 0.5, 1.0], count), 3)
        runs = [Run("weighed", "command", time, commands, force=weights(each, count), loaded_by="weights")]
    bench = Bench("poses", stiffness, runs, length=length, mass=mass, plane="vertical", clock=False)
    return encoder(bench, random, 1e-4, 1e-3)


def sweep(random, turning):
    """There and back at constant speed; the first reading was taken on the way in seven of ten."""
    length, mass, weight, stiffness = servo_arm(random, 2)
    n, count = len(length), int(random.integers(50, 91))
    first, last = random.uniform(-1.0, -0.3, n), random.uniform(0.3, 1.2, n)
    way = np.interp(np.arange(count), [0, count // 2, count - 1], [0, 1, 0])
    commands = np.round(first + way[:, None] * (last - first), 4)
    time, begins = 0.5 * np.arange(count), "moving" if random.uniform() < 0.7 else "relaxed"
    runs = [Run("unloaded", "command", time, commands, begins=begins)]
    if random.uniform() < 0.4:
        runs.append(Run("loaded", "command", time, commands, begins=begins, force=weights(weight, count), loaded_by="weights"))
    bench = Bench("sweep", stiffness, runs, length=length, mass=mass, plane="vertical", sweep=True)
    return encoder(bench, random, 1e-4, 1e-3)


def curling(kind, load, values, lever, length, stiffness, rest, mass, random):
    count = len(values)
    run = Run("bend", "force", 2.0 * np.arange(count), np.tile(rest, (count, 1)), value=values)
    bench = Bench(kind, stiffness, [run], length=length, mass=mass, plane="horizontal" if mass is None else "vertical",
                  load=load, lever=lever, sweep=True)
    return encoder(bench, random, 5e-4, 3e-3)


def finger(random, turning):
    """A tendon turns every joint by 20 to 40 degrees, and lets it go."""
    n = int(random.integers(2, 4))
    most, radius = round_to(random.uniform(6, 20), 2), rounded(random.uniform(0.004, 0.01, n))
    stiffness = rounded(most * radius / np.radians(random.uniform(20, 40, n)))
    rest = np.round(random.uniform(0, 0.3, n), 3)
    length = rounded(random.uniform(0.025, 0.05, n))
    mass = rounded(random.uniform(0.005, 0.02, n)) if random.uniform() < 0.3 else None
    values = np.round(path("back", most, int(random.integers(31, 72))), 4)
    return curling("finger", "tendon", values, radius, length, stiffness, rest, mass, random)


def pressed(random, turning):
    """Bellows that turn one to three joints by 15 to 40 degrees."""
    n = int(random.integers(1, 4))
    most, volume = round_to(between(random, 3e4, 3e5), 2), rounded(10 ** random.uniform(-6.3, -5.5, n))
    stiffness = rounded(most * volume / np.radians(random.uniform(15, 40, n)))
    length = rounded(random.uniform(0.03, 0.08, n))
    values = np.round(path("back", most, int(random.integers(31, 72))), 0)
    return curling("pressed", "pressure", values, volume, length, stiffness, np.zeros(n), None, random)


def hung(random, turning):
    """Weights on a link of a sprung arm, there and back."""
    length, mass, weight, _ = servo_arm(random, 3)
    n = len(length)
    count, link = int(random.integers(31, 62)), int(random.integers(1, n + 1))
    force = np.stack([np.zeros(count), np.round(-GRAVITY * path("back", 3 * weight, count), 3)], axis=1)
    level = shape(np.zeros((1, n)), length)[1]
    held = np.abs(moments(level, level[:, -1], np.array([[0.0, -GRAVITY * (mass.sum() + 3 * weight)]]), n - 1)[0])
    stiffness = rounded(held / np.radians(random.uniform(10, 25, n)))
    rest = np.round(random.uniform(-0.3, 0.6, n), 3)
    run = Run("hang", "force", 5.0 * np.arange(count), np.tile(rest, (count, 1)), link_force=force)
    bench = Bench("hung", stiffness, [run], length=length, mass=mass, plane="vertical", load="force", link=link,
                  at=round(float(random.uniform(0.5, 1.0)), 2), sweep=True)
    return encoder(bench, random, 5e-4, 3e-3)
