"""Tests what the program says of files that are no good programs in occam, and of large ones."""

import pathlib
import tempfile
import unittest

from program import placedpar

# A file, the command, and what is printed. A process in a file without errors is compiled by `check`.
MESSAGES = (
    ("", "check", "FILE: no errors; the file has no procedure\n"),
    ("", "run", "placedpar: FILE: the file has no PROC that can be run\n"),
    ("VAL x IS 1:\n", "run", "placedpar: FILE: the file has no PROC that can be run\n"),
    ('#INCLUDE "test.occ"\n', "check", 'the file "test.occ" includes or uses itself\n'),
    ('#USE "test.occ"\n', "check", 'the file "test.occ" includes or uses itself\n'),
    ("PROC p (INT x)\n  x := 1\n:\n", "run",
     "the main procedure cannot have this parameter: write (), (CHAN OF SP fs, ts), (CHAN OF SP fs, ts, []INT memory), or (CHAN OF BYTE keyboard, screen, error)\n"),
    ("PROC p ()\n  INT x\0:\n  SKIP\n:\n", "check", "this is a binary file, not text: it contains the byte 0x00\n"),
    ("PROC p ()\n  INT \xe9:\n  SKIP\n:\n", "check", "the byte 0xe9 is allowed only in a string or a comment\n"),
    ("PROC p ()\r\n  SKIP -- \xe9\r\n:\r\n\x1a", "check", "FILE: no errors; PROC p would be run\n"),
    ("PROC p ()\n" + "".join("  " * (i + 1) + "SEQ\n" for i in range(190)) + "  " * 191 + "SKIP\n:\n", "check",
     "FILE: no errors; PROC p would be run\n"),
    ("PROC p ()\n" + "".join("  " * (i + 1) + "SEQ\n" for i in range(250)) + "  " * 251 + "SKIP\n:\n", "check",
     "the nesting is too deep: at most 200 levels are allowed\n"),
    # each value is named twice by the next one
    ("PROC p ()\n  INT y:\n  VAL x0 IS y:\n" + "".join(f"  VAL x{i + 1} IS x{i} + x{i}:\n" for i in range(60))
     + "  [4]INT a:\n  SEQ\n    y := 0\n    a[x60] := 1\n:\n", "check", '"y" cannot be changed here: "x0" depends on it'),
    ("PROC p (VAL INT y)\n  VAL x0 IS y:\n" + "".join(f"  VAL x{i + 1} IS x{i} + x{i}:\n" for i in range(60))
     + "  [4]INT a:\n  SEQ i = 0 FOR 4\n    PAR\n      a[x60] := 1\n      a[x59] := 1\n:\n", "check", '"a"'),
    ("PROC p ()\n  INT x:\n  SEQ\n" + "    x := 1\n" * 200_000 + ":\n", "check", "FILE: no errors; PROC p would be run\n"),
)


class BadInput(unittest.TestCase):
    def test_each_file_has_its_message(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "test.occ"
            for text, command, expected in MESSAGES:
                with self.subTest(text[:60]):
                    file.write_bytes(text.encode("latin-1"))
                    done = placedpar(command, file)
                    self.assertIn(expected.replace("FILE", str(file)), done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
