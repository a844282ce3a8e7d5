#!/usr/bin/env python3
"""Branch coverage by folder, as a table in Markdown.

usage: tests/coverage.py [SUITE ...]        files, exchange, draft, …, checkers; all without any

Builds the suites with the preset `coverage` (gcc's own counters, nothing inlined), runs them, and lets gcovr (Debian package
gcovr) read the counters. Branches that only an exception takes, which the compiler adds at every call, are left out. The
checkers of certificates are Python: their tests run under Debian's python3-coverage, which counts by line and branch alike.
"""
import collections
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = ROOT / "build-coverage"
#: Where the sources of a suite lie.
FOLDERS = {"files": "support/files", "page": "support/page", "work": "support/work", "exchange": "diagnose/exchange",
           "draft": "diagnose/draft", "campaign": "diagnose/campaign", "diagnose": "diagnose", "core": "core", "proofs": "proofs",
           "verify": "verify", "trial": "trial", "app": "app"}
CHECKERS = "proofs/certificates"
VALUES = "verify/reference/values"
#: Tests of the checkers in tests/proofs/certificates, with what they read.
CHECKER_TESTS = (("inertia", ()), ("tampering", (f"{VALUES}/certificates.json",)),
                 ("tampering_paths", (f"{VALUES}/path-certificates.json",)),
                 ("tampering_structures", (f"{VALUES}/structure-certificates.json",)),
                 ("tampering_equilibria", (f"{VALUES}/equilibria-certificates.json",)))


def run(*words, **settings):
    return subprocess.run([str(word) for word in words], check=True, cwd=ROOT, **settings)


def of_suites(suites):
    """(taken, branches, run, lines) by folder."""
    run("cmake", "--preset", "coverage", stdout=subprocess.DEVNULL)
    run("cmake", "--build", BUILD, "--target", *(f"test-{suite}" for suite in suites), stdout=subprocess.DEVNULL)
    for counters in BUILD.rglob("*.gcda"):
        counters.unlink()
    for suite in suites:
        run(BUILD / "tests" / f"test-{suite}", "--minimal", env={"RC_PARAMS": "seed=1", "PATH": "/usr/bin:/bin"})
    filters = [word for suite in suites for word in ("--filter", f"{ROOT}/{FOLDERS[suite]}/")]
    summary = run("gcovr", "--root", ROOT, "--object-directory", BUILD, "--exclude-throw-branches", "--exclude-unreachable-branches",
                  *filters, "--json-summary", "-", stdout=subprocess.PIPE, text=True).stdout
    folders = collections.defaultdict(lambda: [0, 0, 0, 0])
    for file in json.loads(summary)["files"]:
        for i, key in enumerate(("branch_covered", "branch_total", "line_covered", "line_total")):
            folders[str(pathlib.PurePosixPath(file["filename"]).parent)][i] += file[key]
    return folders


def of_checkers():
    coverage = ("/usr/bin/python3", "-B", "-m", "coverage")
    with tempfile.TemporaryDirectory() as place:
        settings = {"env": {**os.environ, "COVERAGE_FILE": f"{place}/data"}, "stdout": subprocess.DEVNULL}
        for name, read in CHECKER_TESTS:
            run(*coverage, "run", "--branch", "--parallel-mode", "--source", CHECKERS, f"tests/proofs/certificates/{name}.test.py",
                CHECKERS, *read, **settings)
        run(*coverage, "combine", **settings)
        run(*coverage, "json", "-o", f"{place}/report.json", **settings)
        total = json.loads(pathlib.Path(place, "report.json").read_text())["totals"]
    return {CHECKERS: [total["covered_branches"], total["num_branches"], total["covered_lines"], total["num_statements"]]}


def main():
    suites = sys.argv[1:] or [*FOLDERS, "checkers"]
    unknown = set(suites) - {*FOLDERS, "checkers"}
    if unknown:
        sys.exit(f"coverage: found the suite {', '.join(sorted(unknown))}, expected some of {', '.join(FOLDERS)}, checkers")
    folders = {}
    if set(suites) & set(FOLDERS):
        folders |= of_suites([suite for suite in suites if suite in FOLDERS])
    if "checkers" in suites:
        folders |= of_checkers()
    print("| folder | branches taken | of | share | lines run |\n|---|---|---|---|---|")
    for folder, (taken, branches, lines, all_lines) in sorted(folders.items()):
        share = f"{100 * taken / branches:.1f} %" if branches else "–"
        print(f"| `{folder}` | {taken} | {branches} | {share} | {100 * lines / max(all_lines, 1):.1f} % |")


if __name__ == "__main__":
    main()
