"""Recordings of a robot's joints as tables: bags of ROS 2, and datasets of LeRobot."""
from __future__ import annotations

import json
import math
import os
import pathlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

import numpy as np

from plumbline import sqlite_bags
from plumbline._engine import Error
from plumbline.numbers import Floats
from plumbline.sqlite_bags import JointState

if TYPE_CHECKING:
    import pandas

#: The endings by which LeRobot's features name a quantity; a name without one is a position.
_ENDINGS = {"pos": "position", "vel": "velocity", "torque": "torque", "effort": "torque"}


@dataclass(frozen=True)
class _Run:
    """Readings by quantity ("position", "velocity", "torque", "command") and joint, NaN where a message lacks one."""

    time: Floats | None  #: s, never falling; None where the recording has none
    readings: dict[str, dict[str, Floats]]


def read_recording(file: str | os.PathLike[str], *, topic: str = "/joint_states",
                   commands: str | None = None) -> dict[str, pandas.DataFrame]:
    """The joint states of a recording by the name of each run, as `draft` takes them: `t` in seconds from the first, `q NAME`
    for each joint, and `q NAME cmd` where commands are known.

    :param file: a bag of ROS 2, one run: a file (.mcap or .db3) or the folder of several; or the folder of a LeRobot dataset,
        a run an episode, whose actions are the commands. LeRobot's values are in the unit of its robot: degrees, as a rule;
        values that were normalised to -100 … 100 are no angles
    :param topic: of a bag: messages sensor_msgs/msg/JointState
    :param commands: of a bag: such messages too; each state has the last command before it
    :raises Error: where nothing of that kind is in the file, or a package that reads it is not installed
    """
    return {name: _frame(run.time, {f"q {joint}{ending}": values
                                    for quantity, ending in (("position", ""), ("command", " cmd"))
                                    for joint, values in run.readings[quantity].items()})
            for name, run in _runs(pathlib.Path(file), topic, commands).items()}


def read_logs(file: str | os.PathLike[str], joints: Sequence[str] | None = None, *, unit: str = "rad",
              topic: str = "/joint_states", commands: str | None = None) -> dict[str, pandas.DataFrame]:
    """The logs of joints in motion by the name of each run, in SI, as files of the formats motion/1 and torque/1 hold them
    (`to_csv(…, index=False)`): `t`, and of each joint `command NAME`, `position NAME`, `velocity NAME`, `torque NAME` as far as
    they were recorded. A reading that lacks one of its columns is left out, and so is one that was recorded twice.

    :param file: as of `read_recording`. A command that changes between two states counts from the later one on, so that
        delays are known to the time between states
    :param joints: these alone; default all
    :param unit: of the recording's angles, "rad" or "deg"
    :param topic: of a bag, as of `read_recording`
    :param commands: likewise
    :raises Error: as `read_recording`, and where a joint, a clock, or any whole reading is absent
    """
    if unit not in ("rad", "deg"):
        raise Error(f'unit: found {unit!r}, expected "rad" or "deg"')
    if isinstance(joints, str):
        joints = [joints]
    return {name: _log(run, f"{file}, {name}", joints, math.pi / 180 if unit == "deg" else 1.0)
            for name, run in _runs(pathlib.Path(file), topic, commands).items()}


def _log(run: _Run, place: str, joints: Sequence[str] | None, radians: float) -> pandas.DataFrame:
    if run.time is None:
        raise Error(f"{place}: found no timestamp, expected one of every reading, s")
    known = {joint: q for joint, q in run.readings["position"].items() if np.isfinite(q).any()}
    if not known:
        raise Error(f"{place}: found no position, expected that of a joint at least")
    for joint in joints or ():
        if joint not in known:
            raise Error(f"{place}: found no joint {joint!r}, expected one of {', '.join(known)}")
    readings = {f"{quantity} {joint}": of_joint[joint] * (1.0 if quantity == "torque" else radians)
                for joint in joints or known for quantity, of_joint in run.readings.items()
                if joint in of_joint and np.isfinite(of_joint[joint]).any()}
    whole = np.isfinite(np.array(list(readings.values()))).all(axis=0)
    log = _frame(run.time, readings)[whole].drop_duplicates(ignore_index=True)
    if log.empty:
        raise Error(f"{place}: found no reading of all of {', '.join(readings)}, expected some; name fewer joints")
    log["t"] -= log["t"][0]
    return log


