"""One experiment: what is drawn, what the true arm does, what the instruments read."""
from dataclasses import dataclass, field

import numpy as np

import causes
from model_files import rotation_about
from true_arm import TrueArm
from truth import Truth

GRAVITY = 9.81


@dataclass
class Run:
    id: str
    commands: np.ndarray  # by reading and joint
    forces: np.ndarray  # on the measured point, world axes, by reading: true where nothing is planted


@dataclass
class Bench:
    """What the owner of the arm knows of it."""
    shape: object
    runs: list
    points: tuple  # of the tool, beside the tip: offsets from it
    angles: bool  # whether reached joint angles are in the table
    by_cell: bool  # whether a load cell reads the force
    sigma: dict = field(default_factory=dict)  # declared, by kind of channel
    anywhere: bool = False  # the tracker, and the points on the tool


def feasible(shape, tip):
    height, away = shape.reach
    return tip[2] > height and np.hypot(tip[0], tip[1]) > away


def draw_poses(shape, count, random):
    """Commands within nine tenths of the limits, the tip in the room where a tracker sees it."""
    arm = TrueArm(shape, Truth(shape.size))
    low, high = shape.limits.T
    middle, half = (low + high) / 2, 0.45 * (high - low)
    poses = []
    while len(poses) < count:
        c = np.round(random.uniform(middle - half, middle + half), 4)
        if feasible(shape, arm.tip_pose(c)[0]):
            poses.append(c)
    return np.array(poses)


def weights(shape, kilograms, count):
    return np.tile([0.0, 0.0, -GRAVITY * kilograms], (count, 1))


def draw_runs(shape, needs, random):
    """Runs of a design: there and back, pulled by a load cell, with weights, or without any load."""
    load = round(random.uniform(0.4, 1.0) * shape.payload, 2)
    if causes.TURNING in needs:
        n = int(random.integers(20, 33))
        there = draw_poses(shape, n, random)
        return [Run("there", there, weights(shape, 0, n)), Run("back", there[::-1], weights(shape, 0, n))]
    if causes.PULLED in needs:
        n = int(random.integers(40, 121))
        pull = random.normal(size=(n, 3))
        pull *= (random.uniform(0.1, 1, n) * GRAVITY * load / np.linalg.norm(pull, axis=1))[:, None]
        return [Run("pulled", draw_poses(shape, n, random), np.round(pull, 2))]
    n = int(random.integers(20, 76))
    poses = draw_poses(shape, n, random)
    if causes.LOADED not in needs and random.uniform() < 0.25:
        return [Run("unloaded", np.vstack([poses, draw_poses(shape, n, random)]), weights(shape, 0, 2 * n))]
    return [Run("unloaded", poses, weights(shape, 0, n)), Run("loaded", poses, weights(shape, load, n))]


def draw_bench(shape, needs, random):
    spread = 0.1 * shape.length
    points = tuple(map(tuple, np.round(random.normal(size=(2, 3)) * spread / 2, 4))) if random.uniform() < 0.25 else ()
    angles = causes.READ in needs or (shape.encoder > 0 and random.uniform() < 0.7)
    return Bench(shape, draw_runs(shape, needs, random), points, angles, causes.PULLED in needs)


def held_out(bench, random):
    """The same bench with poses that the experiment does not have, loaded as its readings are."""
    n = 30
    forces = np.vstack([run.forces for run in bench.runs])
    run = Run("held_out", draw_poses(bench.shape, n, random), forces[random.integers(len(forces), size=n)])
    return Bench(bench.shape, [run], bench.points, bench.angles, bench.by_cell, bench.sigma)


def true_forces(bench, truth, run):
    """A load cell with errors reads what the table says; the arm feels what it is."""
    if not bench.by_cell:
        return run.forces
    return (run.forces - truth.force_bias) / (1 + truth.force_gain)


def equilibria(arm, truth, run, forces, shares):
    turned = np.array([truth.turned_to(c) for c in run.commands])
    if truth.has_memory:
        return turned, arm.settle(arm.rest(turned[0], forces[0]), turned, forces)
    found = []
    for now, force, share in zip(turned, forces, shares):
        arm.set_reading(share)
        found.append(arm.rest(now, force))
    return turned, found


def clean_readings(bench, truth, after=False):
    """By run: places of the points in the tracker's frame (reading, point, 3) and reached joint coordinates (reading, joint).

    What changes in the course of the session has all changed where the readings come `after` it.
    """
    arm = TrueArm(bench.shape, truth)
    total = sum(len(run.commands) for run in bench.runs)
    done, result = 0, []
    for run in bench.runs:
        shares = np.ones(len(run.commands)) if after else (done + np.arange(len(run.commands))) / max(1, total - 1)
        turned, found = equilibria(arm, truth, run, true_forces(bench, truth, run), shares)
        places, reached = [], []
        for c, t, q, share in zip(run.commands, turned, found, shares):
            arm.set_reading(share)
            place, axes = arm.tip_pose(q)
            seen = [place + axes @ np.array(offset) for offset in ((0.0, 0.0, 0.0), *bench.points)]
            places.append([tracked(truth, p, share) for p in seen])
            reached.append((1 + truth.angle_scale) * (c + q[arm.dof] - t) + truth.angle_bias)
        done += len(run.commands)
        result.append((np.array(places), np.array(reached)))
    return result


def tracked(truth, place, share):
    """As the tracker gives it in what it takes for the base's frame."""
    turn = rotation_about(truth.tracker_turn)
    return (1 + truth.tracker_scale) * turn @ place + truth.tracker_shift + truth.bump * (share > 0.5)


def strength(bench, readings, nominal):
    """Root mean square of the change, in standard deviations of the true noise."""
    parts = []
    for (places, reached), (places0, reached0) in zip(readings, nominal):
        parts.append(((places - places0) / bench.shape.tracker).ravel())
        if bench.angles:
            parts.append(((reached - reached0) / bench.shape.encoder).ravel())
    return float(np.sqrt(np.mean(np.concatenate(parts) ** 2)))


NOISES = ("declared", "misdeclared", "outliers")


def with_noise(bench, readings, random):
    """Readings as an instrument gives them, the kind of their noise, and the true over the declared standard deviation."""
    shape = bench.shape
    kind = str(random.choice(NOISES, p=(0.7, 0.18, 0.12)))
    scale = float(random.choice([1 / 1.5, 1.5])) if kind == "misdeclared" else 1.0
    bench.sigma = {"place": shape.tracker / scale, "q": float(np.hypot(shape.encoder, shape.count / np.sqrt(12))) / scale}
    noisy = []
    for places, reached in readings:
        error = random.normal(size=places.shape)
        if kind == "outliers":
            error[random.uniform(size=places.shape) < 0.02] *= 12
        q = reached + shape.encoder * random.normal(size=reached.shape)
        if shape.count > 0:
            q = np.round(q / shape.count) * shape.count
        noisy.append((places + shape.tracker * error, q))
    return noisy, kind, scale
