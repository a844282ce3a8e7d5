#!/usr/bin/env python3
"""What other priors would say: verdicts that change where an opinion is halved or doubled.

    sensitivity.py HYPOTHESES BANK [--first N] [--markdown FILE]

HYPOTHESES is the program of tests/diagnose/page, which lists every way in which readings may have come about; BANK a folder of experiments.
Verdicts are those of docs/how-it-decides.md before its held-out check, as tests/diagnose/page recomputes them.
"""
import argparse
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/diagnose/page"))

from likelihood import Likelihood  # noqa: E402
from posterior import Priors, decide  # noqa: E402

STATED = Priors()


def half_and_twice(name):
    return [Priors(**{name: factor * getattr(STATED, name)}) for factor in (0.5, 2)]


OPINIONS = {
    "no gap": half_and_twice("no_gap"),
    "outside": half_and_twice("outside"),
    "power at a discrepancy as large as the noise": half_and_twice("temper"),
    "odds of an exact model beside a cause": [Priors(exact=1 / 3), Priors(exact=2 / 3)],
    "share of two effects": [Priors(of_count={2: factor}) for factor in (0.5, 2)],
    "share of three effects": [Priors(of_count={3: factor}) for factor in (0.5, 2)],
}


def answers(hypotheses, folder):
    """The verdict and the names of an experiment, as stated and by each other opinion; nothing where it cannot be read."""
    run = subprocess.run([hypotheses, folder], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return None
    data = json.loads(run.stdout)
    likelihood = Likelihood(data)
    say = lambda priors: decide(data, likelihood, priors)[:2]
    return say(STATED), {name: [say(priors) for priors in variants] for name, variants in OPINIONS.items()}


def table(benches):
    lines = [f"{len(benches)} experiments.", "", "| opinion | verdicts that change, halved | doubled | another sure name |", "| --- | ---: | ---: | ---: |"]
    for name in OPINIONS:
        changed = [sum(stated[0] != other[name][k][0] for stated, other in benches) for k in (0, 1)]
        renamed = sum(stated[0] == now[0] == "identified" and stated != now for stated, other in benches for now in other[name])
        lines.append(f"| {name} | {changed[0]} | {changed[1]} | {renamed} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("hypotheses")
    parser.add_argument("bank", type=pathlib.Path)
    parser.add_argument("--first", type=int, help="of the experiments, by name")
    parser.add_argument("--markdown", type=pathlib.Path)
    a = parser.parse_args()
    folders = sorted(f for f in a.bank.iterdir() if (f / "experiment.toml").exists())[: a.first]
    text = table([one for one in (answers(a.hypotheses, folder) for folder in folders) if one])
    if a.markdown:
        a.markdown.write_text(text)
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
