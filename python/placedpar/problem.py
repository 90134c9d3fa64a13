"""Problems in Python: functions, and problem objects of pymoo and pygmo."""

from typing import Any, Callable, Iterable, Optional, Sequence, Union

from .errors import Error

Function = Callable[[Any], Any]  # takes a population, returns its objectives, or a tuple of objectives and constraints
Problem = Union[str, Function, Any]
Bounds = Sequence[tuple[float, float]]

EQUATION_TOLERANCE = 1e-4  #: an equation h(x) = 0 of a problem object is satisfied if |h(x)| is at most this


default_bits = 16  # number of bits of each parameter


def prepared(problem: Problem, bounds: Optional[Bounds], bits: Union[int, Sequence[int]], maximise: bool,
             search: str) -> tuple[Union[str, Function], Bounds, Sequence[int]]:
    """Returns the name or the function of a problem, its bounds, and the bits of each parameter. `search` is the name
    of the function that searches, for messages."""
    if bounds is not None and not callable(problem):
        raise Error("bounds are for a function: this problem states its own")
    if isinstance(problem, str) and (maximise or isinstance(bits, Iterable) or bits != default_bits):
        given = "maximise" if maximise else "bits"
        raise Error(f"{given} is for a function: the problem \"{problem}\" states its own goal and bits")
    if hasattr(problem, "_evaluate"):
        problem, bounds, objectives = _of_pymoo(problem)
    elif hasattr(problem, "fitness") and hasattr(problem, "get_bounds"):
        problem, bounds, objectives = _of_pygmo(problem)
    else:
        objectives = 1
        if not isinstance(problem, str) and not callable(problem):
            raise TypeError("expected a function, the name of a problem, an object with _evaluate, xl and xu (as "
                            f"pymoo's), or an object with fitness and get_bounds (as pygmo's), not {problem!r}")
    if objectives != 1 and search == "search":
        raise Error(f"a search has one objective, but this problem has {objectives}: use search_front()")
    if bounds is None and not isinstance(problem, str):
        raise TypeError("a function needs bounds: a pair (least, greatest) for each parameter")
    ranges = [] if bounds is None else [_range(each) for each in bounds]
    fields = list(bits) if isinstance(bits, Iterable) else [int(bits)] * len(ranges)
    if len(fields) != len(ranges):
        raise TypeError(f"bits has length {len(fields)}, expected one number of bits for each of the {len(ranges)} bounds")
    return problem, ranges, fields


def _range(pair: Any) -> tuple[float, float]:
    try:
        low, high = pair
        return float(low), float(high)
    except (TypeError, ValueError):
        raise TypeError(f"bounds has {pair!r}, expected pairs of numbers (least, greatest)") from None


def _of_pymoo(problem: Any) -> tuple[Function, Bounds, int]:
    """Returns the function, the bounds and the number of objectives of a pymoo problem."""
    import numpy

    unequal = getattr(problem, "n_ieq_constr", getattr(problem, "n_constr", 0))
    equations = getattr(problem, "n_eq_constr", 0)

    def evaluate(rows: Any) -> Any:
        out: dict[str, Any] = {}
        if getattr(problem, "elementwise", False):
            each: list[dict[str, Any]] = [{} for _ in rows]
            for row, of_row in zip(rows, each):
                problem._evaluate(row, of_row)
            out = {key: numpy.array([of_row[key] for of_row in each]) for key in each[0]}
        else:
            problem._evaluate(rows, out)
        return _with_constraints(out["F"], [out["G"]] if unequal else [], [out["H"]] if equations else [])

    count = getattr(problem, "n_var", numpy.size(problem.xl))
    low, high = (numpy.broadcast_to(bound, count) for bound in (problem.xl, problem.xu))
    return evaluate, list(zip(low, high)), getattr(problem, "n_obj", 1)


def _of_pygmo(problem: Any) -> tuple[Function, Bounds, int]:
    """Returns the function, bounds and number of objectives of a pygmo problem. The problem's fitness is
    a list of objectives, equations and inequalities, in this order."""
    import numpy

    def count(name: str, by_default: int = 0) -> int:
        return int(getattr(problem, name, lambda: by_default)())

    objectives, equations, unequal = count("get_nobj", 1), count("get_nec"), count("get_nic")
    if count("get_nix"):
        raise Error("this problem has whole numbers (get_nix), but a search has real numbers: remove get_nix, and round the numbers in fitness")

    def evaluate(rows: Any) -> Any:
        values = numpy.array([numpy.ravel(problem.fitness(row)) for row in rows])
        if values.shape[1:] != (objectives + equations + unequal,):
            raise Error(f"fitness returned {values.shape[-1]} numbers, but get_nobj, get_nec and get_nic say "
                        f"{objectives} + {equations} + {unequal}")
        of, h, g = numpy.split(values, [objectives, objectives + equations], axis=1)
        return _with_constraints(of, [g] if unequal else [], [h] if equations else [])

    return evaluate, list(zip(*problem.get_bounds())), objectives


def _with_constraints(values: Any, unequal: Sequence[Any], equations: Sequence[Any]) -> Any:
    """Returns objectives, or a tuple of objectives and constraints from inequalities g <= 0 and equations h = 0."""
    import numpy

    tables = [*unequal, *(numpy.abs(h) - EQUATION_TOLERANCE for h in equations)]
    return (values, numpy.column_stack(tables)) if tables else numpy.asarray(values)
