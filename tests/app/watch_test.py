"""Tests watching a run: on a pseudo-terminal, and without one."""

import fcntl
import os
import pty
import re
import signal
import struct
import subprocess
import termios
import time
import unittest

from program import CLUSTER, FIGURE_E2, PROGRAM, placedpar

UP = re.compile(r"\r\x1b\[(\d+)A\x1b\[J")


class Terminal:
    """A terminal that shows the standard error of a watched program."""

    def __init__(self, columns, *arguments, kind="xterm"):
        self.terminal, end = pty.openpty()
        fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        self.before = self.modes()
        self.process = subprocess.Popen([PROGRAM, "run", *map(str, arguments), "--watch"], stdin=subprocess.DEVNULL,
                                        stdout=subprocess.PIPE, stderr=end, env={**os.environ, "TERM": kind})
        os.close(end)
        self.text = b""

    def modes(self):
        """Returns the terminal's modes, such as echo."""
        return termios.tcgetattr(self.terminal)

    def read(self, until=lambda text: False):
        """Reads until the program has ended, or until(text) is true."""
        while not until(self.text.decode(errors="ignore")):
            try:
                part = os.read(self.terminal, 65536)
            except OSError: # on Linux: the other end is closed
                part = b""
            if not part:
                break
            self.text += part
        return self.text.decode().replace("\r\n", "\n")

    def end(self):
        """Returns all output, and the report."""
        text = self.read()
        report = self.process.stdout.read().decode()
        self.process.stdout.close()
        self.process.wait(timeout=60)
        return text, report


def screen_after(text):
    """Returns the lines on a terminal that understands only the control sequences that the program uses."""
    lines = [""]
    for part in re.split(r"(\r\x1b\[\d+A\x1b\[J|\n)", text):
        if up := UP.fullmatch(part):
            lines = lines[:len(lines) - 1 - int(up[1])] + [""]
        elif part == "\n":
            lines.append("")
        else:
            assert "\x1b" not in part, part
            lines[-1] += part
    return lines


class Watched(unittest.TestCase):
    def test_a_curve_in_its_place_as_wide_as_the_terminal(self):
        for columns in (40, 80, 132):
            text, report = Terminal(columns, FIGURE_E2).end()
            screen = screen_after(text)
            self.assertEqual(len([line for line in screen if "generation " in line]), 1)
            self.assertTrue(all(len(line) < columns for line in screen), screen)
            self.assertIn("generation 80: best", screen[1])
            self.assertTrue(any("*" in line for line in screen))
            self.assertTrue(any(line.strip().startswith("diversity") for line in screen))
            self.assertIn("completed at", report)
            self.assertNotIn("\x1b[", report)

    def test_it_draws_at_most_ten_times_a_second(self):
        begin = time.monotonic()
        text, _ = Terminal(80, CLUSTER, "--seeds", "5").end()
        seconds = time.monotonic() - begin
        drawn = len(UP.findall(text)) + 5 # the first drawing of each seed replaces nothing
        self.assertLessEqual(drawn, 10 * seconds + 3 * 5)
        self.assertEqual(len([line for line in screen_after(text) if "generation 80:" in line]), 5)

    def test_an_interruption_leaves_the_terminal_whole(self):
        terminal = Terminal(80, CLUSTER, "--seeds", "100000", "--yes")
        terminal.read(until=lambda text: "seed 2" in text)
        terminal.process.send_signal(signal.SIGINT)
        text = terminal.read()
        report = terminal.process.stdout.read().decode()
        terminal.process.stdout.close()
        self.assertEqual(terminal.process.wait(timeout=60), 130)
        self.assertEqual(terminal.modes(), terminal.before)
        self.assertTrue(text.endswith("\n"))
        self.assertNotIn("\x1b", UP.sub("", text)) # the program only moves up and clears, so nothing stays switched on
        self.assertIn("interrupted", report)

    def test_where_there_is_no_terminal_it_says_lines(self):
        run = placedpar("run", FIGURE_E2, "--watch")
        self.assertEqual(run.returncode, 0)
        self.assertNotIn("\x1b", run.stderr)
        said = re.findall(r", seed 1, generation (\d+): best \S+, mean \S+, diversity 0\.\d+, between 0\.\d+\n",
                          run.stderr)
        self.assertEqual(said, ["1", "2", "5", "10", "20", "50", "80"])
        self.assertEqual(len(run.stderr.splitlines()), 7)
        dumb, _ = Terminal(80, FIGURE_E2, kind="dumb").end()
        self.assertEqual(dumb, run.stderr)
        self.assertEqual(run.stdout, placedpar("run", FIGURE_E2).stdout)


if __name__ == "__main__":
    unittest.main()
