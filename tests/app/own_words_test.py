"""Tests that the program words errors itself instead of passing on a library's text: repeated options and keys, empty
files, runs made before."""

import os
import pathlib
import pty
import re
import subprocess
import tempfile
import unittest

from program import EXAMPLES, FIGURE_E2, PROGRAM, placedpar

RING = EXAMPLES / "csp/deadlock" / "ring.cfs"
VALUES = {"TIME": "1ms"}


def commands():
    listed = placedpar("--help").stdout.split("Subcommands:")[1].split("\n\n")[0]
    return re.findall(r"^  (\w+) ", listed, re.MULTILINE)


def options_with_one_value(command):
    """A name and a value that it accepts."""
    text = placedpar(command, "--help").stdout
    found = re.findall(r"^  (?:-\w,)?(--[\w-]+) ([A-Z][A-Z_:|{}a-z0-9.,-]*)(?:=(\S+))?((?: [A-Z.]\S*)*)", text, re.MULTILINE)
    return [(name, default or VALUES.get(takes, "1")) for name, takes, default, rest in found if "..." not in rest]


class OwnWords(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_an_option_of_one_value_that_is_given_twice(self):
        tried = 0
        for command in commands():
            for name, value in options_with_one_value(command):
                run = placedpar(command, name, value, name, value, folder=self.folder)
                self.assertEqual(run.returncode, 1, (command, name, run.stdout))
                self.assertIn(f"{name} takes one value, but was given 2 times ({value}, {value})", run.stderr,
                              (command, name))
                tried += 1
        self.assertGreater(tried, 60)

    def test_a_file_in_which_there_is_nothing(self):
        path = self.folder / "empty.cfs"
        for text in ("", "\n \n", "/* nothing */\n", "val n 3;\n"):
            path.write_text(text, encoding="utf-8")
            for command in ("run", "check", "show", "explain"):
                run = placedpar(command, path)
                self.assertEqual((run.returncode, run.stdout), (1, ""), (command, text))
                self.assertEqual(run.stderr.splitlines()[0], f"{path}: error: the netlist is empty")
                read = subprocess.run([PROGRAM, command, "-"], input=text, capture_output=True, text=True, timeout=60,
                                      check=False)
                self.assertEqual((read.returncode, read.stdout), (1, ""), (command, text))
                self.assertIn("error: the netlist is empty" if text else "standard input is empty or closed",
                              read.stderr)
        path.write_text("T800 a;\n", encoding="utf-8")
        self.assertEqual(placedpar("check", path).returncode, 0)

    def test_a_key_of_a_study_that_is_given_twice(self):
        twice = {
            'set.count = 1\nset."count" = 2': "set.count", 'set."count" = 1\nset.count = 2': "set.count",
            "set.'count' = 1\nset.count = 2": "set.count", 'set . count = 1\nset. "count" =2': "set.count",
            '[set]\ncount = 1\n"count" = 2': "count", "[set]\n'count' = 1\n  count=2": "count",
            '[set]\n"p[0].count" = 1\n"p[0].count" = 2': "p[0].count", "set = {count = 1, count = 2}": "count",
            'set = {"a, b=" = [1, 2], n = "x=y", n = 2}': "n", "[set]\nn = 1\n[set]\nm = 1": "set",
            '[set]\nn = 1\n["set"]\nm = 1': "set", "seeds = 1\nseeds = 2": "seeds",
        }
        for text, name in twice.items():
            path = self.folder / "study.toml"
            path.write_text(f'netlist = "{RING}"\n{text}\n', encoding="utf-8")
            run = placedpar("sweep", path)
            self.assertEqual(run.returncode, 1, text)
            self.assertRegex(run.stderr.splitlines()[0],
                             r"^\S+study\.toml:\d+:\d+: error: " + re.escape(f'"{name}" is given twice') + "$", text)

    def test_runs_that_are_made_to_see_what_they_measure_count_among_those_that_were_asked_for(self):
        terminal, end = pty.openpty()
        with subprocess.Popen([PROGRAM, "sweep", FIGURE_E2, "slaves=0..3", "--seeds", "40", "--measure",
                               "master.T_exe", "--jobs", "1"], stderr=end, stdout=subprocess.DEVNULL,
                              cwd=self.folder) as run:
            os.close(end)
            said = b""
            try:
                while piece := os.read(terminal, 4096):
                    said += piece
            except OSError: # the other end is closed
                pass
            self.assertEqual(run.wait(), 0, said)
        os.close(terminal)
        counts = re.findall(r"(\d+) of (\d+) runs", said.decode())
        self.assertEqual({total for made, total in counts}, {"160"}, said)
        made = [int(each) for each, total in counts]
        self.assertGreaterEqual(made[0], 1)
        self.assertEqual(made, sorted(made))
        self.assertLessEqual(made[-1], 160)


if __name__ == "__main__":
    unittest.main()
