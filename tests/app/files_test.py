"""Tests that the program writes a file completely or not at all."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, FIGURE_E2, PROGRAM, fingerprint, placedpar

RECORD = EXAMPLES / "hydraulics" / "records" / "boom-4deg.csv"
COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_the_record_holds_what_is_needed_to_run_it_again(self):
        path = self.folder / "run.json"
        run = placedpar("run", CLUSTER, "--set", "slaves=2", "--seed", "7", "--json", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        record = json.loads(path.read_text(encoding="utf-8"))
        manifest = record["manifest"]
        self.assertEqual(manifest["overrides"], {"slaves": "2"})
        overrides = [word for name, value in manifest["overrides"].items() for word in ("--set", f"{name}={value}")]
        again = placedpar("run", manifest["netlist"], "--seed", manifest["seed"], *overrides)
        self.assertEqual(fingerprint(again.stdout), record["fingerprint"])
        self.assertEqual(again.stdout, run.stdout)

    def test_tracing_changes_nothing(self):
        plain = placedpar("run", CLUSTER)
        traced = placedpar("run", CLUSTER, "--trace", self.folder / "trace.json")
        self.assertEqual(plain.stdout, traced.stdout)

    def test_nothing_is_written_when_the_input_is_refused(self):
        run = placedpar("run", CLUSTER, "--set", "population=1", "--json", self.folder / "run.json", "--trace",
                        self.folder / "trace.json")
        self.assertEqual(run.returncode, 1)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_file_that_cannot_be_written_is_refused_before_the_run(self):
        for path in (self.folder / "none" / "run.json", self.folder):
            run = placedpar("run", CLUSTER, "--json", path)
            self.assertEqual(run.returncode, 1)
            self.assertIn(str(path), run.stderr)
            self.assertEqual(run.stdout, "")

    def test_what_show_prints_loads_again_to_the_same_network(self):
        for netlist in (CLUSTER, FIGURE_E2, EXAMPLES / "csp/commstime" / "commstime.cfs"):
            copy = self.folder / "shown.cfs"
            copy.write_text(placedpar("show", netlist).stdout, encoding="utf-8")
            self.assertEqual(placedpar("check", copy).stdout.split("hash ")[1],
                             placedpar("check", netlist).stdout.split("hash ")[1])
            self.assertEqual(fingerprint(placedpar("run", copy).stdout), fingerprint(placedpar("run", netlist).stdout))

    def test_show_json_names_every_process(self):
        network = json.loads(placedpar("show", FIGURE_E2, "--format", "json").stdout)
        self.assertEqual(len(network["processes"]), 17)

    def test_two_outputs_of_one_name_an_empty_name_and_the_netlist_itself_are_refused(self):
        netlist = self.folder / "mine.cfs"
        netlist.write_text(COMMSTIME.read_text(encoding="utf-8"), encoding="utf-8")
        text = netlist.read_text(encoding="utf-8")
        (self.folder / "link.json").symlink_to(netlist)
        both = self.folder / "both.json"
        for arguments, reason in ((["--json", netlist], "the output file is also the input"),
                                  (["--trace", self.folder / ".." / self.folder.name / "link.json"], "the output file is also the input"),
                                  (["--json", self.folder / "link.json"], "the output file is also the input"),
                                  (["--json", both, "--trace", self.folder / "." / "both.json"], "two outputs have the same file name"),
                                  (["--json", ""], "the name is empty; expected a file name"), (["--trace", ""], "the name is empty; expected a file name")):
            run = placedpar("run", netlist, *arguments)
            self.assertEqual(run.returncode, 1, arguments)
            self.assertIn(reason, run.stderr)
            self.assertEqual(run.stdout, "")
            self.assertEqual(netlist.read_text(encoding="utf-8"), text)
            self.assertFalse(both.exists())

    def test_no_command_overwrites_what_it_reads(self):
        including = self.folder / "including.cfs"
        included = self.folder / "included.json"
        including.write_text('#include "included.json"\n', encoding="utf-8")
        included.write_text(COMMSTIME.read_text(encoding="utf-8"), encoding="utf-8")
        machine = self.folder / "machine.csv"
        machine.write_text(placedpar("parameters").stdout, encoding="utf-8")
        record = self.folder / "record.csv"
        record.write_text(RECORD.read_text(encoding="utf-8"), encoding="utf-8")
        for arguments in (["run", including, "--json", included], ["run", including, "--trace", included],
                          ["record", "scenario-a", "--machine", machine, "--out", machine],
                          ["identify", record, "--json", record],
                          ["identify", record, "--machine", machine, "--json", machine],
                          ["identify", record, "--way", "thesis", "--on", including, "--json", including],
                          ["identify", record, "--way", "thesis", "--on", including, "--json", included]):
            before = {path: path.read_text(encoding="utf-8") for path in self.folder.iterdir()}
            run = placedpar(*arguments)
            self.assertEqual(run.returncode, 1, arguments)
            self.assertIn("the output file is also the input", run.stderr)
            self.assertEqual({path: path.read_text(encoding="utf-8") for path in self.folder.iterdir()}, before)

    def test_identify_writes_what_it_found(self):
        path = self.folder / "found.json"
        run = placedpar("identify", RECORD, "--seed", 3, "--json", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(json.loads(path.read_text(encoding="utf-8"))["seed"], 3)

    def test_a_name_cannot_be_empty(self):
        for arguments in (["replay", "table-e1", "--json"], ["replay", "table-e1", "--plots"],
                          ["record", "scenario-a", "--out"], ["record", "scenario-a", "--machine"],
                          ["identify", RECORD, "--json"], ["identify", RECORD, "--machine"],
                          ["identify", RECORD, "--on"], ["monitor", "--state"], ["assemble", "x.tas", "--out"], ["run"], ["check"], ["show"]):
            run = placedpar(*arguments, "")
            self.assertEqual(run.returncode, 1, arguments)
            what = arguments[-1] if arguments[-1].startswith("-") else "FILE"
            self.assertIn(f"{what}: the name is empty; expected a file name", run.stderr)

    def test_a_symbolic_link_stays_one_and_leads_to_what_was_written(self):
        (self.folder / "there").mkdir()
        target = self.folder / "there" / "target.json"
        link = self.folder / "link.json"
        link.symlink_to("there/target.json")
        for _ in range(2):  # the target does not exist the first time
            run = placedpar("run", COMMSTIME, "--set", "count=5", "--json", link)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertTrue(link.is_symlink())
            self.assertIn("fingerprint", json.loads(target.read_text(encoding="utf-8")))
            self.assertEqual(os.listdir(target.parent), ["target.json"])

    def test_a_pipe_is_written_and_stays_one(self):
        for option in ("--json", "--trace"):
            pipe = self.folder / ("pipe" + option)
            os.mkfifo(pipe)
            with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True) as reader:
                run = placedpar("run", COMMSTIME, "--set", "count=5", option, pipe)
                read, _ = reader.communicate(timeout=20)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertTrue(json.loads(read))
            self.assertTrue(pipe.is_fifo())

    def test_permissions_are_heeded_and_kept(self):
        path = self.folder / "run.json"
        path.write_text("precious", encoding="utf-8")
        path.chmod(0o444)
        run = placedpar("run", COMMSTIME, "--set", "count=5", "--json", path)
        self.assertEqual(run.returncode, 1)
        self.assertIn("Permission denied", run.stderr)
        self.assertEqual(path.read_text(encoding="utf-8"), "precious")
        path.chmod(0o640)
        self.assertEqual(placedpar("run", COMMSTIME, "--set", "count=5", "--json", path).returncode, 0)
        self.assertEqual(path.stat().st_mode & 0o777, 0o640)
        self.assertNotEqual(path.read_text(encoding="utf-8"), "precious")

    def test_a_new_file_has_the_permissions_of_any_new_file(self):
        for mask, permissions in ((0o022, 0o644), (0o077, 0o600), (0o002, 0o664)):
            path = self.folder / f"{mask}.json"
            subprocess.run([PROGRAM, "run", str(COMMSTIME), "--set", "count=5", "--json", str(path)], stdout=subprocess.DEVNULL,
                           timeout=60, check=True, umask=mask)
            self.assertEqual(path.stat().st_mode & 0o7777, permissions)

    def test_a_full_standard_output_is_no_success(self):
        for arguments in (["run", COMMSTIME, "--set", "count=5"], ["check", COMMSTIME], ["show", COMMSTIME], ["kinds"],
                          ["show", COMMSTIME, "--format", "dot"], ["show", FIGURE_E2, "--format", "json"], ["kinds", "ga.master"],
                          ["parameters"], ["--help"], ["run", "--help"], ["--version"], ["replay", "table-e1"],
                          ["identify", RECORD], ["record", "scenario-a"], ["record", "scenario-a", "--list"],
                          ["monitor", "--port", "0"]):
            with open("/dev/full", "w", encoding="utf-8") as full:  # written directly, not replaced
                run = subprocess.run([PROGRAM, *map(str, arguments)], stdout=full, stderr=subprocess.PIPE, text=True,
                                     timeout=60, check=False)
            self.assertEqual(run.returncode, 1, arguments)
            self.assertEqual(run.stderr, "placedpar: standard output cannot be written: No space left on device\n")

    def test_where_standard_output_goes_nothing_else_is_written(self):
        path = self.folder / "out.txt"
        with open(path, "w", encoding="utf-8") as out:
            run = subprocess.run([PROGRAM, "run", str(COMMSTIME), "--json", str(path)], stdout=out,
                                 stderr=subprocess.PIPE, text=True, timeout=60, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("standard output is written to the same file", run.stderr)

    def test_a_run_beyond_the_end_of_virtual_time_says_so_and_writes_nothing(self):
        netlist = self.folder / "long.cfs"
        netlist.write_text("""T800 t; process p; process c; use "csp.producer" for p; use "csp.consumer" for c;
            p (cycles = 1000000000000); connect p.out to c.in; place p on t; place c on t;""", encoding="utf-8")
        run = placedpar("run", netlist, "--json", self.folder / "run.json", "--trace", self.folder / "trace.json")
        self.assertEqual(run.returncode, 1)
        self.assertIn("virtual time ends after 106 days, but process p would take longer: shorten its computation or delay", run.stderr)
        self.assertEqual(os.listdir(self.folder), ["long.cfs"])

    def test_numbers_of_a_run_that_takes_no_time_are_numbers(self):
        netlist = self.folder / "at_once.cfs"
        netlist.write_text("""workstation sun; process host; process m; process p; process c;
            use "ga.host" for host; use "ga.traditional" for m; use "csp.producer" for p; use "csp.consumer" for c;
            connect host.to_masters[0] to m.from_host; connect p.out to c.in;
            place host on sun; place m on sun; place p on sun; place c on sun;""", encoding="utf-8")
        path = self.folder / "run.json"
        run = placedpar("run", netlist, "--json", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotRegex(run.stdout, r"\b(nan|inf)\b")
        record = json.loads(path.read_text(encoding="utf-8"))
        self.assertEqual(record["time_ps"], 0)
        self.assertIn("last_number", [m["name"] for m in record["measurements"]])
        self.assertTrue(all(m["value"] is not None for m in record["measurements"]))

    def test_a_seed_is_a_whole_number_that_fits(self):
        commands = (["run", COMMSTIME, "--set", "count=5"], ["replay", "table-e1"], ["identify", "record.csv"],
                    ["record", "scenario-a"], ["monitor", "--port", "0"])
        for command in commands:
            for seed in ("-1", "99999999999999999999999", "18446744073709551616", "0x10", "", " 3", "1.5", "010"):
                run = placedpar(*command, "--seed", seed)
                self.assertEqual(run.returncode, 1, (command, seed))
                self.assertIn(f'"{seed}" is not a whole number', run.stderr)
        self.assertEqual(placedpar(*commands[0], "--seed", 2**64 - 1).returncode, 0)


if __name__ == "__main__":
    unittest.main()
