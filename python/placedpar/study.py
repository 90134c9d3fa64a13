"""Many runs of a network, and what would make it faster."""

import json
import os
import threading
from typing import Any, Callable, Mapping, Optional, Sequence, Union

from . import _core
from .network import Network, FilePath, Time, limit, seed_of, setting
from .tables import table


def sweep(network: Network, settings: Optional[Mapping[str, Any]] = None, seeds: int = 1, seed: int = 1,
          measure: Union[str, Sequence[str]] = "time", until: Optional[Time] = None, store: Optional[FilePath] = None,
          jobs: int = 0, progress: Optional[Callable[[int, int], Any]] = None, **more_settings: Any) -> Any:
    """Runs a network with all combinations of settings and seeds, on all cores, and returns a table.

    settings, and further keyword arguments: for each name a value or several values, such as slaves=range(8),
    linkspeed=["5M", "20M"]. seeds: number of seeds, from `seed` on. measure: one or several measures as in `placedpar
    sweep`, such as "master.T_exe" or "max(slave.T_c)"; "time" is in milliseconds. store: a file that keeps the runs,
    with which a later sweep goes on. jobs: number of threads; 0: one for each core. progress: a function that is called
    with the numbers of runs made and of missing runs, at the end also if nothing was missing.

    The table has a row for each run: the settings, seed, outcome, and the measures (None if the run has no such figure).
    Raises Error if the network was loaded from a text, or has processes in Python.
    """
    axes = []
    for name, values in {**(settings or {}), **more_settings}.items():
        is_one = isinstance(values, str) or not hasattr(values, "__iter__")
        axes.append((name, [setting(value) for value in ([values] if is_one else values)]))
    measures = [measure] if isinstance(measure, str) else list(measure)
    is_main = threading.current_thread() is threading.main_thread()
    rows = _core.sweep(network._core, axes, measures, seed_of(seed), seed_of(seeds, "seeds"), limit(until),
                       "" if store is None else os.fspath(store), jobs, is_main, progress)
    columns = [name for name, _ in axes] + ["seed", "outcome"] + measures
    return table([{name: _number(value) for name, value in row.items()} for row in rows], columns)


def _number(value: Any) -> Any:
    """Returns a setting as the number that it is; other settings stay texts."""
    if not isinstance(value, str):
        return value
    for number in (int, float):
        try:
            return number(value)
        except ValueError:
            pass
    return value


class Explanation:
    """Why a run takes so long, and what would make it faster. print() shows it as `placedpar explain` does."""

    def __init__(self, report: str, text: str) -> None:
        self.report: dict[str, Any] = json.loads(report)  #: all figures; times are in picoseconds
        self.text = text

    @property
    def what_if(self) -> Any:
        """A table of the changes that were tried, the best first: see the keys of report["what_if"]."""
        rows = self.report["what_if"]
        return table(rows, list(dict.fromkeys(key for row in rows for key in row)))

    @property
    def critical_path(self) -> Any:
        """A table of the steps of the critical path: step, subject, begin_ps, end_ps."""
        return table(self.report["critical_path"], ["step", "subject", "begin_ps", "end_ps"])

    def __str__(self) -> str:
        return self.text


def explain(network: Network, seed: int = 1, until: Optional[Time] = None) -> Explanation:
    """Runs a network, tries out changes of it, and returns an Explanation. Raises errors as `sweep`."""
    is_main = threading.current_thread() is threading.main_thread()
    return Explanation(*_core.explain(network._core, seed_of(seed), limit(until), is_main))
