#!/usr/bin/env python3
"""Fits how the population must grow with the string, from the results of string-length.toml.

usage: growth.py RESULTS.sqlite

For each function and length it prints the population with which 90 % of the runs succeed, interpolated between the
populations of the study, and for each function the exponent e of population ~ length^e, by least squares of the
logarithms. Intervals are of 95 %, by a bootstrap over the seeds.
"""

import json
import math
import random
import sqlite3
import sys

FUNCTIONS = {  # beginning of the problem: name, whether a best objective is a success
    "one-max(": ("one-max", lambda best, bits: best >= bits),
    "schwefel(": ("schwefel", lambda best, bits: best < 118),
    "rastrigin(": ("rastrigin", lambda best, bits: best < 1),
    "trap(blocks = 1,": ("a single trap", lambda best, bits: best >= bits),
    "trap(": ("traps of 4 bits", lambda best, bits: best >= bits),
}


def successes(results):
    """Returns, by function and length, a dictionary from the population to the runs' successes, in the order of seeds."""
    found = {}
    with sqlite3.connect(results) as study:
        for settings, figures in study.execute("select settings, figures from runs order by settings, seed"):
            setting, bits = json.loads(settings), int(json.loads(settings)["bits"])
            name, succeeds = next(each for start, each in FUNCTIONS.items() if setting["problem"].startswith(start))
            runs = found.setdefault(name, {}).setdefault(bits, {}).setdefault(int(setting["individuals"]), [])
            runs.append(succeeds(json.loads(figures)["search.best_objective"][0], bits))
    return found


def needed(shares):
    """Returns the population with which 90 % succeed; the greatest of the study if none does."""
    smaller, below = min(shares), 0
    for population in sorted(shares):
        share = shares[population]
        if share >= 0.9:
            return population * (smaller / population) ** ((share - 0.9) / (share - below))
        smaller, below = population, share
    return smaller


def exponent(populations):
    """Returns the slope of log population over log length."""
    points = [(math.log(bits), math.log(population)) for bits, population in populations.items()]
    mean_x, mean_y = (sum(values) / len(points) for values in zip(*points))
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, _ in points)


def figures(by_length, seeds):
    """Returns the populations by length, and last the exponent, of the runs with these indices."""
    populations = {bits: needed({population: sum(runs[seed] for seed in seeds) / len(seeds)
                                 for population, runs in by_population.items()})
                   for bits, by_population in sorted(by_length.items())}
    return [*populations.values(), exponent(populations)]


def main(results):
    draw = random.Random(1)
    for name, by_length in sorted(successes(results).items()):
        runs = len(next(iter(next(iter(by_length.values())).values())))
        drawn = [figures(by_length, draw.choices(range(runs), k=runs)) for _ in range(1000)]
        lows_and_highs = [(sorted(each)[25], sorted(each)[974]) for each in zip(*drawn)]
        of_all = figures(by_length, range(runs))
        for bits, population, (low, high) in zip(sorted(by_length), of_all, lows_and_highs):
            print(f"{name}, {bits} bits: {population:.0f} individuals ({low:.0f} to {high:.0f})")
        low, high = lows_and_highs[-1]
        verdict = "holds" if high <= 1 else "does not hold" if low > 1 else "undecided"
        print(f"{name}: exponent {of_all[-1]:.2f} ({low:.2f} to {high:.2f}); at most 1: {verdict}\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
