#!/usr/bin/env python3
"""Fits of a fixed list against a diagnosis, on sealed logs whose true cause is on nobody's basic list.

    race.py PLUMBLINE EXPERIMENTS LABELS RESULTS [--count N]

takes the first N experiments in which one or two listed effects act, none of them a wrong armature, friction, torque or zero, so that the truth of
these numbers is what the model states. Everybody fits armature, damping and dry friction; BAM's models fit torque and zero, too. RESULTS is a
folder: what it holds of an earlier run is taken from there, and the table is written into it as it grows.
"""
import argparse
import csv
import json
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from draw import drawn  # noqa: E402
from fitters import EVALUATIONS, Log, error, fits  # noqa: E402
from score import answer  # noqa: E402

STATED = {"armature", "viscous_friction", "joint_friction", "stall_torque", "encoder_zero"}
# Plumbline's names of the numbers that everybody fits.
NUMBERS = {"armature": "armature", "damping": "viscous_friction", "dry": "joint_friction"}


def taken(labels, count):
    """Names, numbers and labels of the experiments that are raced on."""
    for path in sorted(labels.iterdir()):
        label = json.loads(json.loads(path.read_text())["label"])
        if label["kind"] in ("one", "two") and not label["unknown"] and not STATED & set(label["causes"]):
            yield path.stem, int(path.stem.split("-")[1]), label
            count -= 1
        if count == 0:
            return


def logs_of(folder):
    """Logs to fit, and those held out."""
    logs = {"fit": [], "held out": []}
    for row in csv.DictReader((folder / "index.csv").open()):
        logs[row["role"]].append(Log(float(row["gain"]), numpy.loadtxt(folder / row["file"], delimiter=",", skiprows=1)))
    return logs["fit"], logs["held out"]


def diagnosed(plumbline, folder):
    """The report where armature and frictions are left to the fit."""
    with tempfile.TemporaryDirectory() as place:
        copy = pathlib.Path(place) / folder.name
        shutil.copytree(folder, copy)
        lines = (copy / "experiment.toml").read_text().splitlines()
        left = [f'{line.split(" =")[0]} = "unknown"' if line.split(" =")[0] in NUMBERS.values() else line for line in lines]
        (copy / "experiment.toml").write_text("\n".join(left) + "\n")
        report = pathlib.Path(place) / "report.json"
        subprocess.run([plumbline, "diagnose", copy, "--json", report], capture_output=True, timeout=1200, check=True)
        return json.loads(report.read_text())


def line_of(found, rig, held_out):
    """Bias of each number that everybody fits, and the error of logs held out, rad."""
    truth = {"armature": rig.armature, "damping": rig.damping, "dry": rig.dry}
    return {**{name: found[name] / truth[name] - 1 for name in NUMBERS}, "held out": held_out}


def fitters_race(folder, number, seed):
    """The numbers of each fit of a fixed list."""
    _, rig, *_ = drawn(number, seed)
    fitted, held_out = logs_of(folder)
    return {name: line_of(found, rig, error(predict, held_out)) for name, found, predict in fits(rig, fitted)}


def plumbline_line(plumbline, folder, number, label, seed):
    _, rig, *_ = drawn(number, seed)
    said = diagnosed(plumbline, folder)
    found = {own: next(one["value"] for one in said["drive"] if one["name"] == name) for own, name in NUMBERS.items()}
    line = line_of(found, rig, statistics.mean(one["after"] for one in said["errors"] if one["held_out"]))
    return {**line, "said": answer(label, said)}


def kept(file, make):
    """The content of a file, made now where there is none."""
    if not file.exists():
        file.write_text(json.dumps(make()))
    return json.loads(file.read_text())


def table(results):
    text = [f"| {len(results)} experiments | bias of armature | of damping | of dry friction | held-out error, mrad | said what is missing |",
            "|---|---:|---:|---:|---:|---:|"]
    for name in results[0]:
        lines = [one[name] for one in results]
        bias = [statistics.median(abs(one[number]) for one in lines) for number in NUMBERS]
        right = sum(one.get("said") in ("named alone", "named in a class") for one in lines)
        text.append(f"| {name} | " + " | ".join(f"{100 * one:.1f} %" for one in bias) +
                    f" | {1e3 * statistics.median(one['held out'] for one in lines):.2f} | {right if name == 'Plumbline' else 'no word for it'} |")
    return "\n".join(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plumbline", type=pathlib.Path)
    parser.add_argument("experiments", type=pathlib.Path)
    parser.add_argument("labels", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=12)
    a = parser.parse_args()
    seed, results = int(a.experiments.name.split("-")[1]), []
    a.results.mkdir(parents=True, exist_ok=True)
    for name, number, label in taken(a.labels, a.count):
        folder = a.experiments / name
        fitted = kept(a.results / f"{name}-fits.json", lambda: fitters_race(folder, number, seed))
        own = kept(a.results / f"{name}-plumbline.json", lambda: plumbline_line(a.plumbline.resolve(), folder, number, label, seed))
        results.append({**fitted, "Plumbline": own})
        print(name, label["causes"], results[-1]["Plumbline"]["said"],
              {who: round(1e3 * line["held out"], 2) for who, line in results[-1].items()}, flush=True)
        (a.results / "table.md").write_text(
            f"{table(results)}\n\nMedians of sizes; {EVALUATIONS} evaluations of all logs for each fit by CMA-ES.\n")


if __name__ == "__main__":
    main()
