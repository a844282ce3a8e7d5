"""The score of a blind trial's answers: arguments, reports of the program, and the table of families."""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import subprocess
import tempfile


def arguments(words):
    """PLUMBLINE, EXPERIMENTS, LABELS and the options of every score. Reports stay in their folder and are not made again."""
    parser = argparse.ArgumentParser(description=words, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plumbline", type=pathlib.Path)
    parser.add_argument("experiments", type=pathlib.Path)
    parser.add_argument("labels", type=pathlib.Path)
    parser.add_argument("--reports", type=pathlib.Path)
    parser.add_argument("--markdown", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    a = parser.parse_args()
    a.plumbline = a.plumbline.resolve()
    a.reports = a.reports or pathlib.Path(tempfile.mkdtemp())
    a.reports.mkdir(parents=True, exist_ok=True)
    return a


def names(a):
    return sorted(path.name for path in a.experiments.iterdir() if path.is_dir())


def for_each_experiment(a, judge):
    with concurrent.futures.ThreadPoolExecutor(a.jobs) as pool:
        return list(pool.map(judge, names(a)))


def diagnosed(a, name, *words):
    """The report NAME.json of `plumbline diagnose` with these words; None without one."""
    out = a.reports / f"{name}.json"
    if not out.exists():
        subprocess.run([a.plumbline, "diagnose", *words, "--json", out], capture_output=True, timeout=1200, check=False)
    return json.loads(out.read_text()) if out.exists() else None


def table(rows, answers):
    """\\param rows  titles with the answers counted under them"""
    lines = ["| | n | " + " | ".join(answers) + " |", "|---|---:|" + "---:|" * len(answers)]
    for title, given in rows:
        count = collections.Counter(given)
        lines.append(f"| {title} | {len(given)} | " + " | ".join(str(count[a] or "") for a in answers) + " |")
    return "\n".join(lines)
