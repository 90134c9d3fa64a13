"""Tests studies that compare their figures with known figures: the printed text and the exit code."""

import pathlib
import tempfile
import unittest

from program import EXAMPLES, placedpar

TABLE = f"""
netlist = "{EXAMPLES / 'csp/commstime' / 'commstime.cfs'}"
measure = "time"
[[table]]
name = "as it was measured"
columns = [{{name = "10 packets", set = {{count = 10}}}}, {{name = "20 packets", set = {{count = 20}}}}]
rows = [{{name = "time", figure = "time", unit = "ms", decimals = 4, known = [KNOWN, nan], tolerance = "1 %"}}]
notes = "with a stopwatch"
"""


class KnownFigures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def sweep(self, known, *arguments, code=0):
        (pathlib.Path(self.folder) / "known.toml").write_text(TABLE.replace("KNOWN", known), encoding="utf-8")
        run = placedpar("sweep", "known.toml", *arguments, folder=self.folder)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        return run.stdout + run.stderr

    def test_a_table_within_its_tolerance(self):
        said = self.sweep("0.095")
        self.assertIn("as it was measured\n", said)
        self.assertIn("10 packets", said)
        self.assertIn("with a stopwatch", said)
        self.assertIn("every judged cell of the first table is within its tolerance", said)

    def test_a_table_that_misses_it_ends_with_3(self):
        self.assertIn("a cell of the first table misses its tolerance", self.sweep("0.11", code=3))

    def test_another_setting_is_one_of_all_cells(self):
        self.assertIn("a cell of the first table misses its tolerance",
                      self.sweep("0.095", "a.clock=10M", "--results", "slower.sqlite", code=3))
        self.assertIn('a.clock was given several values, but the study\'s table "as it was measured" takes one value',
                      self.sweep("0.095", "a.clock=10M,20M", code=1))


if __name__ == "__main__":
    unittest.main()
