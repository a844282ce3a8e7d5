#!/usr/bin/env python3
"""The true benches of the trial: statics against closed forms, energy, known labels, files and seals. Needs numpy and scipy."""
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[3] / "trial" / "benches"))

import numpy as np

from aliases import Readings, aliases, is_imitated
from bench import GRAVITY, Bench, Run
from catalogue import ROWS
from detection import even_chance
from draw import draw
from generate import make
from sealing import sha256
from joint_law import JointLaw
from loads import Loads, delayed, tensions
from statics import clean_readings
from truth import JointTruth, Slider, Truth

STIFFNESS = 40.0  # N m/rad
LOOP = 0.1 * np.interp(np.linspace(0, 4, 161), [0, 1, 3, 4], [0, 1, -1, 0])  # rad
TIME = 0.5 * np.arange(len(LOOP))


def row(id):
    return next(row for row in ROWS if row.id == id)


def held(control="angle", imposed=LOOP, loaded_by=""):
    run = Run("run", control, TIME[:len(imposed)], np.zeros((len(imposed), 1)), imposed=imposed, loaded_by=loaded_by)
    return Bench("loop", np.array([STIFFNESS]), [run], alone="revolute", sigma=0.02, sweep=True)


def arm(commands, begins="relaxed", **parts):
    n = commands.shape[1]
    run = Run("run", "command", 0.5 * np.arange(len(commands)), commands, begins=begins)
    return Bench("sweep", np.full(n, 60.0), [run], length=np.full(n, 0.3), mass=np.full(n, 0.8), plane="vertical", sigma=5e-4, sweep=True, **parts)


def work(torque, angle):
    """By the trapezoidal rule, exact for lines between readings."""
    return float(np.sum((torque[1:] + torque[:-1]) / 2 * np.diff(angle)))


