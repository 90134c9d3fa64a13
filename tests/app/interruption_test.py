"""A long run can be stopped, and says what it has."""

import json
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from program import EXAMPLES, PROGRAM

LONG = ["run", str(EXAMPLES / "01-commstime" / "commstime.cfs"), "--set", "count=1000000000"]


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

    def test_the_trace_grows_beside_its_place_and_is_whole_in_the_end(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "trace.json"
            with subprocess.Popen([PROGRAM, *LONG, "--trace", str(path)], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True) as run:
                deadline = time.monotonic() + 20
                while sum(part.stat().st_size for part in path.parent.iterdir()) < 1_000_000:
                    self.assertLess(time.monotonic(), deadline, "nothing is written while the run goes on")
                    time.sleep(0.01)
                self.assertFalse(path.exists())
                run.send_signal(signal.SIGINT)
                run.communicate(timeout=20)
            self.assertEqual(run.returncode, 130)
            self.assertEqual(list(path.parent.iterdir()), [path])
            self.assertTrue(json.loads(path.read_text(encoding="utf-8"))["traceEvents"])


if __name__ == "__main__":
    unittest.main()
