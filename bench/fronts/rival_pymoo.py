#!/usr/bin/env python3
"""Makes the searches of fronts.cpp with pymoo: NSGA2 for fronts and GA for constraints, with pymoo's defaults.

usage: rival_pymoo.py SEEDS FRONT_EVALUATIONS CONSTRAINED_EVALUATIONS
"""

import sys

try:
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.algorithms.soo.nonconvex.ga import GA
    from pymoo.optimize import minimize
    from pymoo.problems import get_problem
except ImportError:
    sys.exit("pymoo is not installed: pip install pymoo")


def search(name, algorithm, evaluations, seed):
    """Prints the result; `name` is PlacedPar's name of the problem."""
    problem = get_problem(name.replace("g0", "g"))
    found = minimize(problem, algorithm, ("n_eval", evaluations), seed=seed, verbose=False)
    rows = [["not", "feasible"]] if found.F is None else [[repr(float(value)) for value in row]
                                                         for row in found.F.reshape(-1, problem.n_obj)]
    for row in rows:
        print("pymoo", name, seed, *row, flush=True)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    seeds, fronts, constrained = map(int, sys.argv[1:])
    for seed in range(1, seeds + 1):
        for number in range(1, 5):
            search(f"zdt{number}", NSGA2(pop_size=100), fronts, seed)
        for number in range(1, 7):
            search(f"g0{number}", GA(pop_size=100), constrained, seed)


if __name__ == "__main__":
    main()
