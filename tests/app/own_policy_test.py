"""Tests the program of examples/genetic/own-policy: its policies work in every command, and it has all commands but
replay and monitor."""

import pathlib
import re
import subprocess
import tempfile
import unittest

from program import EXAMPLES, PROGRAM, placedpar

NETLIST = str(EXAMPLES / "genetic/own-policy" / "islands.cfs")
OWN = str(pathlib.Path(PROGRAM).resolve().parent / "own_policy")


def own(*arguments):
    return subprocess.run([OWN, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=60, check=False)


def commands_of(help_text):
    return set(re.findall(r"^  (\w+) {2,}", help_text.split("Subcommands:")[1], re.MULTILINE))


class OwnPolicy(unittest.TestCase):
    def test_which_commands_it_lacks(self):
        self.assertEqual(commands_of(placedpar("--help").stdout) - commands_of(own("--help").stdout), {"doctor", "mark", "monitor", "replay", "serve", "tell"})

    def test_policies_are_listed_run_and_studied(self):
        self.assertIn("own.truncation(share = 0.5)", own("kinds", "policies").stdout)
        self.assertNotIn("own.", placedpar("kinds", "policies").stdout)
        self.assertEqual(own("run", NETLIST).returncode, 0)
        with tempfile.TemporaryDirectory() as folder:
            study = pathlib.Path(folder) / "best.toml"
            study.write_text(f'netlist = "{NETLIST}"\n[search]\nminimise = "max(island.best_objective)"\npopulation = 4\ngenerations = 2\n'
                             '[set]\ngenerations = [5, 6]\nreproduction = ["own.truncation(share = 0.2)", "own.truncation(share = 0.4)", "ranking"]\n',
                             encoding="utf-8")
            best = own("optimise", study, "--results", pathlib.Path(folder) / "r.sqlite")
            self.assertEqual(best.returncode, 0, best.stderr)
            self.assertIn("the best: own_policy run ", best.stdout)

    def test_what_it_prints_for_shells_and_readers_goes_by_its_name(self):
        for words in (("completion", "bash"), ("completion", "zsh"), ("manual",)):
            printed = own(*words).stdout
            self.assertIn("own_policy", printed.replace("\\-", "-"), words)
            self.assertNotRegex(printed, r'\.SS "placedpar|_placedpar|placedpar completion', words)
        self.assertIn("run", own("completion", "words", "--", "ru").stdout)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "ring.cfs"
            self.assertEqual(own("generate", "ring", "--size", "4", "-o", path).returncode, 0)
            self.assertIn("own_policy generate ring", path.read_text(encoding="utf-8"))
            self.assertEqual(own("check", path).returncode, 0)

    def test_a_wrong_policy_is_refused(self):
        for policy, why in (("own.trunction", "did you mean"), ("own.truncation(share = 2)", "out of range"),
                            ("own.truncation(part = 1)", "has no number")):
            refused = own("check", NETLIST, "--set", f'reproduction="{policy}"')
            self.assertEqual(refused.returncode, 1)
            self.assertIn(why, refused.stderr)


if __name__ == "__main__":
    unittest.main()
