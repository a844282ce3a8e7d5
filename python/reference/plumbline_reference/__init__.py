"""The reference values as Python finds them: README.md says what the files hold.

>>> chains()["paper-two-link"]
Chain(lengths=['1', '1'], stiffness=['0', '1'])
>>> forces()["paper-two-link"]
['2.0000000000000000000000000000000000000000000000000']
"""
from __future__ import annotations

import csv
import io
import pathlib
from typing import NamedTuple


class Chain(NamedTuple):
    """Exact decimals, from the base on; a stiffness of 0 is a passive joint."""

    lengths: list[str]
    stiffness: list[str]


def file(name: str) -> pathlib.Path:
    """Where a file of the set is, such as "equilibria.json"."""
    path = pathlib.Path(__file__).parent / name
    if not path.is_file():
        raise FileNotFoundError(f"{name}: found no such file, expected one that README.md lists")
    return path


def rows(name: str) -> list[dict[str, str]]:
    """The rows of a table of the set, such as "forces.csv", every field as the text that stands there."""
    return list(csv.DictReader(io.StringIO(file(name).read_text(encoding="utf-8"))))


def chains() -> dict[str, Chain]:
    """The straight chains by name."""
    return {row["chain"]: Chain(row["lengths"].split(";"), row["stiffness"].split(";")) for row in rows("chains.csv")}


def factors() -> dict[str, list[str]]:
    """The critical load factors of chains with other ends and loads, ascending: structures.json says which they are.

    >>> factors()["fixed-free-2"][0][:10]
    '0.38196601'
    """
    found: dict[str, list[str]] = {}
    for row in rows("structures.csv"):
        found.setdefault(row["structure"], []).append(row["factor"])
    return found


def forces() -> dict[str, list[str]]:
    """The critical forces by chain, ascending: decimals of 50 digits, all right."""
    found: dict[str, list[str]] = {}
    for row in rows("forces.csv"):
        found.setdefault(row["chain"], []).append(row["force"])
    return found
