"""Tests that the runner of documents finds each fault."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import document


def console(*lines):
    return "\n".join(["```console", *lines, "```", ""])


def outcome(text):
    """Returns a document's number of failures, the messages about them, and the mended document."""
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as said:
        tree = pathlib.Path(folder)
        (tree / "page.md").write_text(text)
        failures, mended = document.run("page.md", tree, folder)
        return failures, said.getvalue(), mended


class Documents(unittest.TestCase):
    def passes(self, text):
        failures, said, mended = outcome(text)
        self.assertEqual(failures, 0, said)
        self.assertEqual(mended, text)

    def fails(self, text, *because):
        failures, said, _ = outcome(text)
        self.assertEqual(failures, 1)
        for words in because:
            self.assertIn(words, said)

    def test_output_is_compared_to_the_letter(self):
        self.passes(console("$ printf 'a\\nb\\n'", "a", "b"))
        self.fails(console("$ echo a", "b"), "page.md:2: $ echo a", "\n-b\n+a\n")
        self.fails(console("$ echo 'a '", "a"))
        self.fails(console("$ printf 'a\\nb\\n'", "a"), "+b")

    def test_three_points_stand_for_any_number_of_lines(self):
        self.passes(console("$ printf 'a\\nb\\nc\\n'", "a", "...", "c"))
        self.passes(console("$ echo a", "a", "..."))
        self.passes(console("$ true", "..."))
        self.fails(console("$ printf 'a\\nb\\n'", "a", "...", "c"))

    def test_both_streams_are_output(self):
        self.passes(console("$ echo wrong >&2", "wrong"))

    def test_exit_codes(self):
        self.passes(console("$ exit 2 # exit 2"))
        self.fails(console("$ exit 2"), "exit code 2, the document says 0")
        self.fails(console("$ true # exit 2"), "exit code 0, the document says 2")

    def test_commands_go_on_after_a_backslash(self):
        self.passes(console("$ echo a \\", "    b", "a b"))

    def test_each_command_of_a_block_is_run(self):
        self.fails(console("$ echo a", "a", "", "$ echo b", "c", "$ true"), "3 commands, 1 failures")

    def test_outputs_are_mended_in_their_places(self):
        stale = console("$ echo a", "b", "", "$ printf 'c\\nd\\n' \\", "  # goes on", "e", "f", "g", "$ echo h", "x", "...", "y")
        mended = console("$ echo a", "a", "", "$ printf 'c\\nd\\n' \\", "  # goes on", "c", "d", "$ echo h", "x", "...", "y")
        self.assertEqual(outcome(stale)[2], mended)

    def test_a_named_block_is_a_file(self):
        self.passes("```c mine.cfs\nT800 a;\n```\n" + console("$ cat mine.cfs", "T800 a;"))

    def test_other_blocks_are_not_run(self):
        self.passes("```sh\nfalse\n```\n\n```\n$ false\n```\n")

    def test_a_block_must_be_closed_and_begin_with_a_command(self):
        with self.assertRaises(SyntaxError):
            outcome("```console\n$ true\n")
        with self.assertRaises(SyntaxError):
            outcome(console("true"))

    def test_the_copy_has_the_page_and_the_examples_and_all_of_a_tree_that_is_named(self):
        for command, present in (("cat docs/guides/page.md examples/a.cfs", {"docs/guides/page.md", "examples/a.cfs"}),
                                 ("ls .", {"docs/guides/page.md", "examples/a.cfs", "room/b.cpp"})):
            with tempfile.TemporaryDirectory() as folder:
                source, tree = pathlib.Path(folder) / "source", pathlib.Path(folder) / "tree"
                for name, text in (("docs/guides/page.md", console(f"$ {command}")), ("examples/a.cfs", ""), ("room/b.cpp", ""),
                                   ("build/c.o", "")):
                    (source / name).parent.mkdir(parents=True, exist_ok=True)
                    (source / name).write_text(text)
                document.copy_for("docs/guides/page.md", source, tree)
                self.assertEqual({str(path.relative_to(tree)) for path in tree.rglob("*") if path.is_file()}, present)


if __name__ == "__main__":
    unittest.main()
