"""Tests that each command with a number of seeds asks before it starts an implausible number of runs."""

import tempfile
import unittest

from program import EXAMPLES, placedpar

NETLIST = str(EXAMPLES / "csp/commstime" / "commstime.cfs")
CLUSTER = str(EXAMPLES / "thesis/table-e1" / "cluster.cfs")


class ManySeeds(unittest.TestCase):
    def test_very_many_seeds_are_asked_about(self):
        with tempfile.TemporaryDirectory() as folder:
            for words in (["run", NETLIST], ["run", CLUSTER, "--convergence", "c.svg"], ["sweep", NETLIST], ["replay", "faults"]):
                for seeds, said in (("10001", "10,001 runs"), ("1000000", r"(1,000,000|999,99\d) runs")):
                    refused = placedpar(*words, "--seeds", seeds, folder=folder)
                    self.assertEqual((refused.returncode, refused.stdout), (1, ""), words)
                    self.assertRegex(refused.stderr, said, words)
                    self.assertIn("add --yes to start them", refused.stderr, words)

    def test_a_few_are_not(self):
        self.assertEqual(placedpar("run", NETLIST, "--seeds", "3").returncode, 0)


if __name__ == "__main__":
    unittest.main()
