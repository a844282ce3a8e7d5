#!/usr/bin/env python3
"""Makes experiments with arms in space and seals their labels.

    generate.py OUT --seed S --count N [--only ID ...] [--tolerance RAD]

writes OUT/arms-S/NAME/ (the experiment), OUT/arms-S/seals.json and, apart from them, OUT/arms-S-labels/NAME.json and held-out/NAME/ (the
same arm at other poses, without noise). With --tolerance every joint is off by as much, and the tracker stands anywhere. Moved to OUT/arms-S/labels, labels are opened: `plumbline trial --experiments OUT/arms-S` scores.
"""
import argparse
import multiprocessing
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import ordinary  # noqa: E402
from draw import draw  # noqa: E402
from write_experiment import label, write_experiment  # noqa: E402
from sealing import new_folders, sealed, write_seals  # noqa: E402


def make(job):
    out, labels, seed, only, tolerance, number = job
    drawn = draw(number, seed, only) if tolerance is None else ordinary.draw(number, seed, tolerance, only)
    name = f"{drawn.bench.shape.name}-{number:03d}"
    write_experiment(out / name, name, drawn.bench, drawn.readings)
    write_experiment(labels / "held-out" / name, name, drawn.later, drawn.later_readings)
    return sealed(labels, name, seed, label(name, drawn))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--only", nargs="+", default=(), metavar="ID", help="one effect out of these in each experiment")
    parser.add_argument("--tolerance", type=float, metavar="RAD", help="zeros and tilts of all joints, standard deviation; one effect of 40 sigma in each")
    a = parser.parse_args()
    out, labels = new_folders(a.out, "arms", a.seed)
    with multiprocessing.Pool(2) as pool:
        seals = dict(pool.imap(make, [(out, labels, a.seed, a.only, a.tolerance, n) for n in range(a.count)]))
    write_seals(out, seals)


if __name__ == "__main__":
    main()
