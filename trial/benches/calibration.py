#!/usr/bin/env python3
"""Whether stated probabilities hold: of a gap, of a cause outside the catalogue, of each effect to be part of the cause.

    calibration.py PLUMBLINE EXPERIMENTS LABELS [--reports FOLDER] [--markdown FILE] [--jobs J]

diagnoses every experiment (generate.py --faint), and compares what is stated with LABELS. Reports stay in the folder, if one is given.
"""
import json
import pathlib
import sys

import numpy as np
from scipy.stats import beta

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from scoring import arguments, diagnosed, for_each_experiment  # noqa: E402

EDGES = (0, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.97, 1.0001)
COVERAGE = 0.95  # of the intervals of a diagram, all at once
DRAWS = 20000


CURRENT = {"load_zero": "force_bias", "load_gain": "force_gain", "load_drift": "sensor_drift", "load_lag": "sensor_lag"}  # by the ids of labels


def key(effect):
    """An effect as reports have it; alternatives of labels are keys already."""
    text = effect if isinstance(effect, str) else effect["id"] + (f"({effect['joint']})" if effect.get("joint") else "")
    return CURRENT.get(text, text)


def truth_of(labels, name):
    envelope = json.loads((labels / f"{name}.json").read_text())
    label = json.loads(envelope["label"])
    return label, {key(e) for e in label["effects"] if e["id"] != "unknown"}, any(e["id"] == "unknown" for e in label["effects"])


def outside_of(report):
    return next((one["probability"] for one in report["cause"]["ranking"] if one["effects"] == ["unknown"]), 0.0)


def statements(pairs):
    """By question: (stated probability, whether it is so)."""
    gap, outside, effects = [], [], []
    for report, (label, listed, is_outside) in pairs:
        gap.append((report["gap"]["probability"], bool(label["effects"])))
        outside.append((outside_of(report), is_outside))
        if not is_outside:
            effects += [(one["probability"], one["effect"] in listed) for one in report["cause"]["effect_probabilities"]]
    return {"a gap": gap, "a cause outside the catalogue": outside, "an effect to be part of the cause": effects}


def interval(stated, filled):
    """Counts that a bin of these stated probabilities has, so that all filled bins together keep the coverage."""
    random = np.random.default_rng(1)
    counts = (random.uniform(size=(DRAWS, len(stated))) < stated).sum(1)
    tail = (1 - COVERAGE ** (1 / filled)) / 2
    return int(np.quantile(counts, tail, method="lower")), int(np.quantile(counts, 1 - tail, method="higher"))


def p_value(stated, true):
    """Two-sided, of Spiegelhalter's test: the Brier score beside what it is if the stated probabilities hold."""
    random = np.random.default_rng(2)

    def score(y):
        return ((y - stated) * (1 - 2 * stated)).sum(-1)
    drawn = score((random.uniform(size=(DRAWS, len(stated))) < stated).astype(float))
    return float(np.mean(np.abs(drawn) >= np.abs(score(true)) - 1e-12))


def diagram(question, said):
    stated, true = np.array([p for p, _ in said]), np.array([float(y) for _, y in said])
    bins = [(low, high, (stated >= low) & (stated < high)) for low, high in zip(EDGES, EDGES[1:])]
    bins = [one for one in bins if one[2].any()]
    lines = [f"Stated probability of {question}, {len(said)} statements; p of calibration {p_value(stated, true):.3f}, "
             f"log loss {-np.mean(np.log(np.clip(np.where(true > 0, stated, 1 - stated), 1e-6, 1))):.3f}.", "",
             "| stated | mean | is so | share | if it held, at 95 % of all bins |  |", "| --- | ---: | ---: | ---: | ---: | --- |"]
    for low, high, inside in bins:
        least, most = interval(stated[inside], len(bins))
        count, of = int(true[inside].sum()), int(inside.sum())
        lines.append(f"| {low:g} to {min(high, 1):g} | {stated[inside].mean():.3f} | {count} of {of} | {count / of:.2f} | {least} to {most} | "
                     f"{'' if least <= count <= most else '**outside**'} |")
    return "\n".join(lines) + "\n"


def wilson_bound(wrong, of):
    """Upper 95 % bound of a share (Clopper and Pearson)."""
    return float(beta.ppf(0.975, wrong + 1, of - wrong)) if of > wrong else 1.0


def verdicts(pairs):
    """What is said of each family of truths."""
    table = {}
    for report, (label, listed, is_outside) in pairs:
        cause = report["cause"]
        said = [{key(e) for e in cause["effects"]}] + [set(other) for other in cause["equivalent"]]
        equal = [listed] + [{key(e) for e in (one if isinstance(one, list) else [one])} for one in label["equivalent"]]
        right = not is_outside and bool(label["effects"]) and any(one in equal for one in said)
        verdict = cause["verdict"] + (" (too few readings)" if cause.get("too_few_readings") else "")
        family = "outside" if is_outside else ("no gap", "one effect", "two effects")[min(2, len(listed))]
        is_part = not is_outside and said[0] < listed
        named = "" if verdict in ("none", "unknown") else ", with the truth" if right else ", with a part of it" if is_part else ", without the truth"
        table.setdefault(family, {}).setdefault(verdict + named, []).append(label["name"])
    lines = ["| truth | said | experiments |", "| --- | --- | ---: |"]
    for family, said in sorted(table.items()):
        lines += [f"| {family} | {what} | {len(names)} |" for what, names in sorted(said.items())]
    def alone(ending):
        return sum(len(n) for said in table.values() for w, n in said.items() if w.startswith("identified") and w.endswith(ending))
    sure, part, wrong = alone(""), alone("with a part of it"), alone("without the truth")
    lines += ["", f"Of {sure} that name one cause {wrong} are wrong and {part} name one of two planted effects"
              + (f": wrong and sure {wrong + part} of {sure} (upper 95 % bound {wilson_bound(wrong + part, sure):.0%})." if sure else ".")]
    return "\n".join(lines) + "\n"


def main():
    a = arguments(__doc__)
    found = for_each_experiment(a, lambda name: (diagnosed(a, name, a.experiments / name), name))
    pairs = [(report, truth_of(a.labels, name)) for report, name in found if report]
    text = "\n".join([verdicts(pairs)] + [diagram(question, said) for question, said in statements(pairs).items()])
    text = f"{len(pairs)} experiments answered, {len(found) - len(pairs)} not.\n\n" + text
    if a.markdown:
        a.markdown.write_text(text)
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
