"""Tests that only terminals get colours; reads the program's output through a pseudo-terminal."""

import os
import pty
import re
import subprocess
import tempfile
import unittest

from program import EXAMPLES, PROGRAM

COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
DEADLOCK = EXAMPLES / "csp/deadlock" / "ring.cfs"
COLOUR = re.compile(r"\x1b\[[0-9;]*m")


def drained(terminal):
    """Returns everything written to a terminal after its other end is closed."""
    parts = []
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError: # on Linux: the other end is closed
            part = b""
        if not part:
            return b"".join(parts).decode().replace("\r\n", "\n")
        parts.append(part)


def on_terminal(*arguments, stream, **environment):
    """Returns what the program writes to the stream, which is a terminal; the other stream is not."""
    plain = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "TERM")}
    terminal, end = pty.openpty()
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, stream: end}
    with subprocess.Popen([PROGRAM, *map(str, arguments)], env={**plain, "TERM": "xterm", **environment},
                          stdin=subprocess.DEVNULL, **streams) as process:
        os.close(end)
        text = drained(terminal)
        other = (process.stdout or process.stderr).read().decode()
    os.close(terminal)
    return text, other


class Colours(unittest.TestCase):
    def setUp(self):
        with tempfile.NamedTemporaryFile("w", suffix=".cfs", delete=False) as file:
            file.write("T800 a;\nconect a.link[0] to b.link[0];\n")
        self.wrong = file.name
        self.addCleanup(os.remove, file.name)
        self.cases = [("stdout", ["run", COMMSTIME]), ("stdout", ["run", DEADLOCK]), ("stdout", ["kinds", "ga.master"]),
                      ("stdout", ["kinds"]), ("stderr", ["check", self.wrong]), ("stderr", ["rnu"])]

    def test_colours_are_all_that_a_terminal_gets_more(self):
        for stream, arguments in self.cases:
            with self.subTest(arguments=arguments):
                coloured, _ = on_terminal(*arguments, stream=stream)
                plain = subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       text=True, check=False)
                plain = getattr(plain, stream)
                self.assertNotIn("\x1b", plain)
                self.assertIn("\x1b[", coloured)
                self.assertEqual(COLOUR.sub("", coloured), plain)
                self.assertEqual(coloured.count("\x1b[0m") * 2, len(COLOUR.findall(coloured)))

    def test_what_is_coloured(self):
        run, _ = on_terminal("run", COMMSTIME, stream="stdout")
        self.assertIn("\x1b[32mcompleted\x1b[0m", run)
        self.assertRegex(run, r"\n\x1b\[1mprocessor +type +busy\x1b\[0m\n")
        self.assertIn("\x1b[1;31mdeadlock\x1b[0m", on_terminal("run", DEADLOCK, stream="stdout")[0])
        check, _ = on_terminal("check", self.wrong, stream="stderr")
        self.assertRegex(check, r"^\x1b\[1m\S+:2:1:\x1b\[0m \x1b\[1;31merror:\x1b\[0m ")
        self.assertRegex(check, r"\n +\x1b\[1;32m\^\x1b\[0m\n")
        self.assertTrue(on_terminal("rnu", stream="stderr")[0].startswith("\x1b[1;31mplacedpar:\x1b[0m unknown"))

    def test_each_stream_for_itself(self):
        coloured, other = on_terminal("run", COMMSTIME, stream="stderr")
        self.assertEqual(coloured, "")
        self.assertNotIn("\x1b", other)

    def test_users_who_want_none_get_none(self):
        for stream, arguments in self.cases:
            for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
                with self.subTest(arguments=arguments, environment=environment):
                    self.assertNotIn("\x1b", on_terminal(*arguments, stream=stream, **environment)[0])
        self.assertIn("\x1b", on_terminal("run", COMMSTIME, stream="stdout", NO_COLOR="")[0])


if __name__ == "__main__":
    unittest.main()
