"""Tests the log of generations: a file with one value a row, a part of the report, bands over seeds."""

import csv
import io
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree

from program import CLUSTER, EXAMPLES, FIGURE_E2, PROGRAM, fingerprint, placedpar

COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
COLUMNS = ["seed", "generation", "time_ms", "process", "from", "quantity", "value"]


def rows_of(text):
    """Returns the rows of a log."""
    reader = csv.DictReader(io.StringIO(text))
    assert reader.fieldnames == COLUMNS
    return list(reader)


def values(rows, process, quantity):
    """Returns a quantity of a process, over the generations."""
    return [float(row["value"]) for row in rows if (row["process"], row["quantity"]) == (process, quantity)]


class Log(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def logged(self, *arguments):
        path = self.folder / "log.csv"
        run = placedpar("run", *arguments, "--log", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run, rows_of(path.read_text(encoding="ascii"))

    def test_every_generation_of_every_island(self):
        run, rows = self.logged(FIGURE_E2)
        masters = [f"master[{i}]" for i in range(4)]
        for process in masters + ["all"]:
            for quantity in ("best_so_far", "best", "mean", "diversity"):
                self.assertEqual([int(row["generation"]) for row in rows
                                  if (row["process"], row["quantity"]) == (process, quantity)], list(range(1, 81)))
        for process in masters:
            best = values(rows, process, "best")
            self.assertEqual(values(rows, process, "best_so_far"), [max(best[:g + 1]) for g in range(80)])
            self.assertRegex(run.stdout, rf"\n{process.replace('[', '.').replace(']', '.')} +best_fitness +{best[-1]:.6g}")
            self.assertTrue(all(0 <= each <= 1 for each in values(rows, process, "diversity")))
        self.assertEqual(values(rows, "all", "best"),
                         [max(each) for each in zip(*(values(rows, process, "best") for process in masters))])
        self.assertEqual(len(values(rows, "all", "fixation")), 80)
        self.assertGreater(values(rows, "all", "diversity_between")[0], values(rows, "all", "diversity_between")[-1])
        times = [float(row["time_ms"]) for row in rows if (row["process"], row["quantity"]) == ("all", "best")]
        self.assertEqual(times, sorted(times))
        self.assertGreater(times[0], 0)

    def test_who_came_from_where(self):
        _, rows = self.logged(FIGURE_E2)
        came = [row for row in rows if row["from"]]
        self.assertEqual(len(came), 4 * (80 // 3))
        for row in came:
            before = (int(row["process"][7]) - 1) % 4
            self.assertEqual((row["from"], row["quantity"]), (f"master[{before}]", "accepted"))
            self.assertEqual(int(row["generation"]) % 3, 0)

    def test_the_same_bytes_and_the_same_run(self):
        logged, _ = self.logged(FIGURE_E2)
        first = (self.folder / "log.csv").read_bytes()
        out = placedpar("run", FIGURE_E2, "--log", "-")
        self.assertEqual(out.stdout.encode(), first)
        self.assertIn("fingerprint: ", out.stderr)
        self.assertEqual(fingerprint(logged.stdout), fingerprint(placedpar("run", FIGURE_E2).stdout))

    def test_the_report_for_people_and_for_machines(self):
        report = self.folder / "report.json"
        run, rows = self.logged(FIGURE_E2, "--json", report)
        self.assertRegex(run.stdout, r"\nsearch +generations +best, first +last")
        self.assertRegex(run.stdout, r"\nmaster\[0\] +80 .* 26 +0\n")
        self.assertRegex(run.stdout, r"\nall +80 .* 104 +0\n")
        searches = json.loads(report.read_text(encoding="utf-8"))["searches"]
        self.assertEqual([each["process"] for each in searches], [f"master[{i}]" for i in range(4)] + ["all"])
        for each in searches:
            self.assertEqual(each["first"]["best"], values(rows, each["process"], "best")[0])
            self.assertEqual(each["last"]["mean"], values(rows, each["process"], "mean")[-1])
            self.assertEqual(each["last"]["diversity"], values(rows, each["process"], "diversity")[-1])

    def test_several_seeds(self):
        report = self.folder / "report.json"
        run, rows = self.logged(CLUSTER, "--seed", "5", "--seeds", "3", "--json", report)
        self.assertEqual(sorted({row["seed"] for row in rows}), ["5", "6", "7"])
        runs = json.loads(report.read_text(encoding="utf-8"))["runs"]
        self.assertEqual([each["manifest"]["seed"] for each in runs], [5, 6, 7])
        for each in runs:
            alone = placedpar("run", CLUSTER, "--seed", each["manifest"]["seed"])
            self.assertEqual(each["fingerprint"], fingerprint(alone.stdout))
            self.assertIn(each["fingerprint"], run.stdout)
        _, alone = self.logged(CLUSTER, "--seed", "6")
        self.assertEqual([row for row in rows if row["seed"] == "6"], alone)
        self.assertRegex(run.stdout, r"\nmaster +[-0-9.e]+ \[")

    def test_convergence_is_drawn(self):
        for seeds, words in ((1, {"fitness, seed 1", "best", "mean ↓ to -8.4e+04"}),
                             (4, {"fitness, medians and quartiles of 4 seeds", "in a population", "between them"})):
            svg = self.folder / f"{seeds}.svg"
            run = placedpar("run", FIGURE_E2, "--seeds", seeds, "--convergence", svg)
            self.assertEqual(run.returncode, 0, run.stderr)
            root = xml.etree.ElementTree.fromstring(svg.read_text(encoding="utf-8"))
            texts = {" ".join("".join(each.itertext()).split())
                     for each in root.iter("{http://www.w3.org/2000/svg}text")}
            self.assertLessEqual(words, texts)

    def test_what_cannot_be_logged_is_refused_before_the_run(self):
        path = self.folder / "file"
        for arguments, complaint in ((["--log", path], "no process of .* searches"),
                                     (["--convergence", path], "no process of .* searches"),
                                     (["--watch"], "no process of .* searches"),
                                     (["--seeds", "0"], "at least 1"), (["--seeds", "-1"], "not a whole number"),
                                     (["--seeds", "2", "--trace", f"{path}.json"], "a timeline shows one run"),
                                     (["--log", self.folder / "nowhere" / "log.csv"], "nowhere")):
            run = placedpar("run", COMMSTIME, *arguments)
            self.assertEqual((run.returncode, run.stdout), (1, ""), arguments)
            self.assertRegex(run.stderr, complaint)
        self.assertEqual(os.listdir(self.folder), [])
        self.assertIn("two outputs have the same file name", placedpar("run", CLUSTER, "--log", path, "--json", path).stderr)

    def test_a_run_that_is_stopped_logs_what_was(self):
        _, rows = self.logged(FIGURE_E2, "--until", "300ms")
        generations = len(values(rows, "all", "best"))
        self.assertTrue(5 < generations < 80)
        self.assertLessEqual(max(float(row["time_ms"]) for row in rows), 300)
        path = self.folder / "interrupted.csv"
        for moment in range(12): # some within a run, some between two runs
            with subprocess.Popen([PROGRAM, "run", CLUSTER, "--seeds", "100000", "--yes", "--log", path],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
                time.sleep(0.5 + 0.007 * moment)
                self.assertFalse(path.exists())
                run.send_signal(signal.SIGINT)
                output, errors = run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130, errors)
            self.assertRegex(output.splitlines()[0], r": \d+ of 100000 seeds, then interrupted$")
            self.assertTrue(rows_of(path.read_text(encoding="ascii")))
            path.unlink()


if __name__ == "__main__":
    unittest.main()
