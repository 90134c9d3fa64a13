"""Generates, runs, explains and shows a network end to end. As a study, it has a thousand processors and a minute."""

import os
import re
import tempfile
import time
import unittest

from program import placedpar

SIZE = os.environ.get("PLACEDPAR_MESH", "17x17") # above the 256 nodes from which fewer changes are tried
MOST_SECONDS = float(os.environ.get("PLACEDPAR_MOST_SECONDS", "inf"))


class Thousand(unittest.TestCase):
    def test_from_topology_to_page(self):
        with tempfile.TemporaryDirectory() as folder:
            begun = time.monotonic()
            path, page = os.path.join(folder, "mesh.cfs"), os.path.join(folder, "mesh.html")
            at_end = []
            for command in (("generate", "mesh", "--size", SIZE, "--job", "islands", "-o", path), ("run", path, "--set", "samples=6"),
                            ("explain", path, "--set", "samples=6", "--page", page)):
                run = placedpar(*command)
                self.assertEqual(run.returncode, 0, run.stderr)
                at_end += re.findall(r"completed at .*", run.stdout)[:1]
            seconds = time.monotonic() - begun
            print(f"{SIZE} processors from topology to page: {seconds:.1f} s")
            self.assertEqual(at_end[0], at_end[1])
            self.assertIn("all processors twice as fast", run.stdout)
            self.assertNotIn("all processors as fast as can be", run.stdout)
            self.assertGreater(os.path.getsize(page), 100_000)
            self.assertLess(seconds, MOST_SECONDS)


if __name__ == "__main__":
    unittest.main()
