#!/usr/bin/env python3
"""Scores what is said to have changed, and beside it the same data diagnosed singly.

    score.py PLUMBLINE EXPERIMENTS LABELS [--reports FOLDER] [--markdown FILE] [--jobs J]

Of the single diagnoses the one of the state with the effect counts: it is right where the effect is named, alone or in a class, and where the
device lacks another effect too, beside that one.
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from scoring import arguments, diagnosed, for_each_experiment, table  # noqa: E402

ANSWERS = ("right", "in the class", "unknown", "missed", "wrong, hedged", "wrong, sure", "false alarm", "no report")


# Ids of trial/benches that the catalogue calls otherwise now.
RENAMED = {"load_zero": "force_bias", "load_gain": "force_gain", "load_drift": "sensor_drift", "load_lag": "sensor_lag"}


def named(text):
    id, bracket, joint = text.partition("(")
    return RENAMED.get(id, id) + bracket + joint


def key(effect):
    return named(effect["id"] + (f"({effect['joint']})" if effect.get("joint") else ""))


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
    pair = a.experiments / name
    both = diagnosed(a, name, pair / "after", "--against", pair / "before", "--as-is")
    changed = "after" if label["came"] else "before"
    one = diagnosed(a, f"{name}-alone", pair / changed, "--as-is")
    sense = ("added" if label["came"] else "removed") if label["one_sided"] else None
    return name, label, answer(label, both, sense), single(label, one, label["lack"]), both


def main():
    a = arguments(__doc__)
    all_judged = for_each_experiment(a, lambda name: judged(a, name))
    families = sorted({label["family"] for _, label, *_ in all_judged})
    rows = []
    for family in [None, *families]:
        some = [one for one in all_judged if family in (None, one[1]["family"])]
        rows.append((f"{family or 'all'}: one against the other", [one[2] for one in some]))
        rows.append((f"{family or 'all'}: singly", [one[3] for one in some]))
    text = table(rows, ANSWERS)
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
