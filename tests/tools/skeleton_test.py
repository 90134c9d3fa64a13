"""What the tools write keeps to the rules of the house, compiles, and passes its tests; its pages say what happens."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from beside_build import BesideBuild, run
from copied_tree import MADE, copy_tree, make_all


class Made(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.top = copy_tree(folder.name)
        cls.changed = make_all(cls.top)
        cls.programs = pathlib.Path(folder.name) / "programs"
        cls.programs.mkdir()

    def python(self, *arguments, **environment):
        return subprocess.run([sys.executable, *map(str, arguments)], cwd=self.top, capture_output=True, text=True, check=False,
                              env={**os.environ, **environment})

    def succeeds(self, *arguments, **environment):
        done = self.python(*arguments, **environment)
        self.assertEqual(done.returncode, 0, f"{arguments}\n{done.stdout}{done.stderr}")
        return done

    def test_1_it_keeps_to_the_rules_of_the_house(self):
        self.succeeds("tests/tidy/tidy.py", ".")
        self.assertIn(self.python("tests/tidy/format.py", ".").returncode, (0, 77))  # 77: without clang-format
        self.succeeds("tests/docs/figures.py", ".")
        self.succeeds("tests/docs/map_test.py")
        self.succeeds("tests/docs/tables_test.py")

    def test_2_it_compiles_and_passes_its_tests(self):
        build = BesideBuild(self.top, self.programs)
        rooms, tests = self.sources()
        self.assertEqual(sorted(rooms), ["classics", "experiments", "explore", "netlist", "problems", "runtime"])
        self.assertEqual(sorted(tests), ["classics", "netlist", "problems", "runtime"])
        rooms["experiments"].append(build.list_experiments())
        objects = [build.compile(sources, f"placedpar_{room}") for room, sources in rooms.items()]
        of_tests = [build.compile(sources, f"test_{room}") for room, sources in tests.items()]
        build.link("placedpar", objects)
        said = run([build.link("test", [*of_tests, *objects], "tests/libplacedpar_test_main.a", main=False)])
        self.assertRegex(said, r"test cases: +1[0-9] \| +1[0-9] passed \| 0 failed")

    def test_3_its_pages_and_the_program_s_tests_hold(self):
        environment = {"PLACEDPAR": str(self.programs / "placedpar"), "PLACEDPAR_EXAMPLES": str(self.top / "examples")}
        pages = [name for name in self.changed if name.startswith("examples/") and name.endswith("README.md")]
        self.assertEqual(len(pages), len(MADE))
        for page in pages:
            done = self.succeeds("tests/docs/document.py", ".", self.programs, page, **environment)
            self.assertRegex(done.stdout, r"[12] commands, 0 failures")
        script = next(name for name in self.changed if name.startswith("tests/app/"))
        self.succeeds(script, **environment)
        self.succeeds("tests/app/kinds_test.py", **environment)

    def sources(self):
        """The new and changed sources of rooms and those of tests: {room: [paths]} of each."""
        rooms, tests = {}, {}
        for name in self.changed:
            if name.endswith(".cpp"):
                first, _, rest = name.partition("/")
                found, room = (tests, rest.split("/")[0]) if first == "tests" else (rooms, first)
                found.setdefault(room, []).append(self.top / name)
        return rooms, tests


if __name__ == "__main__":
    unittest.main()
