#!/usr/bin/env python3
"""The measurements of DLR's Agile Justin as tables that Plumbline reads.

    published.py measurements.csv OUT

writes OUT/marker_1.csv and OUT/marker_2.csv: the nineteen commanded angles and the place of the marker on one hand in the tracker's frame. The file is
dataset/measurements.csv of github.com/dlr-alr/dlr-elastic-calibration. The nominal kinematics are published as a picture: who has typed them
adds them as [[arm.joint]], and leaves the columns of the joints out that are not on the way to the hand.
"""
import csv
import pathlib
import re
import sys

import numpy as np

JOINTS = 19
NUMBER = re.compile(r"-?\d+\.?\d*(?:[eE][-+]?\d+)?")


def numbers(text, count, line):
    found = [float(word) for word in NUMBER.findall(text)]
    if len(found) != count:
        raise SystemExit(f"line {line}: found {len(found)} numbers, expected {count}")
    return np.array(found)


def read_measurements(file):
    """Commanded angles, rad, and the places of the two hands' markers, m, by pose."""
    with open(file, newline="") as source:
        rows = list(csv.DictReader(source))
    angles = np.array([numbers(row["joints"], JOINTS, i + 2) for i, row in enumerate(rows)])
    hands = np.array([numbers(row["markers"], 6, i + 2).reshape(2, 3) for i, row in enumerate(rows)])
    return angles, hands


def write_table(file, angles, places):
    header = [f"q_command{j + 1}" for j in range(JOINTS)] + [f"hand_{axis}" for axis in "xyz"]
    np.savetxt(file, np.hstack([angles, places]), fmt="%.9g", delimiter=",", header=",".join(header), comments="")


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    angles, hands = read_measurements(sys.argv[1])
    out = pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    for name, places in zip(("marker_1", "marker_2"), (hands[:, 0], hands[:, 1])):
        write_table(out / f"{name}.csv", angles, places)
    print(f"{len(angles)} poses")


if __name__ == "__main__":
    main()
