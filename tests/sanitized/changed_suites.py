#!/usr/bin/env python3
"""Builds and runs under the sanitizers the suites of the folders that changed: their quick cases, within a time.

    tests/sanitized/changed_suites.py BUILD               BUILD is a build of the preset sanitize (or threads)
    tests/sanitized/changed_suites.py BUILD --list        say which suites these are and end

A folder changed if a file of it, or of its suite in tests/, that is compiled differs from the commit that stood four hours
before the last one; where there is no such commit all folders did. What the time does not suffice for is stopped, and
said to be left out: it is no failure."""
import argparse
import os
import pathlib
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
# in the order in which they are run, until the time is over: those first that take least
SUITES = {"page": "support/page", "campaign": "diagnose/campaign", "trial": "trial", "draft": "diagnose/draft", "core": "core",
          "exchange": "diagnose/exchange", "diagnose": "diagnose", "simulator": "trial/simulator", "app": "app",
          "proofs": "proofs", "verify": "verify"}
NOT_COMPILED = {".md", ".py", ".v"}


def git(*words):
    """What git answers, or "" where it knows no such thing."""
    return subprocess.run(["git", *words], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.strip()


def commit_before(hours):
    """The last commit among the ancestors of HEAD that is so much older, or "" """
    written = git("log", "-1", "--format=%ct")
    return written and git("rev-list", "-1", f"--before={int(written) - round(3600 * hours)}", "HEAD")


def changed_suites(commit):
    """The suites of the folders in which what is compiled differs from a commit."""
    found = set()
    for name in git("diff", "--name-only", "--no-renames", commit).splitlines():
        path = pathlib.PurePosixPath(name.removeprefix("tests/"))
        if path.suffix not in NOT_COMPILED:
            # the suite of the innermost folder, where one that has a suite lies in another
            inside = [suite for suite, folder in SUITES.items() if path.is_relative_to(folder)]
            found |= set(sorted(inside, key=lambda suite: len(SUITES[suite]))[-1:])
    return [suite for suite in SUITES if suite in found]


def run(words, end):
    """The exit status of a command, None where it was stopped because the time is over."""
    process = subprocess.Popen(words, start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        output, _ = process.communicate(timeout=max(0, end - time.monotonic()))
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGTERM)
        process.communicate()
        return None
    if process.returncode != 0:
        print(output, flush=True)
    return process.returncode


def run_suite(suite, build, end):
    """Whether a suite was built and passes; None where the time did not suffice."""
    begin = time.monotonic()
    status = run(["cmake", "--build", build, "--target", f"test-{suite}"], end)
    built = time.monotonic()
    if status == 0:
        status = run(["ctest", "--test-dir", f"{build}/tests", "-C", "quick", "-R", f"^quick-{suite}$", "--no-tests=error",
                      "--output-on-failure"], end)
        seconds = f"built in {built - begin:.0f} s, ran for {time.monotonic() - built:.0f} s"
    else:
        seconds = f"{'not built' if status is None else 'does not build'}, {built - begin:.0f} s"
    print(f"{suite}: {seconds}: {'passed' if status == 0 else 'stopped' if status is None else 'FAILED'}", flush=True)
    return None if status is None else status == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", metavar="BUILD", help="the folder of the build")
    parser.add_argument("--hours", type=float, default=4, help="how far back a change reaches")
    parser.add_argument("--minutes", type=float, default=6, help="what has not ended by then is left out")
    parser.add_argument("--list", action="store_true", help="say which suites would be run and end")
    options = parser.parse_args()

    end = time.monotonic() + 60 * options.minutes
    commit = commit_before(options.hours)
    suites = changed_suites(commit) if commit else list(SUITES)
    since = f"since {commit[:12]}" if commit else f"no commit is {options.hours:g} hours older, all folders count"
    print(f"changed ({since}): {' '.join(suites) or 'nothing that a suite here compiles'}", flush=True)
    if options.list:
        return
    left_out, failed = [], False
    for suite in suites:
        passed = run_suite(suite, options.build, end) if time.monotonic() < end else None
        if passed is None:
            left_out.append(suite)
        failed |= passed is False
    if left_out:
        print(f"left out, for {options.minutes:g} minutes are over: {' '.join(left_out)}")
    sys.exit(failed)


main()
