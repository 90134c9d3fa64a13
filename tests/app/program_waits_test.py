"""Tests what the program says of the processes inside of booted transputers: deadlocks, analyse, tables, traces, pages."""

import json
import pathlib
import re
import subprocess
import tempfile
import unittest

from chromium import CHROMIUM, Chromium
from page_reader import data_of
from program import PROGRAM, placedpar

CROSS = """
there = 1
back = 2
        ajw 64
        mint; stl there; mint; stl back
        ldc other - after; ldlp -20; startp
after:  ldlp 3; ldlp there; ldc 4; out
        ldlp 3; ldlp back; ldc 4; in
        stopp
other:  ldlp 0; ldlp 20 + back; ldc 4; out
        ldlp 0; ldlp 20 + there; ldc 4; in
        stopp
"""
LINES = """-- places as a compiler would give them
code +#0C +#16 3 1 cross.occ
code +#16 +#22 4 1 cross.occ
entry +#00 main
entry +#16 other
process +#C0 +#D6 main/0
process +#D6 +#12C main/1
end
"""


class ProgramWaits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return self.folder / name

    def assembled(self, name, source):
        done = placedpar("assemble", self.file(name + ".tas", source), "-o", self.folder / (name + ".btl"))
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / (name + ".btl")

    def run_of(self, *arguments, code=2):
        done = placedpar("run", *arguments)
        self.assertEqual((done.returncode, done.stderr), (code, ""), done.stdout)
        return done.stdout


class Deadlock(ProgramWaits):
    def test_two_processes_that_output_first_are_a_cycle(self):
        out = self.run_of(self.assembled("cross", CROSS))
        self.assertIn("\nwait cycle: root.#80000144 -> root.#80000194 -> root.#80000144\n", out)
        self.assertRegex(out, r"\nhost +inputs\n"
                              r"root.#80000144 +outputs +root.#8000019C +#8000008B after out\n"
                              r"root.#80000194 +outputs +root.#80000198 +#80000080 after out\n")
        self.assertRegex(out, r"\nroot.#8000019C +root.#80000144 +root.#80000194 +outputter\n"
                              r"root.#80000198 +root.#80000194 +root.#80000144 +outputter\n")

    def test_a_cycle_leads_over_the_links_of_two_transputers(self):
        """Each node outputs to the other before it inputs. The output is done when the other one takes it."""
        root = """
            ajw 16; ldpi boot; mint; ldnlp 2; ldc end - boot; out
            ldlp 1; mint; ldnlp 2; ldc 4; out
            ldlp 1; mint; ldnlp 6; ldc 4; in; stopp
    boot:   .byte end - code
    code:   .byte #B8, #11, #24, #F2, #51, #44, #FB, #11, #24, #F2, #55, #44, #F7, #21, #F5
    end:
    """
        # The worker's code: ajw 8; ldlp 1; mint; ldnlp 1; ldc 4; out; ldlp 1; mint; ldnlp 5; ldc 4; in; stopp
        self.assembled("root", root)
        netlist = self.file("net.cfs", 'T800 (memory = 1M) root, worker; connect root.link[0] to host;\n'
                                       'connect root.link[2] to worker.link[1]; use "root.btl" for root;\n')
        out = self.run_of(netlist)
        self.assertRegex(out, r"\nwait cycle: root.#\w+ -> worker.#\w+ -> root.#\w+\n")
        self.assertRegex(out, r"\nroot.#\w+ +outputs +root.link\[2\] -> worker.link\[1\] +#\w+ after out\n")
        self.assertRegex(out, r"\nworker.#\w+ +outputs +worker.link\[1\] -> root.link\[2\] +#\w+ after out\n")
        report = self.folder / "r.json"
        self.run_of(netlist, "--json", report)
        deadlock = json.loads(report.read_text(encoding="utf-8"))["deadlock"]
        self.assertEqual(len(deadlock["cycle"]), 2)
        self.assertEqual([each["operation"] for each in deadlock["processes"]], ["inputs", "outputs", "outputs"])

    def test_a_wait_that_nobody_can_end_is_no_cycle(self):
        out = self.run_of(self.assembled("alone", "ajw 8; ldlp 0; mint; ldnlp 8; ldc 4; in; stopp"))
        self.assertNotIn("wait cycle", out)
        self.assertRegex(out, r"\nroot.#\w+ +inputs +root.event +#\w+ after in\n")
        self.assertRegex(out, r"\nroot.event +none found +root.#\w+ +inputter\n")

    def test_a_table_gives_lines_and_names(self):
        file = self.assembled("cross", CROSS)
        self.file("cross.lines", LINES)
        out = self.run_of(file)
        self.assertIn("\nwait cycle: root.main/0 -> root.main/1 -> root.main/0\n", out)
        self.assertRegex(out, r"\nroot.main/0 +outputs +root.#8000019C +cross.occ:4:1\n")
        self.assertRegex(out, r"\nroot.main/1 +outputs +root.#80000198 +cross.occ:3:1\n")
        listing = self.run_of(file, "--listing")
        self.assertIn("\nmain:\n#80000070 ", listing)
        self.assertRegex(listing, r"\n#8000007C .* cross.occ:3:1\n")
        self.assertEqual(listing.count("cross.occ:3:1"), 2)  # the other one is in the report of the deadlock
        step = subprocess.run([PROGRAM, "run", file, "--step"], input="b #8000007C\nc\nc\n", capture_output=True,
                              text=True, timeout=60, check=False)
        self.assertIn("   -- cross.occ:3:1\n", step.stdout)

    def test_a_wrong_table_is_refused_with_its_place(self):
        file = self.assembled("cross", CROSS)
        for text, message in ((LINES.replace("end\n", ""), '8:1: error: the table is cut off: its last row must be "end"'),
                              (LINES.replace("+#16 3", "+#17 3"), "3:1: error: the row has an address that the row in line 2 has already"),
                              (LINES.replace("#0C", "0C"), "2:6: error: FROM is not an address such as #80000170"),
                              (LINES.replace("main\n", "\x01\n", 1), "error: ")):
            path = self.file("cross.lines", text)
            done = placedpar("run", file)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(f"{path}:", done.stderr)
            self.assertIn(message, done.stderr)


