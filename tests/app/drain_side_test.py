"""Tests identify --side outlet: the compliance of the drain side, judged by the measured machine, and refusals."""

import json
import pathlib
import tempfile
import unittest

from program import placedpar

TRUTH = 0.006
SEEDS = range(4001, 4006)


class DrainSide(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        for seed in SEEDS:
            placedpar("record", "excavator", "--noise", "low", "--seed", seed, "--out", cls.folder / f"{seed}.csv")

    def boom(self, seed, *arguments):
        path = self.folder / "result.json"
        run = placedpar("identify", self.folder / f"{seed}.csv", "--json", path, *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout, json.loads(path.read_text(encoding="utf-8"))["links"][0]

    def refused(self, record, *arguments):
        run = placedpar("identify", record, "--side", "outlet", *arguments)
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertEqual(run.stdout, "")
        return run.stderr

    def test_the_outlet_side_is_within_ten_percent_and_the_inlet_side_is_another(self):
        for seed in SEEDS:
            text, outlet = self.boom(seed, "--side", "outlet")
            self.assertIn("\nC_BOo ", text)
            self.assertNotIn("C_BOi", text)
            self.assertEqual(outlet["name"], "C_BOo")
            self.assertLess(abs(outlet["compliance"] / TRUTH - 1), 0.1)
            _, inlet = self.boom(seed, "--way", "thesis", "--side", "inlet")
            self.assertEqual(inlet["name"], "C_BOi")
            self.assertGreater(inlet["compliance"], 1.2 * TRUTH)

    def test_the_voltage_serves_as_well_as_the_spool(self):
        _, spool = self.boom(SEEDS[0], "--side", "outlet")
        _, servo = self.boom(SEEDS[0], "--side", "outlet", "--areas-from", "servo")
        self.assertNotEqual(spool["compliance"], servo["compliance"])

    def test_what_is_refused(self):
        record = self.folder / f"{SEEDS[0]}.csv"
        self.assertIn("only the outlet side of the boom", self.refused(record, "--link", "stick"))
        self.assertIn("--areas-from spool or --areas-from servo", self.refused(record, "--areas-from", "areas"))
        simple = self.folder / "simple.csv"
        placedpar("record", "scenario-a", "--out", simple)
        self.assertIn("the record has no channel boom.outlet_pressure", self.refused(simple))


if __name__ == "__main__":
    unittest.main()
