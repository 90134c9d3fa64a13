"""Tests the counts of the study of false misses."""

import contextlib
import io
import unittest

import false_misses

TOLERANCE = {"simulated": 5, "known": 4, "thesis": None, "tolerance": 1, "tolerance_percent": 25, "row": "r",
             "column": "c"}


class Misses(unittest.TestCase):
    def test_a_cell_misses_beyond_its_tolerance(self):
        self.assertFalse(false_misses.misses(TOLERANCE))
        self.assertTrue(false_misses.misses({**TOLERANCE, "simulated": 5.1}))
        self.assertTrue(false_misses.misses({**TOLERANCE, "simulated": float("nan")}))

    def test_a_cell_with_bounds_is_judged_by_them_alone(self):
        self.assertFalse(false_misses.misses({**TOLERANCE, "simulated": 9, "at_least": 3}))
        self.assertTrue(false_misses.misses({**TOLERANCE, "simulated": 9, "at_most": 8}))

    def test_a_cell_without_tolerance_is_not_judged(self):
        self.assertFalse(false_misses.misses({"simulated": 9, "tolerance_percent": None, "error_percent": None}))
        self.assertTrue(false_misses.misses({"simulated": 9, "tolerance_percent": 10, "error_percent": -11}))

    def test_tables_that_are_not_judged_do_not_count(self):
        missed = {**TOLERANCE, "simulated": 9}
        record = {"reading": "first: so", "cells": [missed],
                  "other_readings": [{"reading": "other", "judged": False, "cells": [missed]}]}
        self.assertEqual(false_misses.missed_cells(record), [("first", "r", "c")])


class Rate(unittest.TestCase):
    def test_the_probability_of_misses(self):
        self.assertAlmostEqual(false_misses.at_least(0, 60, 0.01), 1)
        self.assertAlmostEqual(false_misses.at_least(1, 2, 0.5), 0.75)

    def test_three_of_sixty_can_be_chance_and_four_cannot(self):
        for missed, expected in ((3, True), (4, False)):
            cells = {seed: [("t", "r", "c")] if seed < missed else [] for seed in range(60)}
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                self.assertEqual(false_misses.report("name", cells), expected)
            self.assertIn(f"{missed} times: r, c (t)", printed.getvalue())


if __name__ == "__main__":
    unittest.main()
