"""Tests programs in occam of the public repository concurrency/kroc, which are not part of PlacedPar.

PLACEDPAR_KROC names a checkout of it. Without it the tests are skipped.
"""

import os
import pathlib
import re
import tempfile
import unittest

from program import placedpar

KROC = os.environ.get("PLACEDPAR_KROC")


@unittest.skipUnless(KROC, "PLACEDPAR_KROC names no checkout of concurrency/kroc")
class Programs(unittest.TestCase):
    def run_example(self, name, *options):
        done = placedpar("run", pathlib.Path(KROC) / "modules/course/examples" / f"{name}.occ", *options)
        self.assertIn(done.returncode, (0, 2), done.stdout + done.stderr)
        return done.stdout

    def test_the_three_hellos_print_one_line(self):
        for name in ("hello_raw_world", "hello_seq_world", "hello_world"):
            with self.subTest(name):
                self.assertTrue(self.run_example(name).startswith("Hello World\n"))

    def test_an_echo_of_keys_prints_each_twice(self):
        self.assertRegex(self.run_example("double_echo", "--keys", "abc", "--until", "1s"), r"aa.*bb.*cc")

    def test_the_benchmark_of_communications_begins(self):
        text = self.run_example("commstime", "--keys", "y", "--until", "1s")
        self.assertIn("Commstime in occam ...", text)
        self.assertIn("Commstime starting ...", text)

    def test_a_pipeline_draws_the_characters_that_it_sorts(self):
        text = self.run_example("sort_pump", "--keys", "hello", "--until", "3s")
        self.assertIn("................", text)
        self.assertIn("olleh", text)

    def test_conversions_are_right(self):
        self.assertTrue(self.run_example("casting").startswith("OK!\n"))

    def test_the_library_of_the_course_moves_the_cursor_and_writes_numbers(self):
        text = self.run_example("test_utils", "--keys", r"hello world and 42\r", "--until", "3s")
        self.assertIn("[11;41HHello World", text)
        self.assertIn("[20;12HHello World", text)


@unittest.skipUnless(KROC, "PLACEDPAR_KROC names no checkout of concurrency/kroc")
class CompilerTests(unittest.TestCase):
    def run_test(self, number, *options):
        """Runs a test of the compiler without what the language of 1988 lacks: lists that are compared."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "test.occ"
            file.write_text(f'#DEFINE COMPILER.TOCK\n#INCLUDE "cgtest{number}.occ"\n', encoding="ascii")
            return placedpar("run", file, "-I", pathlib.Path(KROC) / "tests/cgtests", *options)

    def test_the_tests_pass(self):
        # The fifth has a subscript out of range in a guard that is false.
        for number, options in (("00", ()), ("02", ()), ("05", ("--no-checks", "range")), ("12", ()), ("20", ())):
            with self.subTest(number):
                done = self.run_test(number, *options)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertTrue(re.search(r"\^\^\^ Passed : .*: All \d+ tests passed OK", done.stdout), done.stdout)

    def test_a_table_of_channels_is_refused_by_name(self):
        done = self.run_test("03")
        self.assertEqual(done.returncode, 1)
        self.assertIn("cgtest03.occ:361:16: error: tables of channels are not supported", done.stderr)


if __name__ == "__main__":
    unittest.main()
