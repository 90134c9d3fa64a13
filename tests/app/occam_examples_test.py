"""Compares the examples in occam and the answers of the course with what INMOS's compiler makes of them.

PLACEDPAR_D7205 names the folder of INMOS's occam toolset, unpacked from its itools. Without it the tests are skipped.
"""

import pathlib
import re
import shutil
import tempfile
import unittest

import occam_test
from program import EXAMPLES, placedpar

COURSE = EXAMPLES.parent / "docs/occam-course"
# Occam does not say which worker of this example gets the first task, and the compilers differ.
OPEN = ("farm.occ",)
# The last number that these examples print is a time.
TIMED = ("commstime.occ", "matrix.occ")


def in_one_procedure(text):
    """Returns the program as one procedure: INMOS's tools want no other at the outermost level."""
    name = re.findall(r"^PROC ([\w.]+) \(CHAN OF SP fs, ts, \[\]INT memory\)", text, re.MULTILINE)[-1]
    inner = [f"  {line}" if line else "" for line in text.splitlines() if line != '#INCLUDE "hostio.inc"']
    return "\n".join(['#INCLUDE "hostio.inc"', "PROC whole (CHAN OF SP fs, ts, []INT memory)", *inner,
                      f"  {name} (fs, ts, memory)", ":", ""])


@unittest.skipUnless(occam_test.D7205, "PLACEDPAR_D7205 names no folder of the occam toolset")
class Examples(unittest.TestCase):
    def by_inmos(self, file):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for library in (pathlib.Path(occam_test.D7205) / "libs").iterdir():
                shutil.copy(library, folder)
            return occam_test.Toolset.compiled_by_inmos(self, folder, in_one_procedure(file.read_text("ascii")))

    CONFIGURATION = occam_test.Toolset.CONFIGURATION

    def test_both_compilers_make_the_same_of_them(self):
        # The files of networks have processes of netlists, and no programs.
        programs = [file for file in EXAMPLES.glob("occam/*/*.occ") if file.parent.name != "network"]
        files = [*programs, *(COURSE / "answers").glob("*.occ")]
        self.assertGreater(len(files), 40)
        for file in sorted(files):
            ours = placedpar("run", file, "--memorycycles", 1)
            if file.name in OPEN or ours.returncode == 2:
                continue
            with self.subTest(file=file.name):
                printed, expected = occam_test.output_of(ours.stdout), self.by_inmos(file)
                if file.name in TIMED:
                    time, expected_time = (int(text.split()[-1]) for text in (printed, expected))
                    self.assertLessEqual(abs(time / expected_time - 1), 0.06)
                    printed, expected = (text.rsplit(maxsplit=1)[0] for text in (printed, expected))
                self.assertEqual(printed, expected)


if __name__ == "__main__":
    unittest.main()
