"""Tests the options --set that change a VAL of a program in occam, and the commands that treat a program as a netlist."""

import pathlib
import re
import tempfile
import unittest

from program import placedpar

TEXT = """VAL INT n IS 3:
VAL []BYTE greeting IS "hi":
VAL [2]BYTE fixed IS "ab":
VAL REAL32 scale IS 1.5 (REAL32):
VAL INT twice IS n * 2:
PROC main (CHAN OF BYTE keyboard, screen, error)
  [n]INT x:
  VAL INT inside IS 1:
  SEQ
    SEQ i = 0 FOR SIZE greeting
      screen ! greeting[i]
    SEQ i = 0 FOR twice
      screen ! '.'
    SEQ i = 0 FOR SIZE x
      screen ! fixed[i \\ 2]
    IF
      scale > 2.0 (REAL32)
        screen ! '!'
      TRUE
        SKIP
    screen ! '*n'
:
"""


class Vals(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "vals.occ").write_text(TEXT, encoding="ascii")

    def ask(self, command, *options, status=0):
        done = placedpar(command, "vals.occ", *options, folder=self.folder)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stderr if status else done.stdout

    def test_a_setting_changes_all_that_the_program_computes_from_the_val(self):
        for settings, printed in (((), "hi......aba"), (("n=1",), "hi..a"),
                                  (("greeting=good bye", "scale=3", "fixed=xy"), "good bye......xyx!")):
            with self.subTest(settings=settings):
                options = [word for each in settings for word in ("--set", each)]
                self.assertTrue(self.ask("run", *options).startswith(printed + "\n"))

    def test_a_val_of_an_included_file_and_any_spelling_of_the_path(self):
        (self.folder / "count.inc").write_text("VAL INT count IS 3:\n", encoding="ascii")
        for memory in ("", ", []INT memory"):
            (self.folder / "host.occ").write_text(
                '#INCLUDE "hostio.inc"\n#INCLUDE "count.inc"\n#USE "hostio.lib"\n'
                f"PROC p (CHAN OF SP fs, ts{memory})\n  SEQ\n    so.write.int (fs, ts, count, 0)\n    so.write.nl (fs, ts)\n"
                "    so.exit (fs, ts, sps.success)\n:\n", encoding="ascii")
            for file in ("host.occ", ".//host.occ", self.folder / "host.occ"):
                with self.subTest(memory=memory, file=str(file)):
                    done = placedpar("run", file, "--set", "count=5", folder=self.folder)
                    self.assertEqual((done.returncode, done.stdout[:2]), (0, "5\n"), done.stderr)

    def test_a_study_of_a_program_is_checked_as_it_is_run(self):
        (self.folder / "s.toml").write_text('netlist = "vals.occ"\n[set]\nn = [1, 2]\n', encoding="ascii")
        for command in ("check", "sweep"):
            done = placedpar(command, "s.toml", folder=self.folder)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_other_settings_are_refused_with_the_reason(self):
        for setting, reason in (("m=1", 'no val, attribute or parameter "m"'), ("inside=2", '"inside"'), ("twice=x", 'the name "x" is undefined'),
                                ("fixed=abc", "a text must have exactly this size"), ("n=4000000000", "INT holds whole numbers from"),
                                ("n=1.5", "in the program its value is 3"), ("n=-1", "vals.occ:7:")):
            with self.subTest(setting=setting):
                self.assertIn(reason, self.ask("run", "--set", setting, status=1))

    def test_a_program_is_swept_and_explained_like_a_netlist(self):
        rows = re.findall(r"^(\d) +1 +([\d.]+)$", self.ask("sweep", "n=1,2"), re.MULTILINE)
        self.assertEqual([row[0] for row in rows], ["1", "2"])
        self.assertLess(float(rows[0][1]), float(rows[1][1]))
        self.assertRegex(self.ask("explain"), r"root +[\d.]+ %")

    def test_a_warning_is_printed_once(self):
        (self.folder / "vals.occ").write_text(TEXT.replace("  [n]INT x:", "  INT unused:\n  [n]INT x:"), encoding="ascii")
        for command in (("run",), ("run", "--set", "n=2"), ("explain",)):
            with self.subTest(command=command):
                done = placedpar(command[0], "vals.occ", *command[1:], folder=self.folder)
                self.assertEqual(done.stderr.count('warning: the variable "unused" is never used'), 1, done.stderr)

    def test_a_program_is_not_shown_as_a_netlist_that_could_not_be_read(self):
        self.assertIn("compile it: placedpar compile vals.occ", self.ask("show", status=1))
        self.assertTrue(self.ask("show", "--format", "svg").startswith("<svg"))

    def test_figures_of_a_program_that_an_error_has_ended_are_not_used(self):
        """With n = 0, 1 the program completes; with n = 2 it exits with failure, and with n = 3 an error halts it."""
        (self.folder / "vals.occ").write_text(
            '#INCLUDE "hostio.inc"\n#USE "hostio.lib"\nVAL INT n IS 0:\n'
            "PROC p (CHAN OF SP fs, ts)\n  [3]INT x:\n  INT i:\n  SEQ\n    i := n\n    x[i] := n\n    IF\n      n = 2\n"
            "        so.exit (fs, ts, sps.failure)\n      TRUE\n        so.exit (fs, ts, sps.success)\n:\n", encoding="ascii")
        rows = [line.split(maxsplit=3) for line in self.ask("sweep", "n=0..3").splitlines()[3:7]]
        self.assertEqual([row[0::3] for row in rows], [["0"], ["1"], ["2", "program failed"], ["3", "halted by an error"]])
        self.assertEqual([row[2] == "-" for row in rows], [False, False, True, True])
        explained = placedpar("explain", "vals.occ", "--set", "n=3", folder=self.folder)
        self.assertEqual(explained.returncode, 1)
        self.assertRegex(explained.stdout, r"\A\S+: halted by an error at .*\n")
        compared = placedpar("compare", "vals.occ", "vals.occ", "--set", "n=2", folder=self.folder)
        self.assertEqual(compared.returncode, 1)
        self.assertRegex(compared.stdout, r"\AA  .*: program failed at ")
        placedpar("run", "vals.occ", "--set", "n=3", "--trace", "t.json", folder=self.folder)
        self.assertIn("halted by an error", (self.folder / "t.json").read_text(encoding="utf-8"))
        seeds = placedpar("run", "vals.occ", "--set", "n=3", "--seeds", "2", "--json", "r.json", folder=self.folder)
        self.assertEqual(seeds.returncode, 1)
        self.assertEqual((self.folder / "r.json").read_text(encoding="ascii").count('"outcome": "halted by an error"'), 2)


if __name__ == "__main__":
    unittest.main()
