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
                process = {"table.cfs": "root.phil[2]", "spread.cfs": "left.phil[3]", "mixed.cfs": "",
                           "../routed/farm.cfs": "between[0].mux of link[0], worker[1].result"}[name]
                self.assertTrue(any(process in str(event.get("args", "")) for event in events), process)
                for command in (("check",), ("show",), ("show", "--format", "json"), ("show", "--format", "dot"),
                                ("show", "--format", "svg"), ("explain",)):
                    done = placedpar(*command[:1], NETWORKS / name, *command[1:])
                    self.assertEqual((done.returncode, done.stderr), (0, ""), command)

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
