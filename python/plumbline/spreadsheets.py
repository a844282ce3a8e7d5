"""Sheets of workbooks (.xlsx) as text in columns, where openpyxl is installed."""
from __future__ import annotations

import csv
import datetime
import io
import os
import pathlib
from typing import TYPE_CHECKING, Any

from plumbline._engine import Error

if TYPE_CHECKING:
    from openpyxl.worksheet.worksheet import Worksheet

EPOCH = datetime.datetime(1970, 1, 1)


def is_workbook(file: str | os.PathLike[str]) -> bool:
    """By its name."""
    return pathlib.Path(file).suffix.lower() in (".xlsx", ".xlsm")


def sheet_names(file: str | os.PathLike[str]) -> list[str]:
    """The sheets of a workbook that hold anything."""
    return _filled(_workbook(file))


def sheet_as_csv(file: str | os.PathLike[str], sheet: str | None = None) -> str:
    """The values of a sheet, with commas between; dates and times of the day as seconds. Empty rows are left out.

    :param sheet: its name; not needed where one sheet alone holds anything
    :raises Error: where it has to be named, is not there or is empty, or a formula has no value
    """
    workbook = _workbook(file)
    names = _filled(workbook)
    if sheet is None and len(names) > 1:
        raise Error(f"{file}: found the sheets {', '.join(names)}, expected the name of one of them: sheet")
    if not names or sheet not in (None, *names):
        raise Error(f"{file}: found {f'no sheet {sheet} with values' if names else 'empty sheets alone'}, "
                    f"expected {'one of ' + ', '.join(names) if names else 'a table in one of them'}")
    chosen = sheet or names[0]
    values = workbook[chosen]
    _require_values(file, values, _workbook(file, formulas=True)[chosen])
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    for row in _rows(values):
        writer.writerow([_written(value) for value in row])
    return text.getvalue()


def _filled(workbook: Any) -> list[str]:
    return [sheet.title for sheet in workbook.worksheets if any(_rows(sheet))]


def _workbook(file: str | os.PathLike[str], formulas: bool = False) -> Any:
    try:
        import openpyxl
    except ImportError:
        raise Error(f"{file}: found no package openpyxl, expected it: pip install plumbline[spreadsheets]") from None
    if not pathlib.Path(file).is_file():
        raise Error(f"{file}: found no such file, expected a workbook")
    try:
        return openpyxl.load_workbook(file, data_only=not formulas)
    except Exception as error:  # openpyxl lets those of zipfile, xml and its own through
        raise Error(f"{file}: found {type(error).__name__} where it is read, expected a workbook (.xlsx)") from None


def _rows(sheet: Worksheet) -> list[tuple[Any, ...]]:
    """Those that hold anything, as wide as the widest."""
    rows = [row for row in sheet.iter_rows(values_only=True) if any(value is not None for value in row)]
    width = max((1 + max(place for place, value in enumerate(row) if value is not None) for row in rows), default=0)
    return [row[:width] for row in rows]


def _require_values(file: str | os.PathLike[str], values: Worksheet, formulas: Worksheet) -> None:
    for row in formulas.iter_rows():
        for cell in row:
            if cell.data_type == "f" and values[cell.coordinate].value is None:
                raise Error(f"{file}, {formulas.title}!{cell.coordinate}: found a formula without its value, expected a "
                            "workbook that a spreadsheet program has saved")


def _written(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, datetime.datetime):
        return repr((value - EPOCH).total_seconds())
    if isinstance(value, datetime.time):
        return repr((datetime.datetime.combine(EPOCH, value) - EPOCH).total_seconds())
    if isinstance(value, datetime.timedelta):
        return repr(value.total_seconds())
    return str(value)
