"""The progress of long work: a line on a terminal or in a notebook, or the caller's function."""

import contextlib
import sys
import threading
import time
from typing import Any, Callable, Iterator, Optional, Union

ProgressOption = Union[None, bool, Callable[[float, Optional[float]], Any]]
Told = Callable[[float, Optional[float]], Any]


def _line_in_notebook() -> Optional[Callable[[str], None]]:
    """Returns a function that shows a text in the output of the notebook's cell, or None outside a notebook."""
    get_ipython = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)
    if not hasattr(get_ipython(), "kernel"):
        return None
    from IPython.display import display  # type: ignore
    handles: list[Any] = []

    def show(text: str) -> None:
        if handles:
            handles[0].update({"text/plain": text}, raw=True)
        elif text:
            handles.append(display({"text/plain": text}, raw=True, display_id=True))
    return show


def _line_on_terminal() -> Optional[Callable[[str], None]]:
    if sys.stderr is None or not sys.stderr.isatty():
        return None

    def show(text: str) -> None:
        sys.stderr.write("\r" + text + "\x1b[K")
        sys.stderr.flush()
    return show


@contextlib.contextmanager
def progress_of(option: ProgressOption, what: str) -> Iterator[Optional[Told]]:
    """Returns a function that shows progress; None if no progress is shown. Its arguments are the amount of work that is
    done and the whole amount (None if unknown).

    option: the user's function, which is returned; or False, which shows nothing. Otherwise a line is shown on a
    terminal or in a notebook, once the work has taken half a second.
    what: the text of the line, such as "{} of {} runs".
    """
    line = None if option is False or callable(option) else _line_in_notebook() or _line_on_terminal()
    if line is None:
        yield option if callable(option) else None
        return
    show = line
    due = time.monotonic() + 0.5
    shown = False

    def tell(done: float, of: Optional[float]) -> None:
        nonlocal due, shown
        if time.monotonic() >= due:
            due = time.monotonic() + 0.2
            shown = True
            show(what.format(f"{done:.6g}", "?" if of is None else f"{of:.6g}"))
    try:
        yield tell
    finally:
        if shown:
            show("")


@contextlib.contextmanager
def watched(tell: Optional[Told], done: Callable[[], float], of: Optional[float]) -> Iterator[None]:
    """Calls `tell` five times per second, from a separate thread, with the amount of work that is done."""
    if tell is None:
        yield
        return
    over = threading.Event()

    def watch(told: Told) -> None:
        while not over.wait(0.2):
            if done() > 0:
                told(done(), of)
    thread = threading.Thread(target=watch, args=(tell,), daemon=True)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()
