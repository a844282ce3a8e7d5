#!/usr/bin/env python3
"""The rules of docs/contributing.md that a machine can check: layout, lengths, folder arrows, prose.

usage: style.test.py [SOURCE]

Files of more lines and pages of more words than the rule allows are listed with the reason in long-files.md, which may only shrink.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

COLUMNS = 120
LINES = 400
WORDS = 40
PAGE = 900
CODE = ("core", "proofs", "statement", "verify", "diagnose", "app", "support", "trial", "tests", "python", "benchmarks")
LIBRARIES = ("core", "proofs", "statement", "verify", "diagnose", "app", "support", "trial")
# A folder includes files of itself and of those before it in a line that has both.
ARROWS = (("core", "support", "proofs", "statement", "verify", "app"),
          ("core", "support", "statement", "diagnose", "trial", "app"),
          *(("core", "support", "diagnose", f"diagnose/{own}", "app")
            for own in ("api", "exchange", "calibration", "campaign", "change", "draft", "motion")),
          ("diagnose/exchange", "diagnose/calibration", "diagnose/api"), ("diagnose/exchange", "diagnose/draft"), ("diagnose/campaign", "diagnose/change"))
# Words that stand in place of a subject.
NO_SUBJECT = re.compile(r"(What|Of|Where)\b")
# Pages that programs write: their words are those of the schemas and of the sources.
WRITTEN = ("docs/reference.md",)


def files(source, folders, endings):
    for folder in folders:
        for path, inner, names in os.walk(os.path.join(source, folder)):
            inner[:] = sorted(name for name in inner if not name.startswith((".", "build", "__")))
            for name in sorted(names):
                if name.endswith(endings):
                    yield os.path.relpath(os.path.join(path, name), source)


def text(source, name):
    with open(os.path.join(source, name), encoding="utf-8") as file:
        return file.read()


def unformatted(source):
    program = shutil.which("clang-format")
    if not program:
        return ["clang-format is not installed; ./setup.sh --tests installs it"]
    names = list(files(source, CODE, (".cpp", ".hpp")))
    said = subprocess.run([program, "--dry-run", *names], cwd=source, stderr=subprocess.PIPE, text=True).stderr
    places = {line.split(": warning")[0].rsplit(":", 2)[0] for line in said.splitlines() if ": warning" in line}
    return [f"{place}: clang-format would change it" for place in sorted(places)]


def wide(source):
    """Comments alone: clang-format breaks code, and a literal is as wide as what it holds."""
    for name in files(source, CODE, (".cpp", ".hpp")):
        for number, line in enumerate(text(source, name).splitlines(), 1):
            if len(line) > COLUMNS and re.search(r"(^|\s)///?<? ", line):
                yield f"{name}:{number}: found {len(line)} columns, expected at most {COLUMNS}"


def listed(source, endings):
    """The rows of long-files.md: how many lines or words a file may have that has more than the rule allows."""
    rows = re.findall(r"^\| `(.+)` \| (\d+) \| .+ \|$", text(source, "tests/style/long-files.md"), flags=re.M)
    return {name: int(most) for name, most in rows if name.endswith(endings)}


def long_ones(source, folders, endings, limit, size, what):
    allowed = listed(source, endings)
    for name in files(source, folders, endings):
        found, most = size(text(source, name)), allowed.pop(name, None)
        if most is None and found >= limit:
            yield f"{name}: found {found} {what}, expected less than {limit}"
        elif most is not None and found > most:
            yield f"{name}: found {found} {what}, expected at most the {most} of long-files.md"
        elif most is not None and found < limit:
            yield f"tests/style/long-files.md: found {name}, which has {found} {what}, expected files of {limit} and more"
    yield from (f"tests/style/long-files.md: found {name}, which is not there" for name in allowed)


def long_files(source):
    yield from long_ones(source, CODE, (".cpp", ".hpp", ".py"), LINES, lambda file: file.count("\n"), "lines")


def long_pages(source):
    yield from long_ones(source, ("docs",), (".md",), PAGE, lambda page: len(page.split()), "words")


def place(name):
    """The longest folder of ARROWS that holds a file."""
    folders = {folder for line in ARROWS for folder in line}
    return max((folder for folder in folders if name.startswith(folder + "/")), key=len, default="")


def upward(source):
    for name in files(source, LIBRARIES, (".cpp", ".hpp")):
        for other in re.findall(r'#include "([a-z0-9/_.]+)"', text(source, name)):
            here, there = place(name), place(other)
            if any(here in line and there in line and line.index(there) > line.index(here) for line in ARROWS):
                yield f"{name}: found an include of {there}/, which uses {here}/"


def sentences(document):
    """The sentences of a page in Markdown with their lines; code, tables, headings and quotations are none."""
    paragraph, first, fenced = [], 0, False
    for number, line in enumerate(document.splitlines() + [""], 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
            line = ""
        if fenced or not line.strip() or re.match(r" {4}(?![-*])|\s*(\||#|>|<|!\[|[-*] |\d+\. )", line):
            if paragraph:
                yield from ((first, s) for s in re.split(r"(?<=[.!?:;])\s+(?=[A-Z`*\[(])", " ".join(paragraph).replace("**", "")))
            item = re.match(r"\s*(?:[-*]|\d+\.) (.+)", line)
            paragraph, first = ([item.group(1)] if item and not fenced else []), number
            continue
        if not paragraph:
            first = number
        paragraph.append(line.strip())


def prose(source):
    pages = [name for name in files(source, ("docs",), (".md",)) if name not in WRITTEN]
    for name in ["README.md", "verify/papers/README.md", "diagnose/rig/effects/README.md", *pages]:
        for line, sentence in sentences(text(source, name)):
            words = re.sub(r"\]\([^)]*\)|`[^`]*`", "x", sentence).split()
            if NO_SUBJECT.match(sentence) and not sentence.endswith("?"):
                yield f"{name}:{line}: “{sentence[:40]}…”: found {words[0]} in place of a subject, expected a noun"
            if len(words) > WORDS:
                yield f"{name}:{line}: “{sentence[:40]}…”: found {len(words)} words, expected at most {WORDS}"


def planted():
    """Every check finds the fault that is planted for it, and no other."""
    pages = {"core/long.cpp": "int a();\n" * LINES, "core/up.hpp": '#include "app/verb.hpp"\n',
             "core/wide.hpp": "/// " + "word " * 30 + "\n", "diagnose/change/fine.hpp": '#include "diagnose/rig/rig.hpp"\n',
             "README.md": "# A title\n\nWhat is it? Where it leads is not said.\n\n| What | a table |\n",
             "diagnose/rig/effects/README.md": "**A bold word.** Of these none is said.\n",
             "verify/papers/README.md": "word " * (WORDS + 1) + "end.\n", "docs/page.md": "```sh\nWhat a line.\n```\n", "docs/long.md": "Fine words.\n" * PAGE,
             "tests/style/long-files.md": "| `core/gone.cpp` | 500 | none |\n"}
    with tempfile.TemporaryDirectory() as folder:
        for name, content in pages.items():
            place = pathlib.Path(folder, name)
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(content, encoding="utf-8")
        found = {check.__name__: [line.split(":")[0] for line in check(folder)] for check in (wide, long_files, long_pages, upward, prose)}
    assert found == {"wide": ["core/wide.hpp"], "long_files": ["core/long.cpp", "tests/style/long-files.md"], "long_pages": ["docs/long.md"], "upward": ["core/up.hpp"],
                     "prose": ["README.md", "verify/papers/README.md", "diagnose/rig/effects/README.md"]}, found


def main():
    planted()
    source = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "..", "..")
    found = [complaint for check in (unformatted, wide, long_files, long_pages, upward, prose) for complaint in check(source)]
    print("\n".join(found) if found else "layout, lengths, folder arrows and prose: as docs/contributing.md asks")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
