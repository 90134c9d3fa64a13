"""Tests programs and configurations in occam from Python, against the command line."""

import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

import placedpar as pp
from network_test import rows

SOURCE = pathlib.Path(os.environ["PLACEDPAR_SOURCE"])
PHILOSOPHERS = SOURCE / "examples/occam/philosophers/philosophers.occ"
FARM = SOURCE / "examples/occam/sixteen/farm.pgm"
DOTS = """VAL INT n IS 3:
PROC dots (CHAN OF BYTE keyboard, screen, error)
  [10]INT x:
  SEQ i = 0 FOR n
    SEQ
      x[i] := i
      screen ! '.'
      screen ! '*n'
:
"""
ECHO = """PROC echo (CHAN OF BYTE keyboard, screen, error)
  BYTE key:
  SEQ i = 0 FOR 3
    SEQ
      keyboard ? key
      screen ! key
:
"""


class Programs(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.dots = self.write("dots.occ", DOTS)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="ascii")
        return self.folder / name

    def printed(self, *typed):
        """Returns what the command line prints for a run."""
        done = subprocess.run([os.environ["PLACEDPAR"], "run", *map(str, typed)], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, text=True, check=False)
        return done.stdout

    def test_a_program_prints_and_reports_as_on_the_command_line(self):
        for setting in ({}, {"meals": 1, "n": 6}):
            with self.subTest(setting=setting):
                run = pp.load(PHILOSOPHERS, **setting).run()
                self.assertRegex(run.output, r"^philosopher 0 eats\n")
                self.assertEqual(run.output.count("eats"), setting.get("meals", 3) * setting.get("n", 5))
                typed = [word for name, value in setting.items() for word in ("--set", f"{name}={value}")]
                self.assertEqual(run.output + str(run), self.printed(PHILOSOPHERS, *typed))

    def test_keys_are_pressed(self):
        net = pp.load(self.write("echo.occ", ECHO))
        self.assertEqual(net.run(keys="abc").output, "abc")
        with self.assertRaises(pp.Deadlock) as caught:
            net.run(keys="a")
        self.assertEqual(caught.exception.run.output, "a")

    def test_the_timeline_and_the_page_repeat_the_run(self):
        run = pp.load(self.dots).run()
        self.assertIn("root", {row["track"] for row in rows(run.timeline)})
        self.assertIn("root", run.page().text)
        self.assertEqual(run.output, ".\n" * 3)

    def test_a_deadlock_names_lines_of_the_program(self):
        with self.assertRaises(pp.Deadlock) as caught:
            pp.load(PHILOSOPHERS, seats=5).run()
        self.assertRegex(str(caught.exception), r"philosophers\.occ:\d+")
        self.assertEqual(caught.exception.run.output, "")
        self.assertEqual(rows(pp.sweep(pp.load(PHILOSOPHERS), seats=[4, 5]))[1]["outcome"], "deadlock")

    def test_an_error_of_a_program_is_an_exception_with_its_line(self):
        with self.assertRaises(pp.ProgramError) as caught:
            pp.load(self.dots, n=11).run()
        self.assertRegex(str(caught.exception), r"^root stopped at .*dots\.occ:6:7: subscript 10 ")
        self.assertEqual(caught.exception.run.output, ".\n" * 9)  # the host has not yet received the tenth line
        self.assertIsInstance(caught.exception, pp.RunError)

    def test_a_wrong_program_or_setting_is_an_exception_with_its_place(self):
        wrong = self.write("wrong.occ", DOTS.replace("x[i]", "y[i]"))
        for file, settings, place, message in ((wrong, {}, (6, 7), 'unknown name "y"'),
                                               (self.dots, {"n": 2**40}, (1, 9), "INT holds whole numbers from"),
                                               (self.dots, {"n": -1}, (4, 17), "the count of this replicator is -1")):
            with self.subTest(message=message), self.assertRaises(pp.NetlistError) as caught:
                pp.load(file, **settings)
            error = caught.exception
            self.assertEqual((error.file, error.line, error.column), (str(file), *place), error)
            self.assertIn(message, str(error))
        with self.assertRaisesRegex(pp.NetlistError, 'no val, attribute or parameter "m"'):
            pp.load(self.dots, m=1)
        with self.assertRaises(pp.NetlistError) as caught:
            pp.load(self.dots, n=1.5)
        self.assertEqual(caught.exception.hint, "in the program its value is 3, an integer")

    def test_a_file_that_is_not_a_program_is_refused(self):
        for text, reason in (("", "the file has no PROC that can be run"),
                             ("PROC main ()\n  [1000000]INT x:\n  x[0] := 1\n:\n", "needs 4000[0-9]+ bytes of memory")):
            with self.subTest(text=text), self.assertRaisesRegex(pp.Error, reason):
                pp.load(self.write("no.occ", text))

    def test_a_warning_has_a_line_and_comes_once(self):
        file = self.write("unused.occ", DOTS.replace("  SEQ i", "  INT unused:\n  SEQ i"))
        with self.assertWarnsRegex(pp.NetlistWarning, r'unused\.occ:4:7: warning: the variable "unused" is never used'):
            net = pp.load(file, n=1)
        self.assertEqual([each["line"] for each in net._core.warnings], [4])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            pp.sweep(net, n=[1, 2])
            pp.explain(net)

    def test_a_program_is_drawn_and_explained_but_is_no_netlist(self):
        net = pp.load(self.dots)
        self.assertTrue(net.svg().text.startswith("<svg"))
        self.assertIn("root", str(pp.explain(net)))
        self.assertTrue(rows(pp.explain(net).what_if))
        with self.assertRaisesRegex(pp.Error, "compile it: placedpar compile"):
            print(net.cfs)

    def test_a_sweep_of_vals_keeps_its_runs(self):
        net = pp.load(self.dots)
        store = self.folder / "runs.sqlite"
        told = []
        first = rows(pp.sweep(net, n=range(1, 3), store=store))
        again = rows(pp.sweep(net, n=range(1, 4), store=store, progress=lambda ended, of: told.append((ended, of))))
        self.assertEqual(told[-1], (1, 1))
        self.assertEqual(again[:2], first)
        self.assertLess(again[0]["time"], again[2]["time"])
        self.assertAlmostEqual(again[2]["time"], net.run().time * 1e3)

    def test_a_sweep_has_no_figures_of_a_program_that_an_error_ended(self):
        program = self.folder / "third.occ"
        program.write_text("VAL INT n IS 0:\nPROC third (CHAN OF BYTE keyboard, screen, error)\n  [2]INT x:\n  INT i:\n"
                           "  SEQ\n    i := n\n    x[i] := 1\n:\n", encoding="ascii")
        found = rows(pp.sweep(pp.load(program), n=[1, 2], measure="time"))
        self.assertEqual([row["outcome"] for row in found], ["completed", "halted by an error"])
        self.assertGreater(found[0]["time"], 0)
        self.assertFalse(found[1]["time"] == found[1]["time"] and found[1]["time"] is not None)  # None, or pandas' nan

    def test_a_configuration_runs_as_a_netlist(self):
        run = pp.load(FARM).run()
        self.assertIn("worker 0 did 18 tasks\n", run.output)
        self.assertIn("worker 1 did 38 tasks\n", pp.load(FARM, settings={"farmer.limit": 100}).run().output)
        self.assertIn("process farmer;", pp.load(FARM).cfs)


if __name__ == "__main__":
    unittest.main()
