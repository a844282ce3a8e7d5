#!/usr/bin/env python3
"""Makes the logs of this example: a pendulum on a position servo, simulated apart from Plumbline (small steps of Euler's).

The truth is a command that acts 30 ms late, beside the numbers below. Readings are rounded as an encoder of 4096 lines does.
"""
import csv
import math
import pathlib
import random

FOLDER = pathlib.Path(__file__).parent
TRUTH = {"stall_torque": 0.3, "back_emf": 0.25, "armature": 0.006, "zero": 0.01, "dry": 0.06, "viscous": 0.03, "delay": 0.030}
SUPPLY, DUTY_PER_ERROR, QUANTUM = 12.0, 0.16, 2 * math.pi / 4096
MASS, LENGTH, GRAVITY = 0.5, 0.12, 9.81
STEP, READ_EVERY, DURATION = 5e-5, 0.01, 4.0


def command(kind, t):
    if kind == "sines":
        return 0.7 * math.sin(2.2 * t) + 0.25 * math.sin(6.1 * t)
    if kind == "chirp":
        return 0.6 * math.sin(1.3 * t * t)
    return 0.9 * min(t, 1.5) / 1.5 - 0.25 * max(0.0, min(t - 2.2, 0.6)) / 0.6  # up, a little down, hold


def log(kind, gain):
    inertia = MASS * LENGTH**2 + TRUTH["armature"]
    delay, per_read = round(TRUTH["delay"] / STEP), round(READ_EVERY / STEP)
    q = v = 0.0
    held = []  # the command as the bus holds it, step by step
    rows = []
    for k in range(round(DURATION / STEP)):
        t = k * STEP
        if k % per_read == 0:
            sent = command(kind, t)
            read = round((q + random.gauss(0, 3e-4)) / QUANTUM) * QUANTUM
            rows.append([f"{t:.3f}", f"{sent:.5f}", f"{read:.5f}"])
        held.append(sent)
        late = held[max(0, k - delay)]
        duty = max(-1.0, min(1.0, DUTY_PER_ERROR * gain * (late - q)))
        torque = TRUTH["stall_torque"] * SUPPLY * duty - MASS * GRAVITY * LENGTH * math.sin(q + TRUTH["zero"])
        torque -= (TRUTH["back_emf"] + TRUTH["viscous"]) * v
        pushed = v + STEP * torque / inertia
        v = math.copysign(max(0.0, abs(pushed) - STEP * TRUTH["dry"] / inertia), pushed)
        q += STEP * v
    return rows


def main():
    random.seed(72)
    index = []
    for kind in ("sines", "chirp", "slow"):
        for gain in (4, 8, 16):
            name = f"{kind}-{gain:02}.csv"
            index.append([name, gain, "held out" if gain == 8 else "fit"])
            with open(FOLDER / name, "w", newline="") as file:
                csv.writer(file, lineterminator="\n").writerows([["t", "command", "position"], *log(kind, gain)])
    with open(FOLDER / "index.csv", "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([["file", "gain", "role"], *index])


if __name__ == "__main__":
    main()
