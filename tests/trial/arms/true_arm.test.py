#!/usr/bin/env python3
"""The true arms of the trial: their statics against theorems and against MuJoCo's dynamics, their files and seals.

    python3 tests/trial/arms/true_arm.test.py   (with trial/arms/requirements.txt)
"""
import json
import pathlib
import sys
import tempfile
import unittest
from dataclasses import replace

sys.path.insert(0, str(pathlib.Path(__file__).parents[3] / "trial" / "arms"))

import mujoco
import numpy as np

from batch_statics import PlainArm
from draw import draw
from experiment import Bench, Run, clean_readings, draw_poses, weights
from generate import make
from sealing import sha256
from model_files import mjcf, quaternion, rotation, rotation_about, urdf
from ordinary import SHAPES as ORDINARY, STRENGTH, beside_frames, draw as draw_ordinary
from shapes import HOBBY, INDUSTRIAL, SHAPES
from true_arm import TrueArm
from truth import Truth


def commands(shape, count, seed=1):
    low, high = shape.limits.T
    return np.random.default_rng(seed).uniform(0.5 * low, 0.5 * high, (count, shape.size))


def load(shape):
    return np.array([0.0, 0.0, -4.0 * shape.payload])


class Statics(unittest.TestCase):
    def test_both_files_are_the_same_arm(self):
        for shape in SHAPES:
            models = [mujoco.MjModel.from_xml_string(text(shape)) for text in (mjcf, urdf)]
            for command in commands(shape, 5):
                places = []
                for model in models:
                    data = mujoco.MjData(model)
                    data.qpos[:] = command
                    mujoco.mj_kinematics(model, data)
                    last = model.body(f"link_{shape.size}").id
                    places.append(data.xpos[last] + data.xmat[last].reshape(3, 3) @ shape.tip)
                # URDF is written to twelve digits
                np.testing.assert_allclose(*places, atol=1e-10 * shape.length)

    def test_dynamics_come_to_rest_at_the_static_equilibrium(self):
        for shape in SHAPES:
            arm = TrueArm(shape, Truth(shape.size))
            path = commands(shape, 3)
            rest = [arm.rest(c, load(shape)) for c in path]
            settled = arm.settle(rest[0], path, [load(shape)] * 3)
            # what is left of a motion after the hold, far below a tracker's hundredth of a millimetre
            np.testing.assert_allclose(settled, rest, atol=1e-6)

    def test_springs_yield_in_proportion_to_their_torque(self):
        """The same at many poses at once, by other equations: moments about the axes."""
        for shape in SHAPES:
            path = commands(shape, 10)
            forces = np.tile(load(shape), (10, 1))
            arm = TrueArm(shape, Truth(shape.size))
            at_once = PlainArm.of_shape(shape).rest(path, forces)
            # three repetitions: the sag, 0.06 rad at most, times the cube of the share by which it changes its own torque, 0.03
            np.testing.assert_allclose([arm.rest(c, load(shape)) for c in path], at_once, rtol=0, atol=2e-6)

    def test_a_rubbing_joint_lags_by_its_friction(self):
        """It stops short of the frictionless equilibrium by tau/k, on the side from which it came."""
        shape = HOBBY
        truth = Truth(shape.size, friction=np.full(shape.size, 0.2))
        path = commands(shape, 3)
        free = TrueArm(shape, Truth(shape.size))
        rest = np.array([free.rest(c, load(shape)) for c in path])
        rubbing = np.array(TrueArm(shape, truth).settle(rest[0], path, [load(shape)] * 3))
        lag = -0.2 * np.sign(np.diff(path, axis=0)) / shape.stiffness
        # MuJoCo's friction is soft, and a joint's lag changes its neighbours' torques: 5 %
        np.testing.assert_allclose((rubbing - rest)[1:], lag, atol=0.05 * 0.2 / shape.stiffness.min())

    def test_a_bending_link_is_a_cantilever(self):
        """The tip of the stretched arm sinks by F L^3/3EI of the link, and by its slope F L^2/2EI + F l L/EI times what hangs beyond."""
        shape, link, rigidity, force = INDUSTRIAL, 2, 1e7, 100.0
        truth = Truth(shape.size, bending={link: rigidity})
        bent, straight = TrueArm(shape, truth), TrueArm(shape, Truth(shape.size))
        command = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0])

        def sinks(arm):
            places = [arm.tip_pose(arm.rest(command, np.array([0.0, 0.0, -f])))[0] for f in (0.0, force)]
            return places[0][2] - places[1][2]

        length = np.linalg.norm(shape.links[3].place)
        beyond = sum(np.array(shape.links[i].place) for i in (4, 5)) + np.array(shape.tip)
        along = beyond[0]
        expected = force / rigidity * (length**3 / 3 + length**2 * along + length * along**2)
        # the offsets of 54 and 60 mm across the arm add twist and turn: some per cent
        self.assertAlmostEqual(sinks(bent) - sinks(straight), expected, delta=0.05 * expected)

    def test_a_bending_link_sags_by_its_own_weight(self):
        """By W L^3/8EI, and its slope W L^2/6EI times what is beyond; a motor at its end adds a load there."""
        link, rigidity, mass = 2, 1e7, 300.0
        for motor in (0.0, 100.0):
            reach = np.array(INDUSTRIAL.links[link + 1].place)
            centre = tuple(reach * (mass / 2 + motor) / (mass + motor))
            links = tuple(replace(one, mass=mass + motor if i == link else 1e-6, centre=centre if i == link else one.centre)
                          for i, one in enumerate(INDUSTRIAL.links))
            shape = replace(INDUSTRIAL, links=links)
            places = [arm.tip_pose(arm.rest(np.zeros(6), np.zeros(3)))[0][2]
                      for arm in (TrueArm(shape, Truth(shape.size, bending={link: rigidity})), TrueArm(shape, Truth(shape.size)))]
            length = np.linalg.norm(reach)
            beyond = sum(np.array(shape.links[i].place) for i in (4, 5)) + np.array(shape.tip)
            expected = 9.81 / rigidity * (mass * (length**3 / 8 + length**2 / 6 * beyond[0]) + motor * (length**3 / 3 + length**2 / 2 * beyond[0]))
            # eight pieces lack 1/(4 8^2) of the slope; the link lies 3 degrees off the horizontal
            self.assertAlmostEqual(places[1] - places[0], expected, delta=0.01 * expected)

    def test_play_lies_where_the_load_pushes(self):
        shape = INDUSTRIAL
        command = commands(shape, 1)[0]
        tight, loose = (TrueArm(shape, Truth(shape.size, play=play)) for play in ({}, {1: 1e-3}))
        q, p = (arm.rest(command, load(shape)) for arm in (tight, loose))
        side = np.sign(q[1] - command[1])
        self.assertAlmostEqual(p[1] - q[1], side * 1e-3, delta=1e-6)  # the torque changes by a thousandth


