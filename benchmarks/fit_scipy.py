#!/usr/bin/env python3
"""Fits single effects one by one, as one does with SciPy: fsolve for the equilibrium at every reading, started from
the reading before, and least_squares for the parameters.

Reads on standard input what bench-fit writes, and writes processor seconds and parameters per fit as JSON.
"""
import json
import sys
import time

import numpy as np
from scipy.optimize import fsolve, least_squares

GRAVITY = 9.81


class Chain:
    """The nominal chain with one effect of the catalogue."""

    def __init__(self, nominal, effect, joint, p):
        self.length = np.array(nominal["length"])
        self.k = np.array(nominal["stiffness"])
        self.rest_error = np.zeros_like(self.k)
        self.c = self.rho = self.tip = self.gain = 0.0
        self.base = self.bias = np.zeros(2)
        if effect == "joint_stiffness": self.k[joint - 1] *= 1 + p[0]
        elif effect == "link_length": self.length[joint - 1] *= 1 + p[0]
        elif effect == "rest_angle": self.rest_error[joint - 1] = p[0]
        elif effect == "nonlinear_spring": self.c = p[0]
        elif effect == "gravity": self.rho = p[0]
        elif effect == "tip_stiffness": self.tip = p[0]
        elif effect == "base_compliance": self.base = np.array(p)
        elif effect == "force_bias": self.bias = np.array(p)
        elif effect == "force_gain": self.gain = p[0]
        else: raise ValueError(effect)

    def balance(self, unknown, rest, end):
        """Torque of every joint out of balance, and distance of the end point from where it should be."""
        q, force = unknown[:-2], unknown[-2:]
        theta = np.cumsum(q)
        dx, dy = self.length * np.cos(theta), self.length * np.sin(theta)
        to_end_x, to_end_y = np.cumsum(dx[::-1])[::-1], np.cumsum(dy[::-1])[::-1]
        moment = to_end_x * force[1] - to_end_y * force[0] - self.tip * (theta[-1] - rest.sum())
        if self.rho:
            weight = self.rho * self.length * GRAVITY
            beyond = np.cumsum(weight[::-1])[::-1] - weight / 2
            moment = moment - np.cumsum((dx * beyond)[::-1])[::-1]
        d = q - rest - self.rest_error
        place = np.array([dx.sum(), dy.sum()]) + self.base * force
        return np.concatenate([self.k * d * (1 + self.c * d * d) - moment, place - end])

    def forces(self, run):
        """What the load cell reads at every reading of a run."""
        rest = np.array(run["rest"])
        unknown = np.concatenate([rest, [0.0, 0.0]])
        result = []
        for end in np.column_stack([run["x"], run["y"]]):
            unknown = fsolve(self.balance, unknown, args=(rest, end))
            result.append((1 + self.gain) * unknown[-2:] + self.bias)
        return np.array(result)


def fit(task):
    measured = [np.column_stack([run["Fx"], run["Fy"]]) for run in task["runs"]]

    def residual(scaled):
        chain = Chain(task["nominal"], task["effect"], task["joint"], scaled * np.array(task["scale"]))
        parts = [chain.forces(run) - force for run, force in zip(task["runs"], measured)]
        return np.concatenate([part.ravel() for part in parts]) / task["sigma"]

    start = time.process_time()
    found = least_squares(residual, np.zeros(len(task["scale"])), ftol=1e-6, xtol=1e-7)
    return {"seconds": time.process_time() - start, "parameters": list(found.x * np.array(task["scale"]))}


json.dump([fit(task) for task in json.load(sys.stdin)], sys.stdout)
