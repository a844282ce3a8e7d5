"""Makes the readings of this folder: two links on servos whose magnets pull them into steps.

usage: make.py FOLDER

Joint i carries k d + a sin(12 q) against its deflection d from rest. The end point is pushed by a force that grows and
goes back; its place and both joint angles are read, with noise.
"""
import math
import random
import sys
from pathlib import Path

LENGTH, STIFFNESS, COGGING, STEPS = (0.3, 0.2), (2.0, 1.5), 0.03, 12
NOISE_PLACE, NOISE_ANGLE = 2e-4, 5e-4
RUNS = {"push": ((0.4, -0.9), (-4.0, 1.5)), "pull": ((-0.3, 0.7), (1.0, 4.0)), "aside": ((0.2, 0.5), (-1.5, -4.0))}
READINGS = 20  # on the way there, and back


def place(q):
    first, second = q[0], q[0] + q[1]
    return (LENGTH[0] * math.cos(first) + LENGTH[1] * math.cos(second),
            LENGTH[0] * math.sin(first) + LENGTH[1] * math.sin(second))


def imbalance(q, rest, force):
    """What the joints carry less the moments of the force about them."""
    x, y = place(q)
    base = (LENGTH[0] * math.cos(q[0]), LENGTH[0] * math.sin(q[0]))
    moments = (x * force[1] - y * force[0], (x - base[0]) * force[1] - (y - base[1]) * force[0])
    return [STIFFNESS[i] * (q[i] - rest[i]) + COGGING * math.sin(STEPS * q[i]) - moments[i] for i in (0, 1)]


def settle(q, rest, force):
    """Newton's method from where the chain is, with a difference quotient for the slopes."""
    for _ in range(50):
        r, h = imbalance(q, rest, force), 1e-7
        column = [[(b - a) / h for a, b in zip(r, imbalance((q[0] + h * (j == 0), q[1] + h * (j == 1)), rest, force))]
                  for j in (0, 1)]
        determinant = column[0][0] * column[1][1] - column[1][0] * column[0][1]
        step = ((column[1][0] * r[1] - column[1][1] * r[0]) / determinant,
                (column[0][1] * r[0] - column[0][0] * r[1]) / determinant)
        q = (q[0] + step[0], q[1] + step[1])
        if max(map(abs, step)) < 1e-12:
            return q
    raise SystemExit("no equilibrium")


def main(folder):
    noise = random.Random(1)
    for name, (rest, largest) in RUNS.items():
        lines, q = ["t,x,y,Fx,Fy,q1,q2"], rest
        for i in range(2 * READINGS + 1):
            share = 1 - abs(1 - i / READINGS)
            force = (round(share * largest[0], 4) + 0.0, round(share * largest[1], 4) + 0.0)
            q = settle(q, rest, force)
            x, y = (value + noise.gauss(0, NOISE_PLACE) for value in place(q))
            angles = [value + noise.gauss(0, NOISE_ANGLE) for value in q]
            lines.append(f"{i},{x:.5f},{y:.5f},{force[0]},{force[1]},{angles[0]:.5f},{angles[1]:.5f}")
        (folder / f"{name}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


main(Path(sys.argv[1]))
