#!/usr/bin/env python3
"""Scores diagnoses of sealed logs of motion.

    score.py PLUMBLINE EXPERIMENTS LABELS [--reports FOLDER] [--markdown FILE] [--jobs J]

*named*: the causes planted are those of the answer, alone, or as one of its alternatives; *part*: one of two is named; *wrong, sure*: a cause that is not
there is identified.
"""
import collections
import json
import pathlib
import resource
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from scoring import arguments, diagnosed, for_each_experiment, table  # noqa: E402

ANSWERS = ("named alone", "named in a class", "part", "unknown", "missed", "wrong, hedged", "wrong, sure", "right (no gap)", "false alarm", "no report")


def accepted(label):
    """Sets of rows that say the truth: each cause by itself, or by another that no log tells from it."""
    sets = [frozenset(label["causes"])]
    for cause, others in label["same"].items():
        sets += [one - {cause} | {other} for one in list(sets) if cause in one for other in others]
    return sets


def answer(label, said):
    if said is None:
        return "no report"
    verdict, listed = said["verdict"], [{e["effect"] for e in one["effects"]} for one in said["causes"]]
    if label["kind"] == "none":
        return "right (no gap)" if verdict == "none" else "false alarm"
    if verdict == "none":
        return "missed"
    if label["kind"] == "outside":
        if verdict == "unknown":
            return "named alone"
        return "wrong, sure" if verdict == "identified" and len(listed) == 1 else "wrong, hedged"
    if verdict == "unknown":
        return "unknown"
    right = accepted(label)
    if listed and listed[0] in right and len(listed) == 1:
        return "named alone"
    if any(one in right for one in listed):
        return "named in a class"
    common = set.intersection(*listed) if listed else set()
    if any(common and common < one for one in right):
        return "part"
    return "wrong, sure" if verdict == "identified" else "wrong, hedged"


def judged(a, name):
    label = json.loads(json.loads((a.labels / f"{name}.json").read_text())["label"])
    said = diagnosed(a, name, a.experiments / name)
    return name, label, answer(label, said), said


def miss(name, label, verdict, said):
    named = said and (said["verdict"], ["+".join(e["effect"] for e in one["effects"]) for one in said["causes"]])
    known = ", numbers unknown" if label["unknown"] else ""
    return f"- {name}: {' + '.join(label['causes']) or 'nothing'} ({label['rate']} Hz{known}); {verdict}: {named}"


def main():
    a = arguments(__doc__)
    all_judged = for_each_experiment(a, lambda name: judged(a, name))
    families = collections.defaultdict(list)
    for _, label, verdict, _ in all_judged:
        for family in ("all", label["kind"], "numbers unknown" if label["unknown"] else "numbers stated"):
            families[family].append(verdict)
    missed = [miss(*one) for one in all_judged if one[2] not in ("named alone", "named in a class", "right (no gap)")]
    text = table(families.items(), ANSWERS) + "\n\n" + "\n".join(missed)
    print(f"{text}\n\nprocessor time {resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime:.0f} s")
    if a.markdown:
        a.markdown.write_text(text + "\n")


if __name__ == "__main__":
    main()
