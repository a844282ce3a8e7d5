#!/usr/bin/env python3
"""Makes experiments on the benches that people have, and seals their labels.

    generate.py OUT --seed S --count N [--faint]

writes OUT/benches-S/NAME/ (the experiment), OUT/benches-S/seals.json and, apart from them, OUT/benches-S-labels/NAME.json. Moved to
OUT/benches-S/labels, labels are opened: `plumbline trial --experiments OUT/benches-S` scores.
"""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from draw import draw  # noqa: E402
from recipe import FAINT, PLAIN  # noqa: E402
from write_experiment import label, write_experiment  # noqa: E402
from sealing import new_folders, sealed, write_seals  # noqa: E402


def make(out, labels, seed, number, recipe=PLAIN):
    """One experiment: its name and its seal."""
    drawn = draw(number, seed, recipe)
    name = f"{drawn.bench.kind}-{number:03d}"
    write_experiment(out / name, name, drawn)
    return sealed(labels, name, seed, label(name, drawn))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--faint", action="store_true", help="strengths from far below the noise, noise of every kind: for calibration")
    a = parser.parse_args()
    out, labels = new_folders(a.out, "benches", a.seed)
    seals = dict(make(out, labels, a.seed, number, FAINT if a.faint else PLAIN) for number in range(a.count))
    write_seals(out, seals)


if __name__ == "__main__":
    main()
