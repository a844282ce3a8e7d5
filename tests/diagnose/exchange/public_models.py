#!/usr/bin/env python3
"""What `plumbline chain` reads of models that others publish: a row a model, as a table in Markdown.

usage: public_models.py PLUMBLINE FOLDER

Every .xml (with the root <mujoco>), .urdf and .sdf below the folder: whether the whole is a planar chain, which part of it
is one (--joints), or why there is none.
"""
import collections
import pathlib
import re
import subprocess
import sys


def chain(program, model, *words):
    done = subprocess.run([program, "chain", model, *words], capture_output=True, text=True, check=False, timeout=60)
    return done.returncode, done.stdout if done.returncode == 0 else done.stderr.strip()


def row(program, model):
    """Joints read, or the reason why none are."""
    status, said = chain(program, model)
    if status == 0:
        joints = re.search(r"# joints: (.*)", said)[1]
        servos = len(re.findall(r"is a spring of", said))
        return "whole", joints + (f"; {servos} servos" if servos else "")
    part = re.search(r"--joints (\S+) keeps a part", said)
    if part:
        status, again = chain(program, model, "--joints", part[1])
        return ("part", part[1].replace(",", ", ")) if status == 0 else ("refused", again)
    return "refused", re.sub(r"; plumbline chain .*", "", said.split(": found ", 1)[-1]).replace(", expected", "; expected")


def main():
    program, folder = sys.argv[1:]
    models = [path for path in sorted(pathlib.Path(folder).rglob("*")) if path.suffix in (".urdf", ".sdf")
              or (path.suffix == ".xml" and "<mujoco" in path.read_text(encoding="utf-8", errors="replace")[:4000])]
    counts, seen = collections.Counter(), set()
    print("| model | read | joints, or the reason |\n|---|---|---|")
    for model in models:
        what, words = row(program, model)
        counts[what] += 1
        name = f"{model.parent.name}/{model.name}"
        if (name, words) not in seen:
            print(f"| `{name}` | {what} | {words[:160].replace('|', '/')} |")
        seen.add((name, words))
    print(f"\n{len(models)} models: {counts['whole']} as a whole, {counts['part']} in part, {counts['refused']} refused")


if __name__ == "__main__":
    main()
