#!/usr/bin/env python3
"""Plants faults in core, proofs and diagnose, one at a time, and says which of them the suites catch.

    tests/mutation/mutate.py                 the listed faults (tests/mutation/faults.toml)
    tests/mutation/mutate.py --generated 300 so many more, made from the text, the same ones for the same --seed
    tests/mutation/mutate.py --changed REV   those made on the lines that changed since REV, alone: all, or --generated so many

A fault is to be caught by the suite of its own folder: a test case fails, crashes or takes far longer. All faults of a
folder are compiled at once, in a copy of the project (build-mutation), and a process chooses one; it is offered only to the
test cases that come by its place, the shortest first. What was caught before is not tried again with --survivors."""
import argparse
import functools
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from checkers import try_checker
from fault import Moved, listed
from generated import all_faults
from source import Source
from table import survivors, survivors_allowed, table
from workplace import FOLDERS, ROOT, Workplace

UNKNOWN_REVISION = 77  # exit status: nothing to compare with, as in a clone of one commit
SHORT = 2.0  # seconds of test cases that run as one process before the longer ones


def changed_lines(revision, folders):
    """{file: lines} that differ from a revision. Ends the program where git knows no such revision."""
    done = subprocess.run(["git", "diff", "-U0", revision, "--", *folders], cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        print(f"--changed {revision}: {done.stderr.splitlines()[0]}, expected a revision to compare with", file=sys.stderr)
        sys.exit(UNKNOWN_REVISION)
    lines, path = {}, ""
    for row in done.stdout.splitlines():
        if row.startswith("+++ "):
            path = row[6:]
        elif row.startswith("@@"):
            begin, _, count = re.search(r"\+(\d+)(,(\d+))?", row).groups()
            lines.setdefault(path, set()).update(range(int(begin), int(begin) + int(count or 1)))
    return lines


def generated_faults(wanted, folders, source):
    """All faults made from the text of the files in the folders, on the wanted lines only if any are given."""
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            name = path.relative_to(ROOT).as_posix()
            if path.suffix in (".cpp", ".hpp", ".py") and "/coq/" not in name and (wanted is None or name in wanted):
                yield from (f for f in all_faults(source(name)) if wanted is None or f.line in wanted[name])


def drawn(seed, fault, source):
    """A place at random among all faults that a change of other lines does not move."""
    return hashlib.sha256(f"{seed} {fault.path} {source.text_of(fault.line)} {fault.what} {fault.after}".encode()).digest()


def pattern(name):
    """A filter of doctest for one test case: commas part filters, so that any letter may stand for them."""
    return re.sub(r"[,\\]", "?", name)


def caught_by(place, number, longest):
    """The test case that catches a fault, or "", and whether any came by it; none is asked that takes longer than this."""
    cases = [case for case in place.cases if number in case[2] and case[0] <= longest]
    groups, seconds = [], SHORT
    for case in cases:
        if seconds + case[0] > SHORT:
            groups.append([])
            seconds = 0
        groups[-1].append(case)
        seconds += case[0]
    for group in groups:
        limit = 20 + 10 * sum(case[0] for case in group)
        names = ",".join(pattern(case[1]) for case in group)
        status, output = place.run(["--abort-after=1", f"-tc={names}"], limit, PLUMBLINE_PLANTED=str(number))
        if status != 0:
            found = re.search(r"^TEST CASE:\s+(.*)", output, re.M)
            return (found[1] if found else group[0][1]) + (" (does not end)" if status is None else ""), True
    return "", bool(cases)


def try_all(folder, faults, options, results):
    """Plants the faults of one folder, and adds to the results what became of them."""
    # where few files hold faults the others are compiled together, as the compiler cache has them from the usual build, and so are
    # all where headers alone hold them, for those are compiled with every file; else each by itself, so that one fault that does
    # not compile costs one file
    compiled = [fault for fault in faults if not fault.path.endswith(".py")]
    changed = options.changed is not None
    together = changed or all(fault.path.endswith(".hpp") for fault in compiled)
    place = Workplace(ROOT / "build-mutation" / ("changed" if changed else "") / folder, folder, options.jobs, together)
    place.unplanted = {key: result["unplanted"] for key, result in results.items() if result.get("unplanted")}
    if compiled:
        place.make(compiled)
        place.record()

    def attempt(fault):
        old = results.get(fault.key)
        if options.survivors and old and old.get("caught"):
            return old
        begin = time.time()
        if fault.key in place.unplanted:
            return {"unplanted": place.unplanted[fault.key]}
        if fault.path.endswith(".py"):
            caught, reached = try_checker(fault, place.folder), True
        else:
            caught, reached = caught_by(place, place.number[fault.key], options.longest)
        print(f"{'caught' if caught else 'SURVIVED'} {fault.listed} {fault.path}:{fault.line}: {fault.what} "
              f"[{caught or ('' if reached else 'not reached')}] {time.time() - begin:.1f} s", file=sys.stderr, flush=True)
        return {"caught": caught, "reached": reached}

    with ThreadPoolExecutor(options.jobs) as pool:
        for fault, result in zip(faults, pool.map(attempt, faults)):
            results[fault.key] = result
            options.results.write_text(json.dumps(results, indent=1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--generated", type=int, metavar="N", help="so many faults made from the text")
    parser.add_argument("--changed", metavar="REV", help="faults made on the lines changed since this revision")
    parser.add_argument("--folders", nargs="+", default=list(FOLDERS), metavar="FOLDER",
                        help="whose code is changed, each with a suite: " + " ".join(FOLDERS))
    parser.add_argument("--only", default="", metavar="PART", help="faults in files whose path holds this, alone")
    parser.add_argument("--seed", type=int, default=1, help="of the choice of generated faults")
    parser.add_argument("--survivors", action="store_true", help="only what was not caught last time")
    parser.add_argument("--longest", type=float, default=float("inf"), metavar="SECONDS",
                        help="test cases that take longer are not asked: what they alone catch survives")
    parser.add_argument("--least", type=float, default=0, metavar="PERCENT",
                        help="of the faults planted and not argued so many are to be caught, all but one at least, or the exit status is 1")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="say what would be planted and end")
    parser.add_argument("--markdown", type=pathlib.Path, help="where the table goes; to standard output unless told")
    options = parser.parse_args()

    source = functools.cache(lambda name: Source(name, (ROOT / name).read_text()))
    wanted = lambda name: options.only in name and name.split("/")[0] in options.folders
    try:
        known = list(listed(pathlib.Path(__file__).with_name("faults.toml"), source, wanted))
    except Moved as moved:
        sys.exit(str(moved))
    argued = {fault.key: fault.argued for fault in known}
    faults = known if options.changed is None else []
    if options.generated or options.changed:
        made = list(generated_faults(changed_lines(options.changed, options.folders) if options.changed else None,
                                     options.folders, source))
        made = [fault for fault in made if wanted(fault.path)]
        for fault in made:
            fault.argued = argued.get(fault.key, "")
        count = len(made)
        made.sort(key=lambda fault: drawn(options.seed, fault, source(fault.path)))
        faults += made[:options.generated] if options.generated else made
        print(f"{count} faults can be made", file=sys.stderr)
    if options.list:
        for fault in faults:
            print(f"{fault.path}:{fault.line}: {fault.what}: {fault.before!r} -> {fault.after!r}")
        return

    options.results = ROOT / "build-mutation/results.json"
    results = json.loads(options.results.read_text()) if options.results.is_file() else {}
    for folder in options.folders:
        here = [fault for fault in faults if fault.path.startswith(folder + "/")]
        if here:
            try_all(folder, here, options, results)
    text = table(faults, results)
    if options.markdown:
        options.markdown.write_text(text)
    else:
        print(text, end="")
    allowed = survivors_allowed(faults, results, options.least)
    if survivors(faults, results) > allowed:
        sys.exit(f"more than {allowed} survived: a test is missing, or faults.toml has to argue why none can tell")


main()