class ClosedForms(unittest.TestCase):
    def test_a_level_servo_sags_until_its_spring_carries_the_weight(self):
        read = clean_readings(arm(np.linspace(-1, 1, 21)[:, None]), Truth.none(1))[0][:, 0]
        # k (q - command) = -m g L/2 cos q
        np.testing.assert_allclose(60.0 * (read - np.linspace(-1, 1, 21)), -0.8 * GRAVITY * 0.15 * np.cos(read), atol=1e-6)

    def test_a_maxwell_arm_under_constant_speed(self):
        """Its torque is m k v tau (1 - exp(-t/tau))."""
        time, speed, m, tau = np.arange(0, 20, 0.5), 0.01, 0.4, 3.0
        law = JointLaw(STIFFNESS, JointTruth(arms=[(m * STIFFNESS, tau)]))
        expected = STIFFNESS * speed * (time + m * tau * (1 - np.exp(-time / tau)))
        np.testing.assert_allclose(law.torques(speed * time, 0 * time, time), expected, rtol=1e-12, atol=1e-12)

    def test_torques_and_deflections_are_each_others_inverse(self):
        laws = {"hardening": JointTruth(hardening=30.0), "play": JointTruth(play=0.02), "stop": JointTruth(stop=(0.05, 100.0)),
                "knee": JointTruth(knee=(0.04, 0.5)), "uneven": JointTruth(uneven=0.3), "plastic": JointTruth(plastic=(2.0, 0.4)),
                "arms": JointTruth(arms=[(12.0, 5.0)]),
                "slider": JointTruth(sliders=[Slider(20.0, lambda q, d: (0.5, 0.5), False)]),
                "contact": JointTruth(sliders=[Slider(1e4 * STIFFNESS, lambda q, d: (0.3, 0.2), True)])}
        for name, truth in laws.items():
            with self.subTest(name):
                law = JointLaw(STIFFNESS, truth)
                torques = law.torques(LOOP, 0 * LOOP, TIME)
                back = law.torques(law.deflections(torques, 0 * LOOP, TIME), 0 * LOOP, TIME)
                # Newton's method ends at 1e-12 of the deflection; inside play and friction every angle has the torque
                np.testing.assert_allclose(back, torques, atol=1e-6)

    def test_a_joint_balances_what_is_beside_its_spring(self):
        """Also where no torque is imposed."""
        beside = JointTruth(beside=[lambda q: 2.0 * np.sin(5 * q - 0.3)], sliders=[Slider(10.0, lambda q, d: (0.1, 0.1), True)])
        for truth in (beside, JointTruth(beside=beside.beside)):
            d = JointLaw(STIFFNESS, truth).deflections(np.zeros(3), np.zeros(3), np.arange(3.0))
            np.testing.assert_allclose(STIFFNESS * d + 2.0 * np.sin(5 * d - 0.3), 0, atol=1e-8)

    def test_a_lag_follows_a_ramp_late_by_its_time_constant(self):
        time = np.arange(0, 50, 0.5)
        np.testing.assert_allclose(delayed(2 * time, time, 1.5)[60:], 2 * (time - 1.5)[60:], atol=1e-6)

    def test_a_tendon_loses_a_factor_at_every_joint_and_keeps_its_tension_on_the_way_back(self):
        value = np.array([0.0, 5.0, 10.0, 9.9, 0.1])
        mu = 0.1
        along = tensions(value, 3, mu)
        np.testing.assert_allclose(along[2], 10 * np.exp(-mu * np.arange(3)))
        np.testing.assert_allclose(along[3, 1:], along[2, 1:])
        np.testing.assert_allclose(along[4], 0.1 * np.exp(mu * np.arange(3)))

    def test_a_servo_with_friction_lags_on_either_way(self):
        there = np.linspace(-0.5, 0.5, 30)
        commands = np.concatenate([there, there[::-1]])[:, None]
        level = arm(commands, begins="moving")
        level.plane = "horizontal"
        truth = Truth.none(1)
        row("joint_friction").put(truth, level, -1, [0.6])
        read = clean_readings(level, truth)[0][:, 0]
        np.testing.assert_allclose((read - commands[:, 0])[:30], -0.01, atol=1e-6)
        # a reading later the joint slips the other way: twice the lag is less than a step of the command
        np.testing.assert_allclose((read - commands[:, 0])[31:], 0.01, atol=1e-6)

    def test_errors_of_a_load_sensor_act_on_what_a_servo_imposes(self):
        truth = Truth.none(1)
        truth.zero, truth.gain = 0.3, 0.1
        torque = np.linspace(0, 4, 20)
        by_servo, by_weights = (clean_readings(held("torque", torque, by), truth)[0][:, 0] for by in ("servo", "weights"))
        np.testing.assert_allclose(by_servo, (torque - 0.3) / 1.1 / STIFFNESS)
        np.testing.assert_allclose(by_weights, torque / STIFFNESS)


class Energy(unittest.TestCase):
    def test_loads_do_the_work_that_their_potential_loses(self):
        random = np.random.default_rng(2)
        n, force = 3, np.array([3.0, -7.0])
        run = Run("run", "force", np.arange(1.0), np.zeros((1, n)), force=force[None], link_force=np.array([[1.0, 2.0]]), loaded_by="weights")
        bench = Bench("hung", np.ones(n), [run], length=np.array([0.3, 0.2, 0.25]), mass=np.array([1.0, 0.7, 0.4]), plane="vertical", load="force", link=2, at=0.6)
        truth = Truth.none(n)
        truth.payload, truth.eccentricity, truth.coupling = 2.0, 0.03, 5.0

        def potential(q):
            theta = np.cumsum(q)
            along = np.stack([np.cos(theta), np.sin(theta)], axis=1)
            ends = np.cumsum(along * bench.length[:, None], axis=0)
            middles = ends - along * bench.length[:, None] / 2
            at = ends[1] - 0.4 * bench.length[1] * along[1]
            acts = ends[2] + 0.03 * np.array([-along[2, 1], along[2, 0]])
            return (GRAVITY * bench.mass @ middles[:, 1] + 2.0 * ends[2, 1] - force @ acts - np.array([1.0, 2.0]) @ at
                    - 5.0 * (q[0] * q[1] + q[1] * q[2]))

        q, h = random.uniform(-1, 1, n), 1e-6
        slope = [(potential(q + h * e) - potential(q - h * e)) / (2 * h) for e in np.eye(n)]
        # central differences: h^2 times the third derivative, 10 N m
        np.testing.assert_allclose(Loads(bench, truth, run).torques(q[None], q[None])[0], -np.array(slope), atol=1e-8)

    def test_springs_give_back_what_they_took_and_friction_takes_its_torque_times_the_way(self):
        elastic = JointLaw(STIFFNESS, JointTruth(hardening=20.0, uneven=0.2))
        self.assertAlmostEqual(work(elastic.torques(LOOP, 0 * LOOP, TIME), LOOP), 0.0, places=12)
        rubbing = JointLaw(STIFFNESS, JointTruth(sliders=[Slider(1e5 * STIFFNESS, lambda q, d: (0.5, 0.5), True)]))
        # four times 0.1 rad; at each of three reversals, and at the start, half a step at less than the slip torque
        self.assertAlmostEqual(work(rubbing.torques(LOOP, 0 * LOOP, TIME), LOOP), 0.5 * 0.4, delta=0.5 * 0.0025 * 4)

    def test_unloading_is_loading_doubled(self):
        """Masing's rule for an element that slips."""
        law = JointLaw(STIFFNESS, JointTruth(sliders=[Slider(30.0, lambda q, d: (0.9, 0.9), False)]))
        torque = law.torques(LOOP, 0 * LOOP, TIME)
        up, down = torque[:41], torque[40:121]
        np.testing.assert_allclose(down[::2], up[-1] - 2 * up, atol=1e-9)


