"""Tests placedpar run --shuffle: another order of the same network's events, reproducible by its number."""

import json
import pathlib
import tempfile
import unittest

from program import CLUSTER, fingerprint, placedpar

# Nothing takes time on a workstation, so only the order decides which pair communicates first.
PAIRS = """workstation w; process p; process q; process c; process d;
use "csp.producer" for p; use "csp.producer" for q; use "csp.consumer" for c; use "csp.consumer" for d;
p (count = 5); q (count = 5); c (count = 5); d (count = 5);
connect p.out to c.in; connect q.out to d.in;
place p on w; place q on w; place c on w; place d on w;
"""

# Four processes of one transputer are ready to output. The ALT takes the first in its text, unless it comes too early.
RACE = """#INCLUDE "hostio.inc"
PROC race (CHAN OF SP fs, ts, []INT memory)
  #USE "hostio.lib"
  [4]CHAN OF INT c:
  PAR
    PAR i = 0 FOR 4
      c[i] ! i
    INT x:
    SEQ
      SEQ j = 0 FOR 4
        ALT i = 0 FOR 4
          c[i] ? x
            so.write.int (fs, ts, x, 0)
      so.write.nl (fs, ts)
      so.exit (fs, ts, sps.success)
:
"""


class Shuffled(unittest.TestCase):
    def test_the_same_number_gives_the_same_course_and_others_give_others(self):
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder) / "pairs.cfs"
            netlist.write_text(PAIRS, encoding="utf-8")
            plain = fingerprint(placedpar("run", netlist).stdout)
            courses = [fingerprint(placedpar("run", netlist, "--shuffle", seed).stdout) for seed in (1, 1, 2, 3)]
        self.assertEqual(courses[0], courses[1])
        self.assertEqual(len({plain, *courses}), 4)

    def test_a_transputer_runs_its_own_ready_processes_in_other_orders(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "race.occ"
            program.write_text(RACE, encoding="utf-8")
            def printed(*options):
                done = placedpar("run", program, *options)
                self.assertEqual(done.returncode, 0, done.stderr)
                return done.stdout.splitlines()[0]
            self.assertEqual(printed(), "0123")
            orders = [printed("--shuffle", seed) for seed in range(1, 17)]
            self.assertEqual(orders[:4], [printed("--shuffle", seed) for seed in range(1, 5)])
        self.assertEqual({"".join(sorted(order)) for order in orders}, {"0123"})
        self.assertGreater(len(set(orders)), 1)

    def test_processes_that_share_a_transputer_run_in_other_orders(self):
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder) / "pairs.cfs"
            netlist.write_text(PAIRS.replace("workstation w", "T800 w"), encoding="utf-8")
            plain = fingerprint(placedpar("run", netlist).stdout)
            courses = [fingerprint(placedpar("run", netlist, "--shuffle", seed).stdout) for seed in (1, 1, 2, 3)]
        self.assertEqual(courses[0], courses[1])
        self.assertEqual(len({plain, *courses}), 4)

    def test_what_is_computed_is_the_same_in_every_course(self):
        populations = set()
        for options in ((), ("--shuffle", "1"), ("--shuffle", "2")):
            report = placedpar("run", CLUSTER, "--set", "slaves=3", *options).stdout
            populations.add(next(line for line in report.splitlines() if " populations " in line))
        self.assertEqual(len(populations), 1)

    def test_the_manifest_says_how_to_run_it_again(self):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder) / "report.json"
            placedpar("run", CLUSTER, "--shuffle", 7, "--json", report)
            self.assertEqual(json.loads(report.read_text(encoding="utf-8"))["manifest"]["shuffle"], 7)
            placedpar("run", CLUSTER, "--json", report)
            self.assertNotIn("shuffle", json.loads(report.read_text(encoding="utf-8"))["manifest"])

    def test_a_seed_is_a_number(self):
        run = placedpar("run", CLUSTER, "--shuffle", "some")
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        self.assertIn("--shuffle", run.stderr)


if __name__ == "__main__":
    unittest.main()
