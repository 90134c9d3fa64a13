"""Tests placedpar check --format json: the same errors as in the text, with the end of each place."""

import json
import pathlib
import re
import tempfile
import unittest

from program import EXAMPLES, placedpar

TESTS = pathlib.Path(__file__).parents[1]


def checked(file, *options):
    """Returns the exit code, and what the program says as JSON."""
    done = placedpar("check", file, "--format", "json", *options)
    assert done.stderr == "", done.stderr
    return done.returncode, json.loads(done.stdout)


def heading(at):
    line = f":{at['line']}:{at['column']}" if "line" in at else ""
    return f"{at['file']}{line}: " if "file" in at else ""


def as_text(said):
    """Returns the diagnostics as the text form has them, without the lines of the source."""
    lines = []
    for each in said["diagnostics"]:
        lines.append(f"{heading(each)}{each['severity']}: {each['message']}")
        lines += [f"hint: {each['hint']}"] if each["hint"] else []
        lines += [f"{heading(other)}note: {other['message']}" for other in each["also"]]
    return lines + ([said["not_shown"]] if said["not_shown"] else [])


class CheckJson(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def test_a_good_file_has_a_summary(self):
        for file, language in ((EXAMPLES / "thesis/figure-e2/figure-e2.cfs", "netlist"),
                               (EXAMPLES / "thesis/table-e1/table-e1.toml", "study"),
                               (next((EXAMPLES / "occam").rglob("*.occ"), EXAMPLES / "occam"), "occam")):
            code, said = checked(file)
            self.assertEqual((code, said["valid"], said["diagnostics"], said["language"]), (0, True, [], language), said)
            self.assertEqual(placedpar("check", file).stdout, said["summary"] + "\n")

    def test_a_netlist(self):
        path = self.file("a.cfs", 'T800 (memory = 1M) t, /* \u00e9 */ tt, t;\nprocess p;\nuse "csp.identity" for quux;\n')
        code, said = checked(path)
        self.assertEqual((code, said["valid"], said["summary"]), (1, False, ""))
        name = str(path)
        self.assertEqual(said["diagnostics"], [
            {"severity": "error", "file": name, "line": 1, "column": 36, "end_line": 1, "end_column": 37,
             "message": "the name \"t\" is declared twice", "hint": "",
             "also": [{"file": name, "line": 1, "column": 20, "end_line": 1, "end_column": 21,
                       "message": "first declared here, as a node"}]},
            {"severity": "error", "file": name, "line": 3, "column": 24, "end_line": 3, "end_column": 28,
             "message": "the name \"quux\" is undefined", "hint": "", "also": []}])

    def test_occam(self):
        path = self.file("a.occ", "PROC p ()\n  INT x:\n  x := long.name\n:\n")
        code, said = checked(path)
        self.assertEqual(code, 1)
        self.assertEqual([(d["line"], d["column"], d["end_column"]) for d in said["diagnostics"]], [(3, 8, 17)])
        path = self.file("a.occ", "PROC p ()\n  INT x:\n  SKIP\n:\n")
        code, said = checked(path)
        self.assertEqual((code, said["valid"]), (0, True))
        self.assertEqual([d["severity"] for d in said["diagnostics"]], ["warning"])

    def test_a_configuration(self):
        path = self.file("a.pgm", "NODE n:\nNETWORK\n  DO\n    SET m (type, memsize := \"T800\", 1024)\n:\n")
        code, said = checked(path)
        self.assertEqual(code, 1)
        self.assertEqual([(d.get("line"), d.get("column")) for d in said["diagnostics"]], [(None, None), (4, 9)])

    def test_a_study_and_its_netlist(self):
        self.file("ring.cfs", (EXAMPLES / "csp/commstime/commstime.cfs").read_text())
        code, said = checked(self.file("a.toml", 'netlist = "ring.cfs"\n[set]\ncount = [10, 20]\n'))
        self.assertEqual((code, said["diagnostics"]), (0, []), said)
        self.assertIn("2 runs", said["summary"])
        code, said = checked(self.file("a.toml", 'netlist = "ring.cfs"\nsets = 3\n[set]\ncount = []\n'))
        places = sorted((d["line"], d["column"], d["end_column"]) for d in said["diagnostics"])
        self.assertEqual(places, [(2, 1, 5), (4, 9, 10)])
        code, said = checked(self.file("a.toml", 'netlist = "ring.cfs"\n[set]\nno_such_setting = 3\n'))
        self.assertEqual(code, 1)
        self.assertIn("no_such_setting", json.dumps(said["diagnostics"]))

    def test_a_study_whose_netlist_is_missing(self):
        study = self.file("a.toml", 'netlist = "missing.cfs"\n')
        code, said = checked(study)
        self.assertEqual(code, 1)
        self.assertEqual([(d["file"], d["message"]) for d in said["diagnostics"]],
                         [(str(study), f"{self.folder}/missing.cfs: this file does not exist")])

    def test_a_file_as_a_whole(self):
        code, said = checked(self.folder / "missing.cfs")
        self.assertEqual(code, 1)
        self.assertEqual(said["diagnostics"], [{"severity": "error", "file": str(self.folder / "missing.cfs"),
                                                "message": "this file does not exist", "hint": "", "also": []}])
        code, said = checked(self.file("empty.cfs", ""))
        self.assertEqual((code, said["diagnostics"][0]["message"]), (1, "the netlist is empty"))

    def test_every_refusal_is_the_same_in_both_forms(self):
        files = sorted((TESTS / "netlist/refusals").rglob("*.cfs"))
        self.assertGreater(len(files), 100)
        for file in files[::5]:
            with self.subTest(file.name):
                text = placedpar("check", file)
                code, said = checked(file)
                self.assertEqual(code, text.returncode)
                shown = [line for line in text.stderr.splitlines() if not re.match(r"^    ", line)]
                self.assertEqual(shown, as_text(said))


if __name__ == "__main__":
    unittest.main()
