"""The command `plumbline new` on tables that are no text: workbooks, recordings, datasets."""
from __future__ import annotations

import pathlib
import subprocess
import sys
import tempfile
from collections.abc import Sequence

from plumbline._engine import Error
from plumbline.program import executable
from plumbline.recordings import read_recording
from plumbline.spreadsheets import is_workbook, sheet_as_csv, sheet_names


def is_converted(word: str) -> bool:
    """Whether a word of the command is a workbook, a bag of ROS 2, or the folder of a LeRobot dataset."""
    path = pathlib.Path(word)
    return (is_workbook(path) or path.suffix.lower() in (".mcap", ".db3")
            or any((path / own).is_file() for own in ("metadata.yaml", "meta/info.json")))


def new(words: Sequence[str]) -> int:
    """`plumbline new` with the tables that it can read, in a folder that is there as long as it runs.

    :param words: of the command behind `new`; `--sheet NAME` and `--commands TOPIC` are taken out
    :returns: the exit status
    """
    try:
        rest, sheet = _without("--sheet", list(words))
        rest, commands = _without("--commands", rest)
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            plain = [name for word in rest
                     for name in (_written(pathlib.Path(word), sheet, commands, folder) if is_converted(word) else [word])]
            return subprocess.run([executable(), "new", *plain], check=False).returncode
    except Error as error:
        print(f"plumbline: {error}", file=sys.stderr)
        return 2


def _without(option: str, words: list[str]) -> tuple[list[str], str | None]:
    """The words without an option, and its value."""
    for place, word in enumerate(words):
        if word.startswith(f"{option}="):
            return words[:place] + words[place + 1:], word.removeprefix(f"{option}=")
        if word == option:
            if place + 1 == len(words):
                raise Error(f"{option}: found no name, expected one")
            return words[:place] + words[place + 2:], words[place + 1]
    return words, None


def _written(source: pathlib.Path, sheet: str | None, commands: str | None, folder: pathlib.Path) -> list[str]:
    """The names of its tables as CSV."""
    if is_workbook(source):
        texts = {source.stem: sheet_as_csv(source, sheet or _asked(source))}
    else:
        texts = {name: table.to_csv(index=False) for name, table in read_recording(source, commands=commands).items()}
    files = []
    for name, text in texts.items():
        file = folder / f"{name}.csv"
        if file.exists():
            raise Error(f"{source}: found a table {name} already, expected a name for each table")
        file.write_text(text, encoding="utf-8")
        files.append(str(file))
    return files


def _asked(workbook: pathlib.Path) -> str | None:
    """The sheet that a person on a terminal names, where there are several."""
    names = sheet_names(workbook)
    if len(names) < 2 or not (sys.stdin.isatty() and sys.stdout.isatty()):
        return None
    return input(f"{workbook} has the sheets {', '.join(names)}. Which one? ").strip() or None
