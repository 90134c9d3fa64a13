"""The exceptions of PlacedPar."""

import sys
from types import FrameType
from typing import Any, Sequence


def caller() -> tuple[FrameType, int]:
    """Returns the frame in the user's program that called the package, and its level for warnings.warn()."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and frame.f_globals.get("__name__", "").startswith("placedpar."):
        frame, level = frame.f_back, level + 1
    return frame, level


class Error(Exception):
    """Base class of the errors that a user can cause. The text says what is wrong, where, and what would be right."""


class NetlistError(Error):
    """A netlist was refused.

    `diagnostics` has all errors and warnings as dictionaries with the keys severity, message, file, line, column, hint
    and text. `file`, `line` (from 1), `column` (from 1) and `hint` are attributes of the first error.
    """

    def __init__(self, text: str, diagnostics: Sequence[dict[str, Any]] = ()) -> None:
        super().__init__(text.rstrip("\n"))
        self.diagnostics = list(diagnostics)
        first: dict[str, Any] = next((each for each in self.diagnostics if each["severity"] == "error"), {})
        self.file: str = first.get("file", "")
        self.line: int = first.get("line", 0)
        self.column: int = first.get("column", 0)
        self.hint: str = first.get("hint", "")


class NetlistWarning(UserWarning):
    """A warning about a netlist, such as a process that is connected to nothing."""


class RecordError(Error):
    """The readings in a DataFrame were refused.

    `diagnostics` has the errors as dictionaries with the keys severity, row (its label in the index), column (its
    name), message and hint. `row` and `column` are attributes of the first error; None stands for all rows or columns.
    """

    def __init__(self, text: str, diagnostics: Sequence[dict[str, Any]] = ()) -> None:
        self.diagnostics = list(diagnostics)
        said = [each["message"] + f"\nhint: {each['hint']}" * bool(each["hint"]) for each in self.diagnostics]
        super().__init__(text or "\n".join(said))
        first: dict[str, Any] = next(iter(self.diagnostics), {})
        self.row, self.column = first.get("row"), first.get("column")


class RecordWarning(UserWarning):
    """A warning about the readings in a DataFrame, such as a pressure below vacuum."""


class ProcessError(Error):
    """A process in Python raised an exception, which is the `__cause__`. The text names the process and the virtual time."""


class RunError(Error):
    """Base class of the errors that a run can end with. `run` is the run, with its measures and its output up to the error."""

    def __init__(self, text: str, run: Any) -> None:
        super().__init__(text.rstrip("\n"))
        self.run = run


class Deadlock(RunError):
    """A run ended in a deadlock. The text has the wait cycle, and for each process the line of its program at which it waits."""


class ProgramError(RunError):
    """A program in occam stopped with an error, or told its host that it failed. The text has the error and the line of
    the program."""
