"""Chains out of simulators' models, and experiments drafted out of them and tables of readings."""
from __future__ import annotations

import json
import os
import pathlib
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Union

import numpy as np

from plumbline import _engine
from plumbline._engine import Error
from plumbline.numbers import Floats
from plumbline.spreadsheets import is_workbook, sheet_as_csv

PathLike = Union[str, "os.PathLike[str]"]
#: A file (MJCF, URDF, SDF or our TOML), or a specification of MuJoCo's own (`mujoco.MjSpec`).
Model = Union[PathLike, Any]


@dataclass(frozen=True)
class NominalChain:
    """The planar elastic chain of a model, in SI and radians: what `diagnose` takes as `nominal`."""

    link_length: Floats
    joint_stiffness: Floats
    link_mass: Floats
    gravity: Floats
    rest: Floats
    joints: list[str]  #: their names in the model, from the base on
    notes: list[str]  #: what was assumed and what was left out

    def settings(self) -> dict[str, list[float]]:
        """As the table [nominal] of an experiment has it."""
        return {key: getattr(self, key).tolist()
                for key in ("link_length", "joint_stiffness", "link_mass", "gravity", "rest") if len(getattr(self, key))}


class ModelFile:
    """A model as a file, which is there as long as this is."""

    def __init__(self, model: Model | Mapping[str, Any] | None) -> None:
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        if isinstance(model, Mapping):
            self._folder = tempfile.TemporaryDirectory()
            nominal = pathlib.Path(self._folder.name, "model.toml")
            lines = [f"{key} = {_toml(value)}" for key, value in model.items()]
            nominal.write_text("\n".join(["[nominal]", *lines, ""]), encoding="utf-8")
            self.path = str(nominal)
            return
        if not hasattr(model, "to_xml"):
            if not isinstance(model, (str, os.PathLike, type(None))):
                raise Error(f"model: found {type(model).__name__}, expected a file (MJCF, URDF, SDF) or a mujoco.MjSpec")
            self.path = "" if model is None else os.fspath(model)
            return
        model.compile()
        self._folder = tempfile.TemporaryDirectory()
        file = pathlib.Path(self._folder.name, "model.xml")
        file.write_text(model.to_xml(), encoding="utf-8")
        self.path = str(file)


def _toml(value: Any) -> str:
    """A string, a number or a list of numbers."""
    return json.dumps(value) if isinstance(value, str) else repr(np.asarray(value, dtype=float).tolist())


def read_chain(model: Model, joints: Sequence[str] = ()) -> NominalChain:
    """The planar elastic chain of a simulator's model, as `plumbline chain` reads it. No simulator is needed; an MJCF
    whose elements stand for several bodies (<attach>, <replicate>, <composite>) is written out by the package `mujoco`
    first, where that is installed.

    :param joints: those that make the chain, where the model has more; the others are held as the model draws them
    :raises Error: where the model is no planar serial chain of hinges, with the part of it that is one
    """
    file = ModelFile(model)
    try:
        found = _engine.chain(file.path, list(joints))
    except Error as error:
        file = written_out(model, error)
        found = _engine.chain(file.path, list(joints))
    return NominalChain(**found)


def written_out(model: Model, error: Error) -> ModelFile:
    """An MJCF whose elements stand for several bodies, written out by the package `mujoco`, where that is installed.

    :param error: that the file gave; raised again where it is another one, or nothing can write the file out
    """
    if hasattr(model, "to_xml") or "which stands for several" not in str(error):
        raise error
    try:
        import mujoco
    except ImportError:
        raise error from None
    return ModelFile(mujoco.MjSpec.from_file(os.fspath(model)))


class Guess(NamedTuple):
    """What a table does not say, and was guessed."""

    what: str
    value: str
    reason: str
    doubtful: bool  #: whether a person should look at it


@dataclass(frozen=True)
class Draft:
    """An experiment drafted out of a model and tables."""

    settings: str  #: the text of experiment.toml
    tables: dict[str, str]  #: the sample files, by name
    guesses: list[Guess]
    question: str  #: what is still in doubt, in a line; or empty

    def write(self, folder: PathLike) -> pathlib.Path:
        """Writes the experiment's folder, which is new or empty; `diagnose_folder` takes it."""
        place = pathlib.Path(folder)
        place.mkdir(parents=True, exist_ok=True)
        if any(place.iterdir()):
            raise Error(f"{place}: found something there already, expected a new folder, or an empty one")
        for name, text in {"experiment.toml": self.settings, **self.tables}.items():
            (place / name).write_text(text, encoding="utf-8")
        return place


def draft(model: Model | Mapping[str, Any], tables: Mapping[str, Any] | Sequence[PathLike], *, name: str = "experiment",
          joints: Sequence[str] = (), sheet: str | None = None, columns: str = "", base: str = "", tip: str = "") -> Draft:
    """Guesses an experiment out of tables as labs have them, as `plumbline new` does: delimiter, header, columns, units,
    signs, runs; every guess comes with its reason.

    :param model: a file, or the table [nominal] as a mapping: of a chain, or of a joint alone
    :param columns: what columns hold, as `plumbline new --columns` has it: "x=Traverse:mm,ignore=humidity"
    :param base, tip: the bodies at the ends of an arm in space, where its model has several
    :param tables: files, workbooks (.xlsx) among them, or DataFrames by a name each
    :param sheet: of the workbooks, where they have several
    :raises Error: where a table cannot be read at all, or no column of it can be told
    """
    if isinstance(tables, Mapping):
        texts: list[tuple[str, str | bytes]] = [(title if "." in title else f"{title}.csv", table.to_csv(index=False)) for title, table in tables.items()]
    else:
        texts = [_named_text(pathlib.Path(table), sheet) for table in tables]
    file = ModelFile(model)
    found = _engine.draft(name, file.path, list(joints), texts, columns, base, tip)
    return Draft(found["settings"], found["tables"], [Guess(*guess) for guess in found["guesses"]], found["question"])


def _named_text(table: pathlib.Path, sheet: str | None) -> tuple[str, str | bytes]:
    if sheet is not None and is_workbook(table):
        return f"{table.stem}.csv", sheet_as_csv(table, sheet)
    return table.name, table.read_bytes()
