"""Tests files as the original tool used them: from DOS, on an include path, with kinds in place of their programs."""

import json
import pathlib
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, fingerprint, placedpar

STEP = EXAMPLES / "hydraulics" / "records" / "boom-4deg.csv"
PIPE = """T800 (memory = size) root;
#INCLUDE "LIB\\SECOND.INC"
connect root.link[0] to host;
process (interface (output out)) source;
process (interface (input in)) sink;
connect source.out to sink.in;
use "SOURCE.LKU" for source;
use "sink.lku" for process;
place source on root;
"""


class RealFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "sizes").mkdir()
        (self.folder / "sizes" / "size.inc").write_text("val size 2M;\r\n\x1a", encoding="ascii", newline="")
        (self.folder / "lib").mkdir()
        (self.folder / "lib" / "second.inc").write_text("T800 second;\nconnect second.link[0] to root.link[1];\n",
                                                        encoding="ascii")
        self.pipe = self.write("PIPE.CFS", '#INCLUDE "SIZE.INC"\n' + PIPE + "place sink on second;\n")
        self.sizes = ("-I", self.folder / "sizes")
        self.kinds = ("--use", "SOURCE.LKU=csp.producer", "--use", "sink.lku=csp.consumer")

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="ascii")
        return path

    def refused(self, *arguments):
        run = placedpar(*arguments)
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        return run.stderr

    def printed(self, *arguments):
        run = placedpar(*arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run.stdout

    def test_every_command_with_a_netlist_takes_an_include_path(self):
        said = self.refused("check", self.pipe)
        self.assertIn('PIPE.CFS:1:10: error: cannot include "SIZE.INC": this file does not exist', said)
        self.assertIn("hint: -I FOLDER", said)
        self.printed("check", self.pipe, *self.sizes)
        self.printed("check", self.pipe, "-I", self.folder / "lib", *self.sizes)
        self.assertIn("2 M", self.printed("show", self.pipe, "--format", "dot", *self.sizes))
        self.printed("run", self.pipe, *self.sizes, *self.kinds)

    def test_a_folder_that_is_none_is_refused(self):
        self.assertEqual(self.refused("check", self.pipe, "-I", "nowhere"),
                         "placedpar: -I nowhere: this folder does not exist\n")

    def test_kinds_take_the_place_of_programs(self):
        said = self.refused("run", self.pipe, *self.sizes)
        self.assertEqual(said.count(": error: "), 1)
        self.assertIn("the netlist can be shown, but not run: 2 programs are unknown\n", said)
        self.assertIn('"SOURCE.LKU" is the program of source\n', said)
        self.assertIn('"sink.lku" is the program of sink\n', said)
        self.assertIn("csp.consumer", self.printed("show", self.pipe, *self.sizes, *self.kinds))
        record = self.folder / "run.json"
        run = self.printed("run", self.pipe, *self.sizes, *self.kinds, "--json", record)
        manifest = json.loads(record.read_text(encoding="utf-8"))["manifest"]
        self.assertEqual(manifest["programs"], {"SOURCE.LKU": "csp.producer", "sink.lku": "csp.consumer"})
        self.assertEqual(manifest["include_folders"], [str(self.sizes[1])])
        shown = self.write("shown.cfs", self.printed("show", self.pipe, *self.sizes, *self.kinds))
        self.assertEqual(fingerprint(self.printed("run", shown)), fingerprint(run))

    def test_wrong_uses_are_refused_with_what_there_is(self):
        self.assertIn("expected PROGRAM=KIND", self.refused("run", self.pipe, "--use", "sink.lku"))
        self.assertIn("sink.lku is given two kinds",
                      self.refused("run", self.pipe, "--use", "sink.lku=csp.consumer", "--use", "sink.lku=csp.delta"))
        self.assertIn('hint: did you mean "sink.lku"?\n',
                      self.refused("check", self.pipe, *self.sizes, "--use", "snk.lku=csp.consumer"))
        self.assertIn('--use:1:10: error: unknown process kind "csp.consumr"\n',
                      self.refused("check", self.pipe, *self.sizes, "--use", "sink.lku=csp.consumr"))

    def test_a_process_at_the_host_runs_without_a_workstation(self):
        at_host = self.write("host.cfs", '#INCLUDE "SIZE.INC"\n' + PIPE + "place sink on host;\n")
        run = self.printed("run", at_host, *self.sizes, *self.kinds)
        self.assertRegex(run, r"sink +last_number +999\n")
        shown = self.write("shown.cfs", self.printed("show", at_host, *self.sizes, *self.kinds))
        self.assertIn("workstation host;", shown.read_text(encoding="utf-8"))
        self.assertEqual(fingerprint(self.printed("run", shown)), fingerprint(run))

    def test_identify_takes_both(self):
        text = CLUSTER.read_text(encoding="utf-8").replace('"ga.slave"', '"SLAVE.LKU"')
        text = text.replace('"../', '"thesis/')
        self.assertIn("SLAVE.LKU", text)
        self.write("sizes/cluster.inc", text)
        netlist = self.write("main.cfs", '#include "CLUSTER.INC"\n')
        way = ("identify", STEP, "--way", "thesis", "--trials", "1", "--on", netlist, "-I", EXAMPLES)
        self.assertIn("cannot include", self.refused(*way))
        self.assertIn("equal\n", self.printed(*way, *self.sizes, "--use", "SLAVE.LKU=ga.slave"))


if __name__ == "__main__":
    unittest.main()
