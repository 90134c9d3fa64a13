"""Compares the verdicts on small occam programs with those of INMOS's compiler of 1991.

PLACEDPAR_D7205 names the folder of INMOS's occam toolset; without it the test is skipped.
"""

import os
import pathlib
import re
import tempfile
import unittest

from program import EXAMPLES, placedpar

D7205 = os.environ.get("PLACEDPAR_D7205")
VERDICTS = EXAMPLES.parent / "tests/occam/check/verdicts"


def programs():
    """Yields the verdict that is expected here, the name and the text of each program."""
    for file in sorted(VERDICTS.glob("*.txt")):
        parts = re.split(r"^== (.*): (.*)\n", file.read_text(encoding="ascii"), flags=re.MULTILINE)[1:]
        for verdict, name, text in zip(parts[::3], parts[1::3], parts[2::3]):
            yield verdict, f"{file.stem}: {name}", text


@unittest.skipUnless(D7205, "PLACEDPAR_D7205 names no folder of the occam toolset")
class Verdicts(unittest.TestCase):
    def accepts(self, folder, text):
        """Whether the compiler finds no error in a line of the program. It may miss libraries."""
        (pathlib.Path(folder) / "a.occ").write_text(text, encoding="ascii")
        done = placedpar("run", pathlib.Path(D7205) / "itools/oc.btl", "--processor", "T414", "--host-folder", folder,
                         "--", "a", "-t8", "-h", "-y", "-o", "a.tco")
        self.assertRegex(done.stdout, r"\S")
        return not re.search(r"^(Error|Serious)-oc-a\.occ\(\d+\)", done.stdout, flags=re.MULTILINE)

    def test_the_compiler_of_1991_decides_as_the_files_say(self):
        with tempfile.TemporaryDirectory() as folder:
            for verdict, name, text in programs():
                with self.subTest(name):
                    expected = verdict in ("accepted", "refused here")
                    self.assertEqual(self.accepts(folder, text), expected, text)


if __name__ == "__main__":
    unittest.main()