def _runs(place: pathlib.Path, topic: str, commands: str | None) -> dict[str, _Run]:
    """Every run of a recording by its name."""
    if place.is_file():
        return {place.stem: _recorded([place], topic, commands)}
    if (place / "meta" / "info.json").is_file():
        return _episodes(place)
    if (place / "metadata.yaml").is_file():
        parts = sorted(place.glob("*.mcap")) or sorted(place.glob("*.db3"))
        if not parts:
            raise Error(f"{place}: found metadata.yaml alone, expected .mcap or .db3 beside it")
        return {place.name: _recorded(parts, topic, commands)}
    found = "no metadata.yaml and no meta/info.json" if place.is_dir() else "no such file"
    raise Error(f"{place}: found {found}, expected a bag of ROS 2 or the folder of a LeRobot dataset")


class _State(NamedTuple):
    """A message sensor_msgs/msg/JointState."""

    stamped: float  #: s; 0 where whoever sent it left the stamp out
    recorded: float  #: s
    readings: dict[str, dict[str, float]]  #: by quantity and joint


def _recorded(files: Sequence[pathlib.Path], topic: str, commands: str | None) -> _Run:
    """The run that the files of a bag hold together."""
    states = _joint_states(files, topic)
    sent = _joint_states(files, commands) if commands else []
    stamped = all(state.stamped > 0 for state in [*states, *sent])  # two clocks do not tell which came first

    def time_of(state: _State) -> float:
        return state.stamped if stamped else state.recorded

    states.sort(key=time_of)
    sent.sort(key=time_of)
    time = np.array([time_of(state) for state in states])
    readings = {quantity: _by_joint([state.readings[quantity] for state in states])
                for quantity in ("position", "velocity", "torque")}
    before = np.searchsorted([time_of(state) for state in sent], time, side="right") - 1
    readings["command"] = _by_joint([sent[at].readings["position"] if at >= 0 else {} for at in before])
    return _Run(time - time[0], readings)


def _by_joint(rows: Sequence[Mapping[str, float]]) -> dict[str, Floats]:
    joints = dict.fromkeys(joint for row in rows for joint in row)
    return {joint: np.array([row.get(joint, np.nan) for row in rows]) for joint in joints}


def _joint_states(files: Sequence[pathlib.Path], topic: str) -> list[_State]:
    states = [_State(message.stamp, recorded, {"position": dict(zip(message.name, message.position)),
                                               "velocity": dict(zip(message.name, message.velocity)),
                                               "torque": dict(zip(message.name, message.effort))})
              for file in files
              for recorded, message in (sqlite_bags.joint_states if file.suffix == ".db3" else _mcap_joint_states)(file, topic)]
    if not states:
        topics = sorted({one for file in files for one in (sqlite_bags.topics if file.suffix == ".db3" else _mcap_topics)(file)})
        raise Error(f"{files[0]}: found no message on {topic}, expected one of {', '.join(topics) or 'no topic'}")
    return states


def _mcap_joint_states(file: pathlib.Path, topic: str) -> Iterator[tuple[float, JointState]]:
    try:
        with open(file, "rb") as recording:
            for schema, _, message, state in _mcap_reader(file, recording).iter_decoded_messages(topics=[topic]):
                if schema.name not in sqlite_bags.JOINT_STATE:
                    raise Error(f"{file}: found {schema.name} on {topic}, expected {sqlite_bags.JOINT_STATE[0]}")
                stamp = state.header.stamp
                yield 1e-9 * message.log_time, JointState(stamp.sec + 1e-9 * stamp.nanosec, state.name, state.position,
                                                          state.velocity, state.effort)
    except Error:
        raise
    except Exception as error:  # the reader lets those of struct, zstandard and its own through
        raise Error(f"{file}: found {type(error).__name__} where it is read, expected an MCAP file of ROS 2") from None


