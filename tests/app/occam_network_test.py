"""Tests commands on netlists whose processes are programs in occam."""

import json
import pathlib
import tempfile
import unittest

from program import EXAMPLES, placedpar

NETWORKS = EXAMPLES / "occam" / "network"


class OccamNetworks(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def test_every_command_reads_the_examples(self):
        for name in ("table.cfs", "spread.cfs", "mixed.cfs", "../routed/farm.cfs"):
            with self.subTest(name):
                report, trace, page = (self.folder / file for file in ("report.json", "trace.json", "page.html"))
                plain = placedpar("run", NETWORKS / name)
                done = placedpar("run", NETWORKS / name, "--json", report, "--trace", trace, "--page", page)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(done.stdout, plain.stdout)
                self.assertEqual(json.loads(report.read_text(encoding="utf-8"))["outcome"], "completed")
                events = json.loads(trace.read_text(encoding="utf-8"))["traceEvents"]
                process = {"table.cfs": "phil[2]", "spread.cfs": "phil[3]", "mixed.cfs": "",
                           "../routed/farm.cfs": "between[0].mux of link[0], worker[1].result"}[name]
                self.assertTrue(any(process in str(event.get("args", "")) for event in events), process)
                rows = [event["args"]["name"] for event in events if event["name"] == "thread_name"]
                self.assertFalse([row for row in rows if ".phil[" in row], "a process has one row")
                self.assertEqual(len(rows), len(set(rows)))
                for command in (("check",), ("show",), ("show", "--format", "json"), ("show", "--format", "dot"),
                                ("show", "--format", "svg"), ("explain",)):
                    done = placedpar(*command[:1], NETWORKS / name, *command[1:])
                    self.assertEqual((done.returncode, done.stderr), (0, ""), command)

    SHARES = """PROC share (VAL INT of, CHAN OF INT out)
  out ! 100 / of
:
PROC sum (CHAN OF INT a, b)
  INT x, y:
  SEQ
    a ? x
    b ? y
:
"""

    def test_the_error_mode_is_an_option(self):
        (self.folder / "shares.occ").write_text(self.SHARES, encoding="ascii")
        netlist = self.folder / "shares.cfs"
        netlist.write_text('process share[2], sum; use "shares.occ#share" for share; use "shares.occ#sum" for sum;\n'
                           "rep i = 0 for 2 share[i] (of = i);\n"
                           "connect share[0].out to sum.a; connect share[1].out to sum.b;\n", encoding="ascii")
        halted = placedpar("run", netlist)
        self.assertEqual(halted.returncode, 1, halted.stdout + halted.stderr)
        self.assertRegex(halted.stdout, r"stopped at \S*shares\.occ:2:3: division by zero: 100 / 0, in share\[0\], at ")
        stopped = placedpar("run", netlist, "--mode", "stop")
        self.assertEqual(stopped.returncode, 2, stopped.stdout + stopped.stderr)
        self.assertRegex(stopped.stdout, r"\nshare\[0\] stopped at \S*shares\.occ:2:3: division by zero: 100 / 0, at ")
        self.assertRegex(stopped.stdout, r"\nsum +inputs +.*shares\.occ:7:")
        unchecked = placedpar("run", netlist, "--no-checks", "usage")
        self.assertEqual(unchecked.returncode, 1)
        self.assertIn('a netlist cannot turn off the check "usage" of its programs; write #OPTION "N" into the file', unchecked.stderr)
        empty = self.folder / "empty.cfs"
        empty.write_text("T800 a;\n", encoding="ascii")
        run = placedpar("run", empty, "--mode", "stop")
        self.assertEqual(run.returncode, 1)
        self.assertIn("--mode: no process of ", run.stderr)

    def test_a_halted_processor_of_a_configuration_is_the_first_that_is_told(self):
        configuration = self.folder / "two.pgm"
        configuration.write_text("""NODE a, b:
ARC l:
NETWORK
  DO
    SET a (type, memsize := "T800", 1024 * 1024)
    SET b (type, memsize := "T800", 1024 * 1024)
    CONNECT a[link][1] TO b[link][0] WITH l
:
PROC p (CHAN OF INT c)
  INT x:
  SEQ
    x := 0
    c ! 5 / x
:
PROC q (CHAN OF INT c)
  INT x:
  c ? x
:
CONFIG
  CHAN OF INT c:
  PLACE c ON l:
  PAR
    PROCESSOR a
      p (c)
    PROCESSOR b
      q (c)
:
""", encoding="ascii")
        halted = placedpar("run", configuration)
        self.assertEqual(halted.returncode, 1, halted.stdout + halted.stderr)
        self.assertRegex(halted.stdout, r"\A\S*two\.pgm: halted by an error at \d+\.\d+ us\nfingerprint: \w+\n\n"
                                        r"a stopped at \S*two\.pgm:13:5: division by zero: 5 / 0, in p, at .*\n\n")
        self.assertRegex(halted.stdout, r"\nq +inputs +p\.c -> q\.c +\S*two\.pgm:17:3\n")

    def test_a_printed_network_runs_the_same(self):
        printed = self.folder / "printed.cfs"
        absolute = NETWORKS.resolve() / "spread.cfs"
        printed.write_text(placedpar("show", absolute, "--format", "cfs").stdout, encoding="utf-8")
        self.assertEqual(placedpar("run", printed).stdout.replace(str(printed), "").splitlines()[:7],
                         placedpar("run", absolute).stdout.replace(str(absolute), "").splitlines()[:7])

    def test_a_sweep_runs_channels_over_shared_wires(self):
        done = placedpar("sweep", EXAMPLES.resolve() / "occam/routed/stream.cfs", "shared=0,1", "messages=50", "--yes",
                         folder=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        alone, shared = (float(line.split()[-1]) for line in done.stdout.splitlines() if line.split()[-2:-1] == ["1"])
        self.assertLess(alone, shared)

    def test_the_kind_of_a_file_is_printed(self):
        done = placedpar("kinds", NETWORKS / "square.occ")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"in +input +INT")
        (kind,) = json.loads(placedpar("kinds", NETWORKS / "square.occ", "--json").stdout)["processes"]
        self.assertEqual([port["name"] for port in kind["ports"]], ["in", "out"])
        done = placedpar("kinds", self.folder / "none.occ")
        self.assertEqual(done.returncode, 1)
        self.assertIn("none.occ\" is missing", done.stderr)

    def test_errors_of_a_file_have_their_places(self):
        (self.folder / "bad.occ").write_text("PROC bad (CHAN OF INT out)\n  out ! TRUE\n:\n", encoding="utf-8")
        netlist = self.folder / "bad.cfs"
        netlist.write_text('process p; use "bad.occ" for p;\n', encoding="utf-8")
        for command in ("run", "check"):
            done = placedpar(command, netlist)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"bad\.occ:2:9: error: .*BOOL")
            self.assertRegex(done.stderr, r"bad\.cfs:1:12: note: the file is used here")

    def test_files_are_found_in_folders(self):
        netlist = self.folder / "apart.cfs"
        netlist.write_bytes((NETWORKS / "mixed.cfs").read_bytes())
        self.assertEqual(placedpar("run", netlist).returncode, 1)
        self.assertEqual(placedpar("run", netlist, "-I", NETWORKS).returncode, 0)


if __name__ == "__main__":
    unittest.main()
