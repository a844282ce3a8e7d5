"""Makes the readings of this folder: a lever behind a spring that hardens.

usage: make.py FOLDER

The drive is held; the lever of 0.25 m is pushed aside at its end by a force that grows and goes back. The spring carries
k d (1 + c d^2) against its deflection d. The place of the end and the angle of the joint are read, with noise.
"""
import math
import random
import sys
from pathlib import Path

LENGTH, STIFFNESS, HARDENING = 0.25, 8.0, 1.5
NOISE_PLACE, NOISE_ANGLE = 1e-4, 4e-4
RUNS = {"up": (0.0, 18.0), "down": (0.0, -18.0), "lifted": (0.5, 15.0)}
READINGS = 20  # on the way there, and back


def angle(rest, force):
    """Where the spring holds the force: what is missing falls with the angle."""
    low, high = rest - 1.4, rest + 1.4
    for _ in range(60):
        q = (low + high) / 2
        d = q - rest
        if STIFFNESS * d * (1 + HARDENING * d * d) < LENGTH * math.cos(q) * force:
            low = q
        else:
            high = q
    return q


def main(folder):
    noise = random.Random(1)
    for name, (rest, largest) in RUNS.items():
        lines = ["t,x,y,Fx,Fy,q1"]
        for i in range(2 * READINGS + 1):
            force = round((1 - abs(1 - i / READINGS)) * largest, 4) + 0.0
            q = angle(rest, force)
            x, y = (LENGTH * part + noise.gauss(0, NOISE_PLACE) for part in (math.cos(q), math.sin(q)))
            lines.append(f"{i},{x:.5f},{y:.5f},0,{force},{q + noise.gauss(0, NOISE_ANGLE):.5f}")
        (folder / f"{name}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


main(Path(sys.argv[1]))
