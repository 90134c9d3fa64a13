"""Tests that a trace shows the whole run, each part in its place, and agrees with the report."""

import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree

from program import CLUSTER, EXAMPLES, FIGURE_E2, PROGRAM, fingerprint, placedpar
from trace_reader import JsonTrace, VcdTrace, measure

COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
DEADLOCK = EXAMPLES / "csp/deadlock" / "ring.cfs"
SHARED_LINK = """T800 a; T800 b; connect a.link[1] to b.link[0];
process p; process q; process c; process d;
use "csp.producer" for p; use "csp.producer" for q; use "csp.consumer" for c; use "csp.consumer" for d;
p (count = 50); q (count = 50); c (count = 50); d (count = 50);
connect p.out to c.in; connect q.out to d.in;
place p on a; place q on a; place c on b; place d on b;"""


class Traces(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_traced(self, netlist, *options, ending="json", exit_code=0):
        """Returns the finished process, its JSON report and the path of its trace."""
        trace, report = self.folder / f"trace.{ending}", self.folder / "report.json"
        run = placedpar("run", netlist, "--trace", trace, "--json", report, *options)
        self.assertEqual(run.returncode, exit_code, run.stderr)
        return run, json.loads(report.read_text(encoding="utf-8")), trace

    def trace(self, netlist, *options, **expected):
        run, report, path = self.run_traced(netlist, *options, **expected)
        return run, report, JsonTrace(path)

    def netlist(self, text):
        path = self.folder / "netlist.cfs"
        path.write_text(text, encoding="utf-8")
        return path

    def test_a_process_has_one_track_for_its_whole_life(self):
        _, report, trace = self.trace(FIGURE_E2)
        self.assertEqual(len(report["processes"]), 17)
        self.assertEqual(sorted(trace.processes()), sorted(p["name"] for p in report["processes"]))
        self.assertEqual(trace.components("master[0]"), ["master[0]", "master[0]/0", "master[0]/1"])
        self.assertEqual(trace.components("slave[0][0]"),
                         ["slave[0][0]" + c for c in ("", "/0", "/0/0", "/0/1", "/1")])
        exchanges = [s for s in trace.slices["master[0]"] if s.name == "waits for its components"]
        self.assertGreater(len(exchanges), 20)  # the two tracks were reused this often

    def test_tracks_come_in_the_order_of_the_netlist(self):
        netlist = self.netlist("""T800 z; T800 a; connect z.link[0] to a.link[3]; process q; process p; process c;
            process d; use "csp.producer" for q; use "csp.producer" for p; use "csp.consumer" for c;
            use "csp.consumer" for d; q (count = 2); p (count = 2); c (count = 2); d (count = 2);
            connect q.out to c.in; connect p.out to d.in;
            place d on a; place p on a; place q on z; place c on a;""")
        _, _, trace = self.trace(netlist)
        self.assertEqual(list(trace.nodes.values()), ["z T800", "a T800"])
        self.assertEqual(trace.tracks, ["processor z", "q", "z.link[0] -> a.link[3]",
                                        "processor a", "p", "c", "d", "a.link[3] -> z.link[0]"])

    def test_the_host_is_drawn_on_its_workstation(self):
        _, _, trace = self.trace(FIGURE_E2, "--trace-until", "100ms")
        self.assertEqual(trace.node_of["host"], "sun workstation")
        self.assertEqual(trace.node_of["host/3"], "sun workstation")
        self.assertEqual(trace.node_of["slave[2][1]/0"], "t[2][2] T800")
        self.assertNotIn("processor sun", trace.tracks)  # processes on a workstation take no time

    def test_slices_add_up_to_the_report(self):
        for netlist in (COMMSTIME, CLUSTER, FIGURE_E2, self.netlist(SHARED_LINK)):
            _, report, trace = self.trace(netlist)
            self.assertEqual((trace.end, trace.why), (report["time_ps"], "completed"))
            for processor in report["processors"]:
                busy = sum(s.end - s.begin for s in trace.slices["processor " + processor["name"]])
                self.assertAlmostEqual(busy / trace.end, processor["busy"], 12, processor["name"])
            for link in report["links"]:
                carried = trace.slices[f"{link['from']} -> {link['to']}"]
                self.assertEqual(sum(s.arguments["bytes"] for s in carried), link["bytes"])
                byte = 550_000  # picoseconds: eleven bits at 20 Mbit/s
                self.assertAlmostEqual(sum(s.arguments["bytes"] for s in carried) * byte / trace.end, link["occupied"], 12)
                for each in carried:  # each slice has time for its bytes, with only small gaps between them
                    self.assertGreaterEqual(each.end - each.begin, each.arguments["bytes"] * byte)
                    self.assertLess(each.end - each.begin, each.arguments["bytes"] * 2 * byte)
            for process in report["processes"]:
                waiting = trace.waiting(process["name"])
                self.assertAlmostEqual(waiting / trace.end, process["waiting"], 12, process["name"])

    def test_what_a_processor_executes_computes(self):
        _, _, trace = self.trace(CLUSTER)
        executed = {}
        for track in trace.tracks:
            if track.startswith("processor "):
                for each in trace.slices[track]:
                    executed.setdefault(each.name, []).append((each.begin, each.end))
        for name, intervals in executed.items():
            computed = [(s.begin, s.end) for s in trace.of_category(name, "compute")]
            self.assertEqual(measure(intervals + computed), measure(intervals), name)
            # The rest is the time to interrupt another process, during which this process still waits.
            waited = [(s.begin, s.end) for s in trace.of_category(name, "wait")]
            self.assertEqual(measure(intervals + computed + waited), measure(computed + waited), name)
            self.assertLess(measure(intervals) - measure(computed), 0.1 * measure(intervals), name)

    def test_an_arrow_for_every_message(self):
        _, _, trace = self.trace(COMMSTIME, "--set", "count=5")
        passed = [(a.source, a.target) for a in trace.arrows]
        self.assertEqual(len(passed), 20)
        self.assertEqual(set(passed), {("prefix", "delta"), ("delta", "successor"), ("delta", "consumer"),
                                       ("successor", "prefix")})
        for arrow in trace.arrows:
            source = [s for s in trace.slices[arrow.source] if s.begin <= arrow.left < s.end]
            self.assertEqual([s.name for s in source], ["outputs to " + arrow.target])
            self.assertEqual(source[0].arguments, {"channel": arrow.name, "partner": arrow.target})

    def test_a_wait_says_what_for(self):
        _, _, trace = self.trace(CLUSTER, "--trace-until", "200ms")
        waits = {s.name for track in trace.processes() for t in trace.components(track) for s in trace.slices[t]}
        self.assertLessEqual({"outputs to slave[0]/0/0", "inputs from master", "waits for its components"}, waits)
        self.assertFalse([name for name in waits if "has ended" in name])
        _, _, trace = self.trace(CLUSTER, "--set", 'split="demand"', "--trace-until", "200ms")
        alternations = [s for s in trace.slices["master/0"] if s.name.startswith("alternates")]
        self.assertGreater(len(alternations), 50)
        either = [s for s in alternations[10:] if s.name == "alternates: input from slave[0]/0/1 or master/1"]
        self.assertGreater(len(either), 30)
        # The master's own evaluator finishes first in each generation.
        self.assertLessEqual({s.name for s in alternations[10:]} - {either[0].name},
                             {"alternates: input from slave[0]/0/1",  # the next name occurs at first, from the other end:
                              "alternates: input from slave[0]/0/1 or share of master done"})
        for each in either:
            self.assertEqual(each.category, "wait")
            self.assertEqual(each.arguments["channels"],
                             [{"channel": "slave[0].to_master -> master.from_slaves", "partner": "slave[0]/0/1"},
                              {"channel": "share of master done", "partner": "master/1"}])

    def test_channels_inside_a_process_are_named_after_it(self):
        _, _, path = self.run_traced(FIGURE_E2)
        text = path.read_text(encoding="utf-8")
        self.assertIn('"task of slave[0][0]"', text)
        self.assertIn('"result of slave[3][2]"', text)
        self.assertNotIn("own ", text)
        _, _, path = self.run_traced(CLUSTER, "--set", 'split="demand"')
        text = path.read_text(encoding="utf-8")
        self.assertIn('"share of master"', text)
        self.assertNotIn("own ", text)

    def test_open_waits_at_a_deadlock(self):
        _, _, trace = self.trace(DEADLOCK, exit_code=2)
        self.assertEqual(trace.why, "deadlock")
        for i in range(3):
            last = trace.slices[f"buffer[{i}]"][-1]
            before = f"buffer[{(i + 2) % 3}]"
            self.assertTrue(last.open)
            self.assertEqual((last.name, last.arguments),
                             (f"inputs from {before}", {"channel": f"{before}.out -> buffer[{i}].in", "partner": before}))

    def test_nothing_is_open_where_all_is_done(self):
        for netlist in (CLUSTER, FIGURE_E2, COMMSTIME, self.netlist(SHARED_LINK)):
            _, _, trace = self.trace(netlist)
            self.assertFalse([s for track in trace.processes() for s in trace.slices[track] if s.open])

    def test_open_stretches_when_the_run_is_interrupted(self):
        for ending, read in (("json", JsonTrace), ("vcd", VcdTrace)):
            path = self.folder / f"trace.{ending}"
            with subprocess.Popen([PROGRAM, "run", str(COMMSTIME), "--set", "count=1000000000", "--trace", str(path),
                                   "--trace-limit", "1000000000"], stdout=subprocess.PIPE, text=True) as run:
                time.sleep(1)
                run.send_signal(signal.SIGINT)
                output, _ = run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130)
            self.assertIn("interrupted", output)
            trace = read(path)
            if ending == "json":
                self.assertEqual(trace.why, "interrupted")
                self.assertTrue(any(trace.slices[t][-1].open for t in trace.processes()))

    def test_a_part_of_a_run(self):
        _, _, whole = self.trace(COMMSTIME)
        run, _, part = self.trace(COMMSTIME, "--trace-from", "1.5ms", "--trace-until", "2000us")
        self.assertEqual(run.stderr, "")
        begin, end = 1_500_000_000, 2_000_000_000
        self.assertEqual(part.end, end)
        self.assertEqual(part.tracks, whole.tracks)
        for track in whole.tracks:
            clipped = [(max(s.begin, begin), min(s.end, end), s.name) for s in whole.slices[track]
                       if s.end > begin and s.begin < end]
            self.assertEqual([s[:3] for s in part.slices[track] if s.begin < s.end or not s.open], clipped, track)
        self.assertGreater(len(part.arrows), 100)
        self.assertTrue(all(begin <= a.left <= a.arrived <= end for a in part.arrows))

    def test_times_are_refused_where_they_are_none(self):
        for text in ("1", "ms", "1 ms", "1m", "1e3", "1.ms", ".ms", "0x1us", "1ms2", "inf"):
            for option in ("--trace-from", "--trace-until"):
                run = placedpar("run", COMMSTIME, "--trace", self.folder / "t.json", f"{option}={text}")
                self.assertEqual(run.returncode, 1, text)
                self.assertIn(f'"{text}" is not a time: expected a number and one of the units s, ms, us, ns or ps', run.stderr)
        for text, why in (("-1ms", "is negative"), ("0.5ps", "finer than a picosecond"), ("1.0000000000001s", "finer than a picosecond"),
                          ("9223373s", "lasts for 106 days"), ("99999999999999999999ps", "lasts for 106 days")):
            run = placedpar("run", COMMSTIME, "--trace", self.folder / "t.json", f"--trace-from={text}")
            self.assertEqual(run.returncode, 1, text)
            self.assertIn(why, run.stderr)
        run = placedpar("run", COMMSTIME, "--trace", self.folder / "t.json", "--trace-from", "3ms", "--trace-until", "2ms")
        self.assertEqual(run.returncode, 1)
        self.assertIn("the trace would begin at 3.000000 ms but end at 2.000000 ms", run.stderr)
        run = placedpar("run", COMMSTIME, "--trace-from", "3ms")
        self.assertEqual(run.returncode, 1)
        self.assertIn("--trace", run.stderr)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_part_after_the_run_is_empty_and_says_so(self):
        run, report, trace = self.trace(COMMSTIME, "--set", "count=5", "--trace-from", "1s")
        self.assertIn("the trace is empty: the run ended at ", run.stderr)
        self.assertEqual(sum(len(s) for s in trace.slices.values()), 0)
        self.assertEqual(report["outcome"], "completed")

    def test_a_full_trace_says_so_and_what_to_do(self):
        texts = []
        for _ in range(2):
            run, report, path = self.run_traced(COMMSTIME, "--trace-limit", 1000)
            texts.append(path.read_text(encoding="utf-8"))
            trace = JsonTrace(path)
            self.assertIn("the trace is full and ends at ", run.stderr)
            self.assertIn("--trace-from and --trace-until", run.stderr)
            entries = sum(len(s) for s in trace.slices.values()) + len(trace.arrows)
            self.assertTrue(1000 <= entries < 1000 + 2 * len(trace.tracks), entries)
            self.assertEqual(trace.why, "the trace is full")
            self.assertEqual(report["outcome"], "completed")
        self.assertEqual(*texts)

    def test_a_long_run_is_limited_without_being_asked(self):
        run, _, path = self.run_traced(COMMSTIME, "--set", "count=150000")
        self.assertIn("the trace is full and ends at ", run.stderr)
        self.assertIn("2000000 entries", run.stderr)
        self.assertLess(path.stat().st_size, 500_000_000)

    def test_the_ending_says_the_format(self):
        for name in ("trace", "trace.txt", "trace.json.gz", "vcd"):
            run = placedpar("run", COMMSTIME, "--set", "count=5", "--trace", self.folder / name)
            self.assertEqual(run.returncode, 1, name)
            self.assertIn(".json for ui.perfetto.dev, .vcd for GTKWave, or .svg for a drawing", run.stderr)
            self.assertEqual(os.listdir(self.folder), [])
        for name, read in (("a.JSON", JsonTrace), ("a.VCD", VcdTrace)):
            run = placedpar("run", COMMSTIME, "--set", "count=5", "--trace", self.folder / name)
            self.assertEqual(run.returncode, 0, run.stderr)
            read(self.folder / name)

    def test_a_drawing_has_a_row_for_each_process_and_ends_before_it_is_unreadable(self):
        run, _, path = self.run_traced(CLUSTER, "--trace-until", "40ms", ending="svg")
        rows = [text.text for text in xml.etree.ElementTree.parse(path).iter("{http://www.w3.org/2000/svg}text")
                if text.get("class") == "row"]
        self.assertEqual([row for row in rows if row in ("host", "master", "slave[0]", "slave[1]", "slave[2]")],
                         ["master", "slave[0]", "slave[1]", "slave[2]", "host"])
        self.assertEqual(run.stderr, "")
        run, _, path = self.run_traced(FIGURE_E2, ending="svg")
        self.assertIn("after 20000 entries", run.stderr)
        self.assertLess(path.stat().st_size, 2_000_000)

    def test_tracing_does_not_change_the_run(self):
        for netlist in (COMMSTIME, CLUSTER, FIGURE_E2, self.netlist(SHARED_LINK)):
            plain = placedpar("run", netlist)
            for ending in ("json", "vcd", "svg"):
                for part in ([], ["--trace-from", "1ms", "--trace-until", "5ms"]):
                    run, _, _ = self.run_traced(netlist, *part, ending=ending)
                    self.assertEqual(run.stdout, plain.stdout)
                    self.assertEqual(fingerprint(run.stdout), fingerprint(plain.stdout))

    def test_waveforms_agree_with_the_report(self):
        _, report, path = self.run_traced(FIGURE_E2, ending="vcd")
        trace = VcdTrace(path)
        self.assertEqual(trace.end, report["time_ps"])
        self.assertTrue(trace.comment.startswith("completed at "))

        def wire(node, name):
            (path,) = [p for p in trace.wires if p.startswith(f"machine.{node}_") and p.endswith("." + name)]
            return trace.on(path)

        plain = lambda name: re.sub(r"\W+", "_", name).strip("_")
        for processor in report["processors"]:
            busy = measure(wire(plain(processor["name"]), "busy"))
            self.assertAlmostEqual(busy / trace.end, processor["busy"], 12)
        for process in report["processes"]:
            states = {state: wire(plain(process["on"]), f"{plain(process['name'])}.{state}")
                      for state in ("computes", "ready", "inputs", "outputs", "alternates", "delayed", "after_work")}
            waits = measure(states["inputs"] + states["outputs"] + states["alternates"] + states["delayed"]
                            + states["after_work"])
            goes_on = measure(states["computes"] + states["ready"])
            everything = measure(sum(states.values(), []))
            self.assertAlmostEqual((everything - goes_on) / trace.end, process["waiting"], 12, process["name"])
            self.assertGreaterEqual(waits, everything - goes_on)
        for link in report["links"]:
            node = plain(link["from"].split(".")[0])
            active = wire(node, plain(f"{link['from']} {link['to']}"))
            self.assertGreaterEqual(measure(active) / trace.end, link["occupied"])
            self.assertEqual(bool(active), link["bytes"] > 0)

    def test_waveforms_have_identifiers_and_parts(self):
        netlist = self.netlist("""T800 t[1]; T800 t_0_T800; connect t[0].link[0] to t_0_T800.link[1];
            process a[1]; process a_0; use "csp.producer" for a[0]; use "csp.consumer" for a_0; a[0] (count = 200);
            a_0 (count = 200); connect a[0].out to a_0.in; place a[0] on t[0]; place a_0 on t[0];""")
        _, _, path = self.run_traced(netlist, "--trace-from", "100us", "--trace-until", "0.2ms", ending="vcd")
        trace = VcdTrace(path)
        self.assertEqual((trace.begin, trace.end), (100_000_000, 200_000_000))
        self.assertIn("machine.t_0_T800.busy", trace.wires)
        self.assertIn("machine.t_0_T800.a_0.computes", trace.wires)
        self.assertIn("machine.t_0_T800.a_0_2.computes", trace.wires)  # the tracks of a[0] and a_0 get different names
        self.assertTrue(trace.on("machine.t_0_T800.busy"))

    def test_processes_of_the_machine_are_drawn(self):
        _, _, trace = self.trace(self.netlist(SHARED_LINK))
        self.assertTrue(any("router receiver" in t for t in trace.tracks))
        (track,) = [t for t in trace.tracks if t == "router sender a.link[1] -> b.link[0]"]
        self.assertEqual(trace.node_of[track], "a T800")
        self.assertEqual({(a.source, a.target) for a in trace.arrows if a.name in ("p.out -> c.in", "q.out -> d.in")},
                         {("p", "c"), ("q", "d")})


if __name__ == "__main__":
    unittest.main()
