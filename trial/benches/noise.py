"""Readings as an instrument gives them."""
from dataclasses import dataclass

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


@dataclass(frozen=True)
class Noise:
    """Noise of a drawn kind."""
    kind: str = "declared"
    scale: float = 1.0  # true over declared standard deviation
    ratio: float = 0.0  # of its part that grows with the reading, at the largest one, over the rest

    def growth(self, read):
        """By reading: the standard deviation over that at zero."""
        return np.hypot(1, self.ratio * read / max(np.max(np.abs(read)), 1e-300))

    def told(self, bench, read, change):
        """A change of a run's readings in independent standard deviations."""
        result = change / np.hypot(bench.sigma * self.growth(read), bench.count / np.sqrt(12))
        if self.kind == "autocorrelated":
            result[1:] = (result[1:] - CORRELATION * result[:-1]) / np.sqrt(1 - CORRELATION**2)
        return result


def with_noise(bench, readings, random, recipe):
    """The readings, and their noise; its true over the declared standard deviation goes to the bench."""
    kind = str(random.choice(list(recipe.noise), p=list(recipe.noise.values())))
    scale = wrong_by(recipe.misdeclared, random) if kind == "misdeclared" else 1.0
    bench.declared = bench.sigma / scale
    noise = Noise(kind, scale, random.uniform(1, 3) if kind == "proportional" else 0.0)
    noisy = []
    for read in readings:
        error = random.normal(size=read.shape)
        if kind == "outliers":
            error[random.uniform(size=read.shape) < recipe.outliers] *= FAR
        if kind == "autocorrelated":
            error = correlated(error)
        values = read + bench.sigma * noise.growth(read) * error
        noisy.append(np.round(values / bench.count) * bench.count if bench.count else values)
    return noisy, noise
