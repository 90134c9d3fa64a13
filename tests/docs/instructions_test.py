"""Tests that docs/reference/transputer.md has every instruction of the program's table, with its code, cycles and types."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/reference/transputer.md"
TABLE = ROOT / "runtime/transputer/instructions.inc"
ENTRY = re.compile(r"^(FUNCTION|OPERATION|REAL|RESULT|SELECTED|SCHEDULING|COMMUNICATING)\(0x(\w+), (\w+), (.*)", re.MULTILINE)
TYPES = {"all_models": "", "with_reals": "T800, T805", "without_reals": "T414, T425, T400", "second_generation": "not T414",
         "with_breakpoints & without_reals": "T425, T400",
         "with_breakpoints": "T425, T400, T805"}


def numbers(text):
    return sorted(map(int, re.findall(r"\b\d+\b", text)))


def known(text):
    """Returns {name: row} of the program's table; a row has what the page says of an instruction."""
    found = {}
    for macro, code, name, rest in ENTRY.findall(text):
        cycles, *others = [word.strip(" )") for word in rest.split(",")]
        models = {"OPERATION": others[2:3], "SCHEDULING": others[:1], "COMMUNICATING": others[:1]}.get(macro, ["all_models"])[0]
        varies = macro in ("FUNCTION", "OPERATION") and others[0] != "0" and name != "fpentry"
        found[name.rstrip("_")] = {"code": int(code, 16), "cycles": numbers(cycles), "types": TYPES[models], "varies": varies,
                                   "macro": macro}
    return found


def shown(text):
    """Returns {name: cells by header} of the page's tables of instructions."""
    found, header = {}, []
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not cells:
            header = []
        elif not header:
            header = cells
        elif header[:3] in (["code", "name", "cycles"], ["selector", "name", "cycles"]) and not cells[0].startswith("-"):
            name = cells[1].strip("`")
            assert name not in found, f"{name} is shown twice"
            found[name] = dict(zip(header, cells))
    return found


def faults(table, page):
    """Returns what is wrong in the page's tables."""
    program, document = known(table), shown(page)
    wrong = [f"{name}: only one of table and page has it" for name in program.keys() ^ document.keys()]
    for name in program.keys() & document.keys():
        row, cells = program[name], document[name]
        base = re.match(r"\(?(\d+(?:, \d+)*)(.*)", cells["cycles"])
        expected = {"code": f"{row['code']:X}" if row["macro"] == "FUNCTION" else f"{row['code']:02X}",
                    "types": row["types"], "waits": "yes" if row["macro"] == "RESULT" else ""}
        wrong += [f"{name}: {key} is {cells[key]}, not {value}" for key, value in expected.items() if key in cells and cells[key] != value]
        if base is None or numbers(base[1]) != row["cycles"]:
            wrong.append(f"{name}: cycles are {cells['cycles']}, not {row['cycles']}")
        elif row["varies"] and not base[2]:
            wrong.append(f"{name}: the page does not say that its cycles vary")
        if ("selector" in cells) != (row["macro"] == "SELECTED"):
            wrong.append(f"{name}: it is in the wrong table")
        elif cells.get("selector", expected["code"]) != expected["code"]:
            wrong.append(f"{name}: the selector is {cells['selector']}, not {expected['code']}")
    return wrong


class Instructions(unittest.TestCase):
    def test_the_page_has_the_table_of_the_program(self):
        table, page = TABLE.read_text(encoding="utf-8"), PAGE.read_text(encoding="utf-8")
        self.assertGreater(len(known(table)), 150)
        self.assertEqual(faults(table, page), [])

    def test_every_difference_is_found(self):
        table, page = TABLE.read_text(encoding="utf-8"), PAGE.read_text(encoding="utf-8")
        for old, new in (("| 05 | `add` | 1 |", "| 05 | `add` | 2 |"), ("| 05 | `add` | 1 |", "| 06 | `add` | 1 |"),
                         ("| 8C | `fpdiv` | 16, 31 |", "| 8C | `fpdiv` | 16 |"), ("| 5A | `dup` | 1 | not T414 |", "| 5A | `dup` | 1 | |"),
                         ("| A | `cj` | 2; 4 if it jumps |", "| A | `cj` | 2 |"), ("| 94 | `fpgt` | 4 | yes |", "| 94 | `fpgt` | 4 | |"),
                         ("| 22 | `fpurn` |", "| 23 | `fpurn` |"), ("`seterr`", "`setterr`")):
            with self.subTest(old):
                self.assertIn(old, page)
                self.assertNotEqual(faults(table, page.replace(old, new)), [])


if __name__ == "__main__":
    unittest.main()
