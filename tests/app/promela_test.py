"""Tests placedpar show --format promela: Spin's verdict on the model agrees with runs."""

import pathlib
import random
import shutil
import subprocess
import tempfile
import unittest

from program import EXAMPLES, placedpar

SHUFFLES = 24
PHILOSOPHERS = EXAMPLES / "csp/philosophers" / "philosophers.cfs"


def can_get_stuck(netlist, *settings):
    """Returns whether Spin finds an end state in which a process still waits."""
    with tempfile.TemporaryDirectory() as folder:
        model = placedpar("show", netlist, "--format", "promela", *settings)
        assert model.returncode == 0, model.stderr
        (pathlib.Path(folder) / "model.pml").write_text(model.stdout, encoding="utf-8")
        for command in (["spin", "-a", "model.pml"], ["cc", "-O1", "-DSAFETY", "-o", "pan", "pan.c"]):
            subprocess.run(command, cwd=folder, check=True, capture_output=True, timeout=60)
        found = subprocess.run(["./pan", "-m1000000"], cwd=folder, check=True, capture_output=True, text=True, timeout=60)
    assert "max search depth too small" not in found.stdout and "errors: " in found.stdout, found.stdout
    return "errors: 0" not in found.stdout


def runs_that_get_stuck(netlist, *settings):
    codes = [placedpar("run", netlist, *settings, "--shuffle", seed).returncode for seed in range(SHUFFLES)]
    assert set(codes) <= {0, 2}, codes
    return codes.count(2)


def random_network(seed):
    """Makes producers, buffers and consumers in a line or a ring. Each passes one or two packets, not all the same
    number."""
    chance = random.Random(seed)
    middle = [chance.choice(("csp.identity", "csp.prefix", "csp.successor")) for _ in range(chance.randint(1, 4))]
    ring = chance.random() < 0.5
    kinds = middle if ring else ["csp.producer", *middle, "csp.consumer"]
    lines = ["workstation w;"]  # nothing takes time on a workstation, so any order of events is possible
    for number, kind in enumerate(kinds):
        lines += [f"process p{number}; use \"{kind}\" for p{number}; place p{number} on w;",
                  f"p{number} (count = {chance.randint(1, 2)});"]
    for number in range(len(kinds) - (not ring)):
        lines.append(f"connect p{number}.out to p{(number + 1) % len(kinds)}.in;")
    return "\n".join(lines) + "\n"


@unittest.skipUnless(shutil.which("spin") and shutil.which("cc"), "Spin is not installed")
class Models(unittest.TestCase):
    def check_agreement(self, netlist, *settings):
        """Spin explores every order of events. If it finds no deadlock, no run may deadlock; otherwise one of many runs
        must."""
        stuck = can_get_stuck(netlist, *settings)
        runs = runs_that_get_stuck(netlist, *settings)
        self.assertEqual(runs > 0, stuck, f"{runs} of {SHUFFLES} runs get stuck")
        return stuck

    def test_the_examples(self):
        for stuck, *example in ((False, EXAMPLES / "csp/commstime" / "commstime.cfs", "--set", "count=3"),
                                (True, EXAMPLES / "csp/deadlock" / "ring.cfs"),
                                (False, PHILOSOPHERS, "--set", "meals=1"), (True, PHILOSOPHERS, "--set", "butler=0"),
                                (False, EXAMPLES / "csp/bounded-buffer" / "buffer.cfs", "--set", "count=3")):
            self.assertEqual(self.check_agreement(*example), stuck, example)

    def test_a_fifth_seat_is_a_danger_that_runs_do_not_meet(self):
        settings = ("--set", "meals=1", "--set", "seats=5", "--set", "philosopher[0].thinking=4000")
        self.assertTrue(can_get_stuck(PHILOSOPHERS, *settings))
        self.assertEqual(placedpar("run", PHILOSOPHERS, *settings).returncode, 0)

    def test_random_networks(self):
        verdicts = set()
        with tempfile.TemporaryDirectory() as folder:
            for seed in range(8):
                netlist = pathlib.Path(folder) / f"{seed}.cfs"
                netlist.write_text(random_network(seed), encoding="utf-8")
                with self.subTest(seed=seed):
                    verdicts.add(self.check_agreement(netlist))
        self.assertEqual(verdicts, {True, False})


class Refusals(unittest.TestCase):
    def test_a_kind_that_says_nothing_in_promela_is_named(self):
        run = placedpar("show", EXAMPLES / "thesis/figure-e2" / "figure-e2.cfs", "--format", "promela")
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        self.assertIn('"host" is a ga.host, which has no Promela model of its communications; these kinds have one: csp.buffer',
                      run.stderr)


if __name__ == "__main__":
    unittest.main()
