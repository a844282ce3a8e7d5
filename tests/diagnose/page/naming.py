"""Which causes are named, by docs/how-it-decides.md: for decide.test.py."""
import numpy as np

WRONG, LARGEST = 20, 8


def shares_left(data, outlier):
    """The share of what a cause changes that another leaves, where that is a part of it; one where it is none."""
    change, fits = np.array(data["nominal"]), {}
    for one in data["hypotheses"]:
        fits.setdefault(one["own"], np.array(one["residual"]))

    def left(cause, taken):
        if not set(taken) <= set(cause):
            return 1
        squares = [np.sum((other - fits[cause])[~outlier] ** 2) for other in (fits[taken], change)]
        return min(1, np.sqrt(squares[0] / squares[1]))

    return left


def names(causes, outside, whole, share):
    """How many of the causes are named, and whether one outside of the catalogue is beside them."""
    others, count = 1 if outside >= 1 / WRONG else 0, 1

    def left(i, named):
        return causes[i][1] * min(share(causes[i][0], taken) for taken, _ in causes[:named])

    for i in range(1, min(LARGEST - others, len(causes))):
        if left(i, count) >= whole / WRONG:
            count = i + 1
    if count + others == 1:  # the only name costs more where it is wrong
        alone, with_next = (sum(left(i, n) for i in range(n, len(causes))) for n in (1, 2))
        if 1.5 * WRONG * (alone + outside) > 1 + WRONG * min(alone, with_next + outside):
            count, others = (2, 0) if with_next + outside < alone else (1, 1)
    if count + others == 1:  # is a further effect more probable than none?
        larger = [i for i in range(1, len(causes)) if left(i, 1) < causes[i][1]]
        if sum(causes[i][1] for i in larger) > causes[0][1]:
            count = larger[0] + 1
    return count, others
