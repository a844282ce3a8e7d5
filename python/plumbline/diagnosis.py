"""Where the gap between an experiment and its model lies, what causes it, how far it shrinks."""
from __future__ import annotations

import html
import json
import os
import pathlib
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from plumbline import _engine
from plumbline._engine import Error
from plumbline.arms import Arm
from plumbline.models import Model, ModelFile, NominalChain, PathLike
from plumbline.numbers import Floats, doubles
from plumbline.progress import Progress, shown

if TYPE_CHECKING:
    import matplotlib.axes
    import matplotlib.figure


@dataclass(frozen=True, repr=False)
class Curve:
    """One measured channel of one run beside what the models say."""

    run: str
    channel: str  #: "Fx", or "q3"; of an arm in space "z1" and "rz1" of its first point, or "torque3"
    unit: str
    command: str  #: what `along` is: "end point moved along −x, m"; of an arm in space, whose poses are no path, "reading"
    along: Floats  #: of the command, by reading; or the numbers of the readings as they were taken, from 0
    measured: Floats
    nominal: Floats
    corrected: Floats
    model: str  #: what `corrected` is: "corrected model", "best partial explanation", …

    def __repr__(self) -> str:
        return f"<plumbline.Curve {self.channel} ({self.unit}) of run {self.run!r}: {len(self.measured)} readings>"


@dataclass(frozen=True)
class CorrectedModel:
    """The nominal model with what one explanation found in it."""

    cause: str  #: "backlash-2": of several the one that this is; empty where it is the only one
    text: str  #: of the file
    effects: list[tuple[str, bool, str]]  #: each effect, whether the format carries it, and as what, or why not
    note: str  #: what the file is, where there is a choice

    def write(self, file: PathLike) -> pathlib.Path:
        """Writes it. A model of a simulator names meshes that stand beside the original: there it belongs."""
        path = pathlib.Path(file)
        path.write_text(self.text, encoding="utf-8")
        return path


class Diagnosis:
    """A diagnosis, as a report for people (`print`), for machines (`report`, `to_json`) and as a page."""

    def __init__(self, found: _engine.Diagnosed, model: ModelFile) -> None:
        self._found = found
        self._model = model  #: is edited where a corrected model is asked for
        self._json = found.json()

    def to_json(self) -> str:
        """The report as `plumbline diagnose --json` writes it: docs/schemas/gap-diagnosis.schema.json."""
        return self._json

    @property
    def report(self) -> dict[str, Any]:
        """The same as a dictionary."""
        report: dict[str, Any] = json.loads(self._json)
        return report

    @property
    def verdict(self) -> str:
        """"none", "identified", "ambiguous" or "unknown"."""
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

    def corrected_models(self, format: str = "toml") -> list[CorrectedModel]:
        """The nominal model with what was found: one where the cause is identified, one a candidate where it is ambiguous.

        :param format: "toml" (ours), "xml" (MJCF), "urdf" or "sdf". A model that was read from a file of that format is
            edited: what the cause does not ask for stays as it is. Of an arm in space "toml", or that of its file
        """
        return [CorrectedModel(*one) for one in self._found.corrected("." + format.lstrip("."))]

    def plot(self, *, run: str | None = None, channel: str | None = None,
             axes: Sequence[matplotlib.axes.Axes] | None = None) -> matplotlib.figure.Figure:
        """Measured, nominal and corrected, a row of panels for each run; the title says what was found. Of an arm in
        space, whose gap is small beside the way between its poses: measured less nominal, and less corrected.

        :param run: this one alone
        :param channel: this one alone, such as "Fx"
        :param axes: panels of your own, for the curves in their order; without them a figure is made
        """
        import matplotlib.pyplot
        curves = [curve for curve in self.curves() if run in (None, curve.run) and channel in (None, curve.channel)]
        if not curves:
            raise Error(f"plot: found no channel {channel} of run {run}, expected one of "
                        + ", ".join(f"{curve.run}: {curve.channel}" for curve in self.curves()))
        if axes is None:
            rows = list(dict.fromkeys(curve.run for curve in curves))
            curves.sort(key=lambda curve: rows.index(curve.run))
            columns = max(sum(curve.run == row for curve in curves) for row in rows)
            figure, panels = matplotlib.pyplot.subplots(len(rows), columns, squeeze=False, layout="constrained",
                                                        figsize=(4.5 * columns, 3 * len(rows) + 0.4))
            figure.suptitle(self._title())
            axes = [panel for row, of_row in zip(rows, panels)
                    for panel in of_row[:sum(curve.run == row for curve in curves)]]
            for panel in panels.flat:
                panel.set_visible(any(panel is one for one in axes))
        elif len(axes) != len(curves):
            raise Error(f"plot: found {len(axes)} axes, expected {len(curves)}, one for each curve")
        draw = _draw_residuals if "joint_names" in self.report else _draw_curve
        for curve, panel in zip(curves, axes):
            draw(curve, panel)
            panel.set_title(f"{curve.run}: {curve.channel}", fontsize="medium")
            panel.set_xlabel(curve.command)
        axes[0].legend(fontsize="small")
        whole = axes[0].get_figure()
        assert whole is not None
        return whole

    def _title(self) -> str:
        report = self.report
        names = " + ".join(effect["id"] + (f"({effect['joint']})" if effect["joint"] else "")
                           for effect in report["cause"]["effects"])
        verdict = "no gap" if self.verdict == "none" else self.verdict
        return f"{report['experiment']}: {verdict}" + (f", {names}" if names else "")


