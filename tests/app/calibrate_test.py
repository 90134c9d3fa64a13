"""Tests `placedpar calibrate`, and predictions of native runs by what it has measured."""

import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest

from native_ranks_test import start
from program import EXAMPLES, PROGRAM, placedpar
from ranks_test import MODULE, MPIRUN

ISLANDS = EXAMPLES / "native" / "islands.cfs"
CLUSTER = EXAMPLES / "native" / "cluster.inc"
FEW = ("--repetitions", "6")


def populations(run):
    return re.findall(r"(\S+) +populations +(\w+)", run.stdout)


class Calibrate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.here = cls.folder / "here.inc"
        run = placedpar("calibrate", ISLANDS, *FEW, "-o", cls.here)
        if run.returncode != 0:
            raise AssertionError(run.stdout + run.stderr)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def val(self, name):
        return int(re.search(rf"^val {name} (\d+);", self.here.read_text(encoding="utf-8"), re.MULTILINE)[1])

    def test_writes_an_include_for_netlists(self):
        netlist = self.folder / "of_cores.cfs"
        netlist.write_text('#include "here.inc"\nthis_core c[2];\nthis_memory m;\n'
                           "rep i = 0 for 2 connect c[i].bus[0] to m.slot[i + 1];\n", encoding="utf-8")
        self.assertEqual(placedpar("check", netlist).returncode, 0)
        text = self.here.read_text(encoding="utf-8")
        self.assertIn("the median of 6 measurements", text)
        self.assertGreater(self.val("error_costly_work_30"), 0)
        self.assertGreater(self.val("individual_costly_work_30"), 0)

    def test_more_work_costs_more(self):
        run = placedpar("calibrate", "--problem", "costly(work = 30)", "--problem", "costly(work = 3000)", *FEW)
        few, many = (int(re.search(rf"val error_costly_work_{work} (\d+);", run.stdout)[1]) for work in (30, 3000))
        self.assertGreater(many, 30 * few)

    def test_predicts_the_generations_of_the_native_run(self):
        predicted = placedpar("run", ISLANDS, "--predict", self.here, "--threads", 2)
        self.assertRegex(predicted.stdout, r"islands.cfs: completed at [\d.]+ ms\n")
        self.assertIn("thread[1]  core", predicted.stdout)
        self.assertEqual(populations(predicted), populations(placedpar("run", ISLANDS, "--native", "--threads", 2)))
        self.assertEqual(len(populations(predicted)), 4)

    def test_a_netlist_of_transputers_is_predicted_too(self):
        netlist = EXAMPLES / "genetic/islands/islands.cfs"
        run = placedpar("calibrate", netlist, *FEW, "-o", self.folder / "boom.inc")
        self.assertEqual(run.returncode, 0, run.stderr)
        predicted = placedpar("run", netlist, "--predict", self.folder / "boom.inc", "--threads", 2)
        self.assertEqual(populations(predicted), populations(placedpar("run", netlist)))

    def test_the_predicted_netlist_can_be_shown_and_run(self):
        shown = placedpar("show", ISLANDS, "--predict", self.here, "--threads", 2, "-o", self.folder / "predicted.cfs")
        self.assertEqual(shown.returncode, 0, shown.stderr)
        times = [re.search(r"completed at (.*)", placedpar("run", *arguments).stdout)[1]
                 for arguments in ((self.folder / "predicted.cfs",), (ISLANDS, "--predict", self.here, "--threads", 2))]
        self.assertEqual(*times)

    def test_explain_says_what_more_threads_would_bring(self):
        run = placedpar("explain", ISLANDS, "--predict", self.here, "--threads", 2, "--no-what-if")
        table = re.findall(r"^ +(\d+) +([\d.]+) (\w+)$", run.stdout.split("predicted time")[1], re.MULTILINE)
        self.assertEqual([row[0] for row in table], ["1", "2", "3", "4"])
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_ranks_are_predicted_and_explained_beside_threads(self):
        ranks = placedpar("run", ISLANDS, "--predict", CLUSTER, "--ranks", 2, "--set", "problem=costly(work = 300)")
        self.assertRegex(ranks.stdout, r"rank\[1\] +core")
        threads = placedpar("run", ISLANDS, "--native", "--threads", 2, "--set", "problem=costly(work = 300)")
        self.assertEqual(populations(ranks), populations(threads))
        explained = placedpar("explain", ISLANDS, "--predict", CLUSTER, "--ranks", 2, "--no-what-if", "--set", "problem=costly(work = 300)")
        self.assertIn("  ranks  predicted time\n", explained.stdout)
        self.assertNotIn("threads  predicted time", explained.stdout)  # cluster.inc has no threads

    @unittest.skipUnless(MPIRUN and MODULE.exists(), "built without MPI")
    def test_mpirun_measures_between_ranks(self):
        both = self.folder / "both.inc"
        with start(2, "calibrate", ISLANDS, *FEW, "-o", both) as mpirun:
            _, errors = mpirun.communicate(timeout=60)
        self.assertEqual(mpirun.returncode, 0, errors)
        text = both.read_text(encoding="utf-8")
        between = [float(each) for each in re.findall(r"between two (?:thread|rank)s that are awake +([\d.]+)", text)]
        self.assertEqual(len(between), 2)
        self.assertIn(") this_rank;", text)
        for places in ("--threads", "--ranks"):
            run = placedpar("run", ISLANDS, "--predict", both, places, 2)
            self.assertEqual(populations(run), populations(placedpar("run", ISLANDS)), run.stderr)
        explained = placedpar("explain", ISLANDS, "--predict", both, "--threads", 2, "--no-what-if").stdout
        self.assertIn("threads  predicted time\n", explained)
        self.assertIn("  ranks  predicted time\n", explained)

    @unittest.skipUnless(MPIRUN and MODULE.exists(), "built without MPI")
    def test_more_than_two_ranks_and_wrong_input_are_reported_once(self):
        for ranks, arguments, message in ((3, (ISLANDS,), "mpirun -n 2 placedpar calibrate"), (2, ("nothing.cfs",), "nothing.cfs"),
                                          (2, ("--problem", "nothing"), "unknown search problem 'nothing'")):
            with self.subTest(arguments=arguments), start(ranks, "calibrate", *FEW, *arguments) as mpirun:
                _, errors = mpirun.communicate(timeout=60)
                self.assertEqual(mpirun.returncode, 1)
                self.assertEqual(errors.count(message), 1, errors)

    def test_refusals(self):
        for arguments, message in (
                (("calibrate", "--problem", "nothing"), "unknown search problem 'nothing'"),
                (("calibrate", "--repetitions", "5"), "5"),
                (("calibrate", *FEW, "-o", "/no/such/folder/here.inc"), "/no/such/folder"),
                (("calibrate", "nothing.cfs"), "nothing.cfs"),
                (("run", ISLANDS, "--predict", "nothing.inc"), "placedpar: nothing.inc: this file does not exist\n"),
                (("run", ISLANDS, "--predict", ISLANDS), "the file does not describe a computer"),
                (("run", ISLANDS, "--predict", self.here, "--native"), "leave out --native, or --predict"),
                (("run", ISLANDS, "--predict", self.here, "--set", "problem=sphere"), 'no cost of the problem "sphere"'),
                (("run", ISLANDS, "--threads", "2"), "--threads is for native runs"),
                (("run", ISLANDS, "--predict", self.here, "--ranks", "2"), "write it by mpirun -n 2 placedpar calibrate"),
                (("run", ISLANDS, "--predict", self.here, "--ranks", "2", "--threads", "2"), "give one of them"),
                (("run", ISLANDS, "--predict", CLUSTER, "--ranks", "5"), "there are 5 ranks, but only 4 processors have processes"),
                (("run", ISLANDS, "--ranks", "2"), "--ranks requires --predict"),
        ):
            with self.subTest(arguments=arguments):
                run = placedpar(*arguments)
                self.assertNotEqual(run.returncode, 0)
                self.assertIn(message, run.stderr)

    def test_an_interruption_writes_nothing(self):
        out = self.folder / "interrupted.inc"
        with subprocess.Popen([PROGRAM, "calibrate", "--repetitions", "1000", "-o", str(out)],
                              stderr=subprocess.DEVNULL) as process:
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=30), 130)
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
