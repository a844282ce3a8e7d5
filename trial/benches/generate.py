#!/usr/bin/env python3
"""Makes experiments on the benches that people have, and seals their labels.

    generate.py OUT --seed S --count N [--faint]

writes OUT/benches-S/NAME/ (the experiment), OUT/benches-S/seals.json and, apart from them, OUT/benches-S-labels/NAME.json. Moved to
OUT/benches-S/labels, labels are opened: `plumbline trial --experiments OUT/benches-S` scores.
"""
import argparse
import hashlib
import json
import pathlib

from draw import draw
from recipe import FAINT, PLAIN
from write_experiment import label, write_experiment


def sha256(text):
    return hashlib.sha256(text.encode()).hexdigest()


def make(out, labels, seed, number, recipe=PLAIN):
    """One experiment: its name and its seal."""
    drawn = draw(number, seed, recipe)
    name = f"{drawn.bench.kind}-{number:03d}"
    write_experiment(out / name, name, drawn)
    envelope = {"salt": sha256(f"{seed}\n{name}")[:32], "label": label(name, drawn)}
    (labels / f"{name}.json").write_text(json.dumps(envelope, indent=1) + "\n")
    return name, sha256(envelope["salt"] + "\n" + envelope["label"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--faint", action="store_true", help="strengths from far below the noise, noise of every kind: for calibration")
    a = parser.parse_args()
    out, labels = a.out / f"benches-{a.seed}", a.out / f"benches-{a.seed}-labels"
    for folder in (out, labels):
        folder.mkdir(parents=True)
    seals = dict(make(out, labels, a.seed, number, FAINT if a.faint else PLAIN) for number in range(a.count))
    text = json.dumps({"format": "experiment-seals/1", "seals": seals}, indent=1) + "\n"
    (out / "seals.json").write_text(text)
    print(f"{a.count} experiments in {out}; SHA-256 of the seals: {sha256(text)}")


if __name__ == "__main__":
    main()
