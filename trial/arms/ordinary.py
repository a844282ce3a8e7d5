"""Ordinary arms: every joint is a little off, the tracker stands anywhere, and the ball sits somewhere on the tool."""
from dataclasses import replace

import numpy as np

from causes import INSIDE, STATIC
from draw import Drawn, Planted
from experiment import Bench, Run, clean_readings, draw_poses, held_out, strength, weights
from model_files import rotation_about
from shapes import COLLABORATIVE, INDUSTRIAL
from true_arm import TrueArm
from truth import Truth

LASER = 5e-5  # m, of each coordinate
SHAPES = tuple(replace(shape, tracker=LASER, encoder=0.0, count=0.0) for shape in (INDUSTRIAL, COLLABORATIVE))
POSES, STRENGTH, BALL = 30, 40.0, 0.04  # with and without a weight; standard deviations; m
FRAMES = {"tracker_offset", "tracker_turn", "tool_offset"}  # which nothing is known of
CAUSES = tuple(c for c in INSIDE if c.design == STATIC and c.id not in FRAMES)
ALONE = 5  # every so-many-th has no cause


def joints_off(truth, shape, size, random):
    """Zeros and tilts by a standard deviation of `size`, rad, shifts by half a metre times it; whatever slides by it times a metre."""
    truth.zero += size * random.normal(size=shape.size)
    truth.shift += 0.5 * size * random.normal(size=(shape.size, 3))
    truth.tilt += size * random.normal(size=(shape.size, 3))


def frame_columns(bench):
    """Derivatives of the places by shift and turn of the tracker and by the place of the ball."""
    arm, blocks = TrueArm(bench.shape, Truth(bench.shape.size)), []
    for run in bench.runs:
        for command in run.commands:
            place, axes = arm.tip_pose(command)
            turn = np.array([np.cross(e, place) for e in np.eye(3)]).T
            blocks.append(np.hstack([np.eye(3), turn, axes]))
    return np.vstack(blocks)


def beside_frames(bench, readings, nominal):
    """Strength of what no motion of tracker and ball takes away."""
    change = np.concatenate([(a - b).ravel() for (a, _), (b, _) in zip(readings, nominal)]) / bench.shape.tracker
    columns = frame_columns(bench)
    return float(np.sqrt(np.mean((change - columns @ np.linalg.lstsq(columns, change, rcond=None)[0]) ** 2)))


def placed(readings, turn, shift):
    return [(places @ turn.T + shift, reached) for places, reached in readings]


def scaled(bench, nominal, cause, place, random):
    """The cause with an amount that is as strong beside frames as is wanted; nothing where it cannot be."""
    shape = bench.shape
    one = Planted(cause, place, cause.typical(shape, place), int(random.integers(2**31)), {}, 0.0)
    for _ in range(4):
        truth = Truth(shape.size)
        one.on(truth, shape)
        one.strength = beside_frames(bench, clean_readings(bench, truth), nominal)
        if abs(np.log(max(one.strength, 1e-9) / STRENGTH)) < 0.1:
            return one
        one.amount = min(one.amount * STRENGTH / max(one.strength, 1e-9), cause.most * cause.typical(shape, place))
    return None


def attempt(shape, tolerance, alone, causes, random):
    poses = draw_poses(shape, POSES, random)
    load = round(random.uniform(0.4, 1.0) * shape.payload, 2)
    bench = Bench(shape, [Run("unloaded", poses, weights(shape, 0, POSES)), Run("loaded", poses, weights(shape, load, POSES))], (), False, False)
    bench.sigma, bench.anywhere = {"place": shape.tracker}, True
    nominal = clean_readings(bench, Truth(shape.size))
    planted = []
    if not alone:
        cause = causes[random.integers(len(causes))]
        places = list(cause.places(shape))
        if not places:
            return None
        planted = [scaled(bench, nominal, cause, int(random.choice(places)), random)]
        if None in planted:
            return None
    off, ball = int(random.integers(2**31)), BALL * random.normal(size=3)
    turn, shift = rotation_about(np.pi * random.uniform(-1, 1, 3)), random.normal(size=3) * 2

    def truth():
        true = Truth(shape.size)
        joints_off(true, shape, tolerance, np.random.default_rng(off))
        true.tip_shift += ball
        true.load_offset -= ball  # the weights hang where the tool is stated, wherever the ball sits
        for one in planted:
            one.on(true, shape)
        return true

    readings = placed(clean_readings(bench, truth()), turn, shift)
    noisy = [(places + shape.tracker * random.normal(size=places.shape), reached) for places, reached in readings]
    later = held_out(bench, random)
    later.anywhere = True
    return Drawn(bench, noisy, planted, strength(bench, readings, nominal), "declared", 1.0, "one effect" if planted else "no effect", [],
                 later, placed(clean_readings(later, truth(), after=True), turn, shift))


def draw(number, seed, tolerance, only=()):
    """Experiment `number` of a seed; the arms take turns. Its cause is one of `only`, where these are given."""
    causes = tuple(c for c in CAUSES if not only or c.id in only)
    for trial in range(200):
        random = np.random.default_rng([seed, number, trial, 70])
        try:
            drawn = attempt(SHAPES[number % len(SHAPES)], tolerance, number % ALONE == ALONE - 1, causes, random)
        except ArithmeticError:
            continue
        if drawn is not None:
            return drawn
    raise RuntimeError(f"experiment {number} of seed {seed}: nothing drawn in 200 attempts")
