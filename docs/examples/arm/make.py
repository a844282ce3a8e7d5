"""Makes the tables of this folder: an arm of six axes whose third encoder has a wrong zero, and whose second joint is softer
than its model.

The arm is that of experiment.toml. It stands where q = command + zero + compliance * torque, which is iterated.
"""
import csv
import math
import random
import tomllib
from pathlib import Path

HERE = Path(__file__).parent
ZERO = {2: 0.004}  # rad, by joint from 0
SOFTER = {1: 1.3}  # compliance, over the nominal one
GRAVITY = 9.81


def turned(axis, angle, v):
    """Rodrigues' formula."""
    c, s = math.cos(angle), math.sin(angle)
    dot = sum(a * b for a, b in zip(axis, v))
    cross = cross_product(axis, v)
    return [c * v[i] + s * cross[i] + (1 - c) * dot * axis[i] for i in range(3)]


def cross_product(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def poses(arm, q):
    """By joint: its axis, its origin and its link's centre of mass, in the world; then the tip."""
    frame, origin, out = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0], []
    world = lambda v: [sum(frame[k][i] * v[k] for k in range(3)) for i in range(3)]
    for joint, angle in zip(arm["joint"], q):
        origin = [o + d for o, d in zip(origin, world(joint.get("xyz", [0, 0, 0])))]
        axis = world(joint.get("axis", [0, 0, 1]))
        frame = [turned(axis, angle, column) for column in frame]
        out.append((axis, origin, [o + d for o, d in zip(origin, world(joint.get("centre", [0, 0, 0])))]))
    return out, [o + d for o, d in zip(origin, world(arm["tip_xyz"]))]


def at_rest(arm, command, weight):
    """The joint coordinates at rest, and the tip."""
    start = [q + ZERO.get(j, 0) for j, q in enumerate(command)]
    q = start
    for _ in range(12):
        bodies, tip = poses(arm, q)
        q = []
        for j, joint in enumerate(arm["joint"]):
            axis, origin, _ = bodies[j]
            loads = [(bodies[i][2], arm["joint"][i].get("mass", 0)) for i in range(j, len(bodies))] + [(tip, weight)]
            torque = sum(sum(a * m for a, m in zip(axis, cross_product([p - o for p, o in zip(place, origin)], [0, 0, -GRAVITY * mass])))
                         for place, mass in loads)
            q.append(start[j] + SOFTER.get(j, 1) / joint["stiffness"] * torque)
    return q, poses(arm, q)[1]


def main():
    experiment = tomllib.loads((HERE / "experiment.toml").read_text())
    arm, noise = experiment["arm"], random.Random(1)
    commands = [[round(random.Random(100 * i + j).uniform(-1.2, 1.2), 3) for j in range(len(arm["joint"]))] for i in range(25)]
    for run, weight in (("unloaded", 0), ("loaded", 3)):
        with open(HERE / f"{run}.csv", "w", newline="", encoding="utf-8") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["t", *(f"q_command{j + 1}" for j in range(6)), "tip_x", "tip_y", "tip_z", "weight"])
            for i, command in enumerate(commands):
                tip = at_rest(arm, command, weight)[1]
                table.writerow([30 * i, *command, *(f"{1000 * x + noise.gauss(0, 0.03):.3f}" for x in tip), weight])


if __name__ == "__main__":
    main()
