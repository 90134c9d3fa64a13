"""Tests placedpar compare: what differs between two netlists or runs, and which difference changes the time."""

import os
import pathlib
import re
import tempfile
import unittest

from program import EXAMPLES, FIGURE_E2, placedpar

# A computes for 1000000 cycles and then sends a long message, so clock and linkspeed add up; `parts` multiplies both.
NETLIST = """
val cycles 1000000;
val parts 1;
T800 (clock = 20M, linkspeed = 20M) a, b;
process source, sink;
use "csp.producer" for source;
use "csp.consumer" for sink;
source (count = 1, cycles = cycles * parts, bytes = 40000 * parts);
sink (count = 1);
place source on a;
place sink on b;
connect source.out to sink.in;
connect a.link[0] to b.link[0];
"""


def milliseconds(output, what):
    """Returns the change that a row of the table states."""
    return float(re.search(rf"^ *([+-][\d.]+) .*{re.escape(what)}", output, re.MULTILINE).group(1))


class Compare(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.a = self.file("a.cfs", NETLIST)

    def file(self, name, text):
        path = pathlib.Path(self.folder.name, name)
        path.write_text(text)
        return path

    def compared(self, *arguments, code=0):
        run = placedpar("compare", *arguments, folder=self.folder.name)
        self.assertEqual((run.returncode, run.stderr), (code, ""), run.stdout)
        return run.stdout

    def time(self, path, *arguments):
        run = placedpar("run", path, *arguments)
        return float(re.search(r"completed at ([\d.]+) ms", run.stdout).group(1))

    def test_equal_netlists_differ_in_nothing(self):
        out = self.compared(FIGURE_E2, FIGURE_E2, "--set", "samples=5")
        self.assertIn("nothing in the netlists", out)
        self.assertIn("All measures of both runs are equal.", out)

    def test_each_difference_is_the_one_that_a_run_with_it_has(self):
        b = self.file("b.cfs", NETLIST.replace("clock = 20M, linkspeed = 20M", "clock = 10M, linkspeed = 10M"))
        out = self.compared(self.a, b)
        before = self.time(self.a)
        for name in ("clock", "linkspeed"):
            self.assertAlmostEqual(milliseconds(out, f"{name} of"), self.time(self.a, "--set", f"{name}=10000000") - before, 5)
        self.assertAlmostEqual(milliseconds(out, "  B"), self.time(b) - before, 5)
        self.assertIn("clock: 20000000 in A, 10000000 in B (2 elements)", out)
        self.assertIn("The differences add up", out)

    def test_differences_that_act_together_are_said_to_interact(self):
        out = self.compared(self.a, self.a, "--set-b", "cycles=3000000", "--set-b", "parts=3")
        alone = self.time(self.a)
        together = self.time(self.a, "--set", "cycles=3000000", "--set", "parts=3") - alone
        parts = self.time(self.a, "--set", "parts=3") - alone
        cycles = self.time(self.a, "--set", "cycles=3000000") - alone
        self.assertGreater(together, parts + cycles + 1)
        self.assertAlmostEqual(milliseconds(out, "the sum of these"), parts + cycles, 5)
        self.assertAlmostEqual(milliseconds(out, "ms remain: the differences interact"), together - parts - cycles, 5)
        self.assertNotIn("source.cycles", out) # follows from the vals

    def test_structure_is_compared_and_made_alone(self):
        b = self.file("b.cfs", NETLIST.replace("a, b;\nprocess", "a, b, c;\nprocess").replace("place sink on b", "place sink on c")
                      .replace("connect a.link[0] to b.link[0];", "connect a.link[0] to b.link[0];\nconnect b.link[1] to c.link[0];"))
        out = self.compared(self.a, b)
        self.assertIn("hardware: 2 only in B: T800 c, b.link[1] to c.link[0]", out)
        self.assertIn("sink on b", out)
        self.assertAlmostEqual(milliseconds(out, "the hardware of B"), 0, 5)
        self.assertRegex(out, r"not alone +the mapping of B: this does not fit the rest of A: the name \"c\" is undefined\n")
        self.assertIn("differences that could not be applied alone", out)

    def test_vals_are_read_as_the_language_reads_them(self):
        def machine(name, cycles, parts, text):
            return self.file(name, NETLIST.replace("val cycles 1000000;\nval parts 1;", f"""
                val cycles {cycles}; val\tparts
                  {parts};
                val title "{text}; a title";
                /*
                val cycles 7;
                */"""))
        out = self.compared(machine("a3.cfs", 1000000, 1, "A"), machine("b3.cfs", 3000000, 3, "B"))
        self.assertIn("  val cycles: 1000000 in A, 3000000 in B\n", out)
        self.assertIn("  val parts: 1 in A, 3 in B\n", out)
        self.assertIn('  val title: "A; a title" in A, "B; a title" in B\n', out)

    def test_a_section_of_b_leaves_the_settings_of_a(self):
        b = self.file("b.cfs", NETLIST.replace("clock = 20M", "clock = 10M").replace("a, b;\nprocess", "a, b, c;\nprocess")
                      .replace("connect a.link[0] to b.link[0];", "connect a.link[0] to b.link[0];\nconnect b.link[1] to c.link[0];"))
        out = self.compared(self.a, b)
        difference = self.time(b) - self.time(self.a)
        self.assertGreater(difference, 1)
        self.assertAlmostEqual(milliseconds(out, "the hardware of B"), 0, 5)
        self.assertAlmostEqual(milliseconds(out, "the sum of these"), difference, 5)
        self.assertIn("The differences add up", out)

    def test_a_setting_is_made_alone_in_the_elements_that_a_has(self):
        def machine(name, count, clock):
            return self.file(name, NETLIST + f"val extra {count};\nT800 (clock = {clock}) c[extra];\n"
                             "rep i = 0 for extra\n    connect b.link[i + 1] to c[i].link[0];\n")
        out = self.compared(machine("a3.cfs", 1, "20M"), machine("b3.cfs", 2, "10M"))
        self.assertIn("  clock of c[0]: 20000000 in A, 10000000 in B\n", out)
        self.assertNotIn("not alone", out)

    def test_differences_add_up_only_if_all_could_be_made_alone(self):
        b = self.file("b.cfs", NETLIST + 'process idle;\nuse "csp.task" for idle;\nidle (cycles = 1);\nplace idle on b;\n')
        out = self.compared(self.a, b)
        self.assertIn("not alone  the mapping of B", out)
        self.assertNotIn("add up", out)
        self.assertIn("differences that could not be applied alone", out)

    def test_another_wiring_takes_its_time(self):
        chain = NETLIST.replace("a, b;\nprocess", "a, b, c;\nprocess")
        a = self.file("a3.cfs", chain.replace("connect a.link[0]", "connect b.link[1] to c.link[0];\nconnect a.link[0]"))
        b = self.file("b3.cfs", chain.replace("connect a.link[0] to b.link[0];", "connect a.link[0] to c.link[1];\nconnect b.link[1] to c.link[0];"))
        out = self.compared(a, b)
        self.assertAlmostEqual(milliseconds(out, "the hardware of B"), self.time(b) - self.time(a), 5)
        self.assertGreater(self.time(b) - self.time(a), 1)

    def test_two_runs_are_compared_by_their_reports(self):
        for name, options in (("a", ()), ("b", ("--set", "clock=10M", "--seed", "2"))):
            placedpar("run", self.a, *options, "--json", os.path.join(self.folder.name, f"{name}.json"))
        out = self.compared("a.json", "b.json")
        self.assertIn("clock: 20000000 in A, 10000000 in B", out)
        self.assertIn("seed: 1 in A, 2 in B", out)
        self.assertIn("sink.time [ms]", out)

    def test_options_without_effect_on_reports_are_refused(self):
        placedpar("run", self.a, "--json", os.path.join(self.folder.name, "a.json"))
        self.compared("a.json", "a.cfs", "--seed", "2", "--set", "cycles=5")
        for options, files in ((("--set-b", "clock=10M"), ("a.cfs", "a.json")), (("--seed", "2"), ("a.json", "a.json")),
                               (("--set", "cycles=5"), ("a.json", "a.json")), (("-I", "."), ("a.json", "a.json"))):
            run = placedpar("compare", *files, *options, folder=self.folder.name)
            self.assertEqual(run.returncode, 1, options)
            self.assertIn(f"{options[0]} has no effect on a", run.stderr)

    def test_a_tolerance_is_a_finite_number_of_at_least_0(self):
        for tolerance in ("-1", "nan", "inf", "x"):
            run = placedpar("compare", self.a, self.a, f"--tolerance={tolerance}")
            self.assertEqual(run.returncode, 1)
            self.assertIn(f'"{tolerance}" is not a percentage', run.stderr)

    def test_a_netlist_that_has_changed_since_the_run_is_told(self):
        placedpar("run", self.a, "--json", os.path.join(self.folder.name, "a.json"))
        self.file("a.cfs", NETLIST.replace("1000000", "2000000"))
        run = placedpar("compare", "a.json", "a.cfs", folder=self.folder.name)
        self.assertEqual(run.returncode, 0)
        self.assertIn("a.json: warning: ", run.stderr)
        self.assertIn("has changed since this run", run.stderr)

    def test_exit_codes(self):
        self.compared(self.a, self.a, "--set-b", "clock=10M", "--tolerance", "10", code=3)
        self.compared(self.a, self.a, "--set-b", "clock=10M", "--tolerance", "200")
        self.assertEqual(placedpar("compare", self.a, "nowhere.cfs").returncode, 1)
        self.assertEqual(placedpar("compare", self.a, self.a, "--set-b", "colour=3").returncode, 1)
        self.assertIn("No difference was applied alone",
                      self.compared(self.a, self.file("stuck.cfs", NETLIST.replace("sink (count = 1)", "sink (count = 2)")), code=2))

    def test_a_file_that_is_not_a_report_is_refused(self):
        not_a_report = "bad.json: expected a report that placedpar run --json wrote"
        for text, message in (("", not_a_report), ("{", not_a_report), ("[]", not_a_report), ('{"manifest": 3}', not_a_report),
                              ('{"manifest": {"netlist": 3}}', not_a_report), ("[\n" * 100000, not_a_report),
                              ("[" * 100000, "bad.json:1:10001: error: the line is too long")):
            self.file("bad.json", text)
            run = placedpar("compare", "bad.json", self.a, folder=self.folder.name)
            self.assertEqual(run.returncode, 1, text[:40])
            self.assertIn(message, run.stderr)

    def test_every_example_can_be_compared_with_itself(self):
        for name in ("busy-bus/busy-bus", "crossbar-at-run-time/one-link", "faults-of-a-machine/stream", "figure-d1/figure-d1",
                     "figure-d1/figure-e2-on-d1", "figure-d1/sensor-to-alarm"):
            path = EXAMPLES / f"machine/{name}.cfs"
            self.assertIn("nothing in the netlists", self.compared(path, path))


if __name__ == "__main__":
    unittest.main()
