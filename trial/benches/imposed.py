#!/usr/bin/env python3
"""Whether noise of what is imposed on a joint alone is told from its motion: a third of the benches has no cause.

    imposed.py PLUMBLINE --seed S --count N [--reports FOLDER]

A joint is led there and back, in a loop or a sine. The noise of its angle passes on 3 to 20 times the noise of its torque.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from joint_law import JointLaw
from loads import delayed
from truth import JointTruth, Slider

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from scoring import table  # noqa: E402

CAUSES = ("none", "none", "joint_stiffness", "joint_friction", "viscoelasticity", "sensor_lag")
ANSWERS = ("no gap", "alone", "in the class", "other names", "other name, sure", "unknown")


def between(random, low, high):
    """Log-uniform."""
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def motion(random, most, count):
    u = np.arange(count) / (count - 1)
    return {"there and back": most * (1 - np.abs(2 * u - 1)), "loop": most * np.interp(u, [0, 0.25, 0.75, 1], [0, 1, -1, 0]),
            "sine": most * np.sin(3 * np.pi * u)}[random.choice(["there and back", "loop", "sine"])]


def torques(random, cause, stiffness, x, time):
    truth, interval = JointTruth(), time[1]
    if cause == "joint_stiffness":
        truth.softer = random.choice([-1, 1]) * random.uniform(0.05, 0.3)
    if cause == "joint_friction":
        most = stiffness * np.abs(x).max() * random.uniform(0.02, 0.1)
        truth.sliders = [Slider(1e3 * stiffness, lambda q, d: (most, most), True)]
    if cause == "viscoelasticity":
        truth.arms = [(stiffness * random.uniform(0.1, 0.4), time[-1] * random.uniform(0.03, 0.3))]
    carried = JointLaw(stiffness, truth).torques(x, 0 * x, time)
    return delayed(carried, time, interval * random.uniform(0.5, 4)) if cause == "sensor_lag" else carried


def write(random, cause, folder):
    stiffness, most, count = between(random, 20, 500), random.uniform(0.05, 0.4), int(random.integers(50, 110))
    time = float(random.choice([0.05, 0.2, 1.0])) * np.arange(count)
    x = motion(random, most, count)
    torque = torques(random, cause, stiffness, x, time)
    sigma = stiffness * most * random.uniform(0.001, 0.004)
    of_angle = sigma / stiffness * between(random, 3, 20)
    rows = zip(time, x + of_angle * random.normal(size=count), torque + sigma * random.normal(size=count))
    folder.mkdir(parents=True)
    (folder / "run.csv").write_text("t,angle,torque\n" + "".join("%.4f,%.8f,%.8f\n" % row for row in rows))
    (folder / "experiment.toml").write_text(f"""format = "chain-experiment/1"
name = "a joint whose angle is read with noise"

[nominal]
joint = "revolute"
joint_stiffness = [{stiffness:.6g}]

[columns]
t = "t"
angle = {{ column = "angle", unit = "rad" }}
torque = "torque"

[noise]
angle = {of_angle:.6g}
torque = {sigma:.6g}

[[run]]
id = "run"
control = "angle"
samples = "run.csv"
""")


def judged(cause, report):
    said = report["cause"]
    if said["verdict"] in ("none", "unknown"):
        return "no gap" if said["verdict"] == "none" else "unknown"
    members = [{e["id"] for e in said["effects"]}] + [{name.split("(")[0] for name in other} for other in said["equivalent"]]
    if {cause} in members:
        return "alone" if said["verdict"] == "identified" else "in the class"
    return "other name, sure" if said["verdict"] == "identified" else "other names"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plumbline", type=pathlib.Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--reports", type=pathlib.Path)
    a = parser.parse_args()
    random, given = np.random.default_rng(a.seed), {cause: [] for cause in CAUSES}
    reports = a.reports or pathlib.Path(tempfile.mkdtemp())
    for number in range(a.count):
        cause, folder = CAUSES[number % len(CAUSES)], reports / f"bench-{number:03d}"
        write(random, cause, folder)
        subprocess.run([a.plumbline.resolve(), "diagnose", folder, "--json", folder / "report.json"], capture_output=True, check=True)
        given[cause].append(judged(cause, json.loads((folder / "report.json").read_text())))
    print(table(given.items(), ANSWERS))


if __name__ == "__main__":
    main()
