"""Tests that a long run can be stopped and still reports its results."""

import contextlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from program import EXAMPLES, FIGURE_E2, PROGRAM

LONG = ["run", str(EXAMPLES / "csp/commstime" / "commstime.cfs"), "--set", "count=1000000000"]


def wait_until_it_listens(process, number, seconds=20):
    """Waits until the program has a handler for the signal, as Linux reports it."""
    for _ in range(seconds * 200):
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
        caught = next(line.split()[1] for line in status.splitlines() if line.startswith("SigCgt"))
        if int(caught, 16) >> (number - 1) & 1:
            return
        time.sleep(0.005)
    raise AssertionError("it never listened to signals")


def written_in(folder, process):
    """Returns the total bytes of the program's open files in that folder, named or not."""
    sizes = [0]
    for each in pathlib.Path(f"/proc/{process.pid}/fd").iterdir():
        with contextlib.suppress(FileNotFoundError): # the file may be closed meanwhile
            if os.readlink(each).startswith(str(folder)):
                sizes.append(each.stat().st_size)
    return max(sizes)


def long_examples(folder):
    """Copies the examples with so many generations that an experiment takes long."""
    examples = pathlib.Path(folder) / "examples"
    shutil.copytree(EXAMPLES, examples)
    for name in ("thesis/table-e1/cluster.cfs", "thesis/figure-e2/software.inc"):
        text = (examples / name).read_text(encoding="utf-8")
        assert text.count("(population = population,") == 1
        (examples / name).write_text(text.replace("(population", "(trials = 20000, population"), encoding="utf-8")
    return examples


class Interruption(unittest.TestCase):
    def test_a_signal_ends_the_run_with_its_report(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen([PROGRAM, *LONG], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
                time.sleep(0.5)
                self.assertIsNone(run.poll(), "it should still be running")
                run.send_signal(number)
                output, _ = run.communicate(timeout=20)
            self.assertEqual(run.returncode, 130)
            self.assertIn("interrupted at", output)
            self.assertIn("fingerprint: ", output)

    def test_a_signal_ends_a_replay_with_nothing_printed_or_written(self):
        # Delay 0 interrupts before the first run has begun, other delays in the middle of a run.
        for experiment, number, seconds in (("table-e1", signal.SIGINT, 0), ("table-e1", signal.SIGTERM, 0.3),
                                            ("table-e2", signal.SIGTERM, 0), ("table-e2", signal.SIGINT, 0.3)):
            with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as copy:
                with subprocess.Popen([PROGRAM, "replay", experiment, "--json", os.path.join(folder, "cells.json")],
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                      env={**os.environ, "PLACEDPAR_EXAMPLES": str(long_examples(copy))}) as run:
                    wait_until_it_listens(run, number)
                    time.sleep(seconds)
                    self.assertIsNone(run.poll(), "it should still be running")
                    run.send_signal(number)
                    output, errors = run.communicate(timeout=20)
                self.assertEqual(run.returncode, 130, errors)
                self.assertEqual(output, "")
                self.assertIn("interrupted", errors)
                self.assertEqual(os.listdir(folder), [])

    def test_an_interrupted_study_says_what_is_kept_of_it(self):
        for kept, said in (([], "hint: --resume FILE keeps the finished runs\n"),
                           (["--resume", "kept"], "kept keeps the finished runs: type the same command again to continue\n")):
            with tempfile.TemporaryDirectory() as folder:
                with subprocess.Popen([PROGRAM, "replay", "pga-4", "--seeds", "100000", "--yes", *kept], cwd=folder,
                                      stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
                    wait_until_it_listens(run, signal.SIGINT)
                    run.send_signal(signal.SIGINT)
                    output, errors = run.communicate(timeout=60)
                self.assertEqual((run.returncode, output), (130, ""), errors)
                self.assertIn("no table or plot was made\n" + said, errors)

    def test_the_trace_grows_in_its_folder_and_is_whole_in_the_end(self):
        for before in (None, "of an earlier run"):
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "trace.json"
                if before:
                    path.write_text(before, encoding="utf-8")
                code = self.signal_while_it_traces(path, signal.SIGINT)
                self.assertEqual(code, 130)
                self.assertEqual(list(path.parent.iterdir()), [path])
                self.assertTrue(json.loads(path.read_text(encoding="utf-8"))["traceEvents"])

    def test_nothing_is_left_of_a_trace_when_the_program_is_killed(self):
        with tempfile.TemporaryDirectory() as folder:
            self.require_files_without_a_name(folder)
            self.assertEqual(self.signal_while_it_traces(pathlib.Path(folder) / "trace.json", signal.SIGKILL), -signal.SIGKILL)
            self.assertEqual(os.listdir(folder), [])

    def test_nothing_is_left_of_a_page_when_the_program_is_killed_while_it_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            self.require_files_without_a_name(folder)
            page = pathlib.Path(folder) / "run.html"
            page.write_text("of an earlier run", encoding="utf-8")
            run = subprocess.run([PROGRAM, "run", str(FIGURE_E2), "--page", str(page)], capture_output=True, check=False,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (8192, 8192)))
            self.assertEqual(run.returncode, -signal.SIGXFSZ) # the signal kills the program in the middle of a write
            self.assertEqual(os.listdir(folder), ["run.html"])
            self.assertEqual(page.read_text(encoding="utf-8"), "of an earlier run")

    def signal_while_it_traces(self, path, number):
        """Returns the exit code."""
        before = path.read_bytes() if path.exists() else None
        with subprocess.Popen([PROGRAM, *LONG, "--trace", str(path)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as run:
            deadline = time.monotonic() + 20
            while written_in(path.parent, run) < 1_000_000:
                self.assertLess(time.monotonic(), deadline, "nothing is written while the run goes on")
                time.sleep(0.01)
            self.assertEqual(path.read_bytes() if path.exists() else None, before)
            run.send_signal(number)
            run.communicate(timeout=20)
        return run.returncode

    def require_files_without_a_name(self, folder):
        try:
            os.close(os.open(folder, os.O_TMPFILE | os.O_WRONLY))
        except OSError as error:
            self.skipTest(f"the file system has no files without a name: {error}")


if __name__ == "__main__":
    unittest.main()
