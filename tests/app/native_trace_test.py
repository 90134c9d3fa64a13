"""Tests the timelines and pages of native runs: they have the messages of the simulated run, and the waits of the report."""

import collections
import itertools
import json
import pathlib
import re
import tempfile
import unittest

from chromium import CHROMIUM, Chromium
from native_ranks_test import on
from page_reader import data_of
from program import EXAMPLES, placedpar
from ranks_test import MODULE, MPIRUN
from trace_reader import JsonTrace, VcdTrace, measure

ISLANDS = EXAMPLES / "genetic/islands/islands.cfs"
COMMSTIME = EXAMPLES / "csp/commstime/commstime.cfs"
RING = EXAMPLES / "csp/deadlock/ring.cfs"
SMALL = {ISLANDS: ["--set", "trials=3"], COMMSTIME: ["--set", "count=50"], EXAMPLES / "genetic/coarse-fine/pair.cfs": []}
MILLISECOND = 10**9  # picoseconds


def messages(trace):
    """Returns the senders and receivers of each channel, in order."""
    passed = collections.defaultdict(list)
    for arrow in sorted(trace.arrows, key=lambda each: (each.left, each.arrived)):
        passed[arrow.name].append((arrow.source, arrow.target))
    return passed


class NativeTraces(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def trace(self, netlist, *options, exit_code=0, program=placedpar):
        """Returns the run, its report and its trace, whose form JsonTrace has checked."""
        trace, report = self.folder / "trace.json", self.folder / "report.json"
        run = program("run", netlist, "--trace", trace, "--json", report, *options)
        self.assertEqual((run.returncode, run.stderr), (exit_code, ""))
        return run, json.loads(report.read_text(encoding="utf-8")), JsonTrace(trace, has_many_clocks=program is not placedpar)

    def run_undisturbed(self, *arguments, **options):
        """Returns a run whose waits by the trace are those of the report. Another program may take a core between the two
        readings of the clock, so that the run is made again."""
        for _ in range(4):
            run, report, trace = self.trace(*arguments, **options)
            if all(abs(trace.waiting(each["name"]) - each["waiting_ps"]) < MILLISECOND for each in report["processes"]):
                break
        return run, report, trace

    def check_against_report(self, report, trace):
        """Checks that the waits are those of the report, and that a thread executes what computes on it."""
        self.assertGreaterEqual(trace.end, report["time_ps"])
        on_place = collections.defaultdict(list)
        for process in report["processes"]:
            self.assertAlmostEqual(trace.waiting(process["name"]), process["waiting_ps"], delta=MILLISECOND)
            for track in trace.components(process["name"]):
                on_place[process["on"]] += [(s.begin, s.end) for s in trace.of_category(track, "compute")]
        for place in report["processors"]:
            executed = [(s.begin, s.end) for s in trace.slices["processor " + place["name"]]]
            computed = sorted(on_place[place["name"]])
            self.assertTrue(all(a[1] <= b[0] for a, b in itertools.pairwise(computed)))  # one at a time
            self.assertEqual(measure(executed), measure(computed))
            self.assertLessEqual(measure(computed), place["busy_ps"] + MILLISECOND)

    def test_messages_are_those_of_the_simulated_run(self):
        for netlist, options in SMALL.items():
            simulated = messages(self.trace(netlist, *options)[2])
            self.assertGreater(sum(map(len, simulated.values())), 50)
            for threads in (1, 2, 3):
                with self.subTest(netlist=netlist, threads=threads):
                    _, report, trace = self.run_undisturbed(netlist, "--native", "--threads", threads, *options)
                    self.assertEqual(messages(trace), simulated)
                    self.assertEqual(list(trace.nodes.values()),
                                     [f"thread {i}" for i in range(len(report["processors"]))])
                    self.assertNotIn("clocks", report)
                    self.check_against_report(report, trace)

    @unittest.skipUnless(MPIRUN and MODULE.exists(), "built without MPI")
    def test_messages_on_ranks_are_those_of_the_simulated_run_by_one_clock(self):
        for netlist in (ISLANDS, COMMSTIME):
            simulated = messages(self.trace(netlist, *SMALL[netlist])[2])
            for ranks in (2, 3):
                with self.subTest(netlist=netlist, ranks=ranks):
                    run, report, trace = self.run_undisturbed(netlist, "--native", *SMALL[netlist], program=on(ranks))
                    self.assertEqual(messages(trace), simulated)
                    self.assertEqual(list(trace.nodes.values()), [f"rank {i}" for i in range(ranks)])
                    self.assertEqual([each["name"] for each in report["clocks"]], [f"rank {i}" for i in range(1, ranks)])
                    for clock in report["clocks"]:  # all ranks have the clock of this computer
                        self.assertLessEqual(abs(clock["ahead_of_rank_0_ns"]) * 1000, clock["error_ps"])
                    self.assertRegex(run.stdout, r"clock +known to +drift")
                    self.check_against_report(report, trace)

    def test_a_deadlock_is_open_for_ever(self):
        _, _, trace = self.trace(RING, "--native", "--threads", 3, exit_code=2)
        self.assertEqual(trace.why, "deadlock")
        for name in ("buffer[0]", "buffer[1]", "buffer[2]"):
            self.assertTrue(trace.slices[name][-1].open)

    def test_a_part_of_the_run_and_other_formats(self):
        run = placedpar("run", COMMSTIME, "--native", "--trace", self.folder / "trace.vcd")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertTrue(any(path.endswith("consumer.computes") for path in VcdTrace(self.folder / "trace.vcd").wires))
        _, _, trace = self.trace(ISLANDS, "--native", "--threads", 2, "--trace-from", "2ms", "--trace-until", "3ms")
        self.assertEqual((trace.end, trace.why), (3 * MILLISECOND, "end of the part that is traced"))
        self.assertGreaterEqual(min(s.begin for slices in trace.slices.values() for s in slices), 2 * MILLISECOND)
        run = placedpar("run", ISLANDS, "--native", "--trace", self.folder / "trace.json", "--trace-limit", 100)
        self.assertIn("after 100 entries", run.stderr)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_the_page_has_threads_as_tracks_and_opens_in_a_browser(self):
        page = self.folder / "run.html"
        run = placedpar("run", ISLANDS, "--native", "--threads", 2, "--page", page, *SMALL[ISLANDS])
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        tracks = data_of(page.read_text(encoding="utf-8"))["timeline"]["tracks"]
        self.assertEqual([each["name"] for each in tracks if each["kind"] == "processor"], ["thread 0", "thread 1"])
        chromium = Chromium()
        self.addCleanup(chromium.close)
        shown, said = chromium.visit(page.as_uri() + "#at=0.5&process=island[0]")
        self.assertEqual(said, [])
        self.assertIn('data-loaded="yes"', shown[:5000])
        self.assertIn("on thread 0", re.search(r'<aside id="chosen">(.*?)</aside>', shown, re.S).group(1))
        self.assertIn('data-node="thread 1"', shown)
        self.assertTrue(re.search(r'<p id="part" hidden="">', shown))  # all of the run is shown


if __name__ == "__main__":
    unittest.main()
