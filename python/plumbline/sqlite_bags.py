"""Bags of ROS 2 in SQLite, the storage before Iron, whose messages are in CDR (OMG, DDS-XTypes 1.3, 7.4.1): no package reads them here."""
from __future__ import annotations

import pathlib
import sqlite3
import struct
from collections.abc import Iterator
from typing import NamedTuple

from plumbline._engine import Error

JOINT_STATE = ("sensor_msgs/msg/JointState", "sensor_msgs/JointState")


class JointState(NamedTuple):
    """A message sensor_msgs/msg/JointState."""

    stamp: float  #: s
    name: list[str]
    position: list[float]
    velocity: list[float]
    effort: list[float]


class _Fields:
    """The fields of a message, one after the other; each is aligned to its size, counted from behind the four bytes of the head."""

    def __init__(self, message: bytes) -> None:
        self._body = message[4:]
        self._order = "<" if message[1] & 1 else ">"
        self._at = 0

    def numbers(self, kind: str, count: int) -> list[float]:
        size = struct.calcsize(kind)
        self._at += -self._at % size if count else 0
        read = struct.unpack_from(f"{self._order}{count}{kind}", self._body, self._at)
        self._at += size * count
        return list(read)

    def count(self) -> int:
        return int(self.numbers("I", 1)[0])

    def text(self) -> str:
        length = self.count()  # with the zero at its end
        self._at += length
        return self._body[self._at - length:self._at - 1].decode()

    def doubles(self) -> list[float]:
        return self.numbers("d", self.count())


def _joint_state(message: bytes) -> JointState:
    fields = _Fields(message)
    seconds, nanoseconds = fields.numbers("i", 1)[0], fields.numbers("I", 1)[0]
    fields.text()  # the frame
    names = [fields.text() for _ in range(fields.count())]
    return JointState(seconds + 1e-9 * nanoseconds, names, fields.doubles(), fields.doubles(), fields.doubles())


def joint_states(file: pathlib.Path, topic: str) -> Iterator[tuple[float, JointState]]:
    """The time at which each message on a topic was recorded, s, and the message.

    :raises Error: where the file is no bag, or the topic has other messages
    """
    try:
        for number, kind in _rows(file, "SELECT id, type FROM topics WHERE name = ?", topic):
            if kind not in JOINT_STATE:
                raise Error(f"{file}: found {kind} on {topic}, expected {JOINT_STATE[0]}")
            for time, message in _rows(file, "SELECT timestamp, data FROM messages WHERE topic_id = ? ORDER BY timestamp", number):
                yield 1e-9 * time, _joint_state(message)
    except (sqlite3.Error, struct.error, IndexError, UnicodeDecodeError) as error:
        raise Error(f"{file}: found {type(error).__name__} where it is read, expected a bag of ROS 2 in SQLite") from None


def topics(file: pathlib.Path) -> set[str]:
    return {name for (name,) in _rows(file, "SELECT name FROM topics")}


def _rows(file: pathlib.Path, query: str, *values: object) -> Iterator[tuple]:  # type: ignore[type-arg]
    bag = sqlite3.connect(f"{file.absolute().as_uri()}?mode=ro", uri=True)
    try:
        yield from bag.execute(query, values)
    finally:
        bag.close()