def _draw_curve(curve: Curve, panel: matplotlib.axes.Axes) -> None:
    panel.plot(curve.along, curve.nominal, color="0.65", linewidth=3, solid_capstyle="round", label="nominal model")
    if curve.model != "nominal model":
        panel.plot(curve.along, curve.corrected, color="C0", label=curve.model)
    panel.plot(curve.along, curve.measured, ".", color="black", markersize=3.5, label="measured")
    panel.set_ylabel(f"{curve.channel}, {curve.unit}")


def _draw_residuals(curve: Curve, panel: matplotlib.axes.Axes) -> None:
    panel.axhline(0, color="0.85", linewidth=1)
    panel.plot(curve.along, curve.measured - curve.nominal, "o", color="0.65", markersize=4, label="nominal model")
    if curve.model != "nominal model":
        panel.plot(curve.along, curve.measured - curve.corrected, ".", color="C0", label=curve.model)
    panel.set_ylabel(f"{curve.channel}, measured less model, {curve.unit}")


def diagnose(nominal: Mapping[str, Any] | NominalChain | Model, runs: Sequence[Mapping[str, Any]], *,
             noise: Mapping[str, float], bench: Mapping[str, Any] | None = None,
             loads: Sequence[Mapping[str, Any]] = (), units: Mapping[str, str] | None = None,
             columns: Mapping[str, Any] | None = None, name: str = "experiment", effects: PathLike | None = None,
             next: bool = False, as_is: bool = False, progress: Progress = True) -> Diagnosis:
    """Diagnoses an experiment that is in memory. Keys, units and rules are those of docs/experiment-format.md.

    :param nominal: the nominal chain: `link_length`, `joint_stiffness`, and where it has them `link_mass`, `gravity`,
        `rest`, `effect`; or what `read_chain` gave; or the model of a simulator (a file: MJCF, URDF, SDF, or a
        `mujoco.MjSpec`), or a file of ours
    :param runs: each with `id`, `control` ("displacement" or "force"), `rest` (the unloaded joint angles) and `samples`:
        a mapping of columns to arrays, or a DataFrame, with `x, y, Fx, Fy`, where taken `t` and `q1` … `qn`; NaN where
        nothing was measured. Compression has a negative Fx
    :param noise: standard deviation of a reading, by channel: `x`, `y`, `Fx`, `Fy`, `q`
    :param bench: `gravity_plane` ("vertical", "horizontal", "unknown") and `gravity_direction`
    :param loads: tendons, pressures and forces along the chain, each with the keys of a table [[load]]; the columns of
        their values stand in every run's `samples`
    :param units: of the numbers in `nominal`, `rest` and `loads`, where they are not SI
    :param columns: units, signs and zeros of the columns, and their names where they have others
    :param effects: a file with effects of your own
    :param next: propose the next run even where the cause is clear
    :param as_is: take the numbers as they stand, even where they look like another unit, sign or axis
    :param progress: called now and then with the share of the work that is done; True shows a bar in a notebook or on a
        terminal
    :raises Error: for what the format refuses, with the key or the run and reading
    """
    settings = _settings(nominal, runs, noise, bench, loads, units, columns, name)
    samples = _samples(settings["run"])
    model = ModelFile(None if "nominal" in settings else nominal)
    return Diagnosis(_engine.diagnose(_plain(settings), samples, model=model.path, effects=_file(effects), next=next,
                                      as_is=as_is, progress=shown(progress)), model)


