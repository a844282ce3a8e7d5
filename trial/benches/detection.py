#!/usr/bin/env python3
"""How large a gap is found: shares of the benches of a bank, by the size of what their cause changes in all readings together.

    detection.py BANK LABELS REPORTS [BANK LABELS REPORTS ...]

REPORTS is the folder that calibration.py left. The size is the root mean square change over the noise, which labels state, times the root of the number of values.
"""
import csv
import json
import pathlib
import re
import sys
import tomllib

import numpy as np
from scipy.optimize import minimize

from calibration import truth_of

EDGES = (0, 2, 3, 4, 5, 8, 12, 20, np.inf)


def values(folder):
    """The number of measured values of an experiment: of all columns of the channels whose noise it states."""
    stated = tomllib.loads((folder / "experiment.toml").read_text())
    measured = re.compile(f"({'|'.join(stated['noise'])})\\d*")
    count = 0
    for run in stated["run"]:
        with open(folder / run["samples"], newline="") as table:
            count += sum(bool(row[name]) for row in csv.DictReader(table) for name in row if measured.fullmatch(name))
    return count


def found(bank, labels, reports):
    """Of each bench with a cause: its size, and whether a gap was found."""
    for report in sorted(pathlib.Path(reports).glob("*.json")):
        label = truth_of(pathlib.Path(labels), report.stem)[0]
        if label["effects"]:
            size = label["strength_sigma"] * np.sqrt(values(pathlib.Path(bank) / report.stem))
            yield size, json.loads(report.read_text())["gap"]["present"]


def even_chance(size, seen):
    """The size at which a gap is found as often as not, by logistic regression on the logarithm of the size."""
    def loss(a):
        odds = a[0] + a[1] * np.log(size)
        return np.sum(np.logaddexp(0, np.where(seen, -odds, odds)))
    a = minimize(loss, [-2.0, 1.5], method="Nelder-Mead").x
    return float(np.exp(-a[0] / a[1]))


def main(*arguments):
    pairs = [one for i in range(0, len(arguments), 3) for one in found(*arguments[i:i + 3])]
    size, seen = np.array([s for s, _ in pairs]), np.array([y for _, y in pairs])
    print("| size | a gap is found |\n| --- | ---: |")
    for low, high in zip(EDGES, EDGES[1:]):
        inside = (size >= low) & (size < high)
        print(f"| {low:g} to {high:g} | {seen[inside].sum()} of {inside.sum()} |")
    random = np.random.default_rng(1)
    draws = [random.integers(0, len(size), len(size)) for _ in range(400)]
    low, high = np.quantile([even_chance(size[d], seen[d]) for d in draws], [0.025, 0.975])
    print(f"\nEven chance at {even_chance(size, seen):.1f} standard deviations (95 % by resampling: {low:.1f} to {high:.1f}), {len(size)} benches.")


if __name__ == "__main__":
    main(*sys.argv[1:])