class Analyse(ProgramWaits):
    def test_the_state_is_printed_after_each_kind_of_stop(self):
        file = self.assembled("cross", CROSS)
        out = self.run_of(file, "--analyse")
        self.assertIn("\nroot\nno process runs: the registers are those of the last process\nIptr #8000008B  Wptr #80000144", out)
        self.assertIn("\nflags: no Error at low priority, no Error at high priority, no HaltOnError, no FPError\n", out)
        self.assertIn("\nhigh priority: empty\nlow priority: empty\ntimer, high: empty\ntimer, low: empty\nwaiting:\n", out)
        self.assertIn("\n  Wptr #80000144, low priority, Iptr #8000008B after out: outputs, its descriptor is at #8000019C\n", out)
        self.assertNotIn("waiting:", self.run_of(file))
        halted = self.run_of(self.assembled("halts", "sethalterr; ldc 1; ldc 0; div"), "--analyse", code=1)
        self.assertIn("\nflags: Error at low priority, no Error at high priority, HaltOnError, no FPError\n", halted)
        self.assertIn("\nwaiting: none\n", halted)
        runs = self.run_of(self.assembled("runs", "loop: j loop"), "--analyse", "--until", "100us", code=0)
        self.assertIn("\nroot\nIptr #80000070  Wptr #80000074", runs)
        timer = self.run_of(self.assembled("timer", "ajw 8; ldc 0; sttimer; ldc 100; tin; stopp"), "--analyse", "--until", "1ms", code=0)
        self.assertRegex(timer, r"\ntimer, low:\n  Wptr (#\w+)  Iptr #\w+  until 100\nwaiting:\n  Wptr \1, low priority, Iptr "
                                r"#\w+ after tin: waits for its timer, until its clock is after 100\n")


PING_PONG = """
        ajw 64; ldc 0; sttimer
        mint; stl 1; mint; stl 2; ldc 3; stl 4
        ldc other - again; ldlp -20; startp
again:  ldlp 3; ldlp 1; ldc 4; out
        ldlp 3; ldlp 2; ldc 4; in
        ldl 4; adc -1; stl 4; ldl 4; eqc 0; cj again
        ldc 2; tin
        stopp
other:  ldlp 0; ldlp 21; ldc 4; in
        ldlp 0; ldlp 22; ldc 4; out
        j other
"""


