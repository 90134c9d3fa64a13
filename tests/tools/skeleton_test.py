"""Tests that pieces made by the tools keep the rules, compile and pass their tests, and that their pages are true."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from beside_build import BesideBuild, run
from copied_tree import MADE, copy_tree, make_all

ROOMS = ["classics", "experiments", "explore", "netlist", "problems", "runtime"]
TESTED = ["classics", "netlist", "problems", "runtime"]


class Made(unittest.TestCase):
    """A copy of the tree with the four pieces."""

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

    def test_the_rules_of_the_house_hold(self):
        self.succeeds("tests/tidy/tidy.py", ".")
        self.assertIn(self.python("tests/tidy/format.py", ".").returncode, (0, 77))  # 77: without clang-format
        self.succeeds("tests/docs/figures.py", ".")
        self.succeeds("tests/docs/map_test.py")
        self.succeeds("tests/docs/tables_test.py")

    def test_it_compiles_and_passes_its_tests(self):
        build = BesideBuild(self.top, self.programs)
        rooms, tests = self.sources()
        self.assertEqual((sorted(rooms), sorted(tests)), (ROOMS, TESTED))
        rooms["experiments"].append(build.list_experiments())
        objects = [build.compile(sources, f"placedpar_{room}") for room, sources in rooms.items()]
        of_tests = [build.compile(sources, f"test_{room}") for room, sources in tests.items()]
        said = run([build.link("test", [*of_tests, *objects], "tests/libplacedpar_test_main.a", main=False)])
        self.assertRegex(said, r"test cases: +14 \| +14 passed \| 0 failed")
        self.run_program(build.link("placedpar", objects))

    def run_program(self, program):
        """Checks the examples' pages and the command line's tests with a program that knows the four pieces."""
        environment = {"PLACEDPAR": str(program), "PLACEDPAR_EXAMPLES": str(self.top / "examples")}
        pages = [name for name in self.changed if name.startswith("examples/") and name.count("/") == 3 and name.endswith("README.md")]
        self.assertEqual(len(pages), len(MADE))
        for page in pages:
            done = self.succeeds("tests/docs/document.py", ".", self.programs, page, **environment)
            self.assertRegex(done.stdout, r"[12] commands, 0 failures")
        for script in ("tests/app/one_way_test.py", "tests/app/kinds_test.py"):
            self.succeeds(script, **environment)
        experiments = run([program, "replay", "--help"], env={**os.environ, **environment})
        self.assertLess(experiments.index("one-way"), experiments.index("evidence"))

    def sources(self):
        """Returns the new and changed sources of rooms, and those of tests: each {room: [paths]}."""
        rooms, tests = {}, {}
        for name in self.changed:
            if name.endswith(".cpp"):
                first, _, rest = name.partition("/")
                found, room = (tests, rest.split("/")[0]) if first == "tests" else (rooms, first)
                found.setdefault(room, []).append(self.top / name)
        rooms["netlist"].append(self.top / "netlist/kinds/catalogue.cpp")  # it iterates over the list in devices.hpp
        return rooms, tests


if __name__ == "__main__":
    unittest.main()
