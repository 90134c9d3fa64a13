"""Identifies hydraulic compliances from records of measurement in DataFrames."""

import csv
import json
import os
import re
import warnings
from typing import Any, Mapping, Optional, Sequence, Union

from . import _core
from .errors import Error, RecordError, RecordWarning
from .network import FilePath, seed_of
from .tables import table


class Identification:
    """The compliances identified from a record. print() shows them as `placedpar identify` does.

    report: all results as a dictionary, as `placedpar identify --json` writes them.
    """

    def __init__(self, report: str, text: str) -> None:
        self.report: dict[str, Any] = json.loads(report)
        self.text = text

    @property
    def links(self) -> Any:
        """A table with a row for each compliance: link, unit, compliance, standard_error, flags and so on. With the way
        "service", there is a row for each link and movement, which also has set, from_s and to_s."""
        movements = self.report.get("movements", [{"links": self.report.get("links", [])}])
        rows = [{**movement, **link} for movement in movements for link in movement["links"]]
        for row in rows:
            row.pop("links", None)
        return table(rows)

    @property
    def verdicts(self) -> Any:
        """A table of the verdicts on the links, if the way is "service": link, verdict, probability and so on."""
        return table(self.report.get("verdicts", []))

    def __str__(self) -> str:
        return self.text


def identify(record: Any, *, links: Union[str, Sequence[str]] = "", configuration: str = "", way: str = "",
             seed: int = 1, machine: FilePath = "", areas_from: str = "", offset: Union[str, float] = "",
             missing: str = "refuse", side: str = "inlet", bias: float = 400, columns: Optional[Mapping[str, str]] = None,
             columns_from: FilePath = "", **numbers: Any) -> Identification:
    """Identifies compliances from a record, and returns the results of `placedpar identify` as an Identification.

    record: a DataFrame of shape (samples, columns) with the columns of a record's file, such as "time [s]",
    "boom.inlet_pressure [psi]", "boom.angle [deg]" and "boom.spool [in]" (docs/guides/records.md has all sensors and
    units). The name of a column states its unit.
    columns: the DataFrame's own names of columns, by the names above, such as {"boom.angle [deg]": "Phi 1"}.
    columns_from: a file that states such names, one on each line, such as boom.angle = Phi 1.
    links: one link or several, such as "boom" or ["bucket", "boom"].
    configuration: configuration of the main valve, "a" to "e".
    way: "service" (each movement), "thesis" (the first transient) or "whole" (several links over the whole movement).
    machine: a file with the constants of the machine.
    areas_from: source of the valve's areas: "areas", "spool" or "servo".
    offset: offset of the boom's spool in inches, or "auto" or "none".
    missing: "skip" leaves out rows that lack a reading.
    side: side of the cylinders, "inlet" or "outlet".
    bias: bias of the fitness, in (in^3/s)^2.
    numbers: bits, population, trials, window, elite, samples, rising (a truth value) and coding ("natural" or "gray"),
    which mean the same as the options of `placedpar identify`.

    Raises RecordError for wrong readings. The error names the column and the row. Raises Error for settings that are not
    valid, and for a record that lacks data that the settings require. Warns about doubtful readings with a RecordWarning.
    """
    if not hasattr(record, "to_csv") or not hasattr(record, "columns"):
        raise TypeError(f"a record must be a pandas DataFrame, not {type(record).__name__}")
    settings = _core.IdentifySettings()
    given = {"links": links if isinstance(links, str) else ",".join(links), "configuration": configuration, "way": way,
             "seed": seed_of(seed), "machine": os.fspath(machine), "areas_from": areas_from, "offset": str(offset),
             "missing": missing, "side": side, "bias": bias, "columns_from": os.fspath(columns_from),
             "columns": [f"{name}={in_frame}" for name, in_frame in (columns or {}).items()], **numbers}
    for name, value in given.items():
        _set(settings, name, value)
    text = record.to_csv(index=False, na_rep="nan", lineterminator="\n")  # keeps all digits of each number
    try:
        report, printed, faults, of_machine = _core.identify(text, settings)
    except RecordError as wrong:
        raise RecordError("", _placed(wrong.diagnostics, record, text)) from None
    except Error as wrong:
        raise Error(_settings_in_python(str(wrong))) from None
    for warning in _placed(faults, record, text):
        warnings.warn(f"{warning['message']}\nhint: {warning['hint']}", RecordWarning, 2)
    if of_machine:
        warnings.warn(of_machine, RecordWarning, 2)
    return Identification(report, printed)


_CHOICES = {"configuration": "abcde", "way": ("service", "thesis", "whole"), "areas_from": ("areas", "spool", "servo"),
            "missing": ("refuse", "skip"), "side": ("inlet", "outlet"), "coding": ("natural", "gray")}


def _set(settings: _core.IdentifySettings, name: str, value: Any) -> None:
    if not hasattr(settings, name):
        raise TypeError(f"identify has no setting {name!r}")
    if value and value not in _CHOICES.get(name, (value,)):
        raise Error(f"{name} = {value!r}, expected one of {', '.join(_CHOICES[name])}")
    try:
        setattr(settings, name, value)
    except TypeError:
        usual = getattr(settings, name)
        kind = "a whole number" if usual is None else f"a value such as {usual!r}"
        raise Error(f"{name} = {value!r}, expected {kind}") from None


def _placed(faults: Sequence[dict[str, Any]], record: Any, text: str) -> list[dict[str, Any]]:
    """Returns the faults with the row's label and the column's name in place of the line and column of the text. The
    label or the name is None if the fault concerns all rows or all columns."""
    lines = text.split("\n")
    placed = []
    for fault in faults:
        line, at = fault["line"], fault["column"]
        is_cell = line > 0 and (at > 1 or (line > 1 and fault["severity"] == "error"))
        cells = next(csv.reader([lines[line - 1][:at - 1] + "x"])) if is_cell else []
        row = record.index[line - 2] if line > 1 else None
        column = record.columns[len(cells) - 1] if cells else None
        said = [re.sub(r"\bline (\d+)", lambda other: f"row {record.index[int(other[1]) - 2]}", fault[key])
                for key in ("message", "hint")]
        place = [f"row {row}"] * (row is not None) + [f'column "{column}"'] * (column is not None)
        message = f"{', '.join(place) or 'the record'}: {said[0]}"
        hint = said[1].replace('"placedpar identify --missing skip"', 'missing="skip"')
        hint = re.sub(r"--column ([\w.]+)=NAME", r'columns={"\1": NAME}', hint)
        placed.append({"severity": fault["severity"], "row": row, "column": column, "message": message, "hint": hint})
    return placed


def _settings_in_python(text: str) -> str:
    """Returns a text with names of settings in place of the names of the command line's options."""
    return re.sub(r"--([a-z][a-z-]*)", lambda option: {"link": "links", "column": "columns"}.get(option[1], option[1].replace("-", "_")), text)
