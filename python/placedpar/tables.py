"""Tables: pandas DataFrames, or lists of dictionaries where pandas is not installed."""

import csv
import io
from typing import Any, Mapping, Optional, Sequence

try:
    import pandas  # type: ignore
except ImportError:
    pandas = None


def table(rows: Sequence[Mapping[str, Any]], columns: Optional[Sequence[str]] = None) -> Any:
    """Returns a table of dictionaries, by default with all keys as columns. A key that a dictionary lacks is None."""
    columns = list(dict.fromkeys(key for row in rows for key in row)) if columns is None else columns
    if pandas is not None:
        return pandas.DataFrame(rows, columns=columns)
    return [{column: row.get(column) for column in columns} for row in rows]


def table_of_columns(**columns: Sequence[Any]) -> Any:
    """Returns a table of lists of equal lengths."""
    if pandas is not None:
        return pandas.DataFrame(columns)
    return [dict(zip(columns, row)) for row in zip(*columns.values())]


def table_of_csv(text: str) -> Any:
    """Returns a table of comma-separated values. A column is numeric if all its cells are numbers; empty cells are None."""
    if pandas is not None:
        return pandas.read_csv(io.StringIO(text), float_precision="round_trip")
    return [{key: number_in(value) if value else None for key, value in row.items()}
            for row in csv.DictReader(io.StringIO(text))]


def number_in(value: Any) -> Any:
    """Returns the number that a text spells; returns any other text or object unchanged."""
    for number in (int, float) if isinstance(value, str) else ():
        try:
            return number(value)
        except ValueError:
            pass
    return value
