"""Where each claim is checked: the line at which the function begins that judges it, read from the list of checks
that ends every file of this folder; and where each kind of check begins that a claim states (verify/generic).

Usage: lines.py ROOT HEADER   (ROOT of the project; HEADER is written when it would change)
"""

import pathlib
import re
import sys

ENTRY = re.compile(r'\{"([\w.-]+)",\s*(?:\[\]\([^)]*\)\s*\{\s*return )?(\w+)')
KIND = re.compile(r'\{"([a-z -]+)", "(\w+)", generic::(\w+)\}')
FUNCTION = re.compile(r"^Judgement (\w+)\(", re.MULTILINE)


def lines_of(text, where):
    """Pairs (id, line) of one file."""
    functions = {found[1]: text.count("\n", 0, found.start()) + 1 for found in FUNCTION.finditer(text)}
    for entry in ENTRY.finditer(text[text.index("\nChecks claims::") :]):
        if entry[2] not in functions:
            sys.exit(f"{where}: found no function {entry[2]}, expected the one that judges {entry[1]}")
        yield entry[1], functions[entry[2]]


def kinds_of(text, root):
    """Pairs (kind, file, line) of the list in verify/generic/generic.cpp."""
    for name, stem, function in KIND.findall(text):
        path = root / f"verify/generic/{stem}.cpp"
        source = path.read_text(encoding="utf-8")
        at = source.index(f"\nJudgement generic::{function}(") + 1
        yield name, path.relative_to(root).as_posix(), source.count("\n", 0, at) + 1


def main(root, header):
    rows = []
    listed = (root / "verify/generic/generic.cpp").read_text(encoding="utf-8")
    rows += [f'    {{"generic {name}", "{file}", {line}}},\n' for name, file, line in kinds_of(listed, root)]
    for path in sorted((root / "verify/claims").glob("*.cpp")):
        text = path.read_text(encoding="utf-8")
        where = path.relative_to(root).as_posix()
        if "\nChecks claims::" in text:
            rows += [f'    {{"{claim}", "{where}", {line}}},\n' for claim, line in lines_of(text, where)]
    text = (
        "#pragma once\n\nnamespace plumbline::verify {\n\nstruct CheckLine {\n  const char* claim;\n  const char* file;\n"
        "  int line;\n};\n\ninline constexpr CheckLine check_lines[] = {\n" + "".join(rows) + "};\n\n"
        "}  // namespace plumbline::verify\n"
    )
    if not header.exists() or header.read_text(encoding="utf-8") != text:
        header.parent.mkdir(parents=True, exist_ok=True)
        header.write_text(text, encoding="utf-8")


main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
