"""Tests placedpar mark: good, wrong, stuck and hostile submissions, each with its result."""

import csv
import pathlib
import signal
import subprocess
import tempfile
import unittest

from program import EXAMPLES, PROGRAM, placedpar

ANSWERS = EXAMPLES.parent / "docs/occam-course/answers"
STARTS = EXAMPLES.parent / "docs/occam-course/exercises"
PROGRAM_TEXT = """#INCLUDE "hostio.inc"
PROC main (CHAN OF SP fs, ts, []INT memory)
  #USE "hostio.lib"
{}
:
"""
# Two processes that each wait for the other's message.
DEADLOCK = PROGRAM_TEXT.format("""  CHAN OF INT a, b:
  INT x, y:
  PAR
    SEQ
      a ? x
      b ! 1
    SEQ
      b ? y
      a ! 2""")
FOR_EVER = PROGRAM_TEXT.format("""  WHILE TRUE
    SKIP""")
PRINTS_FOR_EVER = PROGRAM_TEXT.format("""  WHILE TRUE
    so.write.string.nl(fs, ts, "occam")""")
# The value that comes first depends on the order of the processes.
RACE = PROGRAM_TEXT.format("""  [4]CHAN OF INT c:
  INT first, x:
  SEQ
    PAR
      PAR i = 0 FOR 4
        c[i] ! 12 - i
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
    so.exit (fs, ts, sps.success)""")
READS_A_FILE = PROGRAM_TEXT.format("""  #INCLUDE "/etc/passwd"
  SKIP""")


class Mark(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.marks = self.folder / "marks.csv"

    def put(self, name, text):
        path = self.folder / "class" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode("ascii"))

    def rows(self):
        with self.marks.open(encoding="utf-8", newline="") as file:
            return {row["file"]: row for row in csv.DictReader(file)}

    def test_every_kind_of_submission(self):
        self.put("ada/good.occ", (ANSWERS / "1-1.occ").read_bytes())
        self.put("start.occ", (STARTS / "1-1.occ").read_bytes())
        self.put("stuck.occ", DEADLOCK)
        self.put("endless.occ", FOR_EVER)
        self.put("prints.occ", PRINTS_FOR_EVER)
        self.put("file.occ", READS_A_FILE)
        self.put("error.occ", "PROC main (\n")
        self.put("utf16.occ", "PROC".encode("utf-16"))
        self.put("notes.txt", "not a submission")
        self.put("eve/notes.txt", "not a submission")
        (self.folder / "class/link.occ").symlink_to(ANSWERS / "1-1.occ")
        done = placedpar("mark", self.folder / "class", "--exercise", "1.1", "--csv", self.marks, "--seconds", "20")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rows = self.rows()
        self.assertEqual({name: row["result"] for name, row in rows.items()},
                         {"ada/good.occ": "solved", "start.occ": "wrong output", "stuck.occ": "deadlock",
                          "endless.occ": "too long", "prints.occ": "too much output", "file.occ": "refused",
                          "error.occ": "refused", "utf16.occ": "refused", "eve": "nothing submitted"})
        self.assertEqual(rows["ada/good.occ"]["why"], "")
        self.assertGreater(float(rows["ada/good.occ"]["simulated_ms"]), 0)
        self.assertIn('expected: "on a transputer"', rows["start.occ"]["why"])
        self.assertIn("/etc/passwd", rows["file.occ"]["why"])
        self.assertRegex(done.stdout, r"(?m)^ada/good.occ  solved +\d+\.\d+ *$")
        self.assertIn("9 marks: 1 deadlock, 1 nothing submitted, 3 refused, 1 solved, 1 too long, 1 too much output, 1 wrong output",
                      done.stdout)

    def test_a_task_of_the_teacher(self):
        (self.folder / "expected.txt").write_text("occam\non a transputer\n", "ascii")
        self.put("good.occ", (ANSWERS / "1-1.occ").read_bytes())
        done = placedpar("mark", self.folder / "class", "--expected", self.folder / "expected.txt")
        self.assertIn("1 mark: 1 solved\n", done.stdout)

    def test_a_race_is_found_in_another_order(self):
        (self.folder / "expected.txt").write_text("12\n", "ascii")
        self.put("race.occ", RACE)
        done = placedpar("mark", self.folder / "class", "--expected", self.folder / "expected.txt", "--csv", self.marks)
        self.assertIn("1 mark: 1 wrong output\n", done.stdout)
        self.assertIn("the program is right in the usual order of its processes, but not in every order", self.rows()["race.occ"]["why"])

    def test_a_check_that_takes_too_long_names_the_limit(self):
        self.put("slow.occ", FOR_EVER)
        done = placedpar("mark", self.folder / "class", "--exercise", "1.1", "--csv", self.marks, "--seconds", "1",
                         "--jobs", "1")
        self.assertEqual(done.returncode, 0)
        self.assertIn(self.rows()["slow.occ"]["result"], ("too long", "out of time"))

    def test_an_include_of_the_submission(self):
        self.put("ada/words.inc", 'VAL word IS "on a transputer":\n')
        text = (ANSWERS / "1-1.occ").read_text("ascii").replace('"on a transputer"', "word")
        self.put("ada/mine.occ", '#INCLUDE "words.inc"\n' + text)
        done = placedpar("mark", self.folder / "class", "--exercise", "1.1")
        self.assertIn("1 mark: 1 solved\n", done.stdout, done.stdout)

    def test_wrong_use(self):
        self.put("notes.txt", "")
        for arguments, message in (((self.folder / "class", "--exercise", "1.1"), "has no submission"),
                                   ((self.folder / "absent", "--exercise", "1.1"), "No such file or directory"),
                                   ((self.folder / "class",), "name one task: either an exercise"),
                                   ((self.folder / "class", "--exercise", "99.1"), 'there is no exercise "99.1"')):
            done = placedpar("mark", *arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(message, done.stderr)

    def test_an_interruption_writes_no_file(self):
        for number in range(40):
            self.put(f"{number:02}.occ", FOR_EVER)
        marking = subprocess.Popen([PROGRAM, "mark", str(self.folder / "class"), "--exercise", "1.1", "--csv",
                                    str(self.marks)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            marking.wait(timeout=1)
        except subprocess.TimeoutExpired:
            marking.send_signal(signal.SIGINT)
        _, complaint = marking.communicate(timeout=20)
        self.assertEqual(marking.returncode, 130)
        self.assertRegex(complaint, r"interrupted: \d+ of 40 submissions are marked, and no file was written")
        self.assertFalse(self.marks.exists())


if __name__ == "__main__":
    unittest.main()
