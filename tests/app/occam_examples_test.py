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
# The last number that these examples print is a time, as that of all in the folder beside-inmos.
TIMED = ("commstime.occ", "matrix.occ")


def with_its_files(file):
    """Returns the text of a program with the files of its folder that it includes."""
    def included(line):
        other = file.parent / line.group(1)
        return with_its_files(other) if other.exists() else line.group()
    return re.sub(r'^#INCLUDE "(.*)"$', included, file.read_text("ascii"), flags=re.MULTILINE)


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
            return occam_test.Toolset.compiled_by_inmos(self, folder, in_one_procedure(with_its_files(file)))

    CONFIGURATION = occam_test.Toolset.CONFIGURATION

    def test_both_compilers_make_the_same_of_them(self):
        # The files of networks have processes of netlists, and no programs.
        programs = [file for file in EXAMPLES.glob("occam/*/*.occ")
                    if file.parent.name not in ("genetic", "mesh", "network", "routed", "sixteen")]
        files = [*programs, *(COURSE / "answers").glob("*.occ")]
        self.assertGreater(len(files), 40)
        for file in sorted(files):
            ours = placedpar("run", file, "--memorycycles", 1)
            if file.name in OPEN or ours.returncode == 2:
                continue
            with self.subTest(file=file.name):
                printed, expected = occam_test.output_of(ours.stdout), self.by_inmos(file)
                if file.name in TIMED or file.parent.name == "beside-inmos":
                    time, expected_time = (int(text.split()[-1]) for text in (printed, expected))
                    self.assertLessEqual(abs(time / expected_time - 1), 0.06)
                    printed, expected = (text.rsplit(maxsplit=1)[0] for text in (printed, expected))
                self.assertEqual(printed, expected)

    def test_both_compilers_evaluate_the_boom_alike(self):
        file = EXAMPLES / "occam/genetic/boom.occ"
        ours = occam_test.output_of(placedpar("run", file, "--memorycycles", 1).stdout)
        time = re.compile(r"([\d.]+) microseconds")
        theirs = self.by_inmos(file)
        self.assertEqual(time.sub("", ours), time.sub("", theirs))
        self.assertEqual(len(time.findall(ours)), 4)
        for here, there in zip(time.findall(ours), time.findall(theirs)):
            self.assertLessEqual(abs(float(here) / float(there) - 1), 0.06)


if __name__ == "__main__":
    unittest.main()
