"""Searches by genetic algorithms, with the fitness in Python or of a problem that PlacedPar knows."""

import math
import os
from typing import Any, Callable, Optional, Sequence, Union

from . import _core
from .errors import Error
from .network import seed_of
from .progress import ProgressOption, progress_of
from .tables import table, table_of_csv


class Found:
    """The result of a search: the best individual of all islands and generations.

    x: its parameters, an array of shape (d,). value: its objective. fitness: what the
    search maximised. generation: the generation, from 1, and island, from 0, that found it.
    """

    x: Any
    value: float
    fitness: float
    string: str
    generation: int

    def __init__(self, found: dict[str, Any]) -> None:
        self._islands = found["islands"]
        for island in self._islands:
            if island["value"] is None:  # the objective was NaN for all individuals
                island["value"] = math.nan
        self._csv = found["log_csv"]
        self.migrations: int = found["migrations"]  #: number of individuals that were sent to another island
        best = max(range(len(self._islands)), key=lambda i: float(self._islands[i]["fitness"]))
        self.island = best
        for name, value in self._islands[best].items():
            setattr(self, name, value)

    @property
    def islands(self) -> Any:
        """A table with a row for each island: x, string, fitness, value, generation, generations."""
        return table(self._islands, ["x", "string", "fitness", "value", "generation", "generations"])

    @property
    def log(self) -> Any:
        """A table of every generation of every island, as Run.log has it, without times."""
        return table_of_csv(self._csv)

    def __repr__(self) -> str:
        return f"<placedpar.Found value {self.value:.9g} at {list(self.x)}>"


def _columns(problem: Any) -> tuple[Callable[[Any], Any], list[tuple[float, float]]]:
    """Returns the objective and the bounds of a problem object: pymoo's (_evaluate, xl, xu) or pygmo's (fitness,
    get_bounds)."""
    if hasattr(problem, "_evaluate"):
        if getattr(problem, "n_obj", 1) != 1 or getattr(problem, "n_constr", 0) or getattr(problem, "n_ieq_constr", 0):
            raise Error("a search has one objective and no constraints: this problem has others")

        def evaluate(rows: Any) -> Any:
            out: dict[str, Any] = {}
            problem._evaluate(rows, out)
            return out["F"]

        return evaluate, list(zip(problem.xl, problem.xu))
    if hasattr(problem, "fitness") and hasattr(problem, "get_bounds"):
        if hasattr(problem, "get_nobj") and problem.get_nobj() != 1:
            raise Error(f"a search has one objective, but this problem has {problem.get_nobj()}")
        return (lambda rows: [problem.fitness(row)[0] for row in rows]), list(zip(*problem.get_bounds()))
    raise TypeError("expected a function, the name of a problem, an object with _evaluate, xl and xu (as pymoo's), or an "
                    f"object with fitness and get_bounds (as pygmo's), not {problem!r}")


Policy = Union[str, Callable[..., Any]]


def search(problem: Any, bounds: Optional[Sequence[tuple[float, float]]] = None, *, islands: int = 1,
           generations: int = 100, population: Optional[int] = None, seed: int = 1, maximise: bool = False,
           bits: Union[int, Sequence[int]] = 16, coding: str = "natural", elite: Optional[int] = None,
           crossover_probability: Optional[float] = None, mutation_probability: Optional[float] = None,
           reproduction: Optional[Policy] = None, crossover: Optional[Policy] = None, mutation: Optional[Policy] = None,
           topology: Optional[Policy] = None, schedule: Optional[Policy] = None, emigration: Optional[Policy] = None,
           acceptance: Optional[Policy] = None, checkpoint: Union[str, "os.PathLike[str]", None] = None,
           progress: ProgressOption = None) -> Found:
    """Searches for the least value of an objective and returns what was Found.

    problem: a function of a population, an array of shape (n, d), that returns n values, shape (n,) or (n, 1); or a
    problem as pymoo or pygmo have it; or the name of a known problem, such as "rastrigin(dimensions = 10)".
    bounds: d pairs (least, greatest) of a function. maximise: the greatest value is wanted.
    bits: of each parameter's field, a number or d numbers; coding: "natural", "gray" or "real" (no bits).
    Each island has `population` individuals and its own random numbers, given by `seed`.
    checkpoint: a file that keeps all populations, every 10 generations. If it is there, the search goes on from it;
    a file of another problem, or of a function with other bounds or another goal, is refused.

    The policies are texts as in a netlist, such as "tournament(3)", or functions:
    reproduction(fitness, count, random) -> count indices of parents;
    crossover(a, b, random) -> (a, b); mutation(x, place, random) -> x, for each place that is mutated;
    topology(islands) -> for each island a list of its neighbours;
    schedule(exchange, neighbours) -> the neighbours that get emigrants; its attribute `every` counts generations;
    emigration(fitness, random) -> indices; its attribute `count` is their number;
    acceptance(fitness, immigrants, random) -> for each immigrant the index of the individual that it replaces, or
    None.
    Strings are arrays of bits, real numbers, or places of a permutation.

    progress: a function that is called with the numbers of generations made, on all islands together, and wanted;
    False: no line of progress on a terminal or in a notebook. Raises Error for settings that do not fit.
    """
    if islands == 1 and topology is None:
        topology = "none"
    settings = dict(population=population, elite=elite, crossover_probability=crossover_probability,
                    mutation_probability=mutation_probability, reproduction=reproduction, crossover=crossover,
                    mutation=mutation, topology=topology, schedule=schedule, emigration=emigration, acceptance=acceptance)
    if not isinstance(problem, str):
        if not callable(problem) or hasattr(problem, "_evaluate"):
            problem, bounds = _columns(problem)
        if bounds is None:
            raise TypeError("a function needs bounds: a pair (least, greatest) for each parameter")
    ranges = [(float(low), float(high)) for low, high in bounds or ()]
    fields = [bits] * len(ranges) if isinstance(bits, int) else list(bits)
    if len(fields) != len(ranges):
        raise TypeError(f"{len(ranges)} bounds need as many numbers of bits, not {len(fields)}")
    with progress_of(progress, "{} of {} generations") as tell:
        return Found(_core.search(problem, ranges, fields, maximise, islands, generations, seed_of(seed), coding,
                                  {name: value for name, value in settings.items() if value is not None}, os.fspath(checkpoint or ""), tell))


class Front:
    """The result of search_front: x, an array of shape (n, d), and values, of shape (n, objectives), of the n
    individuals that no other dominates; names of the objectives; least_violation of the constraints, 0 if an
    individual satisfies all; the number of evaluations.
    """

    def __init__(self, found: dict[str, Any]) -> None:
        import numpy

        self.x = numpy.array(found["x"])
        self.values = numpy.array(found["values"])
        self.names: list[str] = found["names"]
        self.least_violation: float = found["least_violation"]
        self.evaluations: int = found["evaluations"]

    def __repr__(self) -> str:
        return f"<placedpar.Front of {len(self.values)} individuals>"


def search_front(problem: str, *, generations: int = 250, population: int = 100, seed: int = 1,
                 coding: str = "natural") -> Front:
    """Searches for the front of a known problem with several objectives, such as "zdt1", by NSGA-II.

    A function in Python has one objective: use search(). Ctrl-C waits until the search has ended.
    Makes population * (generations + 1) evaluations. Raises Error for settings that do not fit.
    """
    return Front(_core.search_front(problem, generations, population, seed_of(seed), coding))
