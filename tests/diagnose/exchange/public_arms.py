#!/ usr / bin / env python3
"""What `plumbline arm` reads of models that others publish: a row a model, as a table in Markdown.

usage: public_arms.py PLUMBLINE FOLDER

Every .xml (with the root <mujoco>), .urdf and .sdf below the folder that has a serial arm of five joints or more: the joints
of the arm, its ends, what it weighs, the servos. Where a model has several tips the first that the error names is taken, and
where its base floats the body that floats.
"""
import collections
import pathlib
import re
import subprocess
import sys

LEAST_JOINTS = 5


def arm(program, model, *words):
    done = subprocess.run([program, "arm", model, *words], capture_output=True, text=True, check=False, timeout=60)
    return done.returncode, done.stdout if done.returncode == 0 else done.stderr.strip()


def read(program, model):
    """The arm with the ends that it has or that are offered."""
    status, said = arm(program, model)
    offered = re.search(r"expected one by its name: ([^,\n]+)", said) if status else None
    return arm(program, model, "--tip", offered[1]) if offered else (status, said)


def row(program, model):
    """A row of the table, or none for what is no arm."""
    status, said = read(program, model)
    if status:
        if "found no joint" in said:
            return "short", ""
        reason = re.sub(r"^.*?: found ", "", said).replace(", expected", "; expected")
        return "refused", reason[:170].replace("|", "/")
    joints = re.findall(r"^kind = \"(\w)", said, re.MULTILINE)
    if len(joints) < LEAST_JOINTS:
        return "short", ""
    base, tip = re.search(r"# base: (.*); tip: (.*)", said).groups()
    mass = sum(float(one) for one in re.findall(r"^mass = (\S+)", said, re.MULTILINE))
    held = re.search(r"# held where the model draws them: (.*)", said)
    kinds = "".join(joints).upper()
    words = f"{kinds}, {base} to {tip}; {mass:.3g} kg"
    words += f"; {len(re.findall(r'^stiffness', said, re.MULTILINE))} of {len(joints)} joints yield" if "stiffness" in said else ""
    return "read", words + (f"; held: {len(held[1].split(','))}" if held else "")


def main():
    program, folder = sys.argv[1:]
    models = [path for path in sorted(pathlib.Path(folder).rglob("*")) if path.suffix in (".urdf", ".sdf")
              or (path.suffix == ".xml" and "<mujoco" in path.read_text(encoding="utf-8", errors="replace")[:4000])]
    counts, seen = collections.Counter(), set()
    print("| model | read | joints (R, P), ends, moved mass; or the reason |\n|---|---|---|")
    for model in models:
        what, words = row(program, model)
        counts[what] += 1
        name = f"{model.parent.name}/{model.name}"
        if what != "short" and (name, words) not in seen:
            print(f"| `{name}` | {what} | {words} |")
        seen.add((name, words))
    print(f"\n{len(models)} models: {counts['read']} arms read, {counts['short']} with fewer joints read, {counts['refused']} refused")


if __name__ == "__main__":
    main()
