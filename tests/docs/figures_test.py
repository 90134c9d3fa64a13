"""Tests that the check of figures and links finds each fault of a page."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import figures

OUTPUT = "```console\n$ placedpar run a.cfs\nmaster  T_exe  8.91927  ms\nslaves busy  0.679\n```\n"


class Figures(unittest.TestCase):
    def unprinted(self, prose, printed_at=lambda target: []):
        return [figure for _, figure in figures.unprinted(OUTPUT + prose + "\n", printed_at)]

    def test_a_figure_is_a_rounded_number_of_the_output(self):
        self.assertEqual(self.unprinted("It takes 8.92 ms, or 8.9; busy for 67.9 %, or 68 %."), [])
        self.assertEqual(self.unprinted("It takes 8.93 ms, or 8.8; busy for 67.8 %, or 69 %."),
                         ["8.93", "8.8", "67.8", "69"])

    def test_code_counts_as_output_and_its_numbers_are_no_figures(self):
        self.assertEqual(self.unprinted("With `--set noise=0.25` it is 0.25; `0.31` is not read."), [])

    def test_numbers_that_name_something_are_no_figures(self):
        self.assertEqual(self.unprinted("See Tables 3.1, 3.2 and 3.3, equation 4.15, [Figure 2.9](2.9.md) and file v2.7."), [])
        self.assertEqual(self.unprinted("A table of 3.1 ms."), ["3.1"])

    def test_a_linked_page_may_print_it(self):
        self.assertEqual(self.unprinted("As [there](b.md) in 1.25 s.", lambda target: {"b.md": [1.249]}[target]), [])
        self.assertEqual(self.unprinted("As [there](b.md) in 1.26 s.", lambda target: [1.249]), ["1.26"])

    def test_a_listed_figure_needs_a_source_and_a_use(self):
        listed = figures.listed_figures("# why\na.md\n    1.5 1.6: by hand\n")
        self.assertEqual(listed, {"a.md": {"1.5": "by hand", "1.6": "by hand"}})
        self.assertEqual(figures.figure_faults("a.md", "It is 1.5 or 1.6.\n", listed["a.md"]), [])
        self.assertIn("a.md:1: 1.7", figures.figure_faults("a.md", "1.5, 1.6, 1.7\n", listed["a.md"])[0])
        self.assertIn("1.6 is not in the prose", figures.figure_faults("a.md", "It is 1.5.\n", listed["a.md"])[0])
        for wrong in ("a.md\n    1.5\n", "a.md\n    1.5: \n", "    1.5: by hand\n"):
            with self.assertRaises(ValueError):
                figures.listed_figures(wrong)

    def test_commands_that_are_sources_are_run(self):
        listed = figures.listed_figures("a.md\n    1.5 2.5: $ echo 1.499\n")
        faults = figures.command_faults(listed, pathlib.Path("/"), "/bin")
        self.assertEqual(len(faults), 1)
        self.assertIn("2.5 is not in what this prints", faults[0])


class Links(unittest.TestCase):
    def faults(self, text):
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder)
            (tree / "b.md").write_text("# One thing, and `two`\n")
            return figures.link_faults("a.md", text, tree)

    def test_files_and_headings(self):
        self.assertEqual(self.faults("[b](b.md), [web](https://example.org/x), `[no](link.md)`\n"), [])
        self.assertEqual(self.faults("[b](b.md#one-thing-and-two)\n"), [])
        self.assertIn("a.md:1: the link to c.md", self.faults("[c](c.md)\n")[0])
        self.assertIn("no heading #two", self.faults("[b](b.md#two)\n")[0])


class NamedFiles(unittest.TestCase):
    def test_a_file_is_in_the_tree_or_in_a_block_of_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder)
            (tree / "b.md").touch()
            text = "`b.md`, `c.hpp`, `mine.cfs` and `table-e1.md`\n```c mine.cfs\n```\n```console\n$ cat mine.cfs\n```\n"
            faults = figures.named_file_faults("a.md", text, tree, {"c.hpp"})
            self.assertEqual(faults, ["a.md:1: there is no file table-e1.md"])


class Whole(unittest.TestCase):
    def test_a_tree(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
            tree = pathlib.Path(folder)
            (tree / "README.md").write_text("It takes 7.5 s.\n")
            (tree / "list").write_text("gone.md\n    7.5: by hand\n")
            self.assertEqual(figures.main(tree, listing=tree / "list"), 1)
            self.assertIn("README.md:1: 7.5", said.getvalue())
            self.assertIn("there is no page gone.md", said.getvalue())


if __name__ == "__main__":
    unittest.main()
