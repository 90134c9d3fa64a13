"""Tests placedpar front: fronts of problems with several objectives."""

import csv
import io
import pathlib
import tempfile
import unittest

from program import placedpar

ZDT1 = "zdt1(dimensions = 5)"


class Front(unittest.TestCase):
    def found(self, *arguments):
        run = placedpar("front", *arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(io.StringIO(run.stdout))]

    def test_the_front_of_zdt1_is_near_the_known_one(self):
        rows = self.found(ZDT1, "--population", 40, "--generations", 100)
        self.assertEqual((list(rows[0]), len(rows)), (["f_1", "f_2", "x_1", "x_2", "x_3", "x_4", "x_5"], 40))
        self.assertLess(max(row["f_2"] - (1 - row["f_1"] ** 0.5) for row in rows), 0.05)
        self.assertLess(rows[0]["f_1"], 0.01)
        self.assertGreater(rows[-1]["f_1"], 0.99)
        self.assertTrue(all(row["f_1"] == row["x_1"] for row in rows))

    def test_seed_and_coding_decide(self):
        settings = ("--population", 10, "--generations", 5)
        rows = self.found(ZDT1, *settings)
        self.assertEqual(self.found(ZDT1, *settings, "--seed", 1, "--coding", "real"), rows)
        self.assertNotEqual(self.found(ZDT1, *settings, "--seed", 2), rows)
        self.assertNotEqual(self.found(ZDT1, *settings, "--coding", "gray"), rows)

    def test_a_plot_shows_the_individuals(self):
        with tempfile.TemporaryDirectory() as folder:
            plot, table = pathlib.Path(folder, "front.svg"), pathlib.Path(folder, "front.csv")
            self.assertEqual(self.found(ZDT1, "--population", 10, "--generations", 5, "--svg", plot, "-o", table), [])
            self.assertIn(f"front of {len(table.read_text().splitlines()) - 1}<", plot.read_text())

    def test_one_objective_has_a_front_of_one_and_infeasible_problems_none(self):
        rows = self.found("g06", "--generations", 100, "--population", 20)
        self.assertEqual((len(rows), list(rows[0])), (1, ["objective", "x_1", "x_2"]))
        none = placedpar("front", "g05", "--generations", 1, "--population", 2)
        self.assertEqual((none.returncode, none.stdout), (0, "objective,x_1,x_2,x_3,x_4\n"))
        self.assertRegex(none.stderr, r"^warning: no individual is feasible; the least violation of the constraints is \d")

    def test_refusals_say_what_would_be_right(self):
        for message, arguments in (('did you mean "zdt1"', ["zdt0"]),
                                   ("a problem with a record has no front", ["boom", "--coding", "natural"]),
                                   ("--svg draws the front of a problem with two objectives, but g06 has 1", ["g06", "--svg", "plot.svg"]),
                                   ("--generations", [ZDT1, "--generations", 0])):
            run = placedpar("front", *arguments)
            self.assertEqual(run.returncode, 1, run.stdout)
            self.assertIn(message, run.stderr)

    def test_a_netlist_names_the_command(self):
        run = placedpar("generate", "ring", "--size", 4, "--problem", ZDT1)
        self.assertEqual(run.returncode, 1)
        self.assertIn(f"front '{ZDT1}' finds the front; in Python, search_front() finds it", run.stderr)


if __name__ == "__main__":
    unittest.main()
