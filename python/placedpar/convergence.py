"""Plots of searches over their generations."""

import csv
import io
from collections.abc import Mapping, Sequence
from typing import Union

from . import _core
from .errors import Error
from .network import Drawing
from .search import Found

Searches = Union[Found, Sequence[Found]]


def convergence(searches: Union[Searches, Mapping[str, Searches]], title: str = "",
                logarithmic: bool = False) -> Drawing:
    """Draws the best value so far over the generations, as a median with quartiles over the searches.

    searches: one search or several, such as searches with different seeds; or a dictionary with names of curves as
    keys, and one search or several as values.
    title: title of the plot; by default it says what the plot shows.
    logarithmic: whether the axis of the values, which must be above 0, is logarithmic.

    gnuplot draws the plot, and .save("NAME.svg") writes it. Raises Error if gnuplot is not installed, or if no value is
    a finite number.
    """
    settings = searches if isinstance(searches, Mapping) else {"best": searches}
    curves = [_curve(name, [some] if isinstance(some, Found) else some) for name, some in settings.items()]
    if not curves:
        raise Error("no searches, expected at least 1")
    counts = " or ".join(map(str, sorted({len(runs) for _, _, runs in curves})))
    return Drawing(_core.convergence_svg(title or f"best value so far: medians and quartiles of {counts} searches",
                                         curves, logarithmic))


def _curve(name: str, searches: Sequence[Found]) -> tuple[str, int, list[list[float]]]:
    """Returns the name, the first generation, and the values of each search from this generation on."""
    if not isinstance(searches, Sequence) or not searches or not all(isinstance(each, Found) for each in searches):
        raise TypeError(f"{name}: expected a result of search(), or a list of such results, not {searches!r}")
    courses = [_best_so_far(each) for each in searches]
    firsts = {min(course) for course in courses}
    if len(firsts) > 1:
        raise Error(f"{name}: the searches begin at different generations, because some of them continued from a checkpoint")
    return name, firsts.pop(), [list(course.values()) for course in courses]


def _best_so_far(found: Found) -> dict[int, float]:
    """Returns the best value of all islands up to each generation."""
    rows = [row for row in csv.DictReader(io.StringIO(found._csv)) if row["quantity"] == "best_so_far"]
    whose = "all" if len(found._islands) > 1 else rows[0]["process"]
    return {int(row["generation"]): float(row["value"]) for row in rows if row["process"] == whose}
