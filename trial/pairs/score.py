#!/usr/bin/env python3
"""Scores what is said to have changed, and beside it the same data diagnosed singly.

    score.py PLUMBLINE PAIRS LABELS [--reports FOLDER] [--markdown FILE] [--jobs J]

Of the single diagnoses the one of the state with the effect counts: it is right where the effect is named, alone or in a class, and where the
device lacks another effect too, beside that one.
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import subprocess
import tempfile

ANSWERS = ("right", "in the class", "unknown", "missed", "wrong, hedged", "wrong, sure", "false alarm", "no report")


# Ids of trial/benches that the catalogue calls otherwise now.
RENAMED = {"load_zero": "force_bias", "load_gain": "force_gain", "load_drift": "sensor_drift", "load_lag": "sensor_lag"}


def named(text):
    id, bracket, joint = text.partition("(")
    return RENAMED.get(id, id) + bracket + joint


def key(effect):
    return named(effect["id"] + (f"({effect['joint']})" if effect.get("joint") else ""))


def report(plumbline, out, *words):
    if not out.exists():
        subprocess.run([plumbline, "diagnose", *words, "--as-is", "--json", out], capture_output=True, timeout=600, check=False)
    return json.loads(out.read_text()) if out.exists() else None


def keys(effects):
    return sorted(named(e) if isinstance(e, str) else key(e) for e in effects)


def listed(said):
    """Every cause of an answer with its sense: "added", "removed", or "either", where signs of parameters tell it."""
    cause, against = said["cause"], said.get("against", {})
    sense = against.get("sense", "either")
    other = {"added": "removed", "removed": "added"}.get(sense, "either")
    return [(keys(one), sense) for one in [cause["effects"], *cause["equivalent"]]] + [(keys(one), other) for one in against.get("otherwise", [])]


def answer(label, said, sense=None):
    """\\param sense  "added" or "removed", where that is not the sign of a parameter """
    if said is None:
        return "no report"
    cause = said["cause"]
    truth = ["unknown"] if label["description"] else keys(label["effects"])
    if not truth:
        return "right" if cause["verdict"] == "none" else "false alarm"
    if cause["verdict"] == "none":
        return "missed"
    if cause["verdict"] == "unknown":
        return "right" if truth == ["unknown"] else "unknown"
    if truth == ["unknown"]:
        named_unknown = any(one == ["unknown"] for one, _ in listed(said))
        return "in the class" if named_unknown or cause["verdict"] == "partial" else "wrong, sure" if cause["verdict"] == "identified" else "wrong, hedged"
    accepted = [truth] + [keys(one) for one in label["equivalent"]]
    found = any(one in accepted and (sense is None or its in (sense, "either")) for one, its in listed(said))
    if cause["verdict"] == "identified":
        return "right" if found else "wrong, sure"
    return "in the class" if found else "wrong, hedged"


def single(label, said, lack):
    """The same of the state with the effect, where what the device lacks is part of the truth."""
    if said is None:
        return "no report"
    if not lack:
        return answer(label, said)
    cause = said["cause"]
    if cause["verdict"] in ("none", "unknown"):
        return "missed" if cause["verdict"] == "none" else "unknown"
    said_ids = [e.split("(")[0] for e in keys(cause["effects"])]
    wanted = [named(e["id"]) for e in label["effects"]]
    if wanted and all(one in said_ids for one in wanted):
        return "right" if cause["verdict"] == "identified" else "in the class"
    if not wanted:
        return "right" if named(lack) in said_ids else "false alarm"
    return "wrong, sure" if cause["verdict"] == "identified" else "wrong, hedged"


def judged(a, name):
    label = json.loads((a.labels / f"{name}.json").read_text())
    pair = a.pairs / name
    both = report(a.plumbline, a.reports / f"{name}.json", pair / "after", "--against", pair / "before")
    changed = "after" if label["came"] else "before"
    one = report(a.plumbline, a.reports / f"{name}-alone.json", pair / changed)
    sense = ("added" if label["came"] else "removed") if label["one_sided"] else None
    return name, label, answer(label, both, sense), single(label, one, label["lack"]), both


def table(rows):
    lines = ["| | n | " + " | ".join(ANSWERS) + " |", "|---|---:|" + "---:|" * len(ANSWERS)]
    for title, answers in rows:
        count = collections.Counter(answers)
        lines.append(f"| {title} | {len(answers)} | " + " | ".join(str(count[a] or "") for a in ANSWERS) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plumbline", type=pathlib.Path)
    parser.add_argument("pairs", type=pathlib.Path)
    parser.add_argument("labels", type=pathlib.Path)
    parser.add_argument("--reports", type=pathlib.Path)
    parser.add_argument("--markdown", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    a = parser.parse_args()
    a.plumbline = a.plumbline.resolve()
    a.reports = a.reports or pathlib.Path(tempfile.mkdtemp())
    a.reports.mkdir(parents=True, exist_ok=True)
    names = sorted(path.name for path in a.pairs.iterdir())
    with concurrent.futures.ThreadPoolExecutor(a.jobs) as pool:
        all_judged = list(pool.map(lambda name: judged(a, name), names))
    families = sorted({label["family"] for _, label, *_ in all_judged})
    rows = []
    for family in [None, *families]:
        some = [one for one in all_judged if family in (None, one[1]["family"])]
        rows.append((f"{family or 'all'}: one against the other", [one[2] for one in some]))
        rows.append((f"{family or 'all'}: singly", [one[3] for one in some]))
    text = table(rows)
    print(text)
    for name, label, verdict, alone, both in all_judged:
        if verdict not in ("right", "in the class"):
            said = both and (both["cause"]["verdict"], keys(both["cause"]["effects"]), both["against"]["sense"])
            print(f"{name}: {keys(label['effects'])} {'came' if label['came'] else 'went'}, {label['strength_sigma']} sigma, "
                  f"lack {label['lack'] or 'none'}; {verdict}: {said}; singly {alone}")
    if a.markdown:
        a.markdown.write_text(text + "\n")


if __name__ == "__main__":
    main()
