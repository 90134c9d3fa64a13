"""Tests which facts the report of a run states, and which it omits."""

import json
import pathlib
import tempfile
import unittest

from program import EXAMPLES, placedpar

DEADLOCK = EXAMPLES / "csp/deadlock" / "ring.cfs"
ALONE = """T800 t;
process p, c;
use "csp.producer" for p;
use "csp.consumer" for c;
p (count = 5);
c (count = 5);
connect p.out to c.in;
place p on t;
place c on t;
"""
STARVED = """T800 (clock = 20M) a, b;
connect a.link[0] to b.link[0];
process c, p;
use "csp.consumer" for c;
use "csp.producer" for p;
p (count = 1);
connect p.out to c.in;
place c on a;
place p on a;
"""


class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def netlist(self, text):
        path = self.folder / "netlist.cfs"
        path.write_text(text, encoding="utf-8")
        return path

    def run_with_json(self, netlist):
        run = placedpar("run", netlist, "--json", self.folder / "report.json")
        return run, json.loads((self.folder / "report.json").read_text(encoding="utf-8"))

    def test_a_deadlock_has_no_end_that_parts_could_be_of(self):
        run, report = self.run_with_json(DEADLOCK)
        self.assertEqual(run.returncode, 2)
        for processor in report["processors"]:
            self.assertIsNone(processor["busy"])
            self.assertGreater(processor["busy_ps"], 0)
        for process in report["processes"]:
            self.assertIsNone(process["waiting"])
            self.assertIn("waits_since_ps", process)
        self.assertNotIn("%", run.stdout)

    def test_times_of_a_deadlock_are_in_units_that_suit_them(self):
        run, report = self.run_with_json(DEADLOCK)
        for process in report["processes"]:
            since = process["waits_since_ps"] / 1000
            self.assertIn(f"{process['name']}  t[{process['name'][-2]}]  for ever, from {since:.3f} ns on\n", run.stdout)
        run = placedpar("run", self.netlist(STARVED))
        self.assertEqual(run.returncode, 2)
        self.assertRegex(run.stdout, r"\nc +a +for ever, from \d+\.\d{3} us on\n")
        self.assertNotRegex(run.stdout, r"\b0\.000 ms|\d{4,} ps")

    def test_links_are_listed_where_one_carried_something(self):
        for text, listed in ((ALONE, False), (STARVED, False), (STARVED.replace("place p on a", "place p on b"), True)):
            self.assertEqual("\nlink " in placedpar("run", self.netlist(text)).stdout, listed)

    def test_what_there_is_one_of_is_counted_so(self):
        self.assertIn(": 1 processor, 0 connections, 2 processes, 1 channel; hash ",
                      placedpar("check", self.netlist(ALONE)).stdout)


if __name__ == "__main__":
    unittest.main()
