"""Tests names that the tools refuse: impossible ones, taken ones, and trees that they do not know. Nothing is written
then."""

import itertools
import pathlib
import tempfile
import unittest

from copied_tree import copy_tree, run_tool
import skeleton
import tree


class Refusals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.top = copy_tree(folder.name)

    def stamps(self):
        """Returns time of change and size of each file of the tree."""
        found = {name: (self.top / name).stat() for name in tree.names(self.top)}
        return {name: (stat.st_mtime_ns, stat.st_size) for name, stat in found.items()}

    def refused(self, message, what, *arguments):
        before = self.stamps()
        done = run_tool(self.top, what, *arguments)
        self.assertEqual((done.returncode, done.stdout), (1, ""), arguments)
        self.assertIn(message, done.stderr)
        self.assertTrue(done.stderr.startswith(f"new-{what}: "), done.stderr)
        self.assertEqual(self.stamps(), before)

    def test_names_that_cannot_be(self):
        names = ("HourGlass", "hour-glass"), ("hour_glass", "hour-glass"), ("3-way", "way"), ("a--b", "a-b"), ("../x", "x"), ("", "hour-glass")
        for (name, proper), what in itertools.zip_longest(names, skeleton.PIECES, fillvalue="kind"):
            self.refused(f'"{name}" cannot be a name: a name has small letters and digits, and hyphens between words, such as '
                         f'"{proper}"\n', what, name)
        self.refused('"double" is a reserved word of C++: choose another name, such as "my-double"', "kind", "double")
        self.refused('"thread-local" is a reserved word of C++', "problem", "thread-local")
        self.refused('"linux" is a reserved word of C++', "experiment", "linux")
        self.refused('"connect" is a word of netlists', "device", "connect")
        self.refused("has 25 characters: a name has at most 24", "kind", "a" * 25)

    def test_names_that_are_taken(self):
        self.refused("examples/csp/sieve already exists: choose another name", "kind", "sieve")
        self.refused('"buffer" is taken: classics/bounded_buffer.cpp:', "kind", "buffer")
        self.refused('"transputer" is taken: ', "device", "transputer")
        self.refused('"clock" is a word of netlists, or a name', "device", "clock")
        self.refused('"hardware" is taken: ', "device", "hardware")
        self.refused('"sphere" is taken: problems/benchmark/functions.hpp:', "problem", "sphere")
        self.refused('"boom" is taken: explore/problems.cpp:', "problem", "boom")
        self.refused('"processor" is taken: experiments/machine/processor.cpp:', "experiment", "processor", "chapter_2")

    def test_files_that_are_there(self):
        self.refused('tests/app/trace_test.py already exists: choose another name than "trace", or remove the file',
                     "experiment", "trace")
        file = self.top / "classics" / "half_made.cpp"
        file.write_text("")
        self.addCleanup(file.unlink)
        self.refused("classics/half_made.cpp already exists", "kind", "half-made")

    def test_folders_without_experiments(self):
        for folder in ("chapter_9", "kit", "..", "chapter_3/kit"):
            self.refused(f"experiments/{folder} has no experiments: expected one of the folders appendix_e, chapter_2, chapter_3, "
                         "chapter_4, chapter_5, chapter_6, machine", "experiment", "one-way", folder)

    def test_lists_that_are_not_as_they_were(self):
        listing = self.top / "classics" / "kinds.cpp"
        text = listing.read_text(encoding="utf-8")
        self.addCleanup(listing.write_text, text)
        listing.write_text(text.replace("catalogue.add", "catalogue->add").replace("auto& kind", "auto&& kind"))
        self.refused("classics/kinds.cpp: expected the line", "kind", "hour-glass")
        listing.unlink()
        self.refused("classics/kinds.cpp: cannot be read", "kind", "hour-glass")

    def test_arguments(self):
        self.refused("expected a name, got 0 arguments\nusage: tools/new-kind NAME\n", "kind")
        self.refused("expected a name, got 2 arguments\nusage: tools/new-device NAME\n", "device", "a", "b")
        for what in skeleton.PIECES:
            done = run_tool(self.top, what, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertTrue(done.stdout.startswith(f"usage: tools/new-{what} NAME"))


class AllOrNothing(unittest.TestCase):
    def test_what_was_written_before_a_failure_is_taken_back(self):
        with tempfile.TemporaryDirectory() as folder:
            top = pathlib.Path(folder)
            (top / "listed").write_text("before")
            (top / "a-file").write_text("")
            with self.assertRaisesRegex(skeleton.Refusal, "a-file/b: cannot be written: .*; nothing was changed"):
                skeleton.write({"listed": "after", "new/deep/a": "a", "a-file/b": "b", "later": "c"}, top)
            self.assertEqual(sorted(path.name for path in top.rglob("*")), ["a-file", "listed"])
            self.assertEqual((top / "listed").read_text(), "before")


if __name__ == "__main__":
    unittest.main()
