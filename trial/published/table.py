#!/usr/bin/env python3
"""What owners of published data state, what is said of them, and what is left.

    table.py PLUMBLINE FOLDER [--reports FOLDER]

diagnoses every set of sets.toml that FOLDER has, and prints the table of trial/RESULTS-published.md.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile
import tomllib


def named(report):
    """The members of the class that is named, each a set of effects."""
    cause = report["cause"]
    if cause["verdict"] in ("none", "unknown"):
        return []
    own = {e["id"] + (f"({e['joint']})" if e["joint"] else "") for e in cause["effects"]}
    return [own] + [set(other) for other in cause["equivalent"]]


def judged(stated, report):
    """Whether the answer has the stated cause, and whether a sure one lacks it."""
    verdict, members = report["cause"]["verdict"], named(report)
    if stated.get("outside"):
        return "right" if verdict == "unknown" or {"unknown"} in members else "wrong and sure" if verdict == "identified" else "missed"
    if not stated["right"]:
        return "not stated"
    found = [bool(set(stated["right"]) & one) for one in members]
    if any(found):
        return {"identified": "alone", "partial": "in part", "ambiguous": "in the class"}[verdict]
    return "wrong and sure" if verdict == "identified" else "missed"


def said(report):
    members = [" + ".join(f"`{e}`" for e in sorted(one)) for one in named(report) if one != {"unknown"}]
    return report["cause"]["verdict"] + (": " + "; ".join(members) if members else "")


def percent(share):
    return f"{100 * share:.1f} %"


def row(stated, report):
    shrink = report.get("shrink")
    tested = shrink and shrink["tested"]
    left, noise = (percent(shrink["ratio"]), percent(shrink["noise_floor_ratio"])) if tested else ("", "")
    return f"| {stated['data']} | {stated['source']} | {stated['states'] or 'no cause'} | {said(report)} | {judged(stated, report)} | {left} | {noise} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plumbline")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--reports", type=pathlib.Path)
    a = parser.parse_args()
    reports = a.reports or pathlib.Path(tempfile.mkdtemp())
    reports.mkdir(parents=True, exist_ok=True)
    print("| data | source, licence | the owners state | said | judged | left | noise |\n|---|---|---|---|---|---|---|")
    counts = {}
    for name, stated in tomllib.loads((pathlib.Path(__file__).parent / "sets.toml").read_text()).items():
        out = reports / f"{name}.json"
        if not out.exists():
            subprocess.run([a.plumbline, "diagnose", a.folder / name, "--json", out], capture_output=True, check=False)
        report = json.loads(out.read_text())
        print(row(stated, report))
        counts[judged(stated, report)] = counts.get(judged(stated, report), 0) + 1
    print("\n" + ", ".join(f"{what} {count}" for what, count in sorted(counts.items())) + ".")


if __name__ == "__main__":
    main()
