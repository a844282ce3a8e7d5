"""The prior of sizes, and the share of a prior's volume that readings leave to parameters, by docs/how-it-decides.md."""
import itertools

import numpy as np
from scipy.stats import norm

SMALLEST = 1 / 27  # of the typical size


def log_sum(values):
    values = np.asarray(values, float)
    most = values.max()
    return most if not np.isfinite(most) else most + np.log(np.exp(values - most).sum())


def log_normalised(values):
    return np.asarray(values) - log_sum(values)


def log_half_cauchy(size):
    """Half-Cauchy probability of a size, over the typical one, within a factor of the square root of two."""
    return np.log(2 * np.log(2) / np.pi * size / (1 + size**2))


def log_size(size):
    """Probability of a size, over the typical one, within the same factor: even from SMALLEST to one, by the logarithm."""
    with np.errstate(divide="ignore"):
        return np.log(np.log(2) * (1 - SMALLEST) / -np.log(SMALLEST) * size / ((size + SMALLEST) * (1 + size)))


def log_smaller(size):
    """Probability that a size is smaller than this one."""
    return np.log(np.log1p(size * (1 - SMALLEST) / (SMALLEST * (1 + size))) / -np.log(SMALLEST))


SIZES = 3.0 ** np.arange(-4, 4)
LOG_SIZES = log_normalised(log_size(SIZES))


def log_volume(parameters, gradient, information):
    """The share of the prior that the readings leave, by Laplace's method; the sizes of effects summed out on a grid."""
    total, inside, widths, sized, bounded = 0.0, [], [], [], []
    for p, one in enumerate(parameters):
        if one["prior"] == "size":
            if one["at_bound"]:
                bounded.append(p)
            elif information[p, p] > 0:
                sized.append(p)
            continue
        sides = 1 if one["low"] < 0 else 2
        x = one["value"] / one["scale"]
        if one["prior"] == "gaussian":
            peak, density = sides / (one["scale"] * np.sqrt(2 * np.pi)), -(x**2) / 2
        elif one["prior"] == "cauchy":
            peak, density = sides / (np.pi * one["scale"]), -np.log1p(x**2)
        else:
            peak, density = 1 / (one["high"] - one["low"]), 0
        density += np.log(peak)
        if one["at_bound"]:
            total -= np.log1p(abs(gradient[p]) / np.exp(density))
        elif information[p, p] > 0:
            inside.append(p)
            widths.append(1 / (peak * np.sqrt(2 * np.pi)))
            total += density + np.log(2 * np.pi) / 2 + np.log(widths[-1])
    of_sizes = information[np.ix_(sized, sized)]
    if inside:  # the other parameters are integrated over first
        unit = np.array(widths)
        own = np.eye(len(unit)) + unit[:, None] * information[np.ix_(inside, inside)] * unit
        cross = unit[:, None] * information[np.ix_(inside, sized)]
        total -= 0.5 * np.linalg.slogdet(own)[1]
        of_sizes = of_sizes - cross.T @ np.linalg.solve(own, cross)
    effects = sorted({parameters[p]["effect"] for p in sized + bounded})
    terms = []
    for choice in itertools.product(range(len(SIZES)), repeat=len(effects)):
        size = {e: SIZES[k] for e, k in zip(effects, choice)}
        width = np.array([size[parameters[p]["effect"]] * parameters[p]["scale"] for p in sized])
        term = sum(LOG_SIZES[k] for k in choice)
        for p in bounded:
            w, sides = size[parameters[p]["effect"]] * parameters[p]["scale"], 1 if parameters[p]["low"] < 0 else 2
            log_density = np.log(sides / (w * np.sqrt(2 * np.pi))) - (parameters[p]["value"] / w) ** 2 / 2
            term -= np.logaddexp(0, np.log(max(abs(gradient[p]), 1e-300)) - log_density)
        if sized:
            at = np.array([parameters[p]["value"] for p in sized])
            precision = np.eye(len(at)) + width[:, None] * of_sizes * width
            mean = np.linalg.solve(precision, width * (of_sizes @ at))  # in widths
            term -= (at / width) @ mean / 2 + 0.5 * np.linalg.slogdet(precision)[1]
            spread = np.sqrt(np.diag(np.linalg.inv(precision)))
            term += sum(np.log(2) + norm.logcdf(m / s) for p, m, s in zip(sized, mean, spread) if parameters[p]["low"] >= 0)
        terms.append(term)
    return total + log_sum(terms)
