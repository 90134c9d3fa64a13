"""Tests that the manual page contains the help, and that troff and man accept it."""

import re
import subprocess
import tempfile
import unittest

from program import placedpar

OVERSTRUCK = re.compile(".\x08") # bold and underlined text, as on a teletype


def formatted(*command, page):
    done = subprocess.run(command, input=page, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True)
    return done.stdout, done.stderr


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = placedpar("manual").stdout

    def test_troff_has_nothing_to_say_against_it(self):
        text, warnings = formatted("groff", "-ww", "-man", "-Tascii", "-P-c", page=self.page)
        self.assertEqual(warnings, "")
        self.assertIn("SYNOPSIS", OVERSTRUCK.sub("", text))

    def test_man_finds_its_name(self):
        with tempfile.NamedTemporaryFile("w", suffix=".1") as file:
            file.write(self.page)
            file.flush()
            done = subprocess.run(["lexgrog", file.name], text=True, stdout=subprocess.PIPE, check=True)
            self.assertIn('"placedpar - simulator of transputer networks', done.stdout)
            man = subprocess.run(["man", "--warnings", "-l", file.name], text=True, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, check=True)
            self.assertEqual(man.stderr, "")

    def test_it_says_what_the_help_says(self):
        text = OVERSTRUCK.sub("", formatted("groff", "-man", "-Tascii", "-P-c", "-rLL=5000n", page=self.page)[0])
        words = " ".join(text.split())
        commands = re.findall(r"^  (\w+) {2,}(.*)$", placedpar("--help").stdout.split("Subcommands:")[1], re.MULTILINE)
        self.assertGreater(len(commands), 8)
        for command, about in commands:
            self.assertIn(f"placedpar {command} {about}.", words)
            part = " ".join(text.split(f"placedpar {command}\n")[1].split())
            for option in re.findall(r"^  (-\S+)", placedpar(command, "--help").stdout, re.MULTILINE):
                self.assertIn(f" {option} ", part)
        for example in ("table-e2", "exit codes: 0 success", "NO_COLOR"):
            self.assertIn(example, words)


if __name__ == "__main__":
    unittest.main()
