"""Recordings of a robot's joints as tables: MCAP of ROS 2, and datasets of LeRobot."""
from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

from plumbline._engine import Error

if TYPE_CHECKING:
    import pandas



def read_recording(file: str | os.PathLike[str], *, topic: str = "/joint_states",
                   commands: str | None = None) -> dict[str, pandas.DataFrame]:
    """The joint states of a recording by the name of each run, as `draft` takes them: `t` in seconds from the first, `q NAME`
    for each joint, and `q NAME cmd` where commands are known.

    :param file: an MCAP file of ROS 2, one run; or the folder of a LeRobot dataset, a run an episode, whose actions are the
        commands. LeRobot's values are in the unit of its robot: degrees, as a rule; values that were normalised to
        -100 … 100 are no angles
    :param topic: of an MCAP file: messages sensor_msgs/msg/JointState
    :param commands: of an MCAP file: such messages too; each state has the last command before it
    :raises Error: where nothing of that kind is in the file, or a package that reads it is not installed
    """
    place = pathlib.Path(file)
    if place.is_dir():
        return _episodes(place)
    if not place.is_file():
        raise Error(f"{place}: found no such file, expected an MCAP file or the folder of a LeRobot dataset")
    states = _joint_states(place, topic)
    return {place.stem: _with_commands(states, _joint_states(place, commands) if commands else [])}


def _joint_states(file: pathlib.Path, topic: str) -> list[tuple[float, dict[str, float]]]:
    """Time, s, and angle by joint, of every message."""
    states = []
    try:
        for schema, _, _, message in _messages(file, topic):
            if schema.name not in ("sensor_msgs/msg/JointState", "sensor_msgs/JointState"):
                raise Error(f"{file}: found {schema.name} on {topic}, expected sensor_msgs/msg/JointState")
            stamp = message.header.stamp
            states.append((stamp.sec + 1e-9 * stamp.nanosec, dict(zip(message.name, message.position))))
    except Error:
        raise
    except Exception as error:  # the reader lets those of struct, zstandard and its own through
        raise Error(f"{file}: found {type(error).__name__} where it is read, expected an MCAP file of ROS 2") from None
    if not states:
        raise Error(f"{file}: found no message on {topic}, expected one of {', '.join(_topics(file)) or 'no topic'}")
    return states


def _reader(file: pathlib.Path, recording: BinaryIO) -> Any:
    try:
        from mcap.reader import make_reader
        from mcap_ros2.decoder import DecoderFactory
    except ImportError:
        raise Error(f"{file}: found no package mcap-ros2-support, expected it: pip install plumbline[recordings]") from None
    return make_reader(recording, decoder_factories=[DecoderFactory()])


def _messages(file: pathlib.Path, topic: str) -> Iterator[Any]:
    """Schema, channel, message as it was recorded, and decoded; in the order of time."""
    with open(file, "rb") as recording:
        yield from _reader(file, recording).iter_decoded_messages(topics=[topic])


def _topics(file: pathlib.Path) -> list[str]:
    with open(file, "rb") as recording:
        return sorted({channel.topic for _, channel, _ in _reader(file, recording).iter_messages()})


def _with_commands(states: list[tuple[float, dict[str, float]]],
                   commands: list[tuple[float, dict[str, float]]]) -> pandas.DataFrame:
    times = np.array([time for time, _ in states])
    columns: dict[str, Any] = {"t": times - times[0]}
    for joint in _joints(states):
        columns[f"q {joint}"] = [angles.get(joint, np.nan) for _, angles in states]
    if commands:
        before = np.searchsorted([time for time, _ in commands], times, side="right") - 1
        for joint in _joints(commands):
            columns[f"q {joint} cmd"] = [commands[at][1].get(joint, np.nan) if at >= 0 else np.nan for at in before]
    return _frame(columns)


def _joints(states: Iterable[tuple[float, dict[str, float]]]) -> list[str]:
    return list(dict.fromkeys(joint for _, angles in states for joint in angles))


def _episodes(folder: pathlib.Path) -> dict[str, pandas.DataFrame]:
    settings = folder / "meta" / "info.json"
    if not settings.is_file():
        raise Error(f"{folder}: found no meta/info.json, expected the folder of a LeRobot dataset")
    try:
        import pyarrow.parquet
    except ImportError:
        raise Error(f"{folder}: found no package pyarrow, expected it: pip install plumbline[recordings]") from None
    features = json.loads(settings.read_text(encoding="utf-8")).get("features", {})
    if "observation.state" not in features:
        raise Error(f"{settings}: found no feature observation.state, expected the joints' angles there")
    kept = [name for name in ("timestamp", "episode_index", "observation.state", "action") if name in features]
    files = sorted((folder / "data").rglob("*.parquet"))
    if not files:
        raise Error(f"{folder / 'data'}: found no Parquet file, expected one or more")
    rows: dict[int, list[dict[str, Any]]] = {}
    for file in files:
        for row in pyarrow.parquet.read_table(file, columns=kept).to_pylist():
            rows.setdefault(int(row.get("episode_index", 0)), []).append(row)
    return {f"episode-{episode}": _episode(rows[episode], features) for episode in sorted(rows)}


def _episode(rows: list[dict[str, Any]], features: Mapping[str, Any]) -> pandas.DataFrame:
    columns: dict[str, Any] = {"t": [row["timestamp"] for row in rows]} if "timestamp" in rows[0] else {}
    for feature, ending in (("observation.state", ""), ("action", " cmd")):
        if feature not in rows[0]:
            continue
        values = np.array([row[feature] for row in rows], dtype=float)
        for place, joint in enumerate(_names(features[feature], values.shape[1])):
            columns[f"q {joint}{ending}"] = values[:, place]
    return _frame(columns)


def _names(feature: Mapping[str, Any], count: int) -> list[str]:
    """Of the joints: a list, a list in a table, or numbers."""
    names = feature.get("names")
    if isinstance(names, Mapping):
        names = next((entry for entry in names.values() if isinstance(entry, list)), None)
    if not isinstance(names, list) or len(names) != count:
        return [str(place) for place in range(1, count + 1)]
    return [str(name).removesuffix(".pos") for name in names]


def _frame(columns: dict[str, Any]) -> pandas.DataFrame:
    import pandas
    return pandas.DataFrame(columns)
