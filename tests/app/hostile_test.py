"""Tests texts that are not UTF-8 or would control a terminal, and a standard error that is never read."""

import json
import os
import pathlib
import pty
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.dom.minidom

from program import EXAMPLES, PROGRAM
from results_file import opened, renew_checksums

EVIL = b"evil\x1b[1;31m\xff\xc2\x9b\x7f"  # a colour sequence that the program uses, a byte that is not UTF-8, a control character of two bytes
COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
NETLIST = EVIL + b".cfs"
REFUSED = EVIL + b" refused.cfs"
RECORD = EVIL + b".csv"
COMMANDS = [
    ["run", NETLIST], ["run", NETLIST, "--json", "-"], ["run", NETLIST, "--seeds", "2"], ["check", NETLIST], ["check", REFUSED],
    ["run", EVIL], ["check", NETLIST, "--set", b"count=" + EVIL], ["explain", NETLIST], ["explain", NETLIST, "--json", "-"],
    ["show", NETLIST], ["show", NETLIST, "--format", "json"], ["show", NETLIST, "--format", "svg"],
    ["show", NETLIST, "--format", "dot"], ["show", NETLIST, "--format", "promela"], ["kinds", EVIL],
    ["sweep", NETLIST, "count=2,3", "--results", EVIL + b".sqlite"], ["report", EVIL + b".sqlite"],
    ["report", EVIL + b".sqlite", "--measure", EVIL], ["report", EVIL], ["optimise", EVIL], ["identify", RECORD],
    ["identify", EVIL], ["record", EVIL], ["generate", EVIL, "--size", "4"], ["generation", EVIL], ["replay", EVIL],
    ["replay", "table-e1", "--json", "-"], ["parameters", EVIL], ["tell", EVIL, "ping"], [EVIL], ["run", b"--" + EVIL],
]


OURS = re.compile(rb"\x1b\[(1|1;31|1;32|1;33|1;36|32)m(.*?)\x1b\[0m", re.DOTALL)


def clean(data):
    """Returns the text of bytes that must be valid UTF-8 and must not control a terminal."""
    text = data.decode("utf-8")
    odd = [c for c in text if (ord(c) < 32 and c not in "\n\t") or 127 <= ord(c) < 160]
    if odd:
        raise AssertionError(f"{odd} in {text[:2000]!r}")
    return text


