"""pandas and matplotlib, where they are installed."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas


def frame(columns: dict[str, Any], index_name: str) -> pandas.DataFrame:
    """A table whose rows count from 1."""
    import pandas
    table = pandas.DataFrame(columns)
    table.index = pandas.RangeIndex(1, len(table) + 1, name=index_name)
    return table
