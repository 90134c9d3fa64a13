"""Tests the program of examples/csp/own-process: a new kind of process, and all commands for netlists."""

import json
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from program import EXAMPLES, PROGRAM, fingerprint
from trace_reader import JsonTrace

FOLDER = EXAMPLES / "csp/own-process"
NETLIST = str(FOLDER / "thin.cfs")
OWN = str(pathlib.Path(PROGRAM).resolve().parent / "own_process")


def own(*arguments):
    return subprocess.run([OWN, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=60, check=False)


class OwnProcess(unittest.TestCase):
    def test_it_is_short(self):
        self.assertLess(len((FOLDER / "own_process.cpp").read_text(encoding="utf-8").splitlines()), 40)

    def test_it_runs_netlists_with_report_trace_and_settings(self):
        plain = own("run", NETLIST)
        self.assertEqual(plain.returncode, 0, plain.stderr)
        with tempfile.TemporaryDirectory() as folder:
            report, trace = pathlib.Path(folder) / "r.json", pathlib.Path(folder) / "t.json"
            files = own("run", NETLIST, "--json", report, "--trace", trace)
            self.assertEqual(files.stdout, plain.stdout)
            passed = [m for m in json.loads(report.read_text(encoding="utf-8"))["measurements"] if m["name"] == "passed"]
            self.assertEqual(JsonTrace(trace).why, "completed")
        (measured,) = passed
        name = measured["process"]
        sooner = own("run", NETLIST, "--until", "1us")
        self.assertIn("stopped at the time limit at 1.000000 us", sooner.stdout)
        slower = own("run", NETLIST, "--set", f"{name}.cycles=12345")
        self.assertIn(f"set: {name}.cycles = 12345, for {name}\n", slower.stdout)
        self.assertNotEqual(fingerprint(slower.stdout), fingerprint(plain.stdout))

    def test_it_checks_shows_and_lists(self):
        self.assertEqual(own("check", NETLIST).returncode, 0)
        self.assertTrue(own("show", NETLIST, "--format", "svg").stdout.startswith("<svg "))
        self.assertIn("own.thinner", own("kinds").stdout)
        self.assertIn("Passes on every n-th packet.", own("kinds", "own").stdout)

    def test_it_makes_studies_and_says_where_the_time_goes(self):
        with tempfile.TemporaryDirectory() as folder:
            results = pathlib.Path(folder) / "thin.sqlite"
            sweep = own("sweep", NETLIST, "every=5,10", "--measure", "thinner.passed", "--results", results)
            self.assertEqual(sweep.returncode, 0, sweep.stderr)
            self.assertRegex(sweep.stdout, r"\n +5 +1 +200\n +10 +1 +100\n")
            report = own("report", results)
            self.assertRegex(report.stdout, r"\n +5 +1 +200\n +10 +1 +100\n")
        self.assertEqual(own("explain", NETLIST).returncode, 0)

    def test_a_signal_ends_a_run_with_its_report(self):
        with subprocess.Popen([OWN, "run", NETLIST, "--set", "packets=1000000000"], stdout=subprocess.PIPE, text=True) as run:
            time.sleep(1)
            self.assertIsNone(run.poll(), "it should still be running")
            run.send_signal(signal.SIGINT)
            output, _ = run.communicate(timeout=20)
        self.assertEqual(run.returncode, 130)
        self.assertIn("interrupted at", output)


if __name__ == "__main__":
    unittest.main()
