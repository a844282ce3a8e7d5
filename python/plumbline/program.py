"""The program `plumbline`, which stands in the package, and the verbs that have no arrays of their own."""
from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from plumbline._engine import Error
from plumbline.models import Model, ModelFile, PathLike

if TYPE_CHECKING:
    import pandas


def executable() -> str:
    """Where the program is: in the package, where PLUMBLINE says, or on the path."""
    own = pathlib.Path(__file__).parent / "bin" / "plumbline"
    found = str(own) if own.is_file() else os.environ.get("PLUMBLINE") or shutil.which("plumbline")
    if not found:
        raise Error("plumbline: found no program, expected it in the package, on the path, or named by PLUMBLINE")
    return found


def main() -> None:
    """What the command `plumbline` of the package does."""
    program = executable()
    os.execv(program, [program, *sys.argv[1:]])


def run(*words: str | PathLike, allowed: Sequence[int] = (0, 1)) -> str:
    """What the program writes to standard output for these words.

    :param allowed: exit statuses that are answers; 1 is that of a check that failed
    :raises Error: with the program's one line
    """
    done = subprocess.run([executable(), *map(os.fspath, words)], capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL)
    if done.returncode not in allowed:
        lines = done.stderr.strip().splitlines() or [f"plumbline: ended with status {done.returncode}"]
        raise Error(lines[-1].removeprefix("plumbline: "))
    return done.stdout


def verify(paper: PathLike | None = None, *, section: str | None = None, claim: str | None = None, precision: int | None = None) -> pandas.DataFrame:
    """Every claim of the paper, judged: a row each, as `plumbline verify --json` has it.

    :param paper: another paper, by the folder that states its claims (verify/papers/README.md)
    """
    import pandas
    words = ["verify", *([] if paper is None else [os.fspath(paper)]), "--json"]
    for option, value in (("--section", section), ("--claim", claim), ("--precision", precision)):
        if value is not None:
            words += [option, str(value)]
    return pandas.DataFrame(json.loads(run(*words))["claims"]).set_index("id")


def check(values: pandas.DataFrame, chains: pandas.DataFrame | None = None) -> dict[str, Any]:
    """How many digits of your critical forces agree with the reference, as `plumbline check --json` says it.

    :param values: the columns chain, mode, force
    :param chains: the columns chain, lengths, stiffness, of which the latter two hold lists; without it those of the
        reference set
    """
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        values[["chain", "mode", "force"]].to_csv(place / "values.csv", index=False, float_format="%.17g")
        words: list[str | PathLike] = ["check", place / "values.csv", "--json"]
        if chains is not None:
            table = chains[["chain", "lengths", "stiffness"]].copy()
            for column in ("lengths", "stiffness"):
                table[column] = [";".join(repr(float(one)) for one in row) for row in table[column]]
            table.to_csv(place / "chains.csv", index=False)
            words += ["--chains", place / "chains.csv"]
        found: dict[str, Any] = json.loads(run(*words))
        return found


def check_experiment(folder: PathLike, *, model: Model | None = None) -> str:
    """What is read from an experiment, in which units, and what looks odd; nothing is fitted."""
    file = ModelFile(model)
    return run("check-experiment", folder, *_given(model=file.path))


def plan_folder(folder: PathLike, *, model: Model | None = None, effects: PathLike | None = None) -> dict[str, Any]:
    """What `plan` says, of the bench in a folder's experiment.toml."""
    file = ModelFile(model)
    found: dict[str, Any] = json.loads(run("diagnose", folder, "--plan", "--json", *_given(model=file.path, effects=effects)))
    return found


def diagnose_folders(folders: Iterable[PathLike], *, model: Model | None = None, effects: PathLike | None = None,
                     reports: PathLike | None = None) -> dict[str, Any]:
    """Diagnoses many experiments at once: whether the cause is the same, how its parameters scatter, whether they drift,
    as `plumbline diagnose FOLDER FOLDER … --json` says it (docs/many-experiments.md). One that is refused is named with
    its reason and stops no other.

    :param folders: two or more
    :param reports: a folder in which the report and the page of each are kept, and interrupted work continues
    """
    places = list(folders)
    if len(places) < 2:
        raise Error(f"diagnose_folders: found {len(places)} folders, expected two or more: diagnose_folder takes one")
    file = ModelFile(model)
    found: dict[str, Any] = json.loads(run("diagnose", *places, "--json", "-",
                                           *_given(model=file.path, effects=effects, reports=reports)))
    return found


def diagnose_logs(folder: PathLike, *, corrected: PathLike | None = None, html: PathLike | None = None) -> dict[str, Any]:
    """Diagnoses logs of a joint in motion, or of an arm whose torques were read (docs/motion.md), as `plumbline diagnose FOLDER
    --json` says it: docs/schemas/motion-report.schema.json or torque-report.schema.json.

    :param corrected: a file for the corrected model: MJCF, URDF, SDF, or the JSON of BAM
    :param html: a file for the page with plots
    :raises Error: with the file, the line or key, what was found and what was expected
    """
    found: dict[str, Any] = json.loads(run("diagnose", folder, "--json", "-", *_given(corrected=corrected, html=html)))
    return found


def _given(**options: PathLike | None) -> list[str | PathLike]:
    """The options that are given, as words."""
    return [word for name, value in options.items() if value for word in (f"--{name}", value)]


def figure(number: int) -> str:
    """A figure of the paper redrawn from computation, as SVG. Needs gnuplot."""
    with tempfile.TemporaryDirectory() as folder:
        run("figure", str(number), "--out", folder)
        return next(pathlib.Path(folder).glob("*.svg")).read_text(encoding="utf-8")


def reference(folder: PathLike, *, compact: bool = True) -> pathlib.Path:
    """Writes the reference values for other implementations, certified."""
    run("reference", "--out", folder, *(["--compact"] if compact else []))
    return pathlib.Path(folder)


def trial(folder: PathLike) -> dict[str, Any]:
    """Diagnoses and scores the experiments in a folder, as `plumbline trial --experiments` does."""
    found: dict[str, Any] = json.loads(run("trial", "--experiments", folder, "--json"))
    return found
