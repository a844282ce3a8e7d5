"""Writes one program of all examples of the library: those in the documentation comments of the headers of core/, and
the C++ blocks of the documents.

usage: library_examples.py PROGRAM.cpp
"""
import re
import sys
from pathlib import Path

from documents import ROOT, blocks, documents


INCLUDE = re.compile(r"^#include .*$", flags=re.M)


def of_headers():
    """(what is included, where the example stands, its code)"""
    for header in sorted((ROOT / "core").rglob("*.hpp")):
        lines = header.read_text(encoding="utf-8").splitlines()
        comments = "\n".join(line[3:].removeprefix(" ") if line.startswith("///") else "" for line in lines)
        for code in re.findall(r"\\code\{\.cpp\}\n(.*?)\\endcode", comments, flags=re.S):
            name = header.relative_to(ROOT / "core").as_posix()
            yield [f"#include <{name}>", *INCLUDE.findall(code)], name, INCLUDE.sub("", code)


def of_documents():
    for path in documents():
        for block in blocks(path):
            if block.language == "cpp":
                yield INCLUDE.findall(block.text), block.place, INCLUDE.sub("", block.text)


examples = [*of_headers(), *of_documents()]
includes = sorted({line for included, _, _ in examples for line in included})
text = "// Written by tests/docs/library_examples.py.\n#include <cassert>\n#include <cstdio>\n" + "\n".join(includes)
for number, (_, place, code) in enumerate(examples):
    text += f"\n\n/// {place}\nstatic void example_{number}() {{\nusing namespace plumbline;\n{code}}}"
text += "\n\nint main() {\n"
for number, (_, place, _) in enumerate(examples):
    text += f'  std::puts("{place}");\n  example_{number}();\n'
Path(sys.argv[1]).write_text(text + "}\n", encoding="utf-8")
