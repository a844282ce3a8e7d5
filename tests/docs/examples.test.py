"""Every example in the documents, run as it stands there; and what any text links to is there.

usage: examples.test.py PLUMBLINE [--update]

A fenced block with file=PATH is a file. A `console` block is a session: commands after "$ ", each followed by what it
prints, if anything is shown. "…" stands for any text; a line of its own for any lines. All blocks of a document share a
folder, in which the repository's folders can be seen. A `json` block names the schema that it follows. --update writes
what the commands print now, where what is shown has no "…".
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from jsonschema import Draft202012Validator

from documents import ROOT, SCHEMAS, anchors, blocks, documents, texts

SETUP = re.compile(r"(\./setup\.sh|cmake) .*")


def pattern(shown):
    return "".join("(?:.*\n)*" if line == "…" else re.escape(line).replace("…", ".*") + "\n"
                   for line in shown.splitlines())


def sessions(text):
    """(command, what is shown of its output) of a console block."""
    for part in re.split(r"^\$ ", text, flags=re.M)[1:]:
        command, _, shown = part.partition("\n")
        yield command, shown


def run(command, folder):
    path = f"{Path(sys.argv[1]).resolve().parent}:{os.environ['PATH']}"
    done = subprocess.run(["bash", "-c", command], cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env={**os.environ, "PATH": path}, check=False)
    return done.returncode, done.stdout


def visit_console(block, folder):
    """Faults, and the block as the program would write it."""
    faults, anew = [], ""
    for command, shown in sessions(block.text):
        status, output = run(command, folder)
        if status != 0:
            faults.append(f"{block.place}: $ {command}\n  exit status {status}\n{output}")
        elif shown and not re.fullmatch(pattern(shown), output):
            absent = [line for line in shown.splitlines() if not re.search("^" + pattern(line), output, re.M)]
            faults.append(f"{block.place}: $ {command}\n  shown, but not printed (or in another order):\n"
                          + "\n".join(absent or [shown]) + f"\n--- printed\n{output[:3000]}")
        anew += f"$ {command}\n" + (output if shown and "…" not in shown else shown)
    return faults, anew


def visit_json(block):
    if "schema" not in block.attributes:
        return [f"{block.place}: a json block without schema="]
    schema = json.loads((SCHEMAS / f"{block.attributes['schema']}.schema.json").read_text(encoding="utf-8"))
    return [f"{block.place}: {error.message}"
            for error in Draft202012Validator(schema).iter_errors(json.loads(block.text))]


def visit(path, folder):
    faults, text = [], path.read_text(encoding="utf-8")
    for entry in ROOT.iterdir():
        if not entry.name.startswith((".", "build")):
            (folder / entry.name).symlink_to(entry)
    (folder / "build").mkdir()
    (folder / "build" / "plumbline").symlink_to(Path(sys.argv[1]).resolve())
    for block in blocks(path):
        if "file" in block.attributes:
            target = folder / block.attributes["file"]
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(block.text, encoding="utf-8")
        if block.language == "json":
            faults += visit_json(block)
        elif block.language == "console":
            found, anew = visit_console(block, folder)
            faults += found
            text = text.replace(f"```console\n{block.text}", f"```console\n{anew}")
        elif block.language == "sh":
            faults += [f"{block.place}: {line}: not a console block, and not of the set-up"
                       for line in block.text.splitlines() if not SETUP.fullmatch(line)]
        elif "file" not in block.attributes and block.language not in ("cpp", "cmake"):
            faults.append(f"{block.place}: a block that nothing tests")
    if "--update" in sys.argv:
        path.write_text(text, encoding="utf-8")
    return faults


def broken_links(path):
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)
    for target, heading in re.findall(r"\]\(([^)#]*)(?:#([^)]*))?\)", text):
        page = path.parent / target if target else path
        if "://" in target:
            continue
        if not page.exists():
            yield f"{path.relative_to(ROOT)}: a link to {target}, which is not there"
        elif heading and page.suffix == ".md" and heading not in anchors(page):
            yield f"{path.relative_to(ROOT)}: a link to {target}#{heading}, a heading that is not there"


def unknown_presets(path):
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
    known = {preset["name"] for kind in ("configurePresets", "workflowPresets") for preset in presets[kind]}
    for name in re.findall(r"--preset\s+(\w+)", path.read_text(encoding="utf-8")):
        if name not in known:
            yield f"{path.relative_to(ROOT)}: no preset {name}"


def missing_folders(path):
    for folder in re.findall(r"`([a-z]+)/`", path.read_text(encoding="utf-8")):
        if not (ROOT / folder).is_dir():
            yield f"{path.relative_to(ROOT)}: no folder {folder}"


all_faults = []
for document in documents():
    with tempfile.TemporaryDirectory() as place:
        all_faults += [*visit(document, Path(place)), *missing_folders(document)]
for text in texts():
    all_faults += [*broken_links(text), *unknown_presets(text)]
print("\n".join(all_faults))
sys.exit(1 if all_faults else 0)
