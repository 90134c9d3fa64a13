"""Tests runs of booted transputers whose instructions are executed step by step."""

import pathlib
import re
import subprocess
import tempfile
import unittest

from program import EXAMPLES, PROGRAM, placedpar


class Stepped(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "hello.btl"
        hello = EXAMPLES / "transputer" / "hello" / "hello.tas"
        self.assertEqual(placedpar("assemble", hello, "-o", self.file).returncode, 0)

    def stepped(self, script):
        return subprocess.run([PROGRAM, "run", self.file, "--step"], input=script, capture_output=True, text=True, timeout=60, check=False)

    def test_a_stepped_run_ends_as_an_unwatched_one(self):
        stepped = self.stepped("s 2\nr\nc\n")
        self.assertEqual(stepped.returncode, 0, stepped.stderr)
        for text in ("Iptr #", "\nHello from a transputer!!\n", placedpar("run", self.file).stdout.split("Hello from a transputer!!\n")[1]):
            self.assertIn(text, stepped.stdout)

    def test_a_stepped_run_ends_at_the_last_step(self):
        for steps, script in ((0, "quit\n"), (1, "s\nquit\n"), (2, "s 2\nquit\n"), (5, "s 5\nquit\n"), (10, "s 10\n")):
            stdout = self.stepped(script).stdout
            self.assertRegex(stdout, rf"root +{steps} +0  runs")
            self.assertIn(f"hello.btl: interrupted at {re.findall('^([0-9.]+ us)  #', stdout, re.M)[-1]}\n", stdout)


if __name__ == "__main__":
    unittest.main()
