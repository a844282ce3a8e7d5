"""A written experiment, as its owner sees it."""
import csv
import tomllib
from dataclasses import dataclass

import numpy as np

from shapes import SHAPES


@dataclass
class Experiment:
    shape: object
    commands: np.ndarray
    forces: np.ndarray
    places: np.ndarray  # reading, point, coordinate
    reached: np.ndarray  # or None
    offsets: list  # of the points from the tip
    sigma: dict
    tracker: float = 0.0


def read_experiment(folder):
    document = tomllib.loads((folder / "experiment.toml").read_text())
    shape = next(s for s in SHAPES if document["arm"]["model"].startswith(s.name + "."))
    rows = []
    for run in document["run"]:
        with open(folder / run["samples"], newline="") as file:
            rows += [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    points = document["arm"]["point"]

    def columns(names):
        return np.array([[row[name] for name in names] for row in rows])

    joints = range(1, shape.size + 1)
    places = columns([f"{p['name']}_{axis}" for p in points for axis in "xyz"]).reshape(len(rows), len(points), 3)
    reached = columns([f"q{j}" for j in joints]) if "q1" in rows[0] else None
    return Experiment(shape, columns([f"q_command{j}" for j in joints]), columns(["Fx", "Fy", "Fz"]), places, reached,
                      [np.array(p["offset"]) for p in points], document["noise"])
