#!/usr/bin/env python3
"""Compares fronts and constrained optima that several programs found with equal evaluations.

usage: compare.py FILE...    each line is "[PROGRAM] PROBLEM SEED VALUE...", from fronts, fronts_pagmo or rival_pymoo.py

For a front, it prints the hypervolume up to (1.1, 1.1) and the IGD, the mean distance of 500 points of the true front
from the nearest point found. For a constrained problem, it prints the best feasible objective. All are medians over the
seeds, with an interval of 95 % for the median by the binomial distribution. An infeasible run counts as worse than every
feasible run.
"""

import bisect
import collections
import math
import sys

CORNER = 1.1


def true_front(problem, count=500):
    """Returns points of the true front."""
    points = []
    for i in range(count):
        x = i / (count - 1)
        if problem == "zdt2":
            points.append((x, 1 - x * x))
        elif problem == "zdt3":
            points.append((x, 1 - math.sqrt(x) - x * math.sin(10 * math.pi * x)))
        else:
            points.append((x, 1 - math.sqrt(x)))
    return non_dominated(points)


def non_dominated(points):
    """Returns the points that no other point dominates, in ascending order of the first value."""
    front = []
    for point in sorted(points):
        if not front or point[1] < front[-1][1]:
            front.append(point)
    return front


def hypervolume(points):
    """Returns the area that the points dominate, up to the corner."""
    area, above = 0.0, CORNER
    for x, y in non_dominated(points):
        if x < CORNER and y < above:
            area += (CORNER - x) * (above - y)
            above = y
    return area


def igd(points, front):
    """Returns the mean distance of the front's points from the nearest point."""
    return sum(min(math.hypot(x - a, y - b) for a, b in points) for x, y in front) / len(front)


def interval_of_median(count):
    """Returns the ranks, from 0, of the two values that enclose the median with a probability of at least 95 %."""
    below = [sum(math.comb(count, k) for k in range(r + 1)) / 2 ** count for r in range(count)]
    low = max(bisect.bisect_right(below, 0.025) - 1, 0)
    return low, count - 1 - low


def summary(values, form):
    """Returns the median and its interval as a text."""
    values = sorted(values)
    low, high = interval_of_median(len(values))

    def text(value):
        return "infeasible" if math.isinf(value) else form.format(value)

    return f"{text(values[len(values) // 2])} [{text(values[low])}, {text(values[high])}]"


def read(paths):
    """Returns the points of each run, by problem, program and seed."""
    runs = collections.defaultdict(lambda: collections.defaultdict(lambda: collections.defaultdict(list)))
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for line in file:
                words = line.split()
                program = "PlacedPar" if words[0][0] in "zg" and words[0][-1].isdigit() else words.pop(0)
                values = [math.inf] if words[2] == "not" else [float(word) for word in words[2:]]
                runs[words[0]][program][words[1]].append(tuple(values))
    return runs


def main():
    runs = read(sys.argv[1:])
    if not runs:
        sys.exit(__doc__)
    for problem in sorted(runs):
        for program, seeds in sorted(runs[problem].items()):
            label = f"{problem}  {program:15} {len(seeds):3} seeds"
            if problem.startswith("zdt"):
                front = true_front(problem)
                print(label, " hypervolume", summary([hypervolume(run) for run in seeds.values()], "{:.4f}"), " IGD",
                      summary([igd(run, front) for run in seeds.values()], "{:.5f}"))
            else:
                print(label, " best", summary([min(run)[0] for run in seeds.values()], "{:.6g}"))


if __name__ == "__main__":
    main()
