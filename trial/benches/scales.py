"""Sizes of a bench's nominal motion, in which effects are drawn and fits start."""
import numpy as np

from statics import clean_readings
from truth import Truth


def deflection_scale(bench):
    """By joint: the largest nominal deflection, rad (m); thirty standard deviations of the noise where there is none."""
    if bench.scales is None:
        nominal = clean_readings(bench, Truth.none(bench.size))
        largest = np.zeros(bench.size)
        for run, read in zip(bench.runs, nominal):
            d = run.imposed[:, None] - run.command if run.is_held else read - run.command
            largest = np.maximum(largest, np.max(np.abs(d), axis=0))
        bench.scales = np.maximum(largest, 30 * bench.noise / (bench.stiffness if bench.is_held else 1))
    return bench.scales


def mean_deflection(bench):
    return float(np.mean(deflection_scale(bench)))


def duration(bench):
    """Of the longest run, s."""
    return max(float(run.time[-1] - run.time[0]) for run in bench.runs)
