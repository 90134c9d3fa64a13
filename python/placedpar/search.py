"""Searches by genetic algorithms. The objective is a function in Python, or a problem that PlacedPar knows."""

import math
import os
from typing import Any, Callable, Optional, Sequence, Union

from . import _core
from .errors import Error
from .network import FilePath, seed_of
from .problem import Problem, default_bits, prepared
from .progress import ProgressOption, progress_of
from .tables import table, table_of_csv


class Found:
    """The result of a search: the best individual of all islands and generations.

    x: parameters of the individual, an array of shape (d,); empty if the problem has none, such as a tour.
    string: the individual's string of bits, its real numbers or its tour, as a text.
    value: objective of the individual; NaN if the individual is not feasible.
    violation: sum of the violations of the constraints; 0 if the individual is feasible.
    fitness: fitness of the individual, which the search maximised.
    generation, island: the generation, counted from 1, and the island, counted from 0, that found the individual.
    """

    x: Any
    value: float
    violation: float
    fitness: float
    string: str
    generation: int

    def __init__(self, found: dict[str, Any]) -> None:
        self._islands = found["islands"]
        for island in self._islands:
            if island["value"] is None:  # no individual is feasible, or has a finite objective
                island["value"] = math.nan
        self._csv = found["log_csv"]
        self.migrations: int = found["migrations"]  #: number of individuals that were sent to another island
        best = max(range(len(self._islands)), key=lambda i: float(self._islands[i]["fitness"]))
        self.island = best
        for name, value in self._islands[best].items():
            setattr(self, name, value)

    @property
    def islands(self) -> Any:
        """A table with a row for each island: x, string, fitness, value, violation, generation, generations."""
        return table(self._islands, ["x", "string", "fitness", "value", "violation", "generation", "generations"])

    @property
    def log(self) -> Any:
        """A table of every generation of every island, like Run.log but without times."""
        return table_of_csv(self._csv)

    def __repr__(self) -> str:
        return f"<placedpar.Found value {self.value:.9g} at {list(self.x)}>"


Policy = Union[str, Callable[..., Any]]


def search(problem: Problem, bounds: Optional[Sequence[tuple[float, float]]] = None, *, islands: int = 1,
           generations: int = 100, population: Optional[int] = None, seed: int = 1, maximise: bool = False,
           bits: Union[int, Sequence[int]] = default_bits, coding: str = "natural", elite: Optional[int] = None,
           crossover_probability: Optional[float] = None, mutation_probability: Optional[float] = None,
           reproduction: Optional[Policy] = None, crossover: Optional[Policy] = None, mutation: Optional[Policy] = None,
           topology: Optional[Policy] = None, schedule: Optional[Policy] = None, emigration: Optional[Policy] = None,
           acceptance: Optional[Policy] = None, checkpoint: Optional[FilePath] = None,
           progress: ProgressOption = None) -> Found:
    """Searches for the least value of an objective, and returns the result as a Found.

    problem: a function, which receives a population as an array of shape (n, d), and returns n values, of shape (n,) or
    (n, 1); or a problem object of pymoo or pygmo; or the name of a known problem, such as "rastrigin(dimensions = 10)".
    With constraints, the function returns a tuple: the values, and an array of shape (n,) or (n, k). A constraint is
    satisfied if its number is at most 0. A feasible individual is better than an individual that is not feasible. Of two
    individuals that are not feasible, the individual with the smaller sum of violations is better.
    bounds: d pairs (least, greatest) for the parameters of a function.
    maximise: whether to search for the greatest value of a function instead.
    bits: number of bits of each parameter's field; one number, or d numbers. If the problem is given by its name, bounds,
    bits and maximise are refused, because the problem states them. For a problem object, bounds are refused.
    coding: "natural", "gray" or "real" (no bits).
    population: number of individuals of each island. Each island has its own random numbers, given by `seed`.
    checkpoint: a file in which all populations are stored every 10 generations. If the file exists, the search continues
    from it. A file of another problem, or of a function with other bounds or another goal, is refused.

    A policy is a text as in a netlist, such as "tournament(3)", or a function:
    reproduction(fitness, count, random) -> count indices of parents;
    crossover(a, b, random) -> (a, b); mutation(x, place, random) -> x, for each place that is mutated;
    topology(islands) -> for each island a list of its neighbours;
    schedule(exchange, neighbours) -> the neighbours that receive emigrants; the function's attribute `every` is the number
    of generations between exchanges;
    emigration(fitness, random) -> indices of emigrants; the function's attribute `count` is the number of emigrants;
    acceptance(fitness, immigrants, random) -> for each immigrant the index of the individual that it replaces, or
    None.
    a, b and x are arrays of real numbers, or, as whole numbers, of bits 0 and 1 or of the places 0 to n - 1 of a
    permutation. An exception of the function is raised again, with its own traceback.

    progress: a function that is called with the number of generations made, on all islands together, and the number of
    all generations; False shows no line of progress on a terminal or in a notebook.

    Raises Error for settings that are not valid.
    """
    if islands == 1 and topology is None:
        topology = "none"
    settings = dict(population=population, elite=elite, crossover_probability=crossover_probability,
                    mutation_probability=mutation_probability, reproduction=reproduction, crossover=crossover,
                    mutation=mutation, topology=topology, schedule=schedule, emigration=emigration, acceptance=acceptance)
    function, ranges, fields = prepared(problem, bounds, bits, maximise, "search")
    with progress_of(progress, "{} of {} generations") as tell:
        return Found(_core.search(function, ranges, fields, maximise, islands, generations, seed_of(seed), coding,
                                  {name: value for name, value in settings.items() if value is not None},
                                  os.fspath(checkpoint or ""), tell))


