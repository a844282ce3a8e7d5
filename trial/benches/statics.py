"""Readings without noise: the equilibria of a bench with a truth, run by run."""
from dataclasses import replace

import numpy as np

from joint_law import JointLaw
from loads import Loads, delayed

BETWEEN = 4  # steps between two readings of several joints that slip, for their order matters
COMING = 12  # steps of the way to the first reading of a run that begins in motion
SWEEPS = 200
CLOSE = 1e-10  # of a deflection's scale


def rest_angles(truth, command, time, q):
    """Where the springs pull to: the command, with its errors."""
    n = command.shape[1]
    rest = command * np.exp(-truth.rest_loss * np.arange(n)) + np.array([joint.rest for joint in truth.joints])
    for j, joint in enumerate(truth.joints):
        if joint.shift is not None:
            rest[:, j] += joint.shift(time, q[:, j])
    return rest


def laws(bench, truth):
    return [JointLaw(k, joint) for k, joint in zip(bench.stiffness, truth.joints)]


def alone(bench, truth, run):
    """(reading, 1): the load that the sensor reads, or the coordinate."""
    law, time = laws(bench, truth)[0], run.time
    if run.is_held:
        rest = rest_angles(truth, run.command, time, run.imposed[:, None])[:, 0]
        torque = law.torques(run.imposed, rest, time)
        return (delayed((1 + truth.gain) * torque + truth.zero + truth.drift * time, time, truth.lag))[:, None]
    torque = run.imposed
    if run.loaded_by == "servo":
        torque = (torque - truth.zero - truth.drift * time) / (1 + truth.gain)
    q = run.command.copy()
    for _ in range(SWEEPS):
        rest = rest_angles(truth, run.command, time, q)[:, 0]
        new = (rest + law.deflections(torque, rest, time))[:, None]
        change, q = np.max(np.abs(new - q)), new
        if truth.joints[0].shift is None or change < CLOSE * np.max(np.abs(q)):
            return q
    raise ArithmeticError("a rest angle that finds no rest")


def stretched(values, positions):
    """A history at fractional readings."""
    at = np.arange(len(values))
    if values.ndim == 1:
        return np.interp(positions, at, values)
    return np.stack([np.interp(positions, at, column) for column in values.T], axis=1)


def finer(run, steps):
    """The run with steps between its readings, and the indices of the readings."""
    positions = np.arange((len(run.time) - 1) * steps + 1) / steps
    parts = {name: stretched(getattr(run, name), positions) for name in ("time", "command", "force", "value", "link_force")
             if getattr(run, name) is not None}
    return replace(run, **parts), np.arange(len(run.time)) * steps


def with_approach(run):
    """A run that begins in motion, with the way on which it came: a third of that to the farthest command, on the other side of the first."""
    first = run.command[0]
    farthest = run.command[np.argmax(np.linalg.norm(run.command - first, axis=1))]
    share = np.arange(COMING, 0, -1)[:, None] / COMING
    way = first - share * (farthest - first) / 3
    interval = run.time[1] - run.time[0]
    time = np.concatenate([run.time[0] - interval * np.arange(COMING, 0, -1), run.time])
    parts = {name: np.concatenate([np.repeat(getattr(run, name)[:1], COMING, axis=0), getattr(run, name)])
             for name in ("force", "value", "link_force") if getattr(run, name) is not None}
    return replace(run, time=time, command=np.concatenate([way, run.command]), **parts)


def chain(bench, truth, run):
    """(reading, joint): the joint angles. Loads are those of the last sweep's shape until no joint moves any more."""
    joints = laws(bench, truth)
    kept = np.arange(len(run.time))
    if run.begins == "moving":
        run, kept = with_approach(run), kept + COMING
    if bench.size > 1 and any(joint.truth.sliders for joint in joints):
        run, fine = finer(run, BETWEEN)
        kept = fine[kept]
    loads = Loads(bench, truth, run)
    q = run.command.copy()
    d = np.zeros_like(q)
    for _ in range(SWEEPS):
        rest = rest_angles(truth, run.command, run.time, q)
        torques = loads.torques(q, d)
        new = np.stack([law.deflections(torques[:, j], rest[:, j], run.time) for j, law in enumerate(joints)], axis=1)
        change = np.max(np.abs(rest + new - q))
        q, d = rest + new, new
        if not np.isfinite(change):
            break
        if change < CLOSE + 1e-8 * np.max(np.abs(d)):
            return q[kept]
    raise ArithmeticError("no equilibrium of the chain")


def clean_readings(bench, truth):
    """By run: (reading, channel) of what is read, without noise."""
    result = []
    for run in bench.runs:
        read = alone(bench, truth, run) if bench.alone else chain(bench, truth, run)
        if not run.is_held:
            read = (1 + truth.reading_scale) * read
            for joint, (amplitude, phase) in truth.disc.items():
                read[:, joint] += amplitude * np.sin(read[:, joint] + phase)
        if not np.all(np.isfinite(read)):
            raise ArithmeticError("a reading that is not finite")
        result.append(read)
    return result
