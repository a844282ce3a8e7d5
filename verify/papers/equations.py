"""Writes equations.md: where the paper's equations are in the sources, and which claims judge them.

usage: equations.py PLUMBLINE [--check]

Equation numbers stand in the documentation comments of core/ as "(n)" or "(m) to (n)", claims name theirs in `where`.
--check compares with the file instead of writing it.
"""
import json
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TARGET = Path(__file__).with_name("equations.md")
HEAD = """# Equations

Where each numbered equation of the paper is in the library, and the claims that judge it: those about the equation, and
those on the text before and after it. Verdicts other than `confirmed` are named. Written by

```sh
cmake --build build --target equations
```

| equation | in the library | claims about it | claims around it |
|---|---|---|---|
"""


def numbers(text):
    """Equation numbers in a text; the parentheses of a call follow a word, those of an equation a space."""
    for first, last in re.findall(r"(?<![\w\])])\((\d{1,2})\)(?: to \((\d{1,2})\))?", text):
        yield from range(int(first), int(last or first) + 1)


def comments(header):
    """(documentation comment, name of what it documents; empty for a file) of a header."""
    lines = header.read_text(encoding="utf-8").splitlines()
    block = []
    for line in lines:
        stripped = line.strip()
        if stripped.startswith("///"):
            block.append(stripped[3:])
        elif block and not stripped.startswith(("template", "[[", "requires")):
            text = "\n".join(block)
            name = re.search(r"(\w+)\s*(?:\(|=|;|\{|$)", stripped)
            yield text, "" if "\\file" in text or not name else name[1]
            block = []


def sources():
    """By equation: headers, each with the names of what implements it, in the order of the paths."""
    found = defaultdict(lambda: defaultdict(list))
    for header in sorted((ROOT / "core").rglob("*.hpp")):
        for text, name in comments(header):
            for number in numbers(re.sub(r"\\code.*?\\endcode", "", text, flags=re.S)):
                names = found[number][header.relative_to(ROOT)]
                if name and name not in names:
                    names.append(name)
    return found


def claims():
    """By equation: the claims about it and those around it."""
    about, around = defaultdict(list), defaultdict(list)
    done = subprocess.run([Path(sys.argv[1]).resolve(), "verify", "--json"], check=True, text=True, capture_output=True)
    for claim in json.loads(done.stdout)["claims"]:
        verdict = "" if claim["verdict"] == "confirmed" else f" {claim['verdict']}"
        where = claim["where"].split(",", 1)[1]
        target = around if re.search(r"\b(before|after)\b", where) else about
        for number in numbers(where):
            target[number].append(f"`{claim['id']}`{verdict}")
    return about, around


def table():
    library, (about, around) = sources(), claims()
    last = max([*library, *about, *around])
    for number in range(1, last + 1):
        headers = [f"[{header.name}](../../{header.as_posix()})" + "".join(f" `{name}`" for name in names)
                   for header, names in library[number].items()]
        cells = [f"({number})", "<br>".join(headers), ", ".join(about[number]), ", ".join(around[number])]
        yield "| " + " | ".join(cells) + " |\n"


text = HEAD + "".join(table())
if "--check" not in sys.argv:
    TARGET.write_text(text, encoding="utf-8")
elif TARGET.read_text(encoding="utf-8") != text:
    sys.exit(f"{TARGET}: not what the sources say; cmake --build build --target equations")
