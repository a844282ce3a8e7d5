#!/usr/bin/env python3
"""Makes experiments with arms in space and seals their labels.

    generate.py OUT --seed S --count N [--only ID ... | --tolerance RAD]

writes OUT/arms-S/NAME/ (the experiment), OUT/arms-S/seals.json and, apart from them, OUT/arms-S-labels/NAME.json and held-out/NAME/ (the
same arm at other poses, without noise). With --tolerance every joint is off by as much, and the tracker stands anywhere. Moved to OUT/arms-S/labels, labels are opened: `plumbline trial --experiments OUT/arms-S` scores.
"""
import argparse
import hashlib
import json
import multiprocessing
import pathlib

import ordinary
from draw import draw
from write_experiment import label, write_experiment


def sha256(text):
    return hashlib.sha256(text.encode()).hexdigest()


def make(job):
    out, labels, seed, only, tolerance, number = job
    drawn = draw(number, seed, only) if tolerance is None else ordinary.draw(number, seed, tolerance)
    name = f"{drawn.bench.shape.name}-{number:03d}"
    write_experiment(out / name, name, drawn.bench, drawn.readings)
    write_experiment(labels / "held-out" / name, name, drawn.later, drawn.later_readings)
    envelope = {"salt": sha256(f"{seed}\n{name}")[:32], "label": label(name, drawn)}
    (labels / f"{name}.json").write_text(json.dumps(envelope, indent=1) + "\n")
    return name, sha256(envelope["salt"] + "\n" + envelope["label"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--only", nargs="+", default=(), metavar="ID", help="one effect out of these in each experiment")
    parser.add_argument("--tolerance", type=float, metavar="RAD", help="zeros and tilts of all joints, standard deviation; one effect of 40 sigma in each")
    a = parser.parse_args()
    out, labels = a.out / f"arms-{a.seed}", a.out / f"arms-{a.seed}-labels"
    for folder in (out, labels):
        folder.mkdir(parents=True)
    with multiprocessing.Pool(2) as pool:
        seals = dict(pool.imap(make, [(out, labels, a.seed, a.only, a.tolerance, n) for n in range(a.count)]))
    text = json.dumps({"format": "experiment-seals/1", "seals": seals}, indent=1) + "\n"
    (out / "seals.json").write_text(text)
    print(f"{a.count} experiments in {out}; SHA-256 of the seals: {sha256(text)}")


if __name__ == "__main__":
    main()
