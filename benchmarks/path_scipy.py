#!/usr/bin/env python3
"""The force-deflection curve of a chain as one computes it with SciPy: root finding at every deflection, from the point
before, and the stability of every point from the Hessian on the tangent space of the constraint.

Reads on standard input what bench-path writes, and writes processor seconds (the best of five runs) and the forces as JSON.
"""
import json
import sys
import time

import numpy as np
from scipy.linalg import eigvalsh, null_space
from scipy.optimize import root


def residual(unknown, length, k, rest, place):
    """Torque out of balance at every joint, and distance of the end point from its place."""
    q, force = unknown[:-2], unknown[-2:]
    theta = np.cumsum(q)
    dx, dy = length * np.cos(theta), length * np.sin(theta)
    to_end_x, to_end_y = np.cumsum(dx[::-1])[::-1], np.cumsum(dy[::-1])[::-1]
    balance = k * (q - rest) + to_end_y * force[0] - to_end_x * force[1]
    return np.concatenate([balance, [dx.sum() - place[0], dy.sum() - place[1]]])


def negative_directions(unknown, length, k):
    """Of the Hessian in the joint angles on the directions that keep the end point."""
    q, force = unknown[:-2], unknown[-2:]
    theta = np.cumsum(q)
    dx, dy = length * np.cos(theta), length * np.sin(theta)
    to_end_x, to_end_y = np.cumsum(dx[::-1])[::-1], np.cumsum(dy[::-1])[::-1]
    last = np.maximum.outer(np.arange(len(q)), np.arange(len(q)))
    hessian = np.diag(k) + to_end_x[last] * force[0] + to_end_y[last] * force[1]
    basis = null_space(np.vstack([-to_end_y, to_end_x]))
    return int((eigvalsh(basis.T @ hessian @ basis) < 0).sum())


task = json.load(sys.stdin)
length, k, rest = (np.array(task[name]) for name in ("length", "stiffness", "rest"))
seconds = []
for _ in range(5):
    start = time.process_time()
    unknown = np.concatenate([rest, [0.0, 0.0]])
    forces, unstable = [], 0
    for x, y in zip(task["x"], task["y"]):
        unknown = root(residual, unknown, args=(length, k, rest, (x, y)), tol=task["tolerance"]).x
        unstable += negative_directions(unknown, length, k)
        forces.append(unknown[-2])
    seconds.append(time.process_time() - start)
json.dump({"seconds": min(seconds), "unstable": unstable, "Fx": forces}, sys.stdout)
