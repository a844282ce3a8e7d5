#!/usr/bin/env python3
"""The simulator and the diagnosis share no line of mechanics: what both include, however far down, is
infrastructure. Left out is the file that compares the simulator with the nominal statics, for it is there to
use both; nothing that it computes reaches an experiment. What is outside the catalogue is in one file of the
simulator. Usage: independence.test.py SOURCE_FOLDER"""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
# Errors, threads and files know nothing of chains; the label is what the simulator gives away.
INFRASTRUCTURE = re.compile(r"core/plumbline/base/(error|parallel)\.hpp|support/files/[a-z0-9_]+\.hpp")
COMPARES = "trial/simulator/nominal_error.cpp"
NO_ENGINE = "diagnose/exchange", "diagnose/campaign"  # what comes after a diagnosis
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def find(name, includer):
    """The file of the project that an include means; nothing for those of other packages."""
    for folder in (root, root / "core", includer.parent):
        if (folder / name).is_file():
            return (folder / name).resolve()
    return None


def reached(folder):
    """Every file of the project that the sources of a folder include, themselves among them."""
    todo = [p.resolve() for p in sorted((root / folder).rglob("*"))
            if p.suffix in (".cpp", ".hpp") and p != root / COMPARES and p.parent not in [root / room for room in NO_ENGINE]]
    assert todo, f"no source in {folder}"
    seen = set(todo)
    while todo:
        here = todo.pop()
        for name in INCLUDE.findall(here.read_text()):
            there = find(name, here)
            if there and there not in seen:
                seen.add(there)
                todo.append(there)
    return {p.relative_to(root.resolve()).as_posix() for p in seen}


assert (root / COMPARES).is_file()
simulator, diagnosis = reached("trial/simulator"), reached("diagnose")
assert any(p.startswith("core/plumbline/") and "/base/" not in p for p in diagnosis), \
    "includes are not followed: the diagnosis stands on the mechanics of core"
wrong = sorted(p for p in simulator & diagnosis if not INFRASTRUCTURE.fullmatch(p))
crossing = sorted(p for p in simulator if p.startswith("diagnose/")) + \
    sorted(p for p in diagnosis if p.startswith("trial/"))
outside = [p.name for p in sorted((root / "trial/simulator").glob("*.cpp")) if '{"unknown"' in p.read_text()]
assert outside == ["outside.cpp"], f"effects outside the catalogue in {outside}, expected in outside.cpp alone"
for path in wrong:
    print(f"{path}: found in both, expected in one of simulator and diagnose")
for path in crossing:
    print(f"{path}: found across, expected neither to know the other, nor the diagnosis the labels")
print(f"simulator reaches {len(simulator)} files, diagnose {len(diagnosis)}, both {len(simulator & diagnosis)}")
sys.exit(1 if wrong or crossing else 0)