class Labels(unittest.TestCase):
    def test_a_zero_of_the_sensor_and_a_rest_angle_read_the_same(self):
        self.assertIn(["rest_angle(1)"], aliases(held(), [(row("load_zero"), -1, [0.2])]))
        self.assertNotIn(["joint_stiffness(1)"], aliases(held(), [(row("load_zero"), -1, [0.2])]))

    def test_the_weight_of_one_link_and_a_payload_read_the_same(self):
        bench = arm(np.linspace(-1, 1, 21)[:, None])
        found = aliases(bench, [(row("gravity"), -1, [0.5])])
        for other in ("tip_payload", "mass_scale"):
            self.assertIn([other], found)

    def test_hardening_is_like_nothing_else_on_a_loop(self):
        self.assertEqual(aliases(held(), [(row("nonlinear_spring"), -1, [40.0])]), [])

    def test_a_contact_beyond_an_angle_is_a_stop_and_not_outside(self):
        bench, truth = held(), Truth.none(1)
        truth.joints[0].beside.append(lambda q: 30.0 * np.maximum(0.0, q - 0.05) - 30.0 * np.maximum(0.0, -q - 0.05))
        self.assertTrue(is_imitated(bench, truth, 4.0))

    def test_strength_is_the_root_mean_square_over_the_noise(self):
        bench = held()
        truth = Truth.none(1)
        truth.zero = 0.1
        self.assertAlmostEqual(float(np.sqrt(np.mean(Readings(bench).of(truth) ** 2))), 5.0)


class Drawing(unittest.TestCase):
    def test_a_seed_is_a_trial(self):
        written = []
        for _ in range(2):
            with tempfile.TemporaryDirectory() as folder:
                out, labels = pathlib.Path(folder) / "a", pathlib.Path(folder) / "b"
                labels.mkdir()
                name, seal = make(out, labels, 5, 0)
                envelope = json.loads((labels / f"{name}.json").read_text())
                self.assertEqual(seal, sha256(envelope["salt"] + "\n" + envelope["label"]))
                written.append({f.name: f.read_text() for f in sorted((out / name).iterdir())})
        self.assertEqual(*written)

    def test_an_experiment_has_the_declared_strength(self):
        drawn = draw(3, 11)
        self.assertTrue(drawn.strength == 0 or drawn.strength > 2)


class Detection(unittest.TestCase):
    def test_an_even_chance_is_where_as_many_gaps_are_found_as_missed(self):
        # Of 100 benches at each size so many are found as a logistic law in the logarithm has, to a whole one; half of them at 5.
        size = np.repeat(np.exp(np.linspace(np.log(1), np.log(25), 21)), 100)
        chance = 1 / (1 + (5 / size) ** 2)
        seen = np.tile(np.arange(100), 21) < np.round(100 * chance)
        # Rounding moves a chance by 0.005 at most, and the logarithm of the size at the middle by 0.01.
        self.assertAlmostEqual(even_chance(size, seen), 5, delta=0.05)


if __name__ == "__main__":
    unittest.main()