def diagnose_arm(arm: Mapping[str, Any] | Arm | Model, runs: Sequence[Mapping[str, Any]], *, noise: Mapping[str, float],
                 points: Sequence[Mapping[str, Any]] = (), load: Mapping[str, Any] | None = None,
                 units: Mapping[str, str] | None = None, columns: Mapping[str, Any] | None = None, name: str = "experiment",
                 effects: PathLike | None = None, next: bool = False, as_is: bool = False,
                 progress: Progress = True) -> Diagnosis:
    """Diagnoses an arm in space by poses at rest that are in memory. Keys, units and rules are those of docs/arms.md.

    :param arm: the nominal arm: the model of a simulator (a file: URDF, MJCF, SDF, or a `mujoco.MjSpec`); or the keys of
        the table [arm], of which `model` is such a model; or what `read_arm` gave, joint by joint
    :param runs: each with `id`, `loaded_by` ("servo" where a sensor read the loads) and `samples`: a mapping of columns to
        arrays, or a DataFrame, with `q_command1` …, for a point `ball` `ball_x` … and `ball_rx` … or `ball_qw` …, where
        taken `t`, `q1` …, `weight` or `Fx` … `Mz`, `torque1` …, `temperature`; NaN where nothing was measured
    :param noise: standard deviation of a reading: `place`, `turn`, `q`, `torque`
    :param points: what the tracker sees, each with `name`, and where it has them `body`, `offset` and `rpy`; without any the
        point `tip`
    :param load: where weights hang or forces act: `body`, `offset`; without it the tip
    :param units: what all columns of a kind share where they are not SI, and `noise` with them: `place`, `angle`, `force`,
        `torque`, `mass`
    :param columns: `ignore`: the names of those that are left out, whatever they hold
    :param effects: a file with effects of your own
    :param next: propose the next poses even where the cause is clear
    :param as_is: take the numbers as they stand, even where they look like another unit, axis or numbering
    :param progress: as for `diagnose`
    :raises Error: for what the format refuses, with the key or the run and reading
    """
    settings = _settings(None, runs, noise, None, (), units, columns, name)
    settings["arm"] = _arm(arm, points, load)
    model = ModelFile(settings["arm"].get("model"))
    if "model" in settings["arm"]:
        settings["arm"]["model"] = model.path
    samples = _samples(settings["run"], columns.get("ignore") if isinstance(columns, Mapping) else None)
    return Diagnosis(_engine.diagnose(_plain(settings), samples, model="", effects=_file(effects), next=next, as_is=as_is,
                                      progress=shown(progress)), model)


def plan(nominal: Mapping[str, Any] | NominalChain | Model, runs: Sequence[Mapping[str, Any]], *,
         noise: Mapping[str, float], bench: Mapping[str, Any] | None = None, loads: Sequence[Mapping[str, Any]] = (),
         units: Mapping[str, str] | None = None, columns: Mapping[str, Any] | None = None, name: str = "bench",
         effects: PathLike | None = None, progress: Progress = True) -> dict[str, Any]:
    """Before any data: which effects a bench cannot detect, which it cannot distinguish, and the fewest runs that
    distinguish the rest, as `plumbline diagnose --plan --json` says it (docs/plan.md).

    :param runs: as for `diagnose`. One without `samples` says in which way the bench can work, by its control and rest
        shape; of samples the commands count, and no measured value is needed
    :raises Error: as `diagnose`
    """
    settings = _settings(nominal, runs, noise, bench, loads, units, columns, name)
    samples = []
    for number, run in enumerate(settings["run"], 1):
        if "samples" in run:
            samples.append(_columns(run["samples"], f"experiment: run[{number}].samples"))
            run["samples"] = "in memory"
    model = ModelFile(None if "nominal" in settings else nominal)
    found: dict[str, Any] = json.loads(_engine.plan(_plain(settings), samples, model=model.path, effects=_file(effects),
                                                    progress=shown(progress)))
    return found


