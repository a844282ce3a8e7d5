"""Makes the tables of this folder: an arm whose second encoder is off its axis, two wires that are drawn from its tip to the
ceiling and to a wall, and a level on its third link, none of which stands where anybody has measured it.

The arm is that of experiment.toml, with zeros that are off by a milliradian; its statics are those of ../arm/make.py.
"""
import csv
import importlib.util
import math
import random
import tomllib
from pathlib import Path

HERE = Path(__file__).parent
SPEC = importlib.util.spec_from_file_location("arm", HERE.parent / "arm" / "make.py")
statics = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(statics)

WIRES = [[0.2, 0.1, 2.1], [-0.9, -1.2, 0.4]]  # m, in the arm's base
RIPPLE = (2e-3, -3e-3)  # rad, of the cosine and the sine of the second joint's angle
PLATE = ([0.8, 0, 0.6], [-0.12, 1, 0.16])  # the level's first axis, and one beside which its second lies, in its link


def unit(v):
    return [x / math.sqrt(sum(y * y for y in v)) for x in v]


def rises(arm, q):
    """By how much both axes of the level rise above the horizon, deg."""
    first = unit(PLATE[0])
    along = sum(a * b for a, b in zip(first, PLATE[1]))
    second = unit([b - along * a for a, b in zip(first, PLATE[1])])
    out = []
    for axis in (first, second):
        for joint, angle in reversed(list(zip(arm["joint"][:3], q))):
            axis = statics.turned(joint.get("axis", [0, 0, 1]), angle, axis)
        out.append(math.degrees(math.asin(axis[2])))
    return out


def main():
    arm = tomllib.loads((HERE / "experiment.toml").read_text())["arm"]
    noise = random.Random(702401)
    statics.ZERO, statics.SOFTER = {j: noise.gauss(0, 1e-3) for j in range(6)}, {}
    commands = [[round(math.degrees(random.Random(100 * i + j).uniform(-1.2, 1.2)), 1) for j in range(6)] for i in range(40)]
    for run, weight in (("unloaded", 0), ("loaded", 3)):
        with open(HERE / f"{run}.csv", "w", newline="", encoding="utf-8") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow([*(f"q_command{j + 1}" for j in range(6)), "ceiling", "wall", "level_x", "level_y", "weight"])
            for command in commands:
                led = [math.radians(x) for x in command]
                led[1] += RIPPLE[0] * math.cos(led[1]) + RIPPLE[1] * math.sin(led[1])
                q, tip = statics.at_rest(arm, led, weight)
                lengths = [1000 * math.dist(tip, wire) + noise.gauss(0, 0.03) for wire in WIRES]
                table.writerow([*command, *(f"{x:.3f}" for x in lengths),
                                *(f"{x + noise.gauss(0, 0.005):.4f}" for x in rises(arm, q)), weight])


if __name__ == "__main__":
    main()
