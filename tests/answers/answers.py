"""What every verb of Plumbline answers on a fixed set of inputs, and whether two programs answer alike.

    answers.py write EXECUTABLE FOLDER [--experiments DIR]... [--only PATTERN]... [--jobs N]
    answers.py compare FOLDER FOLDER [--tolerance T] [--show N]
    answers.py list [--experiments DIR]...

`write` runs every case of cases.py in an empty folder of its own, with relative names alone, and keeps in FOLDER/CASE/ the
command with the digests of its inputs, standard output, standard error, the exit status and every file that was written. An
experiment of DIR is a folder with an experiment.toml; its label, if any, is not shown to the program.

`compare` says that two such folders are identical to the last byte, or lists the cases that differ, each with the first
difference. `--tolerance` lets numbers differ as comparison.py says; what is no number must be the same.

Exit status: 0 written, or alike; 1 a difference; 2 bad input, or a case that could not be run.
"""

import argparse
import concurrent.futures
import fnmatch
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

import cases
import comparison
import inputs

PATIENCE = 900  # s for one case


class Trouble(Exception):
    """Why the answers cannot be written or compared: one line."""


def lay_out(case, place):
    """The inputs of a case, in the folder where it runs."""
    for name, content in case.inputs.items():
        path = place / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def command_text(case):
    """The command and what it was given, so that answers to other questions are not compared."""
    lines = ["plumbline " + " ".join(case.arguments)]
    for name, content in sorted(case.inputs.items()):
        lines.append(f"{hashlib.sha256(content).hexdigest()}  {name}")
    return "\n".join(lines) + "\n"


def written_files(case, place):
    """Every file that the program made or changed, by its name."""
    found = {}
    for path in sorted(place.rglob("*")):
        name = path.relative_to(place).as_posix()
        if path.is_file() and path.read_bytes() != case.inputs.get(name):
            found["files/" + name] = path.read_bytes()
    return found


def answer(case, executable):
    """All that the program says to one case: name of the file that keeps it -> bytes."""
    with tempfile.TemporaryDirectory() as room:
        place, home = pathlib.Path(room, "here"), pathlib.Path(room, "home")
        place.mkdir()
        home.mkdir()
        lay_out(case, place)
        environment = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "TZ": "UTC", "HOME": str(home), "TMPDIR": str(home),
                       "SOURCE_DATE_EPOCH": "0"}
        try:
            done = subprocess.run([executable, *case.arguments], cwd=place, env=environment, stdin=subprocess.DEVNULL,
                                  capture_output=True, timeout=PATIENCE, check=False)
        except subprocess.TimeoutExpired:
            raise Trouble(f"{case.name}: no answer within {PATIENCE} s") from None
        said = {"stdout": done.stdout, "stderr": done.stderr, "status": f"{done.returncode}\n".encode()}
        said |= written_files(case, place)
        left = [path.name for path in home.iterdir()]
    if left:
        raise Trouble(f"{case.name}: temporary files are left: {', '.join(left)}")
    said = {name: cases.without_chance(case, content) for name, content in said.items()}
    for name, content in said.items():
        if room.encode() in content or str(inputs.ROOT).encode() in content:
            raise Trouble(f"{case.name}, {name}: a path of this machine")
    return {"command": command_text(case).encode(), **said}


def keep(folder, said):
    for name, content in said.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def chosen_cases(options):
    every = cases.all_cases([pathlib.Path(folder) for folder in options.experiments])
    names = [case.name for case in every]
    if len(set(names)) != len(names):
        raise Trouble("two cases of one name: " + ", ".join(sorted({n for n in names if names.count(n) > 1})))
    if not options.only:
        return every
    return [case for case in every if any(fnmatch.fnmatch(case.name, pattern) for pattern in options.only)]


def write(options):
    executable, folder = pathlib.Path(options.executable).resolve(), pathlib.Path(options.folder)
    if not os.access(executable, os.X_OK) or executable.is_dir():
        raise Trouble(f"{options.executable}: no program")
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise Trouble(f"{folder}: there is something already; expected a new or an empty folder")
    todo, troubles = chosen_cases(options), []
    folder.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        running = {pool.submit(answer, case, str(executable)): case for case in todo}
        for number, future in enumerate(concurrent.futures.as_completed(running), 1):
            try:
                keep(folder / running[future].name, future.result())
            except Trouble as trouble:
                troubles.append(str(trouble))
            if sys.stderr.isatty():
                print(f"\r{number}/{len(todo)}", end="", file=sys.stderr)
    for trouble in sorted(troubles):
        print(f"answers.py: {trouble}", file=sys.stderr)
    print(f"{len(todo) - len(troubles)} cases written, {len(troubles)} could not be")
    return 2 if troubles else 0


def kept(folder):
    """Case -> file -> bytes, of a folder that `write` made."""
    root = pathlib.Path(folder)
    if not root.is_dir():
        raise Trouble(f"{folder}: no such folder")
    all_kept = {}
    for command in root.rglob("command"):
        case = command.parent
        if (case / "status").exists():
            files = {path.relative_to(case).as_posix(): path.read_bytes() for path in case.rglob("*") if path.is_file()}
            all_kept[case.relative_to(root).as_posix()] = files
    if not all_kept:
        raise Trouble(f"{folder}: no answers")
    return all_kept


def compare(options):
    one, other = kept(options.folder), kept(options.other)
    alike, different = 0, []
    for name in sorted(one.keys() | other.keys()):
        if name not in one or name not in other:
            different.append((name, f"only in {options.folder if name in one else options.other}"))
            continue
        found = comparison.first_difference(one[name], other[name], options.tolerance)
        alike += one[name] == other[name]
        if found:
            different.append((name, found))
    for name, found in different[: options.show]:
        print(f"{name}: {found}")
    if len(different) > options.show:
        print(f"... and {len(different) - options.show} more")
    within = len(one.keys() | other.keys()) - alike - len(different)
    text = f"{alike} cases identical to the last byte"
    text += f", {within} within {options.tolerance:g}" if options.tolerance else ""
    print(f"{text}, {len(different)} different")
    return 1 if different else 0


def tolerance(text):
    value = float(text)
    if not 0 <= value < 1:
        raise argparse.ArgumentTypeError("a number from 0 to 1")
    return value


def read_options(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    verbs = parser.add_subparsers(dest="verb", required=True)
    writer = verbs.add_parser("write", help="write what a program answers")
    writer.add_argument("executable")
    writer.add_argument("folder", help="new or empty")
    writer.add_argument("--jobs", type=int, default=os.cpu_count(), help="cases at once")
    lister = verbs.add_parser("list", help="the cases, a line each")
    for verb in (writer, lister):
        verb.add_argument("--experiments", action="append", default=[], metavar="DIR", help="diagnose these as well")
        verb.add_argument("--only", action="append", default=[], metavar="PATTERN", help="these cases alone, such as 'critical/*'")
    comparer = verbs.add_parser("compare", help="compare two folders of answers")
    comparer.add_argument("folder")
    comparer.add_argument("other")
    comparer.add_argument("--tolerance", type=tolerance, default=0.0, help="of numbers; 0: the same bytes")
    comparer.add_argument("--show", type=int, default=40, help="how many differences")
    return parser.parse_args(arguments)


def main(arguments):
    options = read_options(arguments)
    try:
        if options.verb == "list":
            for case in chosen_cases(options):
                print(f"{case.name}: plumbline {' '.join(case.arguments)}")
            return 0
        return write(options) if options.verb == "write" else compare(options)
    except (Trouble, OSError) as trouble:
        print(f"answers.py: {trouble}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