def _mcap_reader(file: pathlib.Path, recording: BinaryIO) -> Any:
    try:
        from mcap.reader import make_reader
        from mcap_ros2.decoder import DecoderFactory
    except ImportError:
        raise Error(f"{file}: found no package mcap-ros2-support, expected it: pip install plumbline[recordings]") from None
    return make_reader(recording, decoder_factories=[DecoderFactory()])


def _mcap_topics(file: pathlib.Path) -> set[str]:
    with open(file, "rb") as recording:
        return {channel.topic for _, channel, _ in _mcap_reader(file, recording).iter_messages()}


def _episodes(folder: pathlib.Path) -> dict[str, _Run]:
    """The episodes of a LeRobot dataset, of which a Parquet file holds one (version 2) or many (version 3)."""
    settings = folder / "meta" / "info.json"
    try:
        import pyarrow.parquet
    except ImportError:
        raise Error(f"{folder}: found no package pyarrow, expected it: pip install plumbline[recordings]") from None
    try:
        features = dict(json.loads(settings.read_text(encoding="utf-8")).get("features", {}))
    except (ValueError, AttributeError, TypeError):
        raise Error(f"{settings}: found no object of JSON, expected the features of a LeRobot dataset") from None
    if "observation.state" not in features:
        raise Error(f"{settings}: found no feature observation.state, expected the joints' angles there")
    kept = [name for name in ("timestamp", "episode_index", "observation.state", "action") if name in features]
    files = sorted((folder / "data").rglob("*.parquet"))
    if not files:
        raise Error(f"{folder / 'data'}: found no Parquet file, expected one or more")
    parts: dict[int, list[dict[str, Floats]]] = {}
    for file in files:
        try:
            table = pyarrow.parquet.read_table(file, columns=kept)
            columns = {name: np.array(table.column(name).to_pylist(), dtype=float) for name in kept}
        except (pyarrow.ArrowException, KeyError, ValueError, TypeError, OSError) as error:
            raise Error(f"{file}: found {type(error).__name__} where it is read, expected the columns {', '.join(kept)}") from None
        number = columns.pop("episode_index", np.zeros(table.num_rows))
        for episode in np.unique(number):
            parts.setdefault(int(episode), []).append({name: values[number == episode] for name, values in columns.items()})
    return {f"episode-{episode}": _episode({name: np.concatenate([part[name] for part in parts[episode]])
                                            for name in parts[episode][0]}, features) for episode in sorted(parts)}


def _episode(columns: Mapping[str, Floats], features: Mapping[str, Any]) -> _Run:
    readings: dict[str, dict[str, Floats]] = {"position": {}, "velocity": {}, "torque": {}, "command": {}}
    for feature in ("observation.state", "action"):
        if feature not in columns:
            continue
        rows = columns[feature].reshape(len(columns[feature]), -1)
        for name, values in zip(_names(features[feature], rows.shape[1]), rows.T):
            joint, _, ending = name.rpartition(".")
            quantity = _ENDINGS.get(ending, "position")
            joint = joint if ending in _ENDINGS else name
            if feature == "observation.state":
                readings[quantity][joint] = values
            elif quantity == "position":
                readings["command"][joint] = values
    return _Run(columns.get("timestamp"), readings)


def _names(feature: Mapping[str, Any], count: int) -> list[str]:
    """Of the joints: a list, a list in a table, or numbers."""
    names = feature.get("names")
    if isinstance(names, Mapping):
        names = next((entry for entry in names.values() if isinstance(entry, list)), None)
    if not isinstance(names, list) or len(names) != count:
        return [str(place) for place in range(1, count + 1)]
    return [str(name) for name in names]


def _frame(time: Floats | None, readings: Mapping[str, Floats]) -> pandas.DataFrame:
    import pandas
    return pandas.DataFrame({**({} if time is None else {"t": time}), **readings})
