"""Where the gap between an experiment and its model lies, what causes it, how far it shrinks."""
from __future__ import annotations

import html
import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from plumbline import _engine
from plumbline._engine import Error
from plumbline.numbers import Floats, doubles

if TYPE_CHECKING:
    import matplotlib.figure

PathLike = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Curve:
    """One measured channel of one run beside what the models say."""

    run: str
    channel: str  #: "Fx", or "q3"
    unit: str
    command: str  #: what `along` is: "end point moved along −x, m"
    along: Floats  #: of the command, by reading
    measured: Floats
    nominal: Floats
    corrected: Floats
    model: str  #: what `corrected` is: "corrected model", "best partial explanation", …


class Diagnosis:
    """A diagnosis, as a report for people (`print`), for machines (`report`, `to_json`) and as a page."""

    def __init__(self, found: _engine.Diagnosed) -> None:
        self._found = found
        self._json = found.json()

    def to_json(self) -> str:
        """The report as `plumbline diagnose --json` writes it: docs/report-format.md."""
        return self._json

    @property
    def report(self) -> dict[str, Any]:
        """The same as a dictionary."""
        report: dict[str, Any] = json.loads(self._json)
        return report

    @property
    def verdict(self) -> str:
        """"no_gap", "identified", "ambiguous" or "unknown"."""
        return str(self.report["cause"]["verdict"])

    def __str__(self) -> str:
        return self._found.text()

    def __repr__(self) -> str:
        report = self.report
        return f"<plumbline.Diagnosis of {report['experiment']!r}: {report['cause']['verdict']}>"

    def to_html(self) -> str:
        """The page that `plumbline diagnose --html` writes, whole in one file."""
        return self._found.html()

    def _repr_html_(self) -> str:
        page = html.escape(self.to_html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 40em; border: 1px solid #999"></iframe>'

    def curves(self) -> list[Curve]:
        """Every measured channel of every run beside what the nominal and the corrected model say."""
        return [Curve(**one) for one in self._found.curves()]

    def plot(self) -> matplotlib.figure.Figure:
        """Measured, nominal and corrected, a panel for each channel of each run."""
        import matplotlib.pyplot
        curves = self.curves()
        runs = list(dict.fromkeys(curve.run for curve in curves))
        rows = [[curve for curve in curves if curve.run == run] for run in runs]
        columns = max(len(row) for row in rows)
        figure, panels = matplotlib.pyplot.subplots(len(rows), columns, squeeze=False, layout="constrained",
                                                    figsize=(4.5 * columns, 3 * len(rows)))
        for row, axes_of_row in zip(rows, panels):
            for axes in axes_of_row[len(row):]:
                axes.set_visible(False)
            for curve, axes in zip(row, axes_of_row):
                axes.plot(curve.along, curve.measured, ".", color="0.3", label="measured")
                axes.plot(curve.along, curve.nominal, "--", label="nominal model")
                if curve.model != "nominal model":
                    axes.plot(curve.along, curve.corrected, label=curve.model)
                axes.set_title(f"{curve.run}: {curve.channel}", fontsize="medium")
                axes.set_xlabel(curve.command)
                axes.set_ylabel(f"{curve.channel}, {curve.unit}")
        panels[0][0].legend(fontsize="small")
        return figure


def diagnose(nominal: Mapping[str, Any] | PathLike, runs: Sequence[Mapping[str, Any]], *,
             noise: Mapping[str, float], bench: Mapping[str, Any] | None = None,
             units: Mapping[str, str] | None = None, columns: Mapping[str, Any] | None = None,
             name: str = "experiment", effects: PathLike | None = None, next: bool = False, as_is: bool = False,
             progress: Callable[[float], object] | None = None) -> Diagnosis:
    """Diagnoses an experiment that is in memory. Keys, units and rules are those of docs/experiment-format.md.

    :param nominal: the nominal chain: `link_length`, `joint_stiffness`, and where it has them `link_mass`, `gravity`,
        `rest`, `effect`; or a file with the model of a simulator (MJCF, URDF, SDF) or of ours
    :param runs: each with `id`, `control` ("displacement" or "force"), `rest` (the unloaded joint angles) and `samples`:
        a mapping of columns to arrays, or a DataFrame, with `x, y, Fx, Fy`, where taken `t` and `q1` … `qn`; NaN where
        nothing was measured. Compression has a negative Fx
    :param noise: standard deviation of a reading, by channel: `x`, `y`, `Fx`, `Fy`, `q`
    :param bench: `gravity_plane` ("vertical", "horizontal", "unknown") and `gravity_direction`
    :param units: of the numbers in `nominal` and `rest`, where they are not SI
    :param columns: units, signs and zeros of the columns, and their names where they have others
    :param effects: a file with effects of your own
    :param next: propose the next run even where the cause is clear
    :param as_is: take the numbers as they stand, even where they look like another unit, sign or axis
    :param progress: called now and then with the share of the work that is done
    :raises Error: for what the format refuses, with the key or the run and reading
    """
    settings: dict[str, Any] = {"format": "chain-experiment/1", "name": name, "noise": noise,
                                "columns": columns if columns is not None else {}}
    for key, value in (("bench", bench), ("units", units)):
        if value is not None:
            settings[key] = value
    model = ""
    if isinstance(nominal, Mapping):
        settings["nominal"] = nominal
    else:
        model = os.fspath(nominal)
    settings["run"] = []
    samples = []
    for number, run in enumerate(runs, 1):
        if not isinstance(run, Mapping) or "samples" not in run:
            raise Error(f"experiment: run[{number}].samples: found no such key, expected columns of readings")
        settings["run"].append({key: value for key, value in run.items() if key != "samples"})
        samples.append(_columns(run["samples"], f"experiment: run[{number}].samples"))
    return Diagnosis(_engine.diagnose(_plain(settings), samples, model=model, effects=_file(effects), next=next,
                                      as_is=as_is, progress=progress))


def diagnose_folder(folder: PathLike, *, model: PathLike | None = None, effects: PathLike | None = None,
                    next: bool = False, as_is: bool = False,
                    progress: Callable[[float], object] | None = None) -> Diagnosis:
    """Diagnoses an experiment that is in a folder, as `plumbline diagnose FOLDER` does.

    :param model: stands in for the table [nominal]
    :raises Error: with the file, the line or key, what was found and what was expected
    """
    return Diagnosis(_engine.diagnose_folder(os.fspath(folder), model=_file(model), effects=_file(effects), next=next,
                                             as_is=as_is, progress=progress))


def _file(path: PathLike | None) -> str:
    return "" if path is None else os.fspath(path)


def _columns(samples: Any, place: str) -> list[tuple[str, Floats]]:
    """Columns of one length, as doubles."""
    if not hasattr(samples, "keys"):
        raise Error(f"{place}: found {type(samples).__name__}, expected columns by name: a mapping or a DataFrame")
    columns = [(str(name), doubles(np.asarray(samples[name]), f"{place}.{name}")) for name in samples.keys()]
    for name, values in columns:
        if len(values) != len(columns[0][1]):
            raise Error(f"{place}.{name}: found {len(values)} readings, expected {len(columns[0][1])} as in "
                        f"{columns[0][0]}")
        if len(values) == 0:
            raise Error(f"{place}: found no reading, expected at least one")
    return columns


def _plain(value: Any) -> Any:
    """The value in dictionaries, lists, numbers and text alone; what is None is left out."""
    if isinstance(value, Mapping):
        return {str(key): _plain(entry) for key, entry in value.items() if entry is not None}
    if isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, Iterable):
        return [_plain(entry) for entry in value]
    return str(value)
