"""Tests that a report's rows are in the order of the netlist's declarations."""

import json
import pathlib
import re
import tempfile
import unittest

from program import placedpar

# This order is neither alphabetical nor that of completion: z[0] ends last.
NETLIST = """
val n 12;
T800 z, b, a;
connect b.link[0] to z.link[1];
connect a.link[0] to b.link[1];
process (interface (output out)) m, k[n], d;
process (interface (input in)) y[n], e, c;
use "csp.producer" for m; use "csp.producer" for k; use "csp.producer" for d;
use "csp.consumer" for y; use "csp.consumer" for e; use "csp.consumer" for c;
rep i = 0 for n { connect k[n - 1 - i].out to y[n - 1 - i].in; }
connect m.out to e.in;
connect d.out to c.in;
rep i = 0 for n { k[i] (count = 5 * (n - i)); y[i] (count = 5 * (n - i) + MORE); place k[i] on b; place y[i] on b; }
m (count = 200); e (count = 200 + MORE); d (count = 1); c (count = 1 + MORE);
place m on b; place d on a; place e on z; place c on b;
"""
NAMES = ["m", *(f"k[{i}]" for i in range(12)), "d", *(f"y[{i}]" for i in range(12)), "e", "c"]
CHANNELS = [*(f"k[{i}].out -> y[{i}].in" for i in reversed(range(12))), "m.out -> e.in", "d.out -> c.in"]


def in_order(found, declared):
    """Returns each found name once, in the order of declaration."""
    once = list(dict.fromkeys(found))
    return once == [name for name in declared if name in once]


class Order(unittest.TestCase):
    def reports(self, more, code):
        """Returns the text's tables by their first words, and the JSON report."""
        with tempfile.TemporaryDirectory() as folder:
            netlist, result = pathlib.Path(folder, "order.cfs"), pathlib.Path(folder, "order.json")
            netlist.write_text(NETLIST.replace("MORE", str(more)), encoding="utf-8")
            run = placedpar("run", netlist, "--json", result)
            self.assertEqual(run.returncode, code, run.stderr)
            found = json.loads(result.read_text(encoding="utf-8"))
        tables = {}
        for part in run.stdout.split("\n\n"):
            lines = part.strip().splitlines()
            tables[" ".join(lines[0].split()[:2])] = [re.split(r"  +", line)[0] for line in lines[1:]]
        return tables, found

    def test_of_what_processes_measure(self):
        tables, found = self.reports(0, 0)
        measuring = tables["process measured"]
        self.assertGreater(len(set(measuring)), 12)
        self.assertTrue(in_order(measuring, NAMES), measuring)
        self.assertEqual([each["process"] for each in found["measurements"]], measuring)
        self.assertEqual([each["name"] for each in found["processes"]], NAMES)
        self.assertEqual(tables["process on"], NAMES)
        self.assertEqual([each["name"] for each in found["processors"]], ["z", "b", "a"])
        self.assertEqual(tables["processor type"], ["z", "b", "a"])
        links = [each["from"] + " -> " + each["to"] for each in found["links"] if each["bytes"] > 0]
        self.assertEqual(links, ["b.link[0] -> z.link[1]", "a.link[0] -> b.link[1]"])
        self.assertEqual(tables["link bytes"], links)

    def test_of_a_deadlock(self):
        tables, found = self.reports(1, 2)
        self.assertEqual(tables["channel outputter"], CHANNELS)
        self.assertEqual([each["channel"] for each in found["deadlock"]["channels"]], CHANNELS)
        stuck = tables["process operation"]
        self.assertGreater(len(stuck), 12)
        self.assertTrue(in_order(stuck, NAMES), stuck)
        self.assertEqual([each["process"] for each in found["deadlock"]["processes"]], stuck)


if __name__ == "__main__":
    unittest.main()
