"""A long run can be stopped, and says what it has."""

import signal
import subprocess
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


if __name__ == "__main__":
    unittest.main()