class Traces(ProgramWaits):
    def test_a_trace_shows_each_process_and_changes_nothing(self):
        file, trace = self.assembled("pong", PING_PONG), self.folder / "t.json"
        plain = self.run_of(file)
        traced = self.run_of(file, "--trace", trace)
        self.assertEqual(traced, plain)
        events = json.loads(trace.read_text(encoding="utf-8"))["traceEvents"]
        names = {event["tid"]: event["args"]["name"] for event in events if event["name"] == "thread_name"}
        main, other = (next(tid for tid, name in names.items() if name == "root." + each) for each in ("#800001A4", "#80000154"))
        of = {tid: [event for event in events if event["ph"] in "XB" and event["tid"] == tid] for tid in names}
        waits = [event["name"] for event in of[main] if event["cat"] == "wait"]
        self.assertEqual(waits.count("outputs to root.#80000154"), 3, waits)
        self.assertIn("waits for its timer", waits)
        self.assertEqual(waits[-1], "has stopped")
        self.assertEqual([event["name"] for event in of[other] if event["ph"] == "B"], ["inputs from root.#800001A4"])
        processor = next(tid for tid, name in names.items() if name == "processor root")
        busy = sum(event["dur"] for event in of[processor])
        self.assertAlmostEqual(busy, sum(event["dur"] for tid in names if names[tid].startswith("root.#")
                                         for event in of[tid] if event["cat"] == "compute"), places=6)
        self.assertAlmostEqual(busy, float(re.search(r"root +T800 +([0-9.]+) us", plain).group(1)), places=2)

    def test_names_of_a_table_join_workspaces(self):
        file, trace = self.assembled("cross", CROSS), self.folder / "t.json"
        self.file("cross.lines", LINES.replace("+#C0 +#D6 main/0", "+#20 +#D6 all/0").replace("+#D6 +#12C main/1", "+#D6 +#12C all"))
        self.run_of(file, "--trace", trace)
        names = {event["args"]["name"] for event in json.loads(trace.read_text(encoding="utf-8"))["traceEvents"]
                 if event["name"] == "thread_name"}
        self.assertTrue({"root.all", "root.all/0"} <= names, names)

    def test_the_other_formats_and_the_page_show_them(self):
        file = self.assembled("pong", PING_PONG)
        for name in ("t.vcd", "t.svg"):
            self.run_of(file, "--trace", self.folder / name)
            self.assertIn("#80000154", (self.folder / name).read_text(encoding="utf-8").replace("_80000154", "#80000154"))
        page = self.folder / "p.html"
        self.run_of(file, "--page", page)
        data = data_of(page.read_text(encoding="utf-8"))
        tracks = {track["name"]: track["kind"] for track in data["timeline"]["tracks"]}
        self.assertEqual(tracks["root.#80000154"], "program")
        self.assertEqual(data["report"]["deadlock"]["processes"][1]["process"], "root.#80000154")

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_the_page_tells_in_a_browser_what_a_process_waits_for(self):
        file, page = self.assembled("pong", PING_PONG), self.folder / "p.html"
        self.run_of(file, "--page", page)
        chromium = Chromium()
        self.addCleanup(chromium.close)
        chosen, said = chromium.value_in(page.as_uri() + "#process=root.%2380000154&at=1", "document.getElementById('chosen').textContent")
        self.assertEqual(said, [])
        self.assertIn("a process of the booted program", chosen)
        self.assertIn("inputs from root.#800001A4", chosen)
        rows, said = chromium.value_in(page.as_uri(), "view.rows.map(row => row.heading || labelOf(row.track)).join(' ')")
        self.assertEqual(said, [])
        self.assertEqual(rows.split(), ["root", "T800", "processor", "root.#800000A4", "root.#80000154", "root.#800001A4"])
        self.run_of(self.assembled("cross", CROSS), "--page", page)
        deadlock, said = chromium.value_in(page.as_uri(), "document.getElementById('deadlock').textContent")
        self.assertEqual(said, [])
        self.assertIn("root.#80000144 \u2192 root.#80000194 \u2192 root.#80000144", deadlock)

    def test_explain_accounts_for_the_waits(self):
        self.assembled("pong", PING_PONG)
        netlist = self.file("net.cfs", 'T800 (memory = 1M) root; connect root.link[0] to host; use "pong.btl" for root;\n')
        done = placedpar("explain", netlist)
        self.assertRegex(done.stdout, r"\nroot.#80000154 .* root.#800001A4")


if __name__ == "__main__":
    unittest.main()
