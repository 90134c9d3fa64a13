"""Tests that the checker of code blocks finds each fault."""

import pathlib
import shutil
import tempfile
import unittest
import unittest.mock

import blocks


def wrong(page, name="docs/guides/page.md", **files):
    """Returns the faults found in a tree with one page; without a compiler, C++ blocks are only extracted."""
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        (tree / name).parent.mkdir(parents=True)
        (tree / name).write_text(page)
        for other, text in files.items():
            (tree / name).parent.joinpath(other.replace("_", ".")).write_text(text)
        return blocks.wrong_blocks(tree, folder, shutil.which("true"))


def fenced(info, text):
    return f"```{info}\n{text}\n```\n"


class Blocks(unittest.TestCase):
    def test_a_language_that_nothing_checks_is_refused(self):
        for info in ("", "r", "c++", "occam", "cpp two words"):
            self.assertIn('docs/guides/page.md:2: nothing checks a block of the language', wrong(fenced(info, "x"))[0], info)
        for info in ("console", "text", "monitor"):
            self.assertEqual(wrong(fenced(info, "$ x")), [])

    def test_a_file_must_be_used_by_a_command(self):
        self.assertIn("no command of the page uses a.toml", wrong(fenced("toml a.toml", "x = 1"))[0])
        self.assertEqual(wrong(fenced("toml a.toml", "x = 1") + fenced("console", "$ placedpar sweep a.toml")), [])

    def test_cpp_with_the_name_of_a_file_is_compiled_too(self):
        page = fenced("cpp a.cpp", "int x;") + fenced("console", "$ placedpar check a.cpp")
        with unittest.mock.patch("blocks.wrong_cpp", side_effect=lambda tree, compiler, of_pages: of_pages):
            self.assertEqual(wrong(page), [(pathlib.Path("docs/guides/page.md"), [(2, "int x;\n")])])

    def test_shell_and_python_are_parsed(self):
        self.assertEqual(wrong(fenced("sh", "for i in 1 2; do echo $i; done") + fenced("python", "x = [1]")), [])
        self.assertEqual(len(wrong(fenced("sh", "for i in") + fenced("python", "x = ["))), 2)

    def test_lines_of_a_netlist_beside_the_page_are_an_excerpt(self):
        self.assertEqual(wrong(fenced("netlist", "val b 2;"), "examples/1/README.md", n_cfs="val a 1;\n    val b 2;\n"), [])

    def test_the_blocks_of_a_page_share_a_namespace_and_know_their_lines(self):
        page = [(7, "#include <placedpar/app/program.hpp>\n#include <cmath>\nint main() {}\n"), (20, "int x;\n")]
        includes, body = blocks.source_of("docs/guides/page.md", 3, page)
        self.assertEqual(includes, ['#include "app/program.hpp"', "#include <cmath>"])
        self.assertEqual(body, ["namespace page_3 {", "using namespace ::placedpar;", '#line 7 "docs/guides/page.md"', "", "",
                                "int main_of_the_page() {}", '#line 20 "docs/guides/page.md"', "int x;", "}"])

    def test_what_the_compiler_refuses_is_refused(self):
        tree = pathlib.Path("/")
        self.assertEqual(len(blocks.wrong_cpp(tree, shutil.which("false"), [])), 1)


if __name__ == "__main__":
    unittest.main()