class Rotations(unittest.TestCase):
    def test_quaternions_turn_as_their_matrices(self):
        random = np.random.default_rng(3)
        for _ in range(50):
            matrix = rotation(random.uniform(-3, 3, 3)) @ rotation_about(random.normal(size=3))
            back = np.zeros(9)
            mujoco.mju_quat2Mat(back, quaternion(matrix))
            np.testing.assert_allclose(back.reshape(3, 3), matrix, atol=1e-12)


class Drawing(unittest.TestCase):
    def test_a_seed_is_a_trial(self):
        written = []
        for _ in range(2):
            with tempfile.TemporaryDirectory() as folder:
                out, labels = pathlib.Path(folder) / "a", pathlib.Path(folder) / "b"
                labels.mkdir()
                name, seal = make((out, labels, 5, (), None, 3))
                envelope = json.loads((labels / f"{name}.json").read_text())
                self.assertEqual(seal, sha256(envelope["salt"] + "\n" + envelope["label"]))
                written.append({f.name: f.read_text() for f in sorted((out / name).iterdir())})
        self.assertEqual(*written)

    def test_a_cause_is_as_strong_as_the_label_says(self):
        drawn = draw(0, 11, ("joint_zero",))
        self.assertEqual([one.cause.id for one in drawn.planted], ["joint_zero"])
        self.assertGreater(drawn.strength, 2)


class Ordinary(unittest.TestCase):
    def test_motions_of_tracker_and_ball_have_no_strength_beside_frames(self):
        shape, random = ORDINARY[0], np.random.default_rng(2)
        bench = Bench(shape, [Run("poses", draw_poses(shape, 20, random), weights(shape, 0, 20))], (), False, False)
        moved, small = Truth(shape.size), 1e-4
        moved.tracker_shift, moved.tracker_turn, moved.tip_shift = small * random.normal(size=(3, 3))
        nominal, seen = clean_readings(bench, Truth(shape.size)), clean_readings(bench, moved)
        # to first order: what is left is the square of the turn times the reach, and joints that yield to the tip's own weight, which is none
        self.assertLess(beside_frames(bench, seen, nominal) * shape.tracker, 2 * small**2 * shape.length)

    def test_an_ordinary_arm_has_one_cause_of_the_strength_in_four_of_five(self):
        drawn = [draw_ordinary(number, 3, 6e-4) for number in (0, 4)]
        self.assertEqual([len(one.planted) for one in drawn], [1, 0])
        self.assertLess(abs(np.log(drawn[0].planted[0].strength / STRENGTH)), 0.1)


if __name__ == "__main__":
    unittest.main()
