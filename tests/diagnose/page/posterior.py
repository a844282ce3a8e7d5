"""The posterior and the verdict, by docs/how-it-decides.md: for decide.test.py, and for other priors."""
import dataclasses

import numpy as np

from likelihood import AMPLITUDE, EXACT, expected, log_listed
from naming import WRONG, names, shares_left
from volume import labels_of, log_half_cauchy, log_normalised, log_sum, seen_causes, volume_by_seen

SHARES = {"smooth": 0.3, "local": 0.2, "ends": 0.1, "step": 0.1, "one channel": 0.1, "scatter": 0.1, "part": 0.1}
SCATTER_BESIDE, SCATTER = 0.1, 4


@dataclasses.dataclass(frozen=True)
class Priors:
    """Opinions that could be others; `of_count` is a factor of the prior of so many effects."""

    no_gap: float = 0.3
    outside: float = 0.1
    exact: float = EXACT
    temper: float = 0.25
    of_count: dict = dataclasses.field(default_factory=dict)


def count_of(effects):
    """How many effects of the catalogue act; all tolerances together are one."""
    return sum(not (e["outside"] or e["tolerance"]) for e in effects) + any(e["tolerance"] for e in effects)


def looked(of, likelihood, residual, jacobian):
    """What the likelihood says of a residual, once."""
    if "look" not in of:
        of["look"] = likelihood.look(residual, np.array(jacobian).reshape(-1, len(residual)).T)
    return of["look"]


def departure(data, likelihood, z, orders):
    """Log Bayes factor of one event over independent outliers, in readings that follow each other in an order."""
    outliers, sums = likelihood.outliers, []
    channel = np.concatenate([np.full(count, b) for b, (_, count) in enumerate(data["blocks"])])
    for run, order, most, at_first in orders:
        here = [i for i, p in enumerate(data["places"]) if p[0] == run]
        gain = {c: np.zeros(len(order)) for c in channel[here]}
        for i in here:
            gain[channel[i]][data["places"][i][1]] = outliers.outlier(z[i]) - np.log(outliers.share) - outliers.either(z[i])
        for i in range(1 if at_first else len(order)):
            for j in range(i, min(len(order), i + most)):
                whole = sum(np.logaddexp(g[order[i : j + 1]].sum(), 0) for g in gain.values())
                some = whole + np.log(-np.expm1(-whole)) if whole > 1e-6 else log_sum([g[order[i : j + 1]].sum() for g in gain.values()])
                sums.append(some - np.log(2.0 ** len(gain) - 1))
    return log_sum(sums) - np.log(len(sums)) if sums else -np.inf


