"""Tables: pandas DataFrames, or lists of dictionaries where pandas is not installed."""

import csv
import io
from typing import Any, Mapping, Sequence

try:
    import pandas  # type: ignore
except ImportError:
    pandas = None


def table(rows: Sequence[Mapping[str, Any]], columns: Sequence[str]) -> Any:
    """Returns a table of dictionaries. A key that a dictionary lacks is None."""
    if pandas is not None:
        return pandas.DataFrame(rows, columns=columns)
    return [{column: row.get(column) for column in columns} for row in rows]


def table_of_columns(**columns: Sequence[Any]) -> Any:
    """Returns a table of lists of equal lengths."""
    if pandas is not None:
        return pandas.DataFrame(columns)
    return [dict(zip(columns, row)) for row in zip(*columns.values())]


def table_of_csv(text: str) -> Any:
    """Returns a table of comma-separated values: numbers where all of a column are numbers, None for empty cells."""
    if pandas is not None:
        return pandas.read_csv(io.StringIO(text))
    return [{key: _number(value) for key, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


def _number(text: str) -> Any:
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            pass
    return text or None
