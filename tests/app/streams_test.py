"""Tests standard input and output as files, and readers that close early."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, PROGRAM, placedpar
from trace_reader import JsonTrace

RECORD = EXAMPLES / "hydraulics" / "records" / "boom-4deg.csv"
COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
DEADLOCK = EXAMPLES / "csp/deadlock" / "ring.cfs"


class Streams(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def fed(self, text, *arguments, folder=None):
        return subprocess.run([PROGRAM, *map(str, arguments)], input=text, stdout=subprocess.PIPE, cwd=folder,
                              stderr=subprocess.PIPE, text=isinstance(text, str), timeout=60, check=False)

    def test_a_netlist_comes_from_standard_input(self):
        text = COMMSTIME.read_text(encoding="utf-8")
        for command in (["run"], ["check"], ["show"], ["show", "--format", "dot"], ["run", "--set", "count=5"]):
            named, fed = placedpar(*command, COMMSTIME), self.fed(text, *command, "-")
            self.assertEqual(fed.returncode, 0, fed.stderr)
            self.assertEqual(fed.stdout, named.stdout.replace(str(COMMSTIME), "<standard input>"))
        self.fed(text, "run", "-", "--json", "report.json", folder=self.folder)
        report = json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        self.assertEqual(report["manifest"]["netlist"], "<standard input>")

    def test_differences_in_vals_are_found_in_a_netlist_from_standard_input(self):
        text = "val n 2;\nT800 t;\nprocess p;\nuse \"csp.task\" for p;\np (cycles = n * 100);\nplace p on t;\n"
        (self.folder / "b.cfs").write_text(text.replace("val n 2", "val n 3"), encoding="utf-8")
        run = self.fed(text, "compare", "-", "b.cfs", folder=self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("  val n: 2 in A, 3 in B\n", run.stdout)

    def test_a_sweep_of_standard_input_needs_a_name_for_its_results(self):
        text = COMMSTIME.read_text(encoding="utf-8")
        nameless = self.fed(text, "sweep", "-", "count=5,6", folder=self.folder)
        self.assertEqual((nameless.returncode, nameless.stderr),
                         (1, "placedpar: a netlist from standard input gives the results no name: add --results "
                             "FILE.sqlite\n"))
        swept = self.fed(text, "sweep", "-", "count=5,6", "--results", "r.sqlite", folder=self.folder)
        self.assertEqual(swept.returncode, 0, swept.stderr)
        named = placedpar("sweep", COMMSTIME, "count=5,6", "--results", self.folder / "n.sqlite")
        self.assertEqual(swept.stdout.splitlines()[0], "<standard input>: 2 runs of 2 combinations")
        self.assertEqual(swept.stdout.splitlines()[1:-1], named.stdout.splitlines()[1:-1])

    def test_commands_that_do_not_read_standard_input_say_so(self):
        for command in (["report"], ["optimise"], ["disassemble"], ["send", "--to", "tcp:localhost:1"]):
            run = self.fed("", *command, "-", folder=self.folder)
            self.assertEqual((run.returncode, run.stdout), (1, ""), command)
            self.assertIn("this command does not read standard input; expected the name of a file\n", run.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_netlist_comes_from_a_pipe_with_a_name(self):
        pipe = self.folder / "pipe.cfs"
        os.mkfifo(pipe)
        with subprocess.Popen(["cp", COMMSTIME, pipe]) as writer:
            piped = placedpar("check", pipe)
            self.assertEqual(writer.wait(timeout=60), 0)
        self.assertEqual((piped.returncode, piped.stdout),
                         (0, placedpar("check", COMMSTIME).stdout.replace(str(COMMSTIME), str(pipe))))

    def test_messages_call_it_standard_input(self):
        self.assertTrue(self.fed("val n 1;\nval k;\n", "check", "-").stderr.startswith("<standard input>:2:6: error: "))
        self.assertTrue(self.fed(b"T800\0", "check", "-").stderr.startswith(b"<standard input>:1:5: error: this is a binary file, not text"))
        self.assertTrue(self.fed("depth\n", "identify", "-").stderr.startswith("<standard input>: error: "))
        self.assertTrue(self.fed("time,depth\n1,2\n", "identify", "-").stderr.startswith("<standard input>:1:"))

    def test_occam_on_standard_input_is_refused_with_a_hint(self):
        for command in ("run", "check"):
            run = self.fed("PROC main ()\n  SKIP\n:\n", command, "-")
            self.assertEqual((run.returncode, run.stdout), (1, ""))
            self.assertTrue(run.stderr.startswith("<standard input>:1:1: error: this is occam, but standard input is read as a netlist"), run.stderr)
            self.assertIn("hint: write the program into a file whose name ends in .occ\n", run.stderr)

    def test_nothing_on_standard_input_is_no_empty_netlist(self):
        said = "<standard input>: error: standard input is empty or closed\n"
        for command in ("run", "check", "show"):
            run = self.fed("", command, "-")
            self.assertEqual((run.returncode, run.stdout, run.stderr), (1, "", said), command)
            closed = subprocess.run([PROGRAM, command, "-"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                    timeout=60, check=False, preexec_fn=lambda: os.close(0))
            self.assertEqual((closed.returncode, closed.stdout, closed.stderr), (1, "", said), command)
        self.assertEqual(self.fed("", "identify", "-").stderr, said)

    def test_includes_are_looked_for_in_the_working_directory(self):
        (self.folder / "machine.inc").write_text("T800 t;\n", encoding="utf-8")
        run = self.fed('#include "machine.inc"\n', "check", "-", folder=self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("<standard input>: 1 processor, 0 connections, ", run.stdout)
        (self.folder / "-").write_text("T800 u;\n", encoding="utf-8")  # a file named "-"
        run = self.fed('#include "machine.inc"\n', "check", "./-", folder=self.folder)
        self.assertIn("./-: 1 processor, ", run.stdout)

    def test_a_record_and_a_machine_come_from_standard_input(self):
        text = RECORD.read_text(encoding="utf-8")
        self.assertEqual(self.fed(text, "identify", "-").stdout, placedpar("identify", RECORD).stdout)
        machine = placedpar("parameters").stdout.replace("boom.mass = ", "boom.mass = 1")
        path = self.folder / "machine.txt"
        path.write_text(machine, encoding="utf-8")
        fed = self.fed(machine, "record", "excavator", "--machine", "-")
        self.assertEqual(fed.returncode, 0, fed.stderr)
        self.assertEqual(fed.stdout, placedpar("record", "excavator", "--machine", path).stdout)
        netlist = self.fed(CLUSTER.read_text(encoding="utf-8"), "identify", RECORD, "--way", "thesis", "--on", "-", "--set", "slaves=1",
                           folder=CLUSTER.parent)
        self.assertEqual(netlist.returncode, 0, netlist.stderr)
        self.assertIn("from the netlist's processes: equal", netlist.stdout)

    def test_standard_input_is_one_file(self):
        for arguments in (["identify", "-", "--way", "thesis", "--on", "-"], ["identify", "-", "--machine", "-"]):
            run = self.fed("", *arguments)
            self.assertEqual((run.returncode, run.stderr), (1,
                "placedpar: standard input can be read only once: at most one of RECORD, --machine, --columns-from and --on can be \"-\"\n"))

    def test_what_is_written_to_standard_output_stands_there_alone(self):
        plain = placedpar("run", COMMSTIME, "--set", "count=5")
        run = placedpar("run", COMMSTIME, "--set", "count=5", "--json", "-")
        self.assertEqual((run.returncode, run.stderr), (0, plain.stdout))
        self.assertEqual(json.loads(run.stdout)["outcome"], "completed")
        trace = self.folder / "trace.json"
        placedpar("run", COMMSTIME, "--set", "count=5", "--trace", trace)
        run = placedpar("run", COMMSTIME, "--set", "count=5", "--trace", "-")
        self.assertEqual((run.returncode, run.stderr), (0, plain.stdout))
        self.assertEqual(run.stdout, trace.read_text(encoding="utf-8"))
        self.assertEqual(placedpar("record", "scenario-a", "--out", "-").stdout, placedpar("record", "scenario-a").stdout)
        cells = placedpar("replay", "table-e1", "--json", "-")
        self.assertEqual(cells.stderr, placedpar("replay", "table-e1").stdout)
        self.assertTrue(json.loads(cells.stdout))
        shown, path = placedpar("show", CLUSTER), self.folder / "shown.cfs"
        self.assertEqual(placedpar("show", CLUSTER, "-o", "-").stdout, shown.stdout)
        self.assertEqual(placedpar("show", CLUSTER, "-o", path).stdout, "")
        self.assertEqual(path.read_text(encoding="utf-8"), shown.stdout)
        run = placedpar("show", path, "-o", path)
        self.assertEqual((run.returncode, path.read_text(encoding="utf-8")), (1, shown.stdout))
        found = placedpar("identify", RECORD, "--json", "-")
        self.assertEqual(found.stderr, placedpar("identify", RECORD).stdout)
        self.assertTrue(json.loads(found.stdout))

    def test_from_standard_input_to_standard_output(self):
        run = self.fed(COMMSTIME.read_text(encoding="utf-8"), "run", "-", "--set", "count=5", "--json", "-")
        self.assertEqual(json.loads(run.stdout)["manifest"]["netlist"], "<standard input>")
        self.assertEqual(run.returncode, 0)

    def test_standard_output_takes_one_file_and_no_folder(self):
        run = placedpar("run", COMMSTIME, "--json", "-", "--trace", "-")
        self.assertEqual(run.returncode, 1)
        self.assertEqual(run.stderr, "placedpar: <standard output>: cannot be written: two outputs have the same file name; "
                                     "choose two names\n")
        run = subprocess.run([PROGRAM, "replay", "figure-2-3", "--plots", "-"], stdout=subprocess.PIPE, cwd=self.folder,
                             stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        self.assertEqual((run.returncode, os.listdir(self.folder)), (1, []))
        self.assertIn("plots are written as files into a folder", run.stderr)

    def test_a_full_disk_behind_standard_output_is_no_success(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            run = subprocess.run([PROGRAM, "run", str(COMMSTIME), "--set", "count=5", "--json", "-"], stdout=full,
                                 stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("placedpar: <standard output>: cannot be written: No space left on device\n", run.stderr)


# It prints for ever.
YES = """#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC yes (CHAN OF SP fs, ts)
  WHILE TRUE
    so.write.string.nl (fs, ts, "yes")
