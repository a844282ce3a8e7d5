#!/usr/bin/env python3
"""What others would fit to the same tables, how well it predicts poses that were not fitted, and what it blames.

    race.py OUT/arms-S OUT/arms-S-labels --json FILE [--plumbline PROGRAM]

Three ways: least squares over zeros and stiffnesses of the joints and the place of the tool (what a user writes); MuJoCo's own system
identification (mujoco.sysid) over servo gains, masses and centres of the bodies; Plumbline's corrected model. Errors are root mean squares
of the tip's coordinates at held-out poses, over the standard deviation of the tracker. A parameter is blamed where it is five standard
errors off its nominal value.
"""
import argparse
import json
import pathlib

import numpy as np

from batch_statics import PlainArm
from plumbline_corrected import plumbline_blames_and_errors
from racers import OffsetsAndStiffnesses, Sysid, predicted
from read_experiment import read_experiment

BLAMED = 5.0  # standard errors
ALL = "all"


def error_of(experiment, places):
    return float(np.sqrt(np.mean(((places - experiment.places) / experiment.tracker) ** 2)))


def blames(names, z):
    order = np.argsort(-np.abs(z))
    return [f"{names[i]} {z[i]:+.0f}" for i in order if abs(z[i]) > BLAMED]


def start(folder, label, experiment, later):
    nominal = predicted(PlainArm.of_shape(experiment.shape), later, later.commands)[0]
    truth = [e["id"] + (f"({e['joint']})" if e["joint"] else "") for e in label["effects"]]
    return {"name": folder.name, "truth": truth, "family": label["family"],
            "alike": [one[0] for one in label["equivalent"]], "nominal": error_of(later, nominal)}


def race(folder, later_folder, label, plumbline, row):
    """Adds to the row what is not in it."""
    experiment, later = read_experiment(folder), read_experiment(later_folder)
    later.tracker = experiment.shape.tracker
    row = row or start(folder, label, experiment, later)
    for racer in (OffsetsAndStiffnesses(experiment.shape), Sysid(experiment.shape)):
        if racer.name in row:
            continue
        try:
            x, z = racer.fit(experiment)
            row[racer.name] = error_of(later, racer.predict(x, later)[0])
            row[racer.name + " blames"] = blames(racer.names, z)
        except np.linalg.LinAlgError as error:
            row[racer.name], row[racer.name + " blames"] = None, [str(error)]
    if plumbline and "plumbline" not in row:
        row["plumbline"], row["plumbline blames"] = plumbline_blames_and_errors(plumbline, folder, later_folder, later)
    return row


# What a racer's parameter is called where it is the truth.
MEANS = {"rest_angle": ["zero"], "joint_stiffness": ["stiffness", "gain"], "link_mass": ["mass"],
         "link_centre": ["centre x", "centre y", "centre z"]}


def right_names(truth):
    if truth == "tool_offset":
        return {"tool x", "tool y", "tool z"}
    kind, _, place = truth.partition("(")
    return {f"{name}({place}" for name in MEANS.get(kind, [])}


def blames_wrongly(row, racer):
    """Whether it blames, or for Plumbline identifies, what is not the truth."""
    said = row[racer + " blames"]
    if racer == "plumbline":
        return said[0] == "identified" and sorted(said[1:]) not in [sorted(row["truth"]), *([one] for one in row["alike"])]
    right = set().union(*map(right_names, row["truth"]))
    return any(words.rsplit(" ", 1)[0] not in right for words in said)


def table(rows, racers):
    """Median error at held-out poses by family, and how often each blames what is not the truth."""
    lines = ["| family | n | error: nominal | " + " | ".join(racers) + " | blames wrongly: " + " | ".join(racers) + " |",
             "| --- |" + " ---: |" * (2 + 2 * len(racers))]
    for family in [*sorted({row["family"] for row in rows}), ALL]:
        own = [row for row in rows if family in (row["family"], ALL)]
        medians = [np.median([row[key] for row in own if row[key] is not None] or [np.nan]) for key in ("nominal", *racers)]
        blamed = [sum(blames_wrongly(row, racer) for row in own) for racer in racers]
        lines.append(f"| {family} | {len(own)} | " + " | ".join(f"{m:.2f}" for m in medians) + " | " + " | ".join(map(str, blamed)) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("experiments", type=pathlib.Path)
    parser.add_argument("labels", type=pathlib.Path)
    parser.add_argument("--plumbline", help="a program that reads arms")
    parser.add_argument("--json", type=pathlib.Path, required=True, help="what was found; an interrupted race continues")
    a = parser.parse_args()
    rows = {row["name"]: row for row in json.loads(a.json.read_text())} if a.json.exists() else {}
    for folder in sorted(f.parent for f in a.experiments.glob("*/experiment.toml")):
        envelope = json.loads((a.labels / f"{folder.name}.json").read_text())
        rows[folder.name] = race(folder, a.labels / "held-out" / folder.name, json.loads(envelope["label"]), a.plumbline, rows.get(folder.name))
        a.json.write_text(json.dumps(list(rows.values()), indent=1) + "\n")
    rows = list(rows.values())
    print(table(rows, ["zeros and stiffnesses", "mujoco.sysid"] + (["plumbline"] if a.plumbline else [])))


if __name__ == "__main__":
    main()
