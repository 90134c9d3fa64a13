"""Tests that the table of the thesis is complete, and that thesis.py finds what is wrong with one."""

import pathlib
import tempfile
import unittest

import thesis

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = """# One

```console
$ placedpar replay one --plots plots
table
cells judged against the thesis: 7 (2 of them set constants); against own figures: 3; not judged: 0
$ placedpar replay two
cells judged against the thesis: 0; against own figures: 3; not judged: 0
```

![a](a.svg)
"""
ROW = {"of": "Figure 1.1", "shows": "one", "page": "thesis/one", "command": "placedpar replay one", "verdict": "drawn",
       "picture": "a.svg"}
THESIS = {"figures": "1.1", "tables": "", "equations": ""}
VERDICTS = {"drawn": "d", "within tolerance": "w", "differs": "f", "not reproduced": "n"}


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name)
        page = self.tree / "examples/thesis/one"
        page.mkdir(parents=True)
        (page / "README.md").write_text(PAGE, encoding="utf-8")
        (page / "a.svg").write_text("", encoding="utf-8")

    def faults(self, *rows, **listed):
        data = {"row": rows, "thesis": {**THESIS, **listed}, "verdicts": VERDICTS}
        return thesis.faults_of(data, self.tree)

    def row(self, **changes):
        return {key: value for key, value in {**ROW, **changes}.items() if value is not None}

    def test_a_right_row_has_no_fault(self):
        self.assertEqual(self.faults(ROW), [])
        self.assertEqual(self.faults(self.row(verdict="within tolerance", picture=None)), [])

    def test_every_item_has_one_row(self):
        self.assertEqual(self.faults(ROW, figures="1.1 to 1.3", tables="A.1"),
                         ["Figure 1.2: no row", "Figure 1.3: no row", "Table A.1: no row"])
        self.assertEqual(self.faults(ROW, self.row(of="Equations 1.1, 1.2")),
                         ["Equation 1.1: the thesis has no such item", "Equation 1.2: the thesis has no such item"])
        self.assertEqual(self.faults(ROW, ROW), ["Figure 1.1: two rows"])

    def test_a_statement_in_words_may_have_a_row(self):
        claim = self.row(of="Claim of section 1.2: growth", picture=None, verdict="differs", why="so")
        self.assertEqual(self.faults(ROW, claim), [])
        self.assertEqual(thesis.chapter_of(claim), "1")
        self.assertEqual(thesis.chapter_of({"of": "Claim of appendix E: a time"}), "E")
        self.assertEqual(self.faults(ROW, claim, claim), ["Claim of section 1.2: growth: two rows"])
        self.assertEqual(len(self.faults(ROW, self.row(of="Claim of growth"))), 1)

    def test_a_verdict_is_one_of_the_list_and_has_what_it_needs(self):
        for changes, fault in (({"verdict": "fine"}, 'Figure 1.1: "fine" is none of the verdicts'),
                               ({"verdict": "differs"}, 'Figure 1.1: "differs" without a reason'),
                               ({"picture": None}, "Figure 1.1: drawn, without a picture"),
                               ({"verdict": "within tolerance", "command": "placedpar replay two"},
                                "Figure 1.1: within tolerance, but its command shows no cell judged against the thesis")):
            self.assertEqual(self.faults(self.row(**changes)), [fault])

    def test_what_a_row_names_is_there(self):
        for changes, fault in (({"page": "thesis/none"}, "Figure 1.1: there is no page examples/thesis/none/README.md"),
                               ({"picture": "b.svg"}, "Figure 1.1: examples/thesis/one/README.md shows no picture b.svg"),
                               ({"command": "placedpar replay on"}, "Figure 1.1: examples/thesis/one/README.md does not "
                                                                    "run placedpar replay on"),
                               ({"page": None}, "Figure 1.1: no page")):
            self.assertEqual(self.faults(self.row(**changes)), [fault])
        (self.tree / "examples/thesis/one/a.svg").unlink()
        self.assertEqual(self.faults(ROW), ["Figure 1.1: examples/thesis/one/README.md shows no picture a.svg"])

    def test_cells_are_those_of_the_command(self):
        self.assertEqual(thesis.row_text(ROW, self.tree),
                         "| [Figure 1.1](one/README.md) | one | `placedpar replay one` | drawn | 7, 2 set constants |")
        text = thesis.row_text(self.row(command="placedpar replay two", verdict="differs", why="so"), self.tree)
        self.assertEqual(text, "| [Figure 1.1](one/README.md) | one | `placedpar replay two` | **differs**: so |  |")

    def test_only_the_part_between_the_marks_is_replaced(self):
        text = f"before\n{thesis.BEGIN}\nold\n{thesis.END}\nafter\n"
        self.assertEqual(thesis.with_generated(text, "new"), "before\nnew\nafter\n")
        self.assertRaises(ValueError, thesis.with_generated, "before\n", "new")

    def test_a_readme_that_differs_is_refused_and_written_anew(self):
        folder = self.tree / "examples/thesis"
        row = "\n".join(f'{key} = "{value}"' for key, value in ROW.items())
        (folder / "thesis.toml").write_text(
            f'[thesis]\nfigures = "1.1"\ntables = ""\nequations = ""\n[verdicts]\ndrawn = "d"\ndiffers = "f"\n"not reproduced" = "n"\n'
            f'[chapters]\n1 = "Chapter 1"\n[[row]]\n{row}\n', encoding="utf-8")
        (folder / "README.md").write_text(f"{thesis.BEGIN}\nold\n{thesis.END}\n", encoding="utf-8")
        self.assertEqual(thesis.main(self.tree), 1)
        self.assertEqual(thesis.main(self.tree, write=True), 0)
        self.assertEqual(thesis.main(self.tree), 0)


if __name__ == "__main__":
    unittest.main()