def diagnose_folder(folder: PathLike, *, model: Model | None = None, effects: PathLike | None = None,
                    next: bool = False, as_is: bool = False, progress: Progress = True) -> Diagnosis:
    """Diagnoses an experiment that is in a folder, as `plumbline diagnose FOLDER` does.

    :param model: stands in for the table [nominal]
    :raises Error: with the file, the line or key, what was found and what was expected
    """
    file = ModelFile(model)
    return Diagnosis(_engine.diagnose_folder(os.fspath(folder), model=file.path, effects=_file(effects), next=next,
                                             as_is=as_is, progress=shown(progress)), file)


def _settings(nominal: Mapping[str, Any] | NominalChain | Model, runs: Sequence[Mapping[str, Any]],
                noise: Mapping[str, float], bench: Mapping[str, Any] | None, loads: Sequence[Mapping[str, Any]],
                units: Mapping[str, str] | None, columns: Mapping[str, Any] | None, name: str) -> dict[str, Any]:
    """The keys of experiment.toml; `nominal` is not among them where it is a file."""
    settings: dict[str, Any] = {"format": "chain-experiment/1", "name": name, "noise": noise,
                                "columns": columns if columns is not None else {}}
    for key, value in (("bench", bench), ("units", units)):
        if value is not None:
            settings[key] = value
    if loads:
        settings["load"] = list(loads)
    if isinstance(nominal, NominalChain):
        nominal = nominal.settings()
    if isinstance(nominal, Mapping):
        settings["nominal"] = nominal
    for number, run in enumerate(runs, 1):
        if not isinstance(run, Mapping):
            raise Error(f"experiment: run[{number}]: found {type(run).__name__}, expected keys and values")
    settings["run"] = [dict(run) for run in runs]
    return settings


def _arm(arm: Mapping[str, Any] | Arm | Model, points: Sequence[Mapping[str, Any]],
         load: Mapping[str, Any] | None) -> dict[str, Any]:
    """The table [arm]."""
    if isinstance(arm, Arm):
        arm = arm.settings()
    table = dict(arm) if isinstance(arm, Mapping) else {"model": arm}
    for key, parameter, value in (("point", "points", list(points)), ("load", "load", load)):
        if value and key in table:
            raise Error(f"{parameter}: found beside the key {key!r} of the arm, expected one of the two")
        if value:
            table[key] = value
    return table


def _file(path: PathLike | None) -> str:
    return "" if path is None else os.fspath(path)


def _samples(runs: Sequence[dict[str, Any]], ignored: Any = None) -> list[list[tuple[str, Floats]]]:
    """What the runs hold, which keep their other keys.

    :param ignored: the name or names of columns to leave out
    """
    names = {ignored} if isinstance(ignored, str) else set(ignored) if isinstance(ignored, Iterable) else set()
    samples = []
    for number, run in enumerate(runs, 1):
        place = f"experiment: run[{number}].samples"
        if "samples" not in run:
            raise Error(f"{place}: found no such key, expected columns of readings")
        samples.append(_columns(run.pop("samples"), place, names))
    return samples


def _columns(samples: Any, place: str, ignored: Collection[str] = ()) -> list[tuple[str, Floats]]:
    """Columns of one length, as doubles."""
    if not hasattr(samples, "keys"):
        raise Error(f"{place}: found {type(samples).__name__}, expected columns by name: a mapping or a DataFrame")
    columns = [(str(name), doubles(np.asarray(samples[name]), f"{place}.{name}")) for name in samples.keys()
               if name not in ignored]
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
