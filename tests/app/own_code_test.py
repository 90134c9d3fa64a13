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
        self.assertTrue("root -&gt; consumer.in" in page.read_text(encoding="utf-8"), "the page draws no such channel")
        self.assertEqual(json.loads(report.read_text(encoding="utf-8"))["outcome"], "completed")
        events = json.loads(trace.read_text(encoding="utf-8"))["traceEvents"]
        carried = collections.Counter()
        for event in events:
            if event.get("cat") == "link":
                carried[event["name"]] += event["args"]["bytes"]
        self.assertEqual(carried, {"producer.out -> root": 40, "root -> consumer.in": 40})
        waits = collections.Counter(event["args"]["partner"] for event in events
                                    if event.get("cat") == "wait" and event["args"].get("channel") in carried)
        self.assertEqual(waits["root"], 20)
        self.assertLessEqual(set(waits), {"root"} | set(carried)) # the program's waits name the channel itself
        for phase, ends in (("s", ("producer", "root.")), ("f", ("root.", "consumer"))): # arrows between both
            threads = {event["tid"]: event["args"]["name"] for event in events if event.get("name") == "thread_name"}
            arrows = [event for event in events if event["ph"] == phase and event.get("cat") == "message"]
            self.assertEqual(collections.Counter(event["name"] for event in arrows), {name: 10 for name in carried})
            for channel, end in zip(("producer.out -> root", "root -> consumer.in"), ends):
                self.assertTrue(all(threads[event["tid"]].startswith(end) for event in arrows if event["name"] == channel),
                                (phase, channel))

    def test_explain_says_that_processes_wait_for_a_program(self):
        done = placedpar("explain", self.netlist)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\nconsumer .* root \(0\.072\)")
        self.assertRegex(done.stdout, r"\nproducer .* root \(0\.076\)")

    def test_a_process_and_a_program_that_wait_for_each_other_are_named(self):
        done = placedpar("run", self.netlist, "--set", "numbers=11")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stdout, r"\nproducer.out -> root +producer +root +outputter")
        self.assertRegex(done.stdout, r"\nroot -> consumer.in +root +consumer +inputter")

    def test_a_program_that_waits_for_a_process_names_its_channel(self):
        out = placedpar("run", self.netlist, "--set", "producer.count=5").stdout
        self.assertRegex(out, r"\nno wait cycle: root.#\w+ inputs for ever, but producer has ended")
        self.assertRegex(out, r"\nroot.#\w+ +inputs +producer.out -> root ")
        self.assertRegex(out, r"\nproducer.out -> root +producer \(has ended\) +root.#\w+ +inputter +mixed.cfs:19\n")
        self.assertRegex(out, r"\nroot -> consumer.in +root.#\w+ +consumer +inputter +mixed.cfs:20\n")
        self.assertNotIn("left.link[2] -> root.link[1]  ", out.split("\nlink ")[0])

    def test_options_for_code_of_its_own_are_refused_without_such_code(self):
        for option in ("--listing", "--analyse", "--step"):
            done = placedpar("run", EXAMPLES / "csp/commstime/commstime.cfs", option, typed="")
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertRegex(done.stderr, f"placedpar: {option} has no effect: no transputer of .*commstime.cfs executes code of its own")


if __name__ == "__main__":
    unittest.main()
