"""Tests the reports of networks in which processes and programs in a transputer's own code exchange messages."""

import collections
import json
import pathlib
import tempfile
import unittest

from program import EXAMPLES, placedpar


class OwnCode(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        example = EXAMPLES / "transputer" / "mixed"
        self.assertEqual(placedpar("assemble", example / "sum.tas", "-o", self.folder / "sum.btl").returncode, 0)
        self.netlist = self.folder / "mixed.cfs"
        self.netlist.write_bytes((example / "mixed.cfs").read_bytes())

    def test_processes_and_a_program_exchange_messages(self):
        report, trace, page = (self.folder / name for name in ("report.json", "trace.json", "page.html"))
        plain = placedpar("run", self.netlist)
        done = placedpar("run", self.netlist, "--json", report, "--trace", trace, "--page", page)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, plain.stdout)
        self.assertRegex(done.stdout, r"last_number +45\n")
        self.assertIn("root -&gt; consumer.in", page.read_text(encoding="utf-8"))
        self.assertEqual(json.loads(report.read_text(encoding="utf-8"))["outcome"], "completed")
        events = json.loads(trace.read_text(encoding="utf-8"))["traceEvents"]
        carried = collections.Counter()
        for event in events:
            if event.get("cat") == "link":
                carried[event["name"]] += event["args"]["bytes"]
        self.assertEqual(carried, {"producer.out -> root": 40, "root -> consumer.in": 40})
        waits = [event for event in events if event.get("cat") == "wait"]
        self.assertEqual(len(waits), 20)
        self.assertEqual({event["args"]["partner"] for event in waits}, {"root"})

    def test_explain_says_that_processes_wait_for_a_program(self):
        done = placedpar("explain", self.netlist)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\nconsumer .*  root \(0\.0")
        self.assertRegex(done.stdout, r"\nproducer .*  root \(0\.0")

    def test_a_process_and_a_program_that_wait_for_each_other_are_named(self):
        done = placedpar("run", self.netlist, "--set", "numbers=11")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stdout, r"\nproducer.out -> root +producer +root +outputter")
        self.assertRegex(done.stdout, r"\nroot -> consumer.in +root +consumer +inputter")


if __name__ == "__main__":
    unittest.main()
