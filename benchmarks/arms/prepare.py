#!/usr/bin/env python3
"""Published calibration data of arms as experiments in the project's format.

    benchmarks/arms/prepare.py DATA OUT

DATA holds a folder for each set, as benchmarks/RESULTS-arms.md names them with their sources; nothing of them is
stored here. OUT gets a folder for each, for `plumbline diagnose`: frames are unknown, noise is as declared there.
"""

import csv
import math
import pathlib
import re
import sys


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def rotation_vector(roll, pitch, yaw):
    """Of turns about the fixed axes x, y and z, one after the other."""
    half = [angle / 2 for angle in (roll, pitch, yaw)]
    (cr, cp, cy), (sr, sp, sy) = map(math.cos, half), map(math.sin, half)
    w = cr * cp * cy + sr * sp * sy
    v = (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy)
    size = math.sqrt(sum(x * x for x in v))
    if w < 0:
        w, v = -w, tuple(-x for x in v)
    angle = 2 * math.atan2(size, w)
    return [x * angle / size if size else 0.0 for x in v]


class Experiment:
    def __init__(self, name, model, base, tip, points, place, turn=None, edit=lambda text: text):
        self.name, self.model, self.base, self.tip, self.points = name, model, base, tip, points
        self.place, self.turn, self.edit, self.runs = place, turn, edit, {}

    def add(self, row, run="poses"):
        self.runs.setdefault(run, []).append(row)

    def write(self, out):
        folder = out / self.name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "arm.urdf").write_text(self.edit(self.model.read_text()))
        for run, table in self.runs.items():
            with open(folder / f"{run}.csv", "w", newline="") as file:
                writer = csv.DictWriter(file, table[0].keys())
                writer.writeheader()
                writer.writerows(table)
        points = "".join(f'[[arm.point]]\nname = "{one}"\nbody = "{self.tip}"\n' for one in self.points)
        turn = f"turn = {self.turn}\n" if self.turn else ""
        runs = "".join(f'[[run]]\nid = "{run}"\nsamples = "{run}.csv"\n' for run in self.runs)
        (folder / "experiment.toml").write_text(
            f'format = "chain-experiment/1"\nname = "{self.name}"\n[arm]\nmodel = "arm.urdf"\n'
            f'base = "{self.base}"\ntip = "{self.tip}"\nframes = "unknown"\n{points}[noise]\nplace = {self.place}\n{turn}{runs}'
        )


def irb120(data):
    own = Experiment("irb120-wu", data / "irb120-wu/irb120.urdf", "base_link", "link_6", ["a", "b", "c"], 1.5e-4)
    for row in rows(data / "irb120-wu/poses.csv"):
        one = {f"q_command{j}": math.radians(float(row[f"q{j}_deg"])) for j in range(1, 7)}
        for p, name in enumerate("abc", 1):
            one |= {f"{name}_{axis}": float(row[f"p{p}_{axis}"]) / 1000 for axis in "xyz"}
        own.add(one)
    return own


def ur10(data):
    own = Experiment("ur10-figaroh", data / "ur10-figaroh/ur10.urdf", "base_link", "wrist_3_link", ["a"], 2e-3, 2e-3)
    joints = ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"]
    for row in rows(data / "ur10-figaroh/poses.csv"):
        one = {f"q_command{j}": row[f"{name}_joint"] for j, name in enumerate(joints, 1)}
        one |= {f"a_{axis}": row[f"{axis}1"] for axis in "xyz"}
        turn = rotation_vector(*(float(row[f"phi{axis}1"]) for axis in "xyz"))
        own.add(one | {f"a_r{axis}": value for axis, value in zip("xyz", turn)})
    return own


def tiago(data):
    """Three markers of a rigid body: readings of one pose, for marker 4 is a copy of marker 3."""
    own = Experiment("tiago-figaroh", data / "tiago-figaroh/tiago.urdf", "base_link", "arm_tool_link", ["a"], 1e-3)
    joints = ["torso_lift"] + [f"arm_{j}" for j in range(1, 8)]
    for row in rows(data / "tiago-figaroh/poses.csv"):
        one = {f"q_command{j}": row[f"{name}_joint"] for j, name in enumerate(joints, 1)}
        own.add(one | {f"a_{axis}": row[f"{axis}1"] for axis in "xyz"})
    return own


def talos(data):
    own = Experiment("talos", data / "talos/arm.urdf", "base_link", "gripper_left_base_link", ["a"], 1e-3)
    for row in rows(data / "talos/p.csv") + rows(data / "talos-heldout/p.csv"):
        own.add(row)
    return own


def with_one_column(urdf):
    """Both stages of the column follow one joint, whose tip is theirs: the mount hangs on it."""
    mount = r'(<joint name="column_tip_to_tip_mount".*?<parent link=")column_tip(")'
    return re.sub(mount, r"\1column_pseudo_tip\2", urdf, flags=re.S)


def hilti(data, name):
    """A run for each height of the column, which is held out whole. What the sensor on its base says of the vertical is printed."""
    model, table = data / "hilti/trailblazer.urdf", rows(data / f"hilti/{name}.csv")
    own = Experiment(f"hilti-{name}", model, "column_base", "tool_link", ["prism"], 7.5e-4, edit=with_one_column)
    for row in table:
        one = {f"q_command{j}": row[f"q{j}"] for j in range(1, 8)}
        own.add(one | {f"prism_{axis}": row[f"prism_{axis}"] for axis in "xyz"}, f"height-{row['height']}")
    tilt = [1000 * sum(float(row[f"base_a{axis}"]) for row in table) / len(table) / 9.81 for axis in "xy"]
    print(f"hilti-{name}: the vertical by the sensor on the base, in its axes: {tilt[0]:.1f} and {tilt[1]:.1f} mrad")
    return own


def main():
    data, out = map(pathlib.Path, sys.argv[1:3])
    for one in [irb120(data), ur10(data), tiago(data), talos(data)] + [
        hilti(data, name) for name in ("flat", "outdoor", "seesaw")
    ]:
        one.write(out)


if __name__ == "__main__":
    main()
