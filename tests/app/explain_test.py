"""Tests placedpar explain: the critical path adds up to the run, and predicted gains equal those of changed runs."""

import collections
import contextlib
import glob
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import trace_reader

PROGRAM = os.environ["PLACEDPAR"]
EXAMPLES = os.environ["PLACEDPAR_EXAMPLES"]
FIGURE_E2 = os.path.join(EXAMPLES, "thesis/figure-e2", "figure-e2.cfs")

# A message of one packet passes through an intermediate processor.
CHAIN = """
T800 a, b, c;
connect a.link[0] to b.link[0];
connect b.link[1] to c.link[0];
process source, sink;
use "csp.producer" for source;
use "csp.consumer" for sink;
source (count = 1, cycles = 1000);
sink (count = 1);
place source on a;
place sink on c;
connect source.out to sink.in;
"""

# On each of two buses, a master writes into another's memory; the left bus is slower and carries more.
TWO_BUSES = """
VME (cycle = 600) left;
VME right;
BBKV2 m[4];
connect m[0].bus[0] to left.slot[1];
connect m[1].bus[0] to left.slot[2];
connect m[2].bus[0] to right.slot[1];
connect m[3].bus[0] to right.slot[2];
process source[2], sink[2];
rep i = 0 for 2 {
    use "csp.producer" for source[i];
    use "csp.consumer" for sink[i];
    source[i] (count = 15 - 5 * i, bytes = 1024);
    sink[i] (count = 15 - 5 * i);
    place source[i] on m[2 * i];
    place sink[i] on m[2 * i + 1];
    connect source[i].out to sink[i].in;
}
"""