class Front:
    """The result of search_front(): the n individuals that no other individual dominates.

    x: their parameters, an array of shape (n, d); d is 0 if the problem has none, such as a tour.
    strings: each individual's string of bits, its real numbers or its tour, as a list of n texts.
    values: their objectives, an array of shape (n, objectives).
    names: names of the objectives.
    least_violation: least sum of violations of the constraints; 0 if an individual satisfies all constraints.
    evaluations: number of evaluations that this call made.
    """

    def __init__(self, found: dict[str, Any]) -> None:
        import numpy

        self.names: list[str] = found["names"]
        self.strings: list[str] = found["strings"]
        self.x = numpy.array(found["x"]).reshape(len(self.strings), found["parameters"])
        self.values = numpy.array(found["values"]).reshape(-1, len(self.names))
        self.least_violation: float = found["least_violation"]
        self.evaluations: int = found["evaluations"]

    def __repr__(self) -> str:
        return f"<placedpar.Front of {len(self.values)} individuals>"


def search_front(problem: Problem, bounds: Optional[Sequence[tuple[float, float]]] = None, *, generations: int = 250,
                 population: int = 100, seed: int = 1, maximise: bool = False, bits: Union[int, Sequence[int]] = default_bits,
                 coding: str = "natural", checkpoint: Optional[FilePath] = None,
                 progress: ProgressOption = None) -> Front:
    """Searches for the front of several objectives by NSGA-II, and returns the Front.

    problem: as in search(), but the values that a function returns have the shape (n, objectives). All objectives are
    minimised, or all are maximised.
    bounds, maximise, bits, coding, checkpoint, progress: as in search().

    The operators are the operators of NSGA-II; with coding="real" these are simulated binary crossover and polynomial
    mutation. Makes population * (generations + 1) evaluations. Raises Error for settings that are not valid.
    """
    function, ranges, fields = prepared(problem, bounds, bits, maximise, "search_front")
    if population in (0, 1):
        raise Error(f"a population of {population}, expected at least 2: individuals are bred in pairs")
    with progress_of(progress, "{} of {} generations") as tell:
        return Front(_core.search_front(function, ranges, fields, maximise, 1, generations, seed_of(seed), coding,
                                        {"population": population}, os.fspath(checkpoint or ""), tell))
