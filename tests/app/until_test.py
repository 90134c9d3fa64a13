"""Tests a run that is stopped at a time: its report is that of a full run up to then."""

import json
import pathlib
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, FIGURE_E2, fingerprint, placedpar
from trace_reader import JsonTrace

COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
DEADLOCK = EXAMPLES / "csp/deadlock" / "ring.cfs"
MILLISECOND = 1_000_000_000  # picoseconds


class Until(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_with_files(self, netlist, *options):
        """Returns the finished process, its JSON report, its trace."""
        report, trace = self.folder / "report.json", self.folder / "trace.json"
        run = placedpar("run", netlist, "--json", report, "--trace", trace, *options)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run, json.loads(report.read_text(encoding="utf-8")), JsonTrace(trace)

    def test_it_stops_there_and_says_so(self):
        run, report, trace = self.run_with_files(COMMSTIME, "--until", "1.5ms")
        self.assertTrue(run.stdout.startswith(
            f"{COMMSTIME}: stopped at the time limit at 1.500000 ms; the figures below cover the time until then\n"))
        self.assertEqual((report["outcome"], report["time_ps"]), ("stopped at the time limit", 3 * MILLISECOND // 2))
        self.assertEqual(report["manifest"]["until_ps"], 3 * MILLISECOND // 2)
        self.assertEqual((trace.end, trace.why), (report["time_ps"], report["outcome"]))

    def test_what_was_done_until_then_is_the_same_as_without(self):
        for netlist, time in ((COMMSTIME, "777777777ps"), (CLUSTER, "100ms"), (CLUSTER, "5us"), (FIGURE_E2, "50ms")):
            run, report, stopped = self.run_with_files(netlist, "--until", time)
            self.assertEqual(run.stdout, self.run_with_files(netlist, "--until", time)[0].stdout)
            _, _, whole = self.run_with_files(netlist, "--trace-until", time)
            self.assertEqual(stopped.end, whole.end)
            self.assertEqual(stopped.slices, whole.slices)
            self.assertEqual(stopped.arrows, whole.arrows)
            for processor in report["processors"]:
                busy = sum(s.end - s.begin for s in whole.slices["processor " + processor["name"]])
                self.assertEqual(processor["busy_ps"], busy)
            for process in report["processes"]:
                self.assertEqual(process["waiting_ps"], whole.waiting(process["name"]), (netlist, time, process))
            for link in report["links"]:
                carried = sum(s.end - s.begin for s in whole.slices[f"{link['from']} -> {link['to']}"])
                self.assertLessEqual(link["occupied_ps"], carried)
                self.assertLessEqual(link["bytes"] - 1, carried // 550_000)

    def test_waits_that_had_not_ended_are_shown(self):
        run, report, trace = self.run_with_files(COMMSTIME, "--until", "1ms")
        waiting = {p["name"]: p["waits_since_ps"] for p in report["processes"] if "waits_since_ps" in p}
        self.assertTrue(waiting)
        for name in (p["name"] for p in report["processes"]):
            last = trace.slices[name][-1]
            self.assertEqual(last.category == "wait", name in waiting)
            if name in waiting:
                self.assertEqual((last.begin, last.open), (waiting[name], True))
                self.assertRegex(run.stdout, rf"\n{name} .*%, the last wait since {waiting[name] / 1e6:.3f} us\n")

    def test_what_is_over_before_is_not_changed_by_it(self):
        for netlist in (COMMSTIME, CLUSTER):
            self.assertEqual(placedpar("run", netlist, "--until", "1000s").stdout, placedpar("run", netlist).stdout)
        run = placedpar("run", DEADLOCK, "--until", "1000s")
        self.assertEqual((run.returncode, run.stdout), (2, placedpar("run", DEADLOCK).stdout))

    def test_at_the_very_beginning(self):
        run, report, _ = self.run_with_files(CLUSTER, "--until", "0s")
        self.assertNotRegex(run.stdout, r"\b(nan|inf)\b")
        self.assertEqual(report["time_ps"], 0)
        self.assertEqual(len(fingerprint(run.stdout)), 16)

    def test_times_are_said_in_many_ways(self):
        for time, same in (("0", "0s"), ("1e3us", "1ms"), (".5ms", "500us"), ("1.5E-3s", "1500us"), ("2000e-3ms", "2ms")):
            run = placedpar("run", COMMSTIME, "--until", time)
            self.assertEqual((run.returncode, run.stdout), (0, placedpar("run", COMMSTIME, "--until", same).stdout), time)
        self.assertIn("finer than a picosecond", placedpar("run", COMMSTIME, "--until", "1e-13s").stderr)
        self.assertIn("lasts for 106 days", placedpar("run", COMMSTIME, "--until", "1e999s").stderr)

    def test_a_time_has_a_unit(self):
        for time in ("5", "", "1 fortnight", "1e3", ".ms", "e3us", "0 ms"):
            run = placedpar("run", COMMSTIME, "--until", time)
            self.assertEqual(run.returncode, 1)
            self.assertIn("is not a time: expected a number and one of the units", run.stderr)
        self.assertIn('"-1ms" is negative: expected a time of at least 0', placedpar("run", COMMSTIME, "--until=-1ms").stderr)


if __name__ == "__main__":
    unittest.main()
