"""Tests placedpar report: a study as a table, a plot and a page."""

import json
import unittest

from program import FIGURE_E2, placedpar
from sweep_test import InFolder, rows


class Report(InFolder):
    def setUp(self):
        super().setUp()
        self.sweep(FIGURE_E2, "slaves=0,2,10", "master.trials=10", "--seeds", 3, "--measure", "max(master.best_fitness)")

    def test_means_and_intervals(self):
        found = [values for name, values in sorted(self.best().items())]
        self.assertEqual(len(found), 3)
        lines = self.report("figure-e2.cfs", "--csv", "table.csv").splitlines()
        self.assertIn("all with master.trials = 10", lines)
        header, *table = [line.split(",") for line in (self.folder / "table.csv").read_text().splitlines()]
        self.assertEqual(header[:4], ["slaves", "runs", "ended", "max(master.best_fitness) mean"])
        self.assertEqual([row[0] for row in table], ["0", "2", "10"]) # in numerical order
        for row in table:
            values = self.best()[row[0]]
            mean = sum(values) / 3
            deviation = (sum((value - mean) ** 2 for value in values) / 2) ** 0.5
            self.assertAlmostEqual(float(row[3]), mean)
            self.assertAlmostEqual(float(row[4]), 4.302652729911275 * deviation / 3 ** 0.5)
            self.assertEqual([float(row[5]), float(row[6])], [min(values), max(values)])

    def test_a_row_for_each_run(self):
        shown = self.report("figure-e2.cfs", "--csv", "runs.csv", "--runs")
        self.assertIn("Kruskal-Wallis", shown)
        header, *table = [line.split(",") for line in (self.folder / "runs.csv").read_text().splitlines()]
        self.assertEqual(header, ["slaves", "master.trials", "seed", "ended", "max(master.best_fitness)"])
        self.assertEqual([row[:4] for row in table],
                         [[slaves, "10", seed, "completed"] for slaves in ("0", "2", "10") for seed in "123"])
        self.assertEqual([float(row[4]) for row in table], sum((self.best()[slaves] for slaves in ("0", "2", "10")), []))

    def best(self):
        found = {}
        for row in rows(self.folder / "figure-e2.sqlite"):
            values = [figure[0] for name, figure in json.loads(row[8]).items() if name.endswith(".best_fitness")]
            found.setdefault(json.loads(row[0])["slaves"], []).append(max(values))
        return found

    def test_a_measure_that_was_not_asked_for_is_there(self):
        self.assertRegex(self.report("figure-e2.sqlite", "--measure", "master.T_exe", "--measure", "processors"),
                         r"(?s)slaves  runs  master.T_exe \[ms\]  +95 %  processors  +95 %\n +0  .* 10 +3 .* 44 ")

    def test_figures_relative_to_those_of_other_runs(self):
        self.report("figure-e2.cfs", "--relative-to", "slaves=2", "--csv", "table.csv")
        header, *table = [line.split(",") for line in (self.folder / "table.csv").read_text().splitlines()]
        self.assertEqual(header[3], "relative max(master.best_fitness) mean")
        best = self.best()
        for row in table:  # each divided by the value of the same seed
            ratios = [one / other for one, other in zip(best[row[0]], best["2"])]
            self.assertAlmostEqual(float(row[3]), sum(ratios) / 3, 12)
            self.assertEqual([float(row[5]), float(row[6])], [min(ratios), max(ratios)])
        self.assertEqual(table[1][3:], ["1", "0", "1", "1"])

    def test_a_page_of_single_runs_has_no_intervals(self):
        for seeds, shown in ((1, False), (2, True)):
            self.sweep(FIGURE_E2, "slaves=0,2", "--seeds", seeds, "--results", "kept")
            self.report("kept", "--page", "page.html")
            page = (self.folder / "page.html").read_text(encoding="utf-8")
            self.assertEqual(("Intervals" in page, "95 %" in page), (shown, shown))

    def test_a_page_that_needs_no_other_file(self):
        self.report("figure-e2.cfs", "--page", "page.html", "--svg", "plot.svg")
        page = (self.folder / "page.html").read_text(encoding="utf-8")
        for part in ("<svg", "<td>10</td>", "master.trials = 10", "</html>"):
            self.assertIn(part, page)
        for outside in ("http:", "https:", "src=", "<link", "@import", "url(h"):
            self.assertNotIn(outside, page.replace('"http://www.w3.org/2000/svg"', "").replace('"http://www.w3.org/1999/xlink"', ""))
        self.assertIn("<svg", (self.folder / "plot.svg").read_text(encoding="utf-8"))

    def test_the_study_is_not_written_over(self):
        study = self.study(f'netlist = "{FIGURE_E2}"\n[set]\nslaves = [0, 2]\n', "figure-e2.toml")
        text = (self.folder / study).read_text(encoding="utf-8")
        done = placedpar("report", study, "--csv", study, folder=self.folder)
        self.assertIn("figure-e2.toml: cannot be written: the output file is also the input", done.stderr)
        self.assertEqual((self.folder / study).read_text(encoding="utf-8"), text)

    def test_what_cannot_be_drawn(self):
        done = placedpar("report", "figure-e2.sqlite", "--svg", "a.svg", "--over", "linkspeed", folder=self.folder)
        self.assertIn('"linkspeed" does not have several values in this study', done.stderr)

    def test_what_no_run_has_is_refused(self):
        for arguments, message in (
                (["--measure", "master.T_ex"], 'unknown measure "master.T_ex"; did you mean "master.T_exe"?'),
                (["--runs"], "--runs writes a row for each run as comma-separated values: add --csv FILE"),
                (["--over", "slaves"], "--over names the horizontal axis of a plot, but no plot is drawn")):
            with self.subTest(arguments=arguments):
                done = placedpar("report", "figure-e2.sqlite", *arguments, folder=self.folder)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertIn(message, done.stderr)


if __name__ == "__main__":
    unittest.main()