def orders_of(data, states):
    """The readings of every run as they were taken; and from either end of its command."""
    taken, ends = [], []
    for run in sorted({p[0] for p in data["places"]}):
        count = 1 + max(p[1] for p in data["places"] if p[0] == run)
        taken.append((run, np.arange(count), int(np.clip(count // 4, 1, 8)), False))
        for along in states.command[run][:count].T:
            if along.max() > along.min() + 1e-9:
                order = np.argsort(-np.round(along, 9), kind="stable")
                ends += [(run, order, max(1, count // 2), True), (run, order[::-1], max(1, count // 2), True)]
    return taken, ends


def part_scatters(factors):
    """Log Bayes factor of a part of the readings that scatters by these factors by the work of a cause."""
    noise = 0.375 / 0.25 * (1 + (np.log(np.array(factors, float)) / 0.25) ** 2 / 4) ** -2.5
    return log_sum(-np.log(np.log(100)) - np.log(noise)) if len(factors) else -np.inf


def split(way, size, own, typical, priors):
    """Between the cause and one outside, where a share of that size is left to what the catalogue does not have."""
    size = max(1e-3, size)
    odds = log_listed(priors.exact)[1] + AMPLITUDE[1] / 0.1 - size / 0.1 - log_half_cauchy(size / typical)
    odds += np.log((1 - priors.outside) / priors.outside)
    prior, evidence, discrepancy = way
    return [(prior - np.log1p(np.exp(odds)), evidence, discrepancy, "outside"), (prior - np.log1p(np.exp(-odds)), evidence, discrepancy, own)]


def outside_alone(data, likelihood, nominal):
    """Log evidence and discrepancy of each kind of a cause outside the catalogue, with no effect beside it."""
    taken, ends = orders_of(data, likelihood.states)
    exact, outside = nominal.by_amplitude[0], likelihood.log_outside
    return {"smooth": (log_sum(nominal.by_amplitude + outside), expected(nominal.by_amplitude, outside, nominal.discrepancy)),
            "local": (exact + departure(data, likelihood, nominal.z, taken), 0), "ends": (exact + departure(data, likelihood, nominal.z, ends), 0),
            "step": (exact + likelihood.log_step(np.array(data["nominal"])), 0), "one channel": (nominal.one_channel, nominal.alone),
            "scatter": (nominal.scatter, 0), "part": (exact + part_scatters(data["noisier"]), 0)}


def ways(data, likelihood, priors=Priors()):
    """Every way in which the readings may have come about: log prior, log evidence, discrepancy, cause (None: no gap)."""
    nominal = looked(data, likelihood, np.array(data["nominal"]), [])
    none, listed = np.log(1 - priors.no_gap), log_listed(priors.exact)
    if "kinds" not in data:
        data["kinds"] = outside_alone(data, likelihood, nominal)
    result = [(np.log(priors.no_gap), nominal.by_amplitude[0], 0, None, None)]
    result += [(none + np.log(priors.outside * SHARES[kind]), *data["kinds"][kind], "outside", None) for kind in SHARES]
    for one in data["hypotheses"]:
        left = np.array(one["residual"])
        look = looked(one, likelihood, left, one["jacobian"])
        base = none + one["log_prior"] + np.log(priors.of_count.get(count_of(one["effects"]), 1))
        if "volume" not in one:
            one["volume"] = volume_by_seen(one["parameters"], look.gradient, look.information)
        volume, by_unseen = one["volume"]
        own = labels_of(one["effects"])
        whole = (volume + log_sum(look.by_amplitude + listed), expected(look.by_amplitude, listed, look.discrepancy))
        if any(e["outside"] for e in one["effects"]):
            some = split((base, *whole), one["discrepancy"], own, likelihood.typical, priors) if own else [(base, *whole, "outside")]
        else:
            some = [(base + np.log(1 - priors.outside), *whole, own)]
            imitated = likelihood.log_imitated
            some.append((base + np.log(priors.outside), volume + log_sum(look.by_amplitude + imitated),
                         expected(look.by_amplitude, imitated, look.discrepancy), "outside"))
            some += split((base + np.log(SCATTER_BESIDE), volume + look.scatter, 0), look.scatter_size, own, likelihood.typical, priors)
        result += [(*way[:3], "outside" if one["untimed"] else way[3], one) for way in some]
        one["seen"] = seen_causes(one["effects"], by_unseen)
        one["leaves_nothing"] = (np.exp(log_normalised(look.by_amplitude + listed))[0] > 0.5
                                 and np.mean(left[~likelihood.outlier] ** 2) <= SCATTER**2)
        one["own"] = own
    return result


def decide(data, likelihood, priors=Priors()):
    """The verdict, the causes that are named, and the probabilities of no gap and of a cause outside the catalogue."""
    all_ways = ways(data, likelihood, priors)
    prior, evidence, discrepancy = (np.array([w[k] for w in all_ways], float) for k in range(3))
    no_gap = np.exp(log_normalised(prior + evidence))[0]
    temper = 1 - (1 - priors.temper) * (np.exp(log_normalised(prior[1:] + evidence[1:])) @ discrepancy[1:])
    sums, probability = {"outside": 0.0}, (1 - no_gap) * np.exp(log_normalised(prior[1:] + temper * evidence[1:]))
    for p, (*_, cause, _) in zip(probability, all_ways[1:]):
        sums[cause] = sums.get(cause, 0) + p
    for p, (*_, cause, one) in zip(probability, all_ways[1:]):  # an effect that is not seen is no part of the name
        for share, seen in one["seen"] if cause != "outside" and len(cause) > 1 else []:
            if seen in sums:
                sums[cause] -= p * share
                sums[seen] += p * share
    outside = sums.pop("outside")
    causes = sorted(sums.items(), key=lambda kv: -kv[1])
    if no_gap > 0.5:
        return "none", set(), no_gap, outside
    listed = sum(p for _, p in causes)
    leads = outside > listed
    nothing_left = causes and next(h["leaves_nothing"] for h in data["hypotheses"] if h["own"] == causes[0][0])
    if not causes or (leads and (listed < 1 / WRONG or not nothing_left)):
        return "unknown", set(), no_gap, outside
    count, others = names(causes, outside, listed if leads else 1, shares_left(data, likelihood.outlier))
    named = [cause for cause, _ in causes[:count]]
    return ("identified" if count + others == 1 else "ambiguous"), set(named), no_gap, outside
