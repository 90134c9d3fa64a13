"""What the program writes, and that it writes it whole or not at all."""

import json
import os
import pathlib
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, FIGURE_E2, fingerprint, placedpar


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

    def test_the_trace_is_a_timeline_of_every_process(self):
        path = self.folder / "trace.json"
        run = placedpar("run", EXAMPLES / "01-commstime" / "commstime.cfs", "--set", "count=5", "--trace", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        events = json.loads(path.read_text(encoding="utf-8"))["traceEvents"]
        tracks = {e["args"]["name"] for e in events if e["name"] == "thread_name"}
        self.assertEqual(tracks, {"prefix", "delta", "successor", "consumer"})
        self.assertEqual(sum(e.get("cat") == "message" for e in events), 20)
        self.assertTrue(all(e["dur"] >= 0 for e in events if e["ph"] == "X"))

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
        for netlist in (CLUSTER, FIGURE_E2, EXAMPLES / "01-commstime" / "commstime.cfs"):
            copy = self.folder / "shown.cfs"
            copy.write_text(placedpar("show", netlist).stdout, encoding="utf-8")
            self.assertEqual(placedpar("check", copy).stdout.split("hash ")[1],
                             placedpar("check", netlist).stdout.split("hash ")[1])
            self.assertEqual(fingerprint(placedpar("run", copy).stdout), fingerprint(placedpar("run", netlist).stdout))

    def test_show_json_names_every_process(self):
        network = json.loads(placedpar("show", FIGURE_E2, "--format", "json").stdout)
        self.assertEqual(len(network["processes"]), 17)


if __name__ == "__main__":
    unittest.main()
