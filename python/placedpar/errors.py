"""The exceptions of PlacedPar."""

from typing import Any, Sequence


class Error(Exception):
    """Base class of the errors that a user can cause. The text says what is wrong, where, and what would be right."""


class NetlistError(Error):
    """A netlist was refused.

    `diagnostics` has all errors and warnings as dictionaries with the keys severity, message, file, line, column, hint
    and text. `file`, `line` (from 1), `column` (from 1) and `hint` are those of the first error.
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


class ProcessError(Error):
    """A process in Python raised an exception, which is the `__cause__`. The text names the process and the time."""


class Deadlock(Error):
    """A run ended in a deadlock. The text has the cycle, and where each process waits in its program.

    `run` is the run, with its measures up to the deadlock.
    """

    def __init__(self, text: str, run: Any) -> None:
        super().__init__(text.rstrip("\n"))
        self.run = run
