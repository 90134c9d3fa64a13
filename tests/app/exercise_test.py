"""Tests placedpar exercise: each answer of the course is right, each start is not, and messages say what is wrong."""

import pathlib
import re
import tempfile
import unittest

from program import EXAMPLES, placedpar

COURSE = EXAMPLES.parent / "docs/occam-course"
NUMBERS = [f"{page}.{place}" for page in range(1, 11) for place in (1, 2, 3)]
PROGRAM = """#INCLUDE "hostio.inc"
PROC main (CHAN OF SP fs, ts, []INT memory)
  #USE "hostio.lib"
  {}
:
"""


def file_of(folder, number):
    return COURSE / folder / f"{number.replace('.', '-')}.occ"


class Course(unittest.TestCase):
    def test_the_answers_are_right_in_every_order(self):
        for number in NUMBERS:
            answer = file_of("answers", number)
            done = placedpar("exercise", number, answer)
            self.assertEqual((done.returncode, done.stdout, done.stderr),
                             (0, f"{answer}: solved; also with 20 other orders of its processes\n", ""), number)

    def test_the_starts_are_not_right_yet(self):
        for number in NUMBERS:
            done = placedpar("exercise", number, file_of("exercises", number))
            self.assertIn(done.returncode, (1, 2), number)
            self.assertRegex(done.stdout + done.stderr, "not solved: |error: ", number)

    def test_a_task_is_the_program_to_start_from_and_the_list_has_all_titles(self):
        titles = []
        for number in NUMBERS:
            done = placedpar("exercise", number)
            self.assertEqual((done.returncode, done.stdout), (0, file_of("exercises", number).read_text("ascii")))
            titles.append(re.match(rf"-- Exercise {number}: (\S.*)\n-- \S", done.stdout)[1])
            answer = file_of("answers", number).read_text("ascii")
            self.assertTrue(answer.startswith(f"-- Answer {number}: {titles[-1]}\n"), number)
        listed = placedpar("exercise").stdout
        for number, title in zip(NUMBERS, titles):
            self.assertIn(f"{number:>4}  {title}\n", listed)

    def test_each_page_has_its_three_exercises(self):
        for page in range(1, 11):
            text = next(COURSE.glob(f"{page:02}-*.md")).read_text("utf-8")
            self.assertEqual(re.findall(r"\[([0-9.]+)\]\(exercises/(.*)\.occ\)", text),
                             [(f"{page}.{place}", f"{page}-{place}") for place in (1, 2, 3)])


class Messages(unittest.TestCase):
    def check(self, number, process):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "mine.occ").write_text(PROGRAM.format(process.replace("\n", "\n  ")), "ascii")
            return placedpar("exercise", number, "mine.occ", folder=folder)

    def assert_wrong(self, process, exit_code, pattern):
        done = self.check("3.2", process)
        self.assertEqual(done.returncode, exit_code, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"\Amine\.occ: not solved: " + pattern)

    def test_another_output(self):
        self.assert_wrong('SEQ\n  so.write.string.nl (fs, ts, "43")\n  so.exit (fs, ts, sps.success)', 1,
                          r'line 1 of the output is wrong\n  expected: "42"\n  printed:  "43"\n\Z')

    def test_a_deadlock_an_error_and_a_failure(self):
        self.assert_wrong("CHAN OF INT c:\nc ! 1", 2, "the program is in a deadlock at .* after 0 lines of output")
        self.assert_wrong("INT x:\nSEQ\n  x := MOSTPOS INT\n  x := x + 1", 1, "the program stopped")
        self.assert_wrong("so.exit (fs, ts, sps.failure)", 1, "the program exited with failure")

    def test_a_program_that_computes_or_prints_for_ever(self):
        self.assert_wrong("WHILE TRUE\n  SKIP", 1, "the program has not ended after 10 s of simulated time")
        self.assert_wrong('WHILE TRUE\n  so.write.string.nl (fs, ts, "42")', 1, "the program prints more than 65536 bytes")

    def test_a_program_that_is_right_in_the_usual_order_only(self):
        racing = """[4]CHAN OF INT c:
INT first, x:
SEQ
  PAR
    PAR i = 0 FOR 4
      c[i] ! 42 - i
    SEQ
      ALT i = 0 FOR 4
        c[i] ? first
          SKIP
      SEQ j = 0 FOR 3
        ALT i = 0 FOR 4
          c[i] ? x
            SKIP
  so.write.int (fs, ts, first, 0)
  so.write.nl (fs, ts)
  so.exit (fs, ts, sps.success)"""
        self.assert_wrong(racing, 1, r'the program is right in the usual order of its processes, but not in every order\n'
                                     r'with --shuffle \d+, line 1 of the output is wrong\n  expected: "42"')

    def test_wrong_use(self):
        for arguments, message in ((("3.4",), 'there is no exercise "3.4"; the exercises are 1.1 to 10.3'),
                                   (("3.2", "nowhere.occ"), "nowhere.occ"),
                                   (("3.2", "mine.txt"), "mine.txt: a solution is a program in occam, with a name such as mine.occ")):
            done = placedpar("exercise", *arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(message, done.stderr)


if __name__ == "__main__":
    unittest.main()
