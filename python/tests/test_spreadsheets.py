"""Workbooks, written with the library that reads them."""
import datetime
import pathlib
from typing import Any

import pytest

import plumbline
from plumbline.converted_tables import is_converted, new
from plumbline.spreadsheets import sheet_as_csv, sheet_names

openpyxl = pytest.importorskip("openpyxl")

ROWS = [["t", "x [mm]", "y [mm]", "Fx", "Fy"], [0, 451.8, 20.9, 0, 0], [1, 445.8, 20.9, -1.69, 0.16], [2, 439.8, 20.9, -2.4, 0.22],
        [3, 433.8, 20.9, -3.04, 0.26]]


def workbook(file: pathlib.Path, **sheets: list[list[Any]]) -> pathlib.Path:
    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append(row)
    book.save(file)
    return file


def test_a_sheet_is_the_table_that_stands_in_it(tmp_path: pathlib.Path) -> None:
    file = workbook(tmp_path / "press.xlsx", Notes=[], Monday=[[], *ROWS, []])
    assert sheet_names(file) == ["Monday"]
    assert sheet_as_csv(file).splitlines() == [",".join(map(str, row)) for row in ROWS]


def test_numbers_keep_their_digits_and_times_become_seconds(tmp_path: pathlib.Path) -> None:
    at = datetime.datetime(2026, 3, 1, 12, 0, 0, 500000)
    file = workbook(tmp_path / "a.xlsx", A=[["t", "x"], [at, 451.83125], [datetime.time(0, 1, 2), None]])
    rows = [row.split(",") for row in sheet_as_csv(file).splitlines()]
    assert float(rows[1][0]) == pytest.approx(at.replace(tzinfo=datetime.timezone.utc).timestamp(), abs=1e-6)
    assert float(rows[1][1]) == 451.83125
    assert rows[2] == ["62.0", ""]


def test_a_sheet_among_several_is_to_be_named(tmp_path: pathlib.Path) -> None:
    file = workbook(tmp_path / "press.xlsx", Monday=ROWS, Tuesday=ROWS[:3])
    with pytest.raises(plumbline.Error, match="found the sheets Monday, Tuesday, expected the name of one"):
        sheet_as_csv(file)
    assert len(sheet_as_csv(file, "Tuesday").splitlines()) == 3
    with pytest.raises(plumbline.Error, match="found no sheet Friday with values, expected one of Monday, Tuesday"):
        sheet_as_csv(file, "Friday")


def test_what_is_no_table_is_refused_in_one_line(tmp_path: pathlib.Path) -> None:
    with pytest.raises(plumbline.Error, match="found empty sheets alone"):
        sheet_as_csv(workbook(tmp_path / "empty.xlsx", A=[]))
    with pytest.raises(plumbline.Error, match="A!B2: found a formula without its value"):
        sheet_as_csv(workbook(tmp_path / "formula.xlsx", A=[["t", "x"], [0, "=1+1"]]))
    (tmp_path / "text.xlsx").write_text("t,x\n")
    with pytest.raises(plumbline.Error, match="expected a workbook") as refused:
        sheet_as_csv(tmp_path / "text.xlsx")
    assert "\n" not in str(refused.value)
    with pytest.raises(plumbline.Error, match="no such file"):
        sheet_as_csv(tmp_path / "nowhere.xlsx")


def test_a_workbook_is_drafted_as_its_sheet_is(arm: pathlib.Path, tmp_path: pathlib.Path) -> None:
    file = workbook(tmp_path / "press.xlsx", Monday=ROWS, Tuesday=ROWS)
    (tmp_path / "press.csv").write_text(sheet_as_csv(file, "Monday"))
    of_text, of_book = plumbline.draft(arm, [tmp_path / "press.csv"]), plumbline.draft(arm, [file], sheet="Monday")
    assert of_book.settings == of_text.settings and of_book.tables == of_text.tables


def test_the_command_takes_a_workbook(arm: pathlib.Path, tmp_path: pathlib.Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = workbook(tmp_path / "press.xlsx", Monday=ROWS, Tuesday=ROWS)
    words = [str(tmp_path / "lab"), str(file), "--model", str(arm)]
    assert is_converted(str(file)) and not is_converted(str(arm))
    assert new(words) == 2
    assert "found the sheets Monday, Tuesday" in capfd.readouterr().err
    assert new([*words, "--sheet", "Monday"]) in (0, 1)
    assert (tmp_path / "lab" / "press.csv").is_file()
