"""Readings as an instrument gives them."""
import numpy as np

FAR = 12.0  # of outliers, standard deviations over the others'
CORRELATION = 0.6  # of successive readings


def correlated(error):
    """Of the same variance, each reading with a share of the one before."""
    result = error.copy()
    for i in range(1, len(error)):
        result[i] = CORRELATION * result[i - 1] + np.sqrt(1 - CORRELATION**2) * error[i]
    return result


def wrong_by(factors, random):
    """A factor between these, or one over it."""
    least, most = factors
    sign = random.choice([-1, 1])
    return float((least if least == most else np.exp(random.uniform(np.log(least), np.log(most)))) ** sign)


def with_noise(bench, readings, random, recipe):
    """The readings, the kind of their noise, and the true over the declared standard deviation, which the bench gets."""
    kind = str(random.choice(list(recipe.noise), p=list(recipe.noise.values())))
    scale = wrong_by(recipe.misdeclared, random) if kind == "misdeclared" else 1.0
    bench.declared = bench.sigma / scale
    ratio = random.uniform(1, 3) if kind == "proportional" else 0.0
    noisy = []
    for read in readings:
        error = random.normal(size=read.shape)
        if kind == "outliers":
            error[random.uniform(size=read.shape) < recipe.outliers] *= FAR
        if kind == "autocorrelated":
            error = correlated(error)
        if kind == "proportional":
            error *= np.hypot(1, ratio * read / max(np.max(np.abs(read)), 1e-300))
        values = read + bench.sigma * error
        noisy.append(np.round(values / bench.count) * bench.count if bench.count else values)
    return noisy, kind, scale
