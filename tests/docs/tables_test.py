"""Tests that a CommonMark parser sees every table, and that each row has as many cells as the header."""

import pathlib
import re
import sys
import unittest

sys.path.append("/usr/lib/python3/dist-packages")  # where Debian puts it, whichever Python runs this
from markdown_it import MarkdownIt

ROOT = pathlib.Path(__file__).resolve().parents[2]
PARSER = MarkdownIt("commonmark").enable("table")


def cells(row):
    """Counts cells as a renderer does: a pipe that is not escaped ends a cell, even in code."""
    return len(re.sub(r"\\\|", "", row.strip().strip("|")).split("|"))


def faults(text):
    """Returns a line for each row that is not rendered as intended."""
    lines, tokens = text.splitlines(), PARSER.parse(text)
    blocks = {kind: [token.map for token in tokens if token.type == kind] for kind in ("table_open", "fence", "code_block")}
    inside = lambda i, *kinds: any(first <= i < last for kind in kinds for first, last in blocks[kind])
    found = [f"line {i + 1} is no row of a table: {line}" for i, line in enumerate(lines)
             if line.lstrip().startswith("|") and not inside(i, "table_open", "fence", "code_block")]
    for first, last in blocks["table_open"]:
        found += [f"line {i + 1} has {cells(lines[i])} cells, its header {cells(lines[first])}: {lines[i]}"
                  for i in range(first, last) if cells(lines[i]) != cells(lines[first])]
    return found


class Tables(unittest.TestCase):
    def test_all_documents(self):
        documents = [path for path in ROOT.rglob("*.md") if "build" not in path.relative_to(ROOT).parts]
        self.assertGreater(len(documents), 50)
        for path in documents:
            self.assertEqual(faults(path.read_text(encoding="utf-8")), [], path)

    def test_a_row_without_its_table_and_one_of_too_many_cells_are_found(self):
        table = "| a | b |\n|---|---|\n| 1 | 2 |\n"
        self.assertEqual(faults(table), [])
        self.assertEqual(len(faults(table + "\n| 3 | 4 |\n")), 1)
        self.assertEqual(len(faults(table + "| `x|y` | 4 |\n")), 1)
        self.assertEqual(faults(table + "| `x\\|y` | 4 |\n"), [])
        self.assertEqual(faults("```\n| 3 |\n```\n"), [])


if __name__ == "__main__":
    unittest.main()
