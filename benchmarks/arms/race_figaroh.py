#!/usr/bin/env python3
"""FIGAROH's calibration on sets that prepare.py made: what it leaves of every fifth pose, held out, five times over.

    venv/bin/pip install figaroh
    venv/bin/python benchmarks/arms/race_figaroh.py OUT/SET …

Its `full_params` level: six numbers a joint, those that its regressor finds identifiable, and the frames of base and
markers. Of orientations nothing is used.
"""

import contextlib
import io
import math
import pathlib
import sys
import tempfile
import tomllib
from xml.etree import ElementTree

import numpy as np
import pandas as pd
import yaml
from figaroh.calibration.base_calibration import BaseCalibration
from figaroh.tools.robot import load_robot

FOLDS = 5


def configuration(experiment, folder, markers):
    arm = experiment["arm"]
    one = {"measurable_dof": [True] * 3 + [False] * 3, "sensor_type": "tracker"}
    return {
        "robot": {"name": experiment["name"], "properties": {"joints": {"active_joints": []}}},
        "tasks": {
            "calibration": {
                "enabled": True,
                "parameters": {"calibration_level": "full_params", "outlier_threshold": 1.0},
                "kinematics": {"base_frame": "universe", "tool_frame": arm["tip"]},
                "measurements": {
                    "markers": [dict(one, name=f"marker{k + 1}") for k in range(markers)],
                    "poses": {"base_pose": [0.0] * 6, "tool_pose": [0.0] * 6},
                },
                "data": {"source_file": str(folder / "seen.csv"), "validation_data_file": str(folder / "held.csv")},
            }
        },
    }


def moving_joints(model, arm):
    """Names from the base to the tip."""
    joints = [one for one in ElementTree.parse(model).iter("joint") if one.find("child") is not None]
    before = {one.find("child").get("link"): one for one in joints}
    names, link = [], arm["tip"]
    while link != arm["base"]:
        if before[link].get("type") != "fixed":
            names.insert(0, before[link].get("name"))
        link = before[link].find("parent").get("link")
    return names


def table(experiment, place, all_joints):
    """Poses with the joints by name, places as x1, y1, z1, …, in m and rad; joints beside the arm stand at zero."""
    rows = pd.concat([pd.read_csv(place / run["samples"]) for run in experiment["run"]], ignore_index=True)
    table = pd.DataFrame(0.0, index=rows.index, columns=all_joints)
    for j, name in enumerate(moving_joints(place / experiment["arm"]["model"], experiment["arm"])):
        table[name] = rows[f"q_command{j + 1}"]
    for k, point in enumerate(experiment["arm"]["point"]):
        for axis in "xyz":
            table[f"{axis}{k + 1}"] = rows[f"{point['name']}_{axis}"]
    return table


def robot_of(place, folder):
    """The model without meshes, which stay where they were published."""
    tree = ElementTree.parse(place)
    for link in tree.iter("link"):
        for shape in [part for part in link if part.tag in ("visual", "collision")]:
            link.remove(shape)
    tree.write(folder / "arm.urdf")
    return load_robot(str(folder / "arm.urdf"), load_by_urdf=True)


def left_of_unseen(place):
    """Root mean square of the distances that are left, m."""
    experiment = tomllib.loads((place / "experiment.toml").read_text())
    with tempfile.TemporaryDirectory() as name:
        robot = robot_of(place / experiment["arm"]["model"], pathlib.Path(name))
    poses = table(experiment, place, list(robot.model.names)[1:])
    squares, count = 0.0, 0
    for fold in range(FOLDS):
        held = np.arange(len(poses)) % FOLDS == fold
        with tempfile.TemporaryDirectory() as name, contextlib.redirect_stdout(io.StringIO()):
            folder = pathlib.Path(name)
            poses[~held].to_csv(folder / "seen.csv", index=False)
            poses[held].to_csv(folder / "held.csv", index=False)
            (folder / "config.yaml").write_text(
                yaml.safe_dump(configuration(experiment, folder, len(experiment["arm"]["point"])))
            )
            one = BaseCalibration(robot, str(folder / "config.yaml"))
            one.calib_config |= {"known_baseframe": False, "known_tipframe": False}
            one.initialize()
            one.solve(enable_logging=False)
            found = one._compute_validation_metrics()
        squares += held.sum() * (found["pos_rmse_calibrated_mm"] / 1000) ** 2
        count += held.sum()
    return math.sqrt(squares / count)


for place in map(pathlib.Path, sys.argv[1:]):
    print(place.name, f"{1000 * left_of_unseen(place):.3g} mm")
