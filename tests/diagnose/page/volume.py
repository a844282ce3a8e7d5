"""The prior of sizes, and the share of a prior's volume that readings leave to parameters, by docs/how-it-decides.md."""
import functools
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


def volume_by_seen(parameters, gradient, information):
    """The share of the prior that the readings leave, by Laplace's method, its logarithm: that of all sizes of the effects on a
    grid together, and shares of it by the effects that are not seen there: the readings are as probable without them."""
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

    def log_left(size):
        width = np.array([size[parameters[p]["effect"]] * parameters[p]["scale"] for p in sized])
        term = 0.0
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
        return term

    left_at = functools.cache(lambda sizes: log_left(dict(zip(effects, sizes))))
    terms = {}
    for choice in itertools.product(range(len(SIZES)), repeat=len(effects)):
        sizes = tuple(SIZES[k] for k in choice)
        left = left_at(sizes)
        unseen = frozenset(e for i, e in enumerate(effects) if left <= left_at((*sizes[:i], 1e-3 * sizes[i], *sizes[i + 1:])))
        terms.setdefault(unseen, []).append(left + sum(LOG_SIZES[k] for k in choice))
    whole = log_sum([term for own in terms.values() for term in own])
    return total + whole, {unseen: np.exp(log_sum(own) - whole) for unseen, own in terms.items()}


def labels_of(effects):
    """The cause that effects are: tolerances beside others, and what stands for causes outside, are no part of it."""
    own = sorted(e["label"] for e in effects if not e["outside"] and not e["tolerance"])
    return tuple(own or sorted(e["label"] for e in effects if not e["outside"]))


def seen_causes(effects, by_unseen):
    """Shares of a hypothesis, with the cause that is seen in each: all of it where nothing is."""
    return [(share, labels_of([e for i, e in enumerate(effects) if i not in unseen] or effects)) for unseen, share in by_unseen.items()]
