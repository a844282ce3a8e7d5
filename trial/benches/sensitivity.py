#!/usr/bin/env python3
"""What other priors would say: verdicts that change where an opinion is halved or doubled.

    sensitivity.py HYPOTHESES BANK [--markdown FILE]

HYPOTHESES is the program of tests/diagnose/page, which lists every way in which readings may have come about; BANK a folder of experiments.
"""
import argparse
import json
import pathlib
import subprocess
import sys

import numpy as np

NO_GAP, OUTSIDE, TEMPER, WRONG, LARGEST = 0.3, 0.1, 0.25, 20, 8


def log_normalised(values):
    values = np.asarray(values, float)
    most = values.max()
    return values - most - np.log(np.exp(values - most).sum())


def verdict(ways, temper=TEMPER, shift=lambda way: 0.0):
    """What is said, and of which causes, where log priors are shifted."""
    prior = np.array([way["log_prior"] + shift(way) if way["log_prior"] is not None else -np.inf for way in ways])
    evidence = np.array([-np.inf if way["log_evidence"] is None else way["log_evidence"] for way in ways])
    discrepancy = np.array([way["discrepancy"] for way in ways])
    no_gap = np.exp(log_normalised(prior + evidence))[0]
    if no_gap > 0.5:
        return "none", frozenset()
    d = np.exp(log_normalised(prior[1:] + evidence[1:])) @ discrepancy[1:]
    weight = (1 - no_gap) * np.exp(log_normalised(prior[1:] + (1 - (1 - temper) * d) * evidence[1:]))
    sums = {}
    for p, way in zip(weight, ways[1:]):
        cause = way["effects"] if way["of"] == "listed" else "outside"
        sums[cause] = sums.get(cause, 0) + p
    outside = sums.pop("outside", 0)
    causes = sorted(sums.items(), key=lambda kv: -kv[1])
    if not causes or outside > sum(sums.values()):
        return "unknown", frozenset()
    named = ([causes[0][0]] + [c for c, p in causes[1:] if p >= 1 / WRONG])[: LARGEST - (outside >= 1 / WRONG)]
    others = [outside] + [p for _, p in causes[1:]]
    alone_costs_less = 1.5 * WRONG * sum(others) <= 1 + WRONG * (sum(others) - max(others))
    sure = len(named) == 1 and outside < 1 / WRONG and alone_costs_less
    return "identified" if sure else "ambiguous", frozenset(named)


def of_nothing(old, new):
    """Log priors where the probability of no gap is another."""
    return lambda way: np.log(new / old) if way["of"] == "nothing" else np.log((1 - new) / (1 - old))


def of_outside(old, new):
    return lambda way: {"nothing": 0.0, "outside": np.log(new / old), "listed": np.log((1 - new) / (1 - old))}[way["of"]]


def of_count(count, factor):
    return lambda way: np.log(factor) if way["of"] != "nothing" and way["count"] == count else 0.0


OPINIONS = {
    "no gap": [(TEMPER, of_nothing(NO_GAP, f * NO_GAP)) for f in (0.5, 2)],
    "outside": [(TEMPER, of_outside(OUTSIDE, f * OUTSIDE)) for f in (0.5, 2)],
    "power at a discrepancy as large as the noise": [(f * TEMPER, lambda way: 0.0) for f in (0.5, 2)],
    "share of two effects": [(TEMPER, of_count(2, f)) for f in (0.5, 2)],
    "share of three effects": [(TEMPER, of_count(3, f)) for f in (0.5, 2)],
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("hypotheses")
    parser.add_argument("bank", type=pathlib.Path)
    parser.add_argument("--markdown", type=pathlib.Path)
    a = parser.parse_args()
    benches = []
    for folder in sorted(f for f in a.bank.iterdir() if (f / "experiment.toml").exists()):
        run = subprocess.run([a.hypotheses, folder], capture_output=True, text=True, check=False)
        if run.returncode == 0:
            benches.append(json.loads(run.stdout)["ways"])
    before = [verdict(ways) for ways in benches]
    lines = [f"{len(benches)} experiments.", "", "| opinion | verdicts that change, halved | doubled | another sure name |", "| --- | ---: | ---: | ---: |"]
    for name, variants in OPINIONS.items():
        after = [[verdict(ways, *variant) for ways in benches] for variant in variants]
        changed = [sum(b[0] != n[0] for b, n in zip(before, one)) for one in after]
        other = sum(b[0] == n[0] == "identified" and b != n for one in after for b, n in zip(before, one))
        lines.append(f"| {name} | {changed[0]} | {changed[1]} | {other} |")
    text = "\n".join(lines) + "\n"
    if a.markdown:
        a.markdown.write_text(text)
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
