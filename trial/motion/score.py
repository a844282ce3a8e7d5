#!/usr/bin/env python3
"""Scores diagnoses of sealed logs of motion.

    score.py PLUMBLINE EXPERIMENTS LABELS [--reports FOLDER] [--markdown FILE]

*named*: the causes planted are those of the answer, alone, or as one of its alternatives; *part*: one of two is named; *wrong, sure*: a cause that is not
there is identified.
"""
import argparse
import collections
import json
import pathlib
import resource
import subprocess
import tempfile

ANSWERS = ("named alone", "named in a class", "part", "unknown", "missed", "wrong, hedged", "wrong, sure", "right (no gap)", "false alarm", "no report")


def report_of(plumbline, experiment, out):
    if not out.exists():
        subprocess.run([plumbline, "diagnose", experiment, "--json", out], capture_output=True, timeout=1200, check=False)
    return json.loads(out.read_text()) if out.exists() else None


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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plumbline", type=pathlib.Path)
    parser.add_argument("experiments", type=pathlib.Path)
    parser.add_argument("labels", type=pathlib.Path)
    parser.add_argument("--reports", type=pathlib.Path)
    parser.add_argument("--markdown", type=pathlib.Path)
    a = parser.parse_args()
    reports = a.reports or pathlib.Path(tempfile.mkdtemp())
    reports.mkdir(parents=True, exist_ok=True)
    counts, lines = collections.defaultdict(collections.Counter), []
    for path in sorted(p for p in a.experiments.iterdir() if p.is_dir()):
        label = json.loads(json.loads((a.labels / f"{path.name}.json").read_text())["label"])
        said = report_of(a.plumbline.resolve(), path, reports / f"{path.name}.json")
        verdict = answer(label, said)
        counts["all"][verdict] += 1
        counts[label["kind"]][verdict] += 1
        counts["numbers unknown" if label["unknown"] else "numbers stated"][verdict] += 1
        if verdict not in ("named alone", "named in a class", "right (no gap)"):
            named = said and (said["verdict"], ["+".join(e["effect"] for e in one["effects"]) for one in said["causes"]])
            known = ", numbers unknown" if label["unknown"] else ""
            lines.append(f"{path.name}: {' + '.join(label['causes']) or 'nothing'} ({label['rate']} Hz{known}); {verdict}: {named}")
        print(path.name, label["causes"], verdict, flush=True)
    table = ["| | n | " + " | ".join(ANSWERS) + " |", "|---|---:|" + "---:|" * len(ANSWERS)]
    for title, count in counts.items():
        table.append(f"| {title} | {sum(count.values())} | " + " | ".join(str(count[one] or "") for one in ANSWERS) + " |")
    spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    text = "\n".join(table) + "\n\n" + "\n".join(f"- {one}" for one in lines)
    print(text + f"\n\nprocessor time {spent:.0f} s")
    if a.markdown:
        a.markdown.write_text(text + "\n")


if __name__ == "__main__":
    main()
