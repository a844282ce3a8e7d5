"""Readings as an instrument gives them."""
import numpy as np

KINDS = {"declared": 0.70, "misdeclared": 0.18, "outliers": 0.12}
MISDECLARED = 1.5
OUTLIERS, FAR = 0.02, 12.0  # their share; standard deviations over the others'


def with_noise(bench, readings, random):
    """The readings, the kind of their noise, and the true over the declared standard deviation, which the bench gets."""
    kind = str(random.choice(list(KINDS), p=list(KINDS.values())))
    scale = float(random.choice([1 / MISDECLARED, MISDECLARED])) if kind == "misdeclared" else 1.0
    bench.declared = bench.sigma / scale
    noisy = []
    for read in readings:
        error = random.normal(size=read.shape)
        if kind == "outliers":
            error[random.uniform(size=read.shape) < OUTLIERS] *= FAR
        values = read + bench.sigma * error
        noisy.append(np.round(values / bench.count) * bench.count if bench.count else values)
    return noisy, kind, scale
