"""Tests that one record, as loggers and spreadsheets write it, gives one answer: the files of examples/hydraulics/loggers."""

import json
import pathlib
import re
import tempfile
import unittest

from program import EXAMPLES, placedpar

LOGGERS = EXAMPLES / "hydraulics" / "loggers"
TRUTH = 0.0086


def commands():
    """Returns the options of each file as its page states them."""
    page = (LOGGERS / "README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `([^`]+)` \|.*\| (?:`(.*)`|none) \|$", page, re.MULTILINE)
    return {name: [word.strip("'") for word in re.findall(r"'[^']*'|[^\s']+", options)] for name, options in rows}


class Loggers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def answer(self, path, *options):
        """Returns the answers of `identify` as JSON, without the command and the warnings."""
        out = self.folder / "answer.json"
        run = placedpar("identify", path, *options, "--json", out, folder=LOGGERS)
        self.assertEqual(run.returncode, 0, f"{path} {options}\n{run.stdout}{run.stderr}")
        found = json.loads(out.read_text(encoding="utf-8"))
        return {key: value for key, value in found.items() if key not in ("command", "warnings")}

    def test_twenty_files_give_one_answer_bit_by_bit(self):
        files = commands()
        self.assertEqual(len(files), 20)
        self.assertEqual(sorted([*files, "README.md", "names.txt"]), sorted(path.name for path in LOGGERS.iterdir()))
        expected = self.answer("house.csv")
        (boom,) = expected["movements"][0]["links"]
        self.assertAlmostEqual(boom["whole_movement"]["compliance"], TRUTH, delta=0.15 * TRUTH)
        for name, options in files.items():
            with self.subTest(name):
                if name not in ("amplifier-metric.csv", "script-milliseconds.csv"):
                    self.assertEqual(self.answer(name, *options), expected)

    def test_a_file_in_other_units_differs_only_by_the_rounding_of_its_digits(self):
        files, of_whole = commands(), lambda found: found["movements"][0]["links"][0]["whole_movement"]
        expected = of_whole(self.answer("house.csv"))
        for name in ("amplifier-metric.csv", "script-milliseconds.csv"):
            found = of_whole(self.answer(name, *files[name]))
            self.assertAlmostEqual(found["compliance"] / expected["compliance"], 1, delta=1e-5)
            self.assertAlmostEqual(found["standard_error"] / expected["standard_error"], 1, delta=1e-3)

    def test_a_thesis_search_reads_the_same_names(self):
        names = ["--columns-from", "names.txt", "--way", "thesis"]
        self.assertEqual(self.answer("bench-decimal-comma.txt", *names), self.answer("house.csv", "--way", "thesis"))

    def test_utf_16_and_carriage_returns_only_are_refused_with_the_way_to_convert_them(self):
        text = (LOGGERS / "house.csv").read_text(encoding="utf-8")
        for encoding in ("utf-16", "utf-16-le", "utf-16-be"):
            path = self.folder / "wide.csv"
            path.write_bytes(text.encode(encoding))
            for way in ("service", "thesis"):
                run = placedpar("identify", path, "--way", way)
                self.assertEqual(run.returncode, 1)
                self.assertEqual(run.stderr, f"{path}: error: the file is UTF-16, expected UTF-8 or ASCII: iconv -f UTF-16 "
                                             "-t UTF-8 FILE > NEW converts it\n")
        for rows in (3, 10_000): # a short file, and one that is longer than the longest line
            path = self.folder / "old.csv"
            path.write_bytes("\r".join(text.split("\n")[:rows]).encode())
            run = placedpar("identify", path)
            self.assertEqual(run.returncode, 1)
            self.assertIn("tr '\\r' '\\n' < FILE > NEW", run.stderr)

    def test_wrong_names_are_refused(self):
        for option, said in (("presure=P", "placedpar: --column \"presure\" is not a channel: expected time"),
                             ("pressure", "placedpar: --column \"pressure\": expected NAME=NAME_IN_FILE"),
                             ("angle [bar]=Phi_boom", "placedpar: --column \"bar\" is not a unit of angle"),
                             ("angle=Phi_bom", "bench.txt:6:1: error: no column is named \"Phi_bom\"")):
            run = placedpar("identify", "bench.txt", "--column", option, folder=LOGGERS)
            self.assertEqual(run.returncode, 1)
            self.assertIn(said, run.stderr)
        run = placedpar("identify", "bench.txt", "--column", "angle=X_boom", "--column", "spool=X_boom", folder=LOGGERS)
        self.assertIn('the column "X_boom" is given to two channels', run.stderr)
        names = self.folder / "names.txt"
        names.write_text("# mine\n\nboom.angle = Phi_boom\nboom.hight = X\n", encoding="utf-8")
        run = placedpar("identify", "bench.txt", "--columns-from", names, folder=LOGGERS)
        self.assertEqual(run.returncode, 1)
        self.assertIn(f"{names}:4: error: \"boom.hight\" is not a channel", run.stderr)

    def test_a_repeated_fault_is_one_message_with_its_count(self):
        lines = (LOGGERS / "house.csv").read_text(encoding="utf-8").splitlines()
        path = self.folder / "twice.csv"
        path.write_text("\n".join(lines[:2] + [line for line in lines[2:] for _ in range(2)]) + "\n", encoding="utf-8")
        for way in ("service", "thesis"):
            run = placedpar("identify", path, "--way", way)
            self.assertEqual(run.stderr.count("warning"), 1, run.stderr)
            self.assertIn("twice.csv:4:1: warning: the row repeats line 3 (and 124 more lines, the last is line 252)", run.stderr)
        path.write_text("\n".join(lines[:5] + [line.replace(".", ".x") for line in lines[5:]]) + "\n", encoding="utf-8")
        run = placedpar("identify", path)
        self.assertEqual(run.returncode, 1)
        self.assertLessEqual(run.stderr.count(": error: "), 20)

    def test_a_fault_of_later_pieces_is_counted_at_the_end(self):
        lines = (LOGGERS / "house.csv").read_text(encoding="utf-8").splitlines()
        still = lines[2].split(",")[1:]
        rows = [",".join([f"{2.5 + 0.02 * (i // 2):.2f}", *still]) for i in range(100_000)]
        path = self.folder / "long.csv"
        path.write_text("\n".join(lines + rows) + "\n", encoding="utf-8")
        run = placedpar("identify", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        first, later = re.search(r"repeats line 128 \(and (\d+) more lines", run.stderr), \
            re.search(r"\.\.\. (\d+) more lines like \"the row repeats line 128\", the last is line 100127", run.stderr)
        self.assertTrue(first and later, run.stderr)
        self.assertEqual(1 + int(first[1]) + int(later[1]), 50_000)


if __name__ == "__main__":
    unittest.main()
