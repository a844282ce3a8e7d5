"""The batch of 10^5 chains from NumPy against the same in C++, side by side: ratios of processor time, the fastest runs
of each, in turns.

usage: PYTHONPATH=build/python python3 benchmarks/batch.py BATCH, the program that benchmarks/batch.cpp makes
"""
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import plumbline

CHAINS, RUNS, ROUNDS = 100_000, 5, 8


def fastest(lengths, stiffness):
    best = float("inf")
    for _ in range(RUNS):
        start = time.process_time()
        plumbline.lowest_critical_forces(lengths, stiffness)
        best = min(best, time.process_time() - start)
    return best


for links in (4, 8, 30):
    rng = np.random.default_rng(links)
    lengths, stiffness = rng.uniform(0.1, 10, (2, CHAINS, links))
    with tempfile.NamedTemporaryFile() as file:
        pathlib.Path(file.name).write_bytes(np.stack([lengths, stiffness]).tobytes())
        ours, theirs = float("inf"), float("inf")
        for _ in range(ROUNDS):
            ours = min(ours, fastest(lengths, stiffness))
            printed = subprocess.run([sys.argv[1], file.name, str(links), str(RUNS)], capture_output=True, text=True, check=True)
            theirs = min(theirs, float(printed.stdout.split()[0]))
    print(f"{CHAINS} chains of {links} links: NumPy {ours * 1e3:.2f} ms, C++ {theirs * 1e3:.2f} ms, ratio {ours / theirs:.2f}")
