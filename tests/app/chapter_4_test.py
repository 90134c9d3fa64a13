"""Tests that the studies beside chapter 4's netlists give the same figures as its replays."""

import csv
import json
import pathlib
import tempfile
import unittest

from program import EXAMPLES, placedpar

SECONDS = 0.4  # length of the transient of section 4.4, in which it breeds 100 generations
GENERATIONS = 100


class Chapter4(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def done(self, *arguments):
        run = placedpar(*arguments, folder=self.folder)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def rows(self, name):
        """Returns the rows of a study's table; the measured value is "figure"."""
        study = EXAMPLES / f"{name}.toml"
        self.done("sweep", study)
        self.done("report", study, "--csv", "table.csv")
        with open(self.folder / "table.csv", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        mean = next(head for head in rows[0] if head.endswith(" mean"))
        return [{**row, "figure": float(row[mean])} for row in rows]

    def cells(self, experiment):
        """Returns the simulated figures by reading, row and column."""
        self.done("replay", experiment, "--json", "cells.json")
        document = json.loads((self.folder / "cells.json").read_text(encoding="utf-8"))
        return {(part["reading"], cell["row"], cell["column"]): cell["simulated"]
                for part in [document, *document["other_readings"]] for cell in part["cells"]}

    def assert_same(self, found, known, row):
        self.assertAlmostEqual(found / known, 1, 9, row)

    def test_speedup_with_and_without_a_pipeline(self):
        cells = self.cells("figures-4-6-4-7")
        rows = [row for row in self.rows("explore/pipeline/pipeline") if row["processors"] != "1"]
        self.assertEqual(len(rows), 60)
        for row in rows:
            organisation = {"1": "not pipelined", "2": "pipelined"}[row["populations"]]
            self.assert_same(row["figure"], cells[f"on T800s in a chain, {organisation}",
                                                  f"{row['processors']} processors", f"alpha = {row['alpha']}"], row)

    def test_speedup_of_both_architectures(self):
        cells = self.cells("architectures")
        rows = self.rows("explore/architectures/architectures")
        self.assertEqual(len(rows), 51)
        for row in rows:
            self.assert_same(row["figure"], cells["speedup on T800s", f"{row['architecture']}, {row['processors']} "
                                                  "processors", f"alpha = {row['alpha']}"], row)

    def test_a_transient_in_time(self):
        cells = self.cells("real-time")
        simulated = {row: seconds for (_, row, _), seconds in cells.items()}
        rates = {(row["islands"], row["processors"], row["calls"], row["clock"]): row["figure"]
                 for row in self.rows("explore/architectures/in-time")}
        self.assertEqual(len(rates), 24)
        for machine, row in ((("4", "16", "201", "20M"), "16 T800: 4 islands of 30, 3 slaves each"),
                             (("4", "16", "0", "20M"), "16 T800: occam's channels, no library"),
                             (("8", "16", "201", "20M"), "16 T800: 8 islands of 15, one slave each"),
                             (("4", "32", "201", "20M"), "32 T800: 4 islands of 30, 7 slaves each"),
                             (("8", "32", "201", "20M"), "32 T800: 8 islands of 15, 3 slaves each"),
                             (("8", "64", "201", "20M"), "64 T800: 8 islands of 15, 7 slaves each"),
                             (("8", "64", "0", "20M"), "64 T800: 8 islands, 7 slaves, occam's channels")):
            self.assert_same(GENERATIONS / rates[machine], simulated[row], row)
        in_time = {machine for machine, rate in rates.items() if GENERATIONS / rate <= SECONDS}
        self.assertEqual(in_time, {("8", "64", "0", "20M"), ("8", "32", "0", "30M"), ("8", "64", "0", "30M"),
                                   ("8", "32", "201", "30M"), ("8", "64", "201", "30M")})


if __name__ == "__main__":
    unittest.main()
