"""Makes many runs of a network, and explains what would make it faster."""

import itertools
import json
import os
from typing import Any, Mapping, Optional, Sequence, Union

from . import _core
from .errors import Error, NetlistError, RunError
from .network import FilePath, Network, Time, limit, require_network, seed_of, setting
from .progress import ProgressOption, Told, progress_of
from .tables import number_in, table


def sweep(network: Network, settings: Optional[Mapping[str, Any]] = None, seeds: int = 1, seed: int = 1,
          measure: Union[str, Sequence[str]] = "time", until: Optional[Time] = None, store: Optional[FilePath] = None,
          jobs: int = 0, progress: ProgressOption = None, **more_settings: Any) -> Any:
    """Runs a network with all combinations of settings and seeds, on all cores, and returns a table.

    settings, and further keyword arguments: for each name one value or several values, such as slaves=range(8),
    linkspeed=["5M", "20M"].
    seeds: number of seeds, of which `seed` is the first.
    measure: one or several measures as in `placedpar sweep`, such as "master.T_exe" or "max(slave.T_c)"; "time" is in
    milliseconds.
    store: a file in which the runs are stored. A later sweep with this file makes only the runs that are missing.
    jobs: number of threads; 0: one for each core.
    progress: a function that is called with the number of runs made and the number of runs that were missing; it is
    called at least once, at the end. False shows no line of progress on a terminal or in a notebook.

    The table has a row for each run: the settings, seed, outcome, and the measures (None if the run does not have the
    measure). A network that has processes in Python, or that was not read from a file, is run on one core and without a
    store.
    """
    require_network(network)
    axes = []
    for name, values in {**(settings or {}), **more_settings}.items():
        is_one = isinstance(values, str) or not hasattr(values, "__iter__")
        axes.append((name, [setting(value) for value in ([values] if is_one else values)]))
    measures = [measure] if isinstance(measure, str) else list(measure)
    seeds = seed_of(seeds, "seeds")
    for name, values in axes:
        if not values:
            raise Error(f"{name} has no values: give at least one, such as {name}=[1, 2]")
    with progress_of(progress, "{} of {} runs") as tell:
        if network._file and not network._kinds:
            rows = _core.sweep(network._core, axes, measures, seed_of(seed), seeds, limit(until),
                               "" if store is None else os.fspath(store), jobs, tell)
        elif store is None and seeds > 0:
            rows = _runs_here(network, axes, measures, range(seed_of(seed), seed + seeds), until, tell)
        else:
            raise Error("store: the runs of a network with processes in Python, or without a netlist's file, cannot be "
                        "kept, since a later sweep could not tell whether the program is still the same: keep the "
                        "returned table" if store is not None else "the number of seeds is 0, expected at least 1")
    columns = [name for name, _ in axes] + ["seed", "outcome"] + measures
    return table([{name: number_in(value) for name, value in row.items()} for row in rows], columns)


_WITH_FIGURES = ("completed", "stopped at the time limit")


def _runs_here(network: Network, axes: Sequence[tuple[str, Sequence[str]]], measures: Sequence[str],
               seeds: Sequence[int], until: Optional[Time], tell: Optional[Told]) -> list[dict[str, Any]]:
    """Makes the runs one after the other, since Python can run only one network with processes in Python at a time."""
    rows: list[dict[str, Any]] = []
    combinations = list(itertools.product(*(values for _, values in axes)))
    for combination in combinations:
        settings = dict(zip((name for name, _ in axes), combination))
        for seed in seeds:
            rows.append({**settings, "seed": seed, **_figures_of_run(network.changed(settings), measures, seed, until)})
            if tell:
                tell(len(rows), len(combinations) * len(seeds))
    return rows


def _figures_of_run(network: Network, measures: Sequence[str], seed: int, until: Optional[Time]) -> dict[str, Any]:
    try:
        run = network.run(seed, until, progress=False)
    except RunError as ended:
        run = ended.run
    except NetlistError:
        return {"outcome": "refused", **dict.fromkeys(measures)}
    figures = network._core.figures(run._core, measures) if run.outcome in _WITH_FIGURES else [None] * len(measures)
    return {"outcome": run.outcome, **dict(zip(measures, figures))}


class Explanation:
    """Explains why a run takes so long, and what would make it faster. print() shows it as `placedpar explain` does."""

    def __init__(self, report: str, text: str) -> None:
        self.report: dict[str, Any] = json.loads(report)  #: all figures; times are in picoseconds
        self.text = text

    @property
    def what_if(self) -> Any:
        """A table of the changes that were tried, the best first. Its columns are the keys of report["what_if"]."""
        return table(self.report["what_if"])

    @property
    def critical_path(self) -> Any:
        """A table of the steps of the critical path: step, subject, begin_ps, end_ps."""
        return table(self.report["critical_path"], ["step", "subject", "begin_ps", "end_ps"])

    def __str__(self) -> str:
        return self.text


def explain(network: Network, seed: int = 1, until: Optional[Time] = None,
            progress: ProgressOption = None) -> Explanation:
    """Runs a network, tries out changes of the network, and returns an Explanation.

    progress: as in sweep(), for the runs with changes.

    Raises the errors of Network.run(), and Error if the network has processes in Python.
    """
    require_network(network)
    with progress_of(progress, "{} of {} changes") as tell:
        return Explanation(*_core.explain(network._core, seed_of(seed), limit(until), tell))