:
"""


class ReadersThatGo(unittest.TestCase):
    """Readers close the pipe, as `head` does, but before anything is printed, so that speed does not matter."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def unread(self, *arguments):
        """Returns the exit code and standard error."""
        reader, writer = os.pipe()
        os.close(reader)
        run = subprocess.run([PROGRAM, *map(str, arguments)], stdout=writer, stderr=subprocess.PIPE, text=True, timeout=60,
                             check=False)
        os.close(writer)
        return run.returncode, run.stderr

    def test_a_run_writes_its_files_all_the_same(self):
        for netlist, code in ((COMMSTIME, 0), (DEADLOCK, 2)):
            report, trace = self.folder / "report.json", self.folder / "trace.json"
            self.assertEqual(self.unread("run", netlist, "--json", report, "--trace", trace), (code, ""))
            self.assertTrue(json.loads(report.read_text(encoding="utf-8"))["processes"])
            self.assertTrue(JsonTrace(trace).slices)
            report.unlink()
            trace.unlink()

    def test_a_program_that_prints_for_ever_ends(self):
        program, report = self.folder / "yes.occ", self.folder / "report.json"
        program.write_text(YES, encoding="ascii")
        for options in ((), ("--keys", "a")):
            self.assertEqual(self.unread("run", program, "--json", report, *options), (0, ""))
            self.assertEqual(json.loads(report.read_text(encoding="utf-8"))["outcome"], "interrupted")
        with subprocess.Popen([PROGRAM, "run", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
            self.assertEqual(run.stdout.readline(), b"yes\n")
            run.stdout.close()
            self.assertEqual(run.wait(timeout=60), 0)
            self.assertEqual(run.stderr.read(), b"")

    def test_a_program_whose_output_cannot_be_written_ends(self):
        program = self.folder / "yes.occ"
        program.write_text(YES, encoding="ascii")
        with open("/dev/full", "w", encoding="ascii") as full:
            run = subprocess.run([PROGRAM, "run", program], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("the program's output cannot be written: No space left on device", run.stderr)
        run = subprocess.run([PROGRAM, "run", program], stderr=subprocess.PIPE, text=True, timeout=60, check=False,
                             preexec_fn=lambda: os.close(1))
        self.assertEqual(run.returncode, 1)
        self.assertIn("the program's output cannot be written", run.stderr)

    def test_so_do_other_commands(self):
        path = self.folder / "found.json"
        self.assertEqual(self.unread("identify", RECORD, "--json", path), (0, ""))
        self.assertTrue(json.loads(path.read_text(encoding="utf-8")))
        self.assertEqual(self.unread("replay", "table-e1", "--json", path), (0, ""))
        self.assertTrue(json.loads(path.read_text(encoding="utf-8"))["cells"])
        self.assertEqual(self.unread("kinds"), (0, ""))
        self.assertEqual(self.unread("show", CLUSTER), (0, ""))

    def test_one_file_that_is_not_read_costs_no_other(self):
        path = self.folder / "report.json"
        code, report = self.unread("run", COMMSTIME, "--trace", "-", "--json", path)
        self.assertEqual(code, 0)
        self.assertIn("completed at", report)
        self.assertEqual(json.loads(path.read_text(encoding="utf-8"))["outcome"], "completed")


if __name__ == "__main__":
    unittest.main()
