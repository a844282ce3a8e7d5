"""Fits of a list that a user chose, as the field makes them: MuJoCo's least squares, PACE's vector, the friction models of BAM.

Each takes an experiment whose servo, load, torque and zero are stated, and fits its own list. None has a word for what is not on the list.
"""
import math
import sys

import cma
import mujoco
import mujoco.minimize
import mujoco.rollout
import numba
import numpy
from rig import GRAVITY, rigid

STEP = 1e-3  # s
EVALUATIONS = 400  # of the error over all logs, by each fit that has no derivatives


class Log:
    """Readings, and the command that acts in each step."""

    def __init__(self, gain, rows):
        self.gain, (self.time, command, self.position) = gain, rows.T
        self.at = numpy.rint((self.time - self.time[0]) / STEP).astype(int)
        steps = numpy.arange(self.at[-1] + 1)
        self.command = command[numpy.searchsorted(self.at, steps, side="right") - 1]


def error(predict, logs):
    """Mean |predicted - measured|, rad, of logs that are rolled out whole."""
    return float(numpy.mean([numpy.mean(numpy.abs(predict(log)[log.at] - log.position)) for log in logs]))


# MuJoCo ------------------------------------------------------------------------------------------------------------------------------------


def mujoco_model(rig, gain, armature, damping, dry):
    weight = f'<inertial pos="0 0 {-rig.length}" mass="{rig.mass}" diaginertia="1e-9 1e-9 1e-9"/>'
    if not rig.hangs:
        weight = f'<inertial pos="0 0 0" mass="{rig.mass}" diaginertia="{rig.inertia} {rig.inertia} {rig.inertia}"/>'
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{STEP}" integrator="implicitfast" gravity="0 0 {-GRAVITY}"/><worldbody><body>'
        f'<joint name="j" axis="0 1 0" armature="{armature}" damping="{damping}" frictionloss="{dry}" {rigid(STEP)}/>{weight}</body></worldbody>'
        f'<actuator><position joint="j" kp="{rig.stall * gain}" forcerange="{-rig.stall} {rig.stall}"/></actuator></mujoco>')


def mujoco_predicted(rig, values, log):
    model = mujoco_model(rig, log.gain, *values)
    data = mujoco.MjData(model)
    data.qpos[0] = log.position[0]
    start = numpy.empty(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
    mujoco.mj_getState(model, data, start, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    states, _ = mujoco.rollout.rollout(model, data, start, log.command[:-1, None])
    return numpy.concatenate((log.position[:1], states[0, :, 1]))


def by_mujoco(rig, logs):
    """Armature, damping and dry friction by MuJoCo's own least squares, from the stated ones."""
    stated = numpy.array([rig.armature, rig.damping, rig.dry])

    def residual(shares):
        return numpy.stack([numpy.concatenate([mujoco_predicted(rig, stated * one, log)[log.at] - log.position for log in logs])
                            for one in shares.T], axis=1)

    found, _ = mujoco.minimize.least_squares(numpy.ones(3), residual, bounds=(numpy.full(3, 1e-3), numpy.full(3, 50.0)), eps=1e-4, max_iter=15,
                                             verbose=mujoco.minimize.Verbosity.SILENT)
    values = stated * found
    return dict(zip(("armature", "damping", "dry"), values)), lambda log: mujoco_predicted(rig, values, log)


# PACE and BAM ------------------------------------------------------------------------------------------------------------------------------


@numba.njit(cache=True)
def followed(command, start, gain, inertia, gravity, p):
    """Angles at every step. p: stall, damping, armature, zero, dry, delay, Stribeck, its speed, load, load at rest, motor, external, quadratic."""
    stall, damping, armature, zero, dry, delay, stribeck, slow, load, load_rest, motor_share, external_share, quadratic = p
    total = inertia + armature
    angles = numpy.empty(len(command))
    q, v = start, 0.0
    late = delay / STEP
    for k in range(len(command)):
        angles[k] = q
        q += STEP / 2 * v
        i = max(0, int(math.floor(k + 0.5 - late)))
        motor = stall * max(-1.0, min(1.0, gain * (command[i] - q)))
        external = -gravity * math.sin(q + zero)
        rest = math.exp(-abs(v) / slow) if slow > 0 else 0.0
        friction = dry + rest * stribeck + (load + rest * load_rest) * abs(motor - external)
        friction += motor_share * abs(motor) + external_share * abs(external) + quadratic * external * external
        pushed = (total - STEP / 2 * damping) * v + STEP * (motor + external)
        v = max(0.0, abs(pushed) - STEP * friction) * (1.0 if pushed > 0 else -1.0) / (total + STEP / 2 * damping)
        q += STEP / 2 * v
    return angles


COMMON = ("stall", "damping", "armature", "zero", "dry")
NAMES = COMMON + ("delay", "stribeck", "slow", "load", "load_rest", "motor", "external", "quadratic")
PACE = ("damping", "armature", "zero", "dry", "delay")
STRIBECK, LOAD, DIRECTIONAL = ("stribeck", "slow"), ("load",), ("motor", "external")
BAM = {"M1": COMMON, "M2": COMMON + STRIBECK, "M3": COMMON + LOAD, "M4": COMMON + STRIBECK + LOAD + ("load_rest",), "M5": COMMON + STRIBECK + DIRECTIONAL,
       "M6": COMMON + STRIBECK + DIRECTIONAL + ("quadratic",)}


def by_evolution(rig, logs, chosen):
    """The chosen numbers by CMA-ES, from the stated ones; the others are as stated."""
    torque = rig.mass * GRAVITY * rig.length
    gravity = torque if rig.hangs else 0.0
    stated = {"stall": rig.stall, "damping": rig.damping, "armature": rig.armature, "zero": 0.0, "dry": rig.dry}
    # Units in which a step of one is a large change; numbers that cannot be negative are squares.
    unit = {**stated, "zero": 0.1, "delay": 0.02, "stribeck": 0.1 * torque, "slow": 0.5, "load": 0.1, "load_rest": 0.1, "motor": 0.1, "external": 0.1,
            "quadratic": 0.1 / torque}

    def values(x):
        found = {**dict.fromkeys(NAMES, 0.0), **stated}
        found.update((name, unit[name] * (one if name == "zero" else one * one)) for name, one in zip(chosen, x))
        return found

    def predict(found, log):
        return followed(log.command, log.position[0], log.gain, rig.inertia, gravity, numpy.array([found[name] for name in NAMES]))

    start = [0.0 if name == "zero" else 1.0 if name in stated else 0.3 for name in chosen]
    search = cma.CMAEvolutionStrategy(start, 0.3, {"maxfevals": EVALUATIONS, "seed": 1, "verbose": -9})
    search.optimize(lambda x: error(lambda log: predict(values(x), log), logs))
    found = values(search.result.xbest)
    return found, lambda log: predict(found, log)


def fits(rig, fitted):
    """Of each fitter: its name, the numbers that it found, and its prediction of a log."""
    yield "MuJoCo, least squares", *by_mujoco(rig, fitted)
    yield "PACE's vector, CMA-ES", *by_evolution(rig, fitted, PACE)
    for name, chosen in BAM.items():
        yield f"BAM's {name}, CMA-ES", *by_evolution(rig, fitted, chosen)


if __name__ == "__main__":
    sys.exit(__doc__)