@contextlib.contextmanager
def netlist_file(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "two.cfs"
        path.write_text(text, encoding="utf-8")
        yield path


def explained(netlist, *options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "explained.json")
        run = subprocess.run([PROGRAM, "explain", netlist, "--json", path, *options], capture_output=True, text=True)
        return run, json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def time_of_run(netlist, *options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "run.json")
        subprocess.run([PROGRAM, "run", netlist, "--json", path, *options], capture_output=True, check=True)
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["time_ps"]


def time_of_what_if(netlist, answer):
    return time_of_run(netlist, *(word for name, value in answer["set"].items() for word in ("--set", f"{name}={value}")))


class Explain(unittest.TestCase):
    def test_the_path_leads_without_a_gap_from_the_end_to_the_beginning(self):
        netlists = sorted(glob.glob(os.path.join(EXAMPLES, "*", "*", "*.cfs")))
        self.assertGreater(len(netlists), 20)
        for netlist in netlists:
            with self.subTest(netlist):
                if netlist.endswith(("thin.cfs", "tin.cfs", "genetic/own-policy/islands.cfs")):
                    continue  # these netlists need a program with more kinds
                if "/transputer/" in netlist:
                    continue  # the bootable files of these are made by their pages
                run, document = explained(netlist, "--no-what-if")
                self.assertIn(run.returncode, (0, 2), run.stderr)
                moment = 0
                for part in document["critical_path"]:
                    self.assertEqual(part["begin_ps"], moment)
                    moment = part["end_ps"]
                self.assertEqual(moment, document["time_ps"])

    def test_the_path_leads_through_routers_to_those_who_keep_them_waiting(self):
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder) / "chain.cfs"
            netlist.write_text(CHAIN, encoding="utf-8")
            run, document = explained(str(netlist), "--no-what-if")
        self.assertEqual(run.returncode, 0, run.stderr)
        parts = [(part["step"], part["subject"], part["end_ps"] - part["begin_ps"]) for part in document["critical_path"]]
        # Each packet takes 200 cycles of routing and an instruction of 19. Packets have 8 bytes, acknowledges 4. A
        # cycle is 50 ns.
        handling, instruction, packet, acknowledge = 219 * 50_000, 19 * 50_000, 4_470_000, 2_230_000
        links = ("a.link[0] -> b.link[0]", "b.link[1] -> c.link[0]", "c.link[0] -> b.link[1]", "b.link[0] -> a.link[0]")
        expected = [("computing", f"router receiver {links[3]} on a", instruction),
                    ("computing", "source on a", 1000 * 50_000 + instruction)]
        for link, carried in zip(links, (packet, packet, acknowledge, acknowledge)):
            expected += [("computing", f"router sender {link} on {link[0]}", handling),
                         ("communicating", "source.out -> sink.in", carried),
                         ("computing", f"router receiver {link} on {link[-9]}", handling)]
        self.assertEqual(parts, expected)
        self.assertEqual(sum(length for _, _, length in parts), document["time_ps"])
        source = next(each for each in document["processes"] if each["process"] == "source")
        # The process is ready when the router has handled the last acknowledge, and runs when the router has asked for
        # the next packet.
        self.assertEqual(source["communicating_ps"], document["time_ps"] - sum(length for *_, length in parts[:2]) - instruction)

    def test_who_waits_for_a_fork_waits_for_who_has_it(self):
        _, document = explained(os.path.join(EXAMPLES, "csp/philosophers", "philosophers.cfs"), "--no-what-if")
        spent = collections.Counter()
        for part in document["critical_path"]:
            spent[part["subject"].split("[")[0]] += part["end_ps"] - part["begin_ps"]
        self.assertGreater(spent["philosopher"], 0.9 * document["time_ps"])  # eating or thinking; handing over a fork takes little time
        account = next(each for each in document["processes"] if each["process"] == "philosopher[0]")
        self.assertLess(account["communicating_ps"], 0.01 * document["time_ps"])

    def test_a_what_if_is_a_run_with_what_it_sets(self):
        _, document = explained(FIGURE_E2)
        answers = {what["what"]: what for what in document["what_if"]}
        a_link = next(what for what in answers if what.startswith("link ") and what.endswith(" twice as fast"))
        for what in ("all links twice as fast", "one more of slaves: 4 instead of 3", "channelcall none",
                     "processors of master[] twice as fast", a_link):
            answer = answers[what]
            self.assertNotEqual(answer["time_ps"], document["time_ps"])
            self.assertEqual(answer["time_ps"], time_of_what_if(FIGURE_E2, answer), what)

    def test_each_bus_and_all_of_them_are_asked_about(self):
        with netlist_file(TWO_BUSES) as netlist:
            run, document = explained(netlist)
            answers = {what["what"]: what for what in document["what_if"]}
            left = {"10 % faster": ("545", "282", "182"), "twice as fast": ("300", "155", "100"), "as fast as can be": ("1", "1", "0")}
            right = {"10 % faster": ("282", "282", "182"), "twice as fast": ("155", "155", "100"), "as fast as can be": ("1", "1", "0")}
            for change in left:
                times = {}
                for what, buses in (("bus left", {"left": left}), ("bus right", {"right": right}), ("all buses", {"left": left, "right": right})):
                    answer = answers[f"{what} {change}"]
                    self.assertEqual(answer["set"], {f"{bus}.{name}": time for bus, to in buses.items()
                                                     for name, time in zip(("cycle", "bytecycle", "grant"), to[change])})
                    self.assertEqual(answer["time_ps"], time_of_what_if(netlist, answer), answer)
                    times[what] = answer["time_ps"]
                self.assertLess(times["bus left"], document["time_ps"])  # the process that ends last uses this bus
                self.assertEqual(times["bus right"], document["time_ps"])
                self.assertLessEqual(times["all buses"], times["bus left"])
        self.assertIn("\n  bus left twice as fast: ", run.stdout)
        self.assertRegex(run.stdout, r"bus left twice as fast  \[--set left.bytecycle=155 --set left.cycle=300 --set left.grant=100\]")

    def test_a_bus_alone_is_not_asked_about_twice(self):
        netlist = os.path.join(EXAMPLES, "machine/busy-bus", "busy-bus.cfs")
        _, document = explained(netlist)
        answers = {what["what"]: what for what in document["what_if"]}
        self.assertEqual(sorted(what for what in answers if "bus" in what),
                         ["bus vme 10 % faster", "bus vme as fast as can be", "bus vme twice as fast"])
        memory = answers["memory of all processors as fast as on the chip"]
        self.assertLess(memory["time_ps"], document["time_ps"])
        self.assertEqual(memory["time_ps"], time_of_what_if(netlist, memory))

    def test_what_bytes_cost_between_two_orders_is_asked_about(self):
        to_the_sun = TWO_BUSES.replace("BBKV2 m[4];", "BBKV2 m[3];\nworkstation sun;").replace("m[3].bus", "sun.bus").replace(
            "place sink[i] on m[2 * i + 1];", "if i == 0 place sink[i] on m[1]; else place sink[i] on sun;")
        with netlist_file(to_the_sun) as netlist:
            _, document = explained(netlist)
            answers = {what["what"]: what for what in document["what_if"]}
            self.assertEqual({what: answer["set"] for what, answer in answers.items() if what.startswith("conversion")},
                             {"conversion half": {"conversion": "2"}, "conversion none": {"conversion": "0"}})  # 4 cycles less a tenth would still be 4
            none = answers["conversion none"]
            self.assertLess(none["time_ps"], document["time_ps"])
            self.assertEqual(none["time_ps"], time_of_what_if(netlist, none))

    def test_constants_that_differ_are_asked_about_together(self):
        with netlist_file(re.sub(r"bytes = \d+", "bytes = 100 + 40 * i", TWO_BUSES)) as netlist:
            _, document = explained(netlist)
            half = next(what for what in document["what_if"] if what["what"] == "bytes half")
            self.assertEqual(half["set"], {"source[0].bytes": "50", "source[1].bytes": "70"})
            self.assertLess(half["time_ps"], document["time_ps"])
            self.assertEqual(half["time_ps"], time_of_what_if(netlist, half))

    def test_the_path_goes_over_the_bus_and_what_is_slower_is_so_for_a_reason(self):
        run, document = explained(os.path.join(EXAMPLES, "machine/busy-bus", "busy-bus.cfs"))
        spent = collections.Counter()
        for part in document["critical_path"]:
            spent[part["step"]] += part["end_ps"] - part["begin_ps"]
        # The table in the example's page shows the bus busy 85 % of the time. A path can avoid the bus only for the
        # remaining 15 %.
        self.assertGreater(spent["moving words"], document["time_ps"] / 2)
        slower = [what for what in document["what_if"] if what.get("time_ps", 0) > document["time_ps"] * 1.001]
        self.assertTrue(slower)
        for what in slower:
            self.assertRegex(what["slower_by"], r"^\+\d+\.\d{3} ms \w+")
        self.assertIn("Graham", run.stdout)

    def test_the_path_is_one_line_in_the_trace(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "trace.json"
            _, document = explained(FIGURE_E2, "--no-what-if", "--trace", str(path))
            trace = trace_reader.JsonTrace(path)
        parts = [(part["begin_ps"], part["end_ps"], ": ".join(filter(None, (part["step"], part["subject"]))))
                 for part in document["critical_path"]]
        self.assertEqual([(s.begin, s.end, s.name) for s in trace.slices["all of it"]], parts)
        self.assertEqual(trace.tracks[0], "all of it")
        via = {track: trace.slices[track] for track in trace.tracks if trace.node_of[track] == "critical path"}
        placed = sorted((s for track, slices in via.items() if track != "all of it" for s in slices), key=lambda s: s.begin)
        self.assertEqual([(s.begin, s.end, s.name) for s in placed], parts)  # each part occupies a processor or a link
        for track, slices in via.items():
            for each in slices:
                if each.name.startswith("computing: master[0] "):
                    self.assertIn(track, ("all of it", "via processor t[0][0]"))
                    executed = [(max(s.begin, each.begin), min(s.end, each.end)) for s in trace.slices["processor t[0][0]"]
                                if s.name.startswith("master[0]") and s.begin < each.end and each.begin < s.end]
                    self.assertEqual(trace_reader.measure(executed), each.end - each.begin)
        steps = sorted((arrow for arrow in trace.arrows if arrow.name == "critical path"), key=lambda a: a.left)
        self.assertGreater(len(steps), 100)
        for arrow, following in zip(steps, steps[1:]):
            self.assertEqual(arrow.arrived, arrow.left + 1)
            self.assertEqual(arrow.target, following.source)

    def test_the_path_is_on_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.html"
            _, document = explained(FIGURE_E2, "--no-what-if", "--page", str(path))
            data = json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>',
                                        path.read_text(encoding="utf-8"), re.S).group(1))
        timeline = data["timeline"]
        line = list(zip(*[iter(timeline["path"])] * 4))
        self.assertEqual([(begin, begin + length) for _, begin, length, _ in line],
                         [(part["begin_ps"], part["end_ps"]) for part in document["critical_path"]])
        self.assertIn("master[0]", {timeline["texts"][name].split()[-3] for track, _, _, name in line
                                    if timeline["tracks"][track]["name"] == "t[0][0]" and " on " in timeline["texts"][name]})

    def test_what_is_found_is_told_also_where_a_page_or_a_trace_cannot_be_written(self):
        told = subprocess.run([PROGRAM, "explain", FIGURE_E2, "--no-what-if"], capture_output=True, text=True, check=True).stdout
        for option in ("--page", "--trace", "--json"):
            run = subprocess.run([PROGRAM, "explain", FIGURE_E2, "--no-what-if", option, "/dev/full"], capture_output=True,
                                 text=True, check=False)
            self.assertEqual((run.returncode, run.stdout), (1, told), option)
            self.assertEqual(run.stderr, "placedpar: /dev/full: cannot be written: No space left on device\n")

    def test_a_flag_is_shown_as_it_is_typed(self):
        run = subprocess.run([PROGRAM, "explain", "--help"], capture_output=True, text=True, check=True)
        self.assertRegex(run.stdout, r"(?m)^  --no-what-if +leaves out the additional runs")

    def test_waveforms_have_no_path(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([PROGRAM, "explain", FIGURE_E2, "--trace", os.path.join(folder, "trace.vcd")],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("a timeline with the critical path can be written only as .json", run.stderr)

    def test_what_the_netlist_includes_is_not_written_over(self):
        with tempfile.TemporaryDirectory() as folder:
            netlist, part = pathlib.Path(folder) / "netlist.cfs", pathlib.Path(folder) / "part.inc"
            netlist.write_text('#include "part.inc"\n', encoding="utf-8")
            text = pathlib.Path(EXAMPLES, "csp/commstime", "commstime.cfs").read_text(encoding="utf-8")
            part.write_text(text, encoding="utf-8")
            for option in ("--json", "--page"):
                run = subprocess.run([PROGRAM, "explain", netlist, "--no-what-if", option, part], capture_output=True,
                                     text=True, check=False)
                self.assertEqual(run.returncode, 1)
                self.assertIn("part.inc: cannot be written: the output file is also the input", run.stderr)
                self.assertEqual(part.read_text(encoding="utf-8"), text)

    def test_what_is_refused_is_told(self):
        _, document = explained(os.path.join(EXAMPLES, "machine/busy-bus", "busy-bus.cfs"))
        refused = {what["what"]: what["refused"] for what in document["what_if"] if "refused" in what}
        self.assertIn("bytes none", refused)
        self.assertIn("bytes", refused["bytes none"])

    def test_what_the_tables_say_of_the_machine_is_in_the_json(self):
        for example, counts in (("thesis/figure-e2/figure-e2.cfs", {"processors": 16, "links": 32, "buses": 0}),
                                ("machine/busy-bus/busy-bus.cfs", {"processors": 4, "links": 0, "buses": 1})):
            run, document = explained(os.path.join(EXAMPLES, example), "--no-what-if")
            self.assertEqual({sort: len(document[sort]) for sort in counts}, counts)
            whole = document["time_ps"]
            shown = dict.fromkeys(line for line in run.stdout.splitlines())
            for sort, name in (("processors", "processor"), ("links", "link"), ("buses", "bus")):
                for each in document[sort]:
                    self.assertEqual(each["busy_ps"] + each["idle_ps"], whole)
                    columns = [each["busy_ps"], each["idle_ps"]] + [each[wait] for wait in ("waits_to_ps", "masters_waited_ps") if wait in each]
                    told = " ".join([each[name], *(f"{100 * time / whole:.1f} %" for time in columns)])
                    self.assertIn(told, {" ".join(line.replace("its masters waited", "").split()) for line in shown})

    def test_why_nothing_is_tried_is_told(self):
        deadlock = os.path.join(EXAMPLES, "csp/deadlock", "ring.cfs")
        for netlist, options, ending in ((deadlock, (), "deadlock"),
                                         (FIGURE_E2, ("--until", "1ms"), "stopped at the time limit")):
            run, document = explained(netlist, *options)
            why = f"a comparison needs the time at which the work is done, but this run did not complete ({ending})"
            self.assertIn(f"\nwhat if: no change of the machine was tried: {why}\n", run.stdout)
            self.assertEqual(document["not_tried"], why)
            run, document = explained(netlist, "--no-what-if", *options)
            self.assertNotIn("what if", run.stdout)
            self.assertNotIn("not_tried", document)

    def test_one_more_is_tried_of_what_makes_processes_or_processors(self):
        for example, expected in (("thesis/figure-e2/figure-e2.cfs", {"clusters": "", "slaves": ""}),
                                  ("genetic/islands/islands.cfs", {"islands": "a power of two", "processors": "the subscript 9"})):
            _, document = explained(os.path.join(EXAMPLES, example))
            tried = {what["what"].split()[3].rstrip(":"): what for what in document["what_if"] if what["what"].startswith("one more")}
            self.assertEqual(set(tried), set(expected))
            for val, refusal in expected.items():
                self.assertIn(refusal, tried[val].get("refused", ""))

    def test_a_process_alone_is_varied_where_it_shares_its_processor(self):
        _, document = explained(os.path.join(EXAMPLES, "csp/matrix", "matrix.cfs"))
        answers = {what["what"]: what for what in document["what_if"]}
        times = [answer["time_ps"] for what, answer in answers.items() if what.startswith("what ")]
        self.assertTrue(times)
        self.assertLess(min(times), document["time_ps"])


if __name__ == "__main__":
    unittest.main()
