"""Evidence is made of the values that were used: no literal of one holds a decimal, a power of ten or an angle, which a
premise or a window could make wrong.

usage: evidence.test.py FOLDER...     with the sources of checks
"""
import pathlib
import re
import sys

BEGINS = re.compile(r"EvidenceKind::\w+\s*,|Evidence::(?:by_theorem|by_checked_theorem|at_points)\(")
NUMBER = re.compile(r"(?<![\w.])\d+\.\d+|= *-?pi/\d|\b\de-\d")
PLACES = re.compile(r"[Ss]ections? \d+\.\d+|\bof \d\.\d\b")  # of the paper


def literals(source, at):
    """The literals of the expression that begins at a place, to the end of its brackets."""
    depth = 0
    while at < len(source):
        c = source[at]
        if c == '"':
            end = at + 1
            while source[end] != '"':
                end += 2 if source[end] == "\\" else 1
            yield source[at + 1:end]
            at = end
        elif c in "({":
            depth += 1
        elif c in ")}":
            if depth == 0:
                return
            depth -= 1
        at += 1


def complaints(path):
    source = path.read_text(encoding="utf-8")
    for begin in BEGINS.finditer(source):
        for literal in literals(source, begin.end()):
            if NUMBER.search(PLACES.sub("", literal)):
                yield f"{path.name}:{source.count(chr(10), 0, begin.start()) + 1}: “{literal}”"


def main(*folders):
    files = [path for folder in folders for path in sorted(pathlib.Path(folder).glob("*.cpp"))]
    wrong = [line for path in files for line in complaints(path)]
    planted = 'return {EvidenceKind::interval, "at 0.1 L: " + text};'
    if not any(NUMBER.search(one) for one in literals(planted, planted.index(",") + 1)):
        wrong.append("a planted decimal is not found")
    for line in wrong:
        print(line)
    print(f"{len(files)} files, {len(wrong)} numbers in literals of evidence")
    sys.exit(bool(wrong) or not files)


main(*sys.argv[1:])
