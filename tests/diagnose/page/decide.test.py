"""The verdict again, by docs/how-it-decides.md alone: the likelihood with its discrepancy and noise, the evidence, the
posterior and the decision, in NumPy, from what the rig predicts beside each hypothesis (hypotheses.cpp).

    decide.test.py HYPOTHESES FOLDER...   compares with the program; at least 95 % have to agree
"""
import json
import subprocess
import sys

from likelihood import Likelihood
from posterior import decide


def main(program, *folders):
    agree = total = 0
    for folder in folders:
        data = json.loads(subprocess.run([program, folder], check=True, capture_output=True, text=True).stdout)
        verdict, named, no_gap, outside = decide(data, Likelihood(data))
        same = verdict == data["verdict"] and named == {tuple(n) for n in data["named"]}
        agree, total = agree + same, total + 1
        if not same:
            print(f"{folder}: the page {verdict} {sorted(named)} (no gap {no_gap:.3f}, outside {outside:.3f}), the program "
                  f"{data['verdict']} {data['named']} ({data['no_gap']:.3f}, {data['outside']:.3f})")
    print(f"{agree} of {total} verdicts agree")
    return 0 if agree >= 0.95 * total else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