class Hostile(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.path = os.fsencode(folder.name) + b"/"
        shutil.copy(COMMSTIME, self.path + NETLIST)
        text = COMMSTIME.read_bytes()
        self.write(REFUSED, text + b'\nx = "' + EVIL.replace(b"\x7f", b"") + b'";\n')
        self.write(RECORD, b"time [s]," + EVIL.replace(b"\x7f", b"") + b" [psi]\n0,1\n1,2\n")
        self.write(EVIL, EVIL)

    def write(self, name, content):
        with open(self.path + name, "wb") as file:
            file.write(content)

    def done(self, *arguments, **streams):
        return subprocess.run([PROGRAM, *arguments], cwd=self.path, timeout=120, check=False,
                              **{"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **streams})

    def test_nothing_that_is_printed_moves_a_terminal(self):
        for command in COMMANDS:
            with self.subTest(command=command):
                run = self.done(*command)
                self.assertIn(run.returncode, (0, 1, 2, 3), run.stderr)
                text = clean(run.stdout)
                clean(run.stderr)
                if "json" in map(str, command) or "--json" in command:
                    json.loads(text)
                if "svg" in command:
                    xml.dom.minidom.parseString(text)

    def on_terminal(self, *arguments):
        """Returns everything the program writes to a terminal on both streams, and its exit code."""
        terminal, end = pty.openpty()
        parts = []
        environment = {name: value for name, value in os.environ.items() if name != "NO_COLOR"}
        with subprocess.Popen([PROGRAM, *arguments], cwd=self.path, stdin=subprocess.DEVNULL, stdout=end, stderr=end,
                              env={**environment, "TERM": "xterm"}) as process:
            os.close(end)
            try:
                while part := os.read(terminal, 65536):
                    parts.append(part)
            except OSError:  # on Linux: the other end is closed
                pass
        os.close(terminal)
        return b"".join(parts).replace(b"\r\n", b"\n"), process.returncode

    def test_a_terminal_gets_no_colours_but_our_own(self):
        painted = 0
        for command in COMMANDS:
            with self.subTest(command=command):
                shown, code = self.on_terminal(*command)
                self.assertIn(code, (0, 1, 2, 3), shown)
                shown = re.sub(rb"\r(\x1b\[\d+A)?\x1b\[[KJ]", b"", shown)  # the program removes its progress line like this
                plain = OURS.sub(rb"\2", shown)
                painted += plain != shown
                clean(plain)
        self.assertGreater(painted, 10)

    def test_what_is_kept_has_no_colours(self):
        shown, _ = self.on_terminal("sweep", NETLIST, "count=2,-1", "--results", "c.sqlite")
        self.assertIn(b"refused", shown)
        with opened(self.folder / "c.sqlite") as database:
            refused = [text for (text,) in database.execute("SELECT refused FROM runs WHERE ended = 'refused'")]
        self.assertEqual([("error: " in text, "\x1b[1" in text, "m\x1b" in text) for text in refused], [(True, False, False)])

    def test_files_for_others_are_what_they_say(self):
        self.assertEqual(self.done("run", NETLIST, "--json", "r.json", "--page", "r.html", "--trace", "t.json").returncode, 0)
        self.assertEqual(self.done("sweep", NETLIST, "count=2,3", "--results", "r.sqlite").returncode, 0)
        with opened(self.folder / "r.sqlite") as database:
            database.execute("UPDATE runs SET refused = ?, ended = ? WHERE settings LIKE '%2%'", ("\x1b[31m<b>\x9b\n", "\x1b]0;x\x07"))
            database.execute("UPDATE runs SET figures = replace(figures, '\"ms\"', ?)", (json.dumps("\x1b[31m\x9b<&"),))
            renew_checksums(database)
        report = self.done("report", "r.sqlite", "--csv", "r.csv", "--svg", "r.svg", "--page", "s.html")
        self.assertEqual(report.returncode, 0, report.stderr)
        self.assertIn("[\\x1b[31m\\xc2\\x9b<&]", clean(report.stdout))
        for name in ("r.json", "r.html", "t.json", "r.csv", "r.svg", "s.html"):
            with self.subTest(file=name):
                text = clean((self.folder / name).read_bytes())
                if name.endswith(".json"):
                    json.loads(text)
                if name.endswith(".svg"):
                    xml.dom.minidom.parseString(text)
        self.assertEqual(json.loads((self.folder / "r.json").read_text(encoding="utf-8"))["manifest"]["netlist"],
                         "evil\x1b[1;31m\xff\x9b\x7f.cfs")

    def test_values_that_are_no_utf8_are_kept_as_they_are(self):
        sweep = ["sweep", NETLIST, b'count=2,"\xff\x1b"', "--results", "v.sqlite"]
        first, again = self.done(*sweep), self.done(*sweep)
        self.assertEqual((first.returncode, again.returncode, again.stdout), (0, 0, first.stdout), first.stderr)
        clean(first.stdout)

    def test_without_standard_error_the_exit_codes_are_the_same(self):
        for command in COMMANDS + [["sweep", NETLIST, "count=x"], ["run", EXAMPLES / "csp/deadlock" / "ring.cfs"]]:
            with self.subTest(command=command):
                code = self.done(*command).returncode
                with open("/dev/full", "wb") as full:
                    self.assertEqual(self.done(*command, stderr=full).returncode, code)
                self.assertEqual(self.done(*command, preexec_fn=lambda: os.close(2), stderr=None).returncode, code)

    def test_no_file_takes_the_place_of_a_closed_stream(self):
        def close_all():
            for stream in (0, 1, 2):
                os.close(stream)
        run = self.done("run", NETLIST, "--json", "r.json", "--set", "count=3", preexec_fn=close_all, stdin=None, stdout=None, stderr=None)
        self.assertEqual(run.returncode, 1)  # standard output cannot be written
        if (self.folder / "r.json").exists():
            json.loads((self.folder / "r.json").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
