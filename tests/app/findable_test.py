"""Tests that a user who typed something near finds what was meant, and what placedpar doctor says."""

import pathlib
import tempfile
import unittest

from program import EXAMPLES, FIGURE_E2, placedpar



class Suggestions(unittest.TestCase):
    def refused(self, *arguments):
        done = placedpar(*arguments)
        self.assertEqual((done.returncode, done.stdout), (1, ""), arguments)
        return done.stderr

    def test_experiments_by_figure_and_subject(self):
        self.assertIn('did you mean "figures-4-6-4-7"?', self.refused("replay", "figure-4-6"))
        self.assertIn('did you mean "figures-4-6-4-7", or "table-e2"?', self.refused("replay", "speedup"))
        self.assertIn('did you mean "pga-2"?', self.refused("replay", "figure-5-4"))
        self.assertIn('did you mean "table-e1"?', self.refused("replay", "tabel-e1"))

    def test_commands_by_what_they_do(self):
        self.assertIn('did you mean "run", or "record"?', self.refused("simulate", "x.cfs"))
        self.assertIn('did you mean "optimise"?', self.refused("optimize", "x.cfs"))
        self.assertIn("--help lists the commands", self.refused("frobnicate"))

    def test_values_of_a_netlist_typed_in_another_way(self):
        self.assertIn("leave it out: settings are arguments, such as slaves=0..7",
                      self.refused("sweep", FIGURE_E2, "--set", "slaves=1"))
        self.assertIn("set without an option: slaves=VALUE", self.refused("sweep", FIGURE_E2, "--slaves", "1"))
        self.assertIn("set by --set slaves=3", self.refused("run", FIGURE_E2, "slaves=3"))
        self.assertIn("set by --set slaves=VALUE", self.refused("run", FIGURE_E2, "--slaves", "3"))
        self.assertNotIn("--set", self.refused("run", FIGURE_E2, "other.cfs"))

    def test_several_values_name_the_sweep(self):
        for values in ("1,2", "0..3"):
            self.assertIn(f"hint: --set takes one value; to try several: placedpar sweep FILE slaves={values}\n",
                          self.refused("run", FIGURE_E2, "--set", f"slaves={values}"))
        self.assertIn("placedpar sweep FILE master[0].population=20,40\n",
                      self.refused("run", FIGURE_E2, "--set", "master[0].population=20,40"))
        self.assertNotIn("sweep", self.refused("run", FIGURE_E2, "--set", "slaves=x"))

    def test_what_is_not_a_name_of_an_option(self):
        for option in ("---", "--=3", "-5"):
            refused = self.refused("run", FIGURE_E2, option)
            self.assertNotIn("defect", refused)
            self.assertNotIn("--set", refused)

    def test_problems_by_their_parameters(self):
        self.assertIn('did you mean "dimensions"', self.refused("kinds", "rastrigin(dimension = 10)"))

    def test_topologies(self):
        self.assertIn('unknown topology "tours"; did you mean "torus"?',
                      self.refused("generate", "tours", "--size", "4x4"))


class FigureE2(unittest.TestCase):
    def test_the_machine_is_counted_and_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            done = placedpar("replay", "figure-e2", "--plots", folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            for row, number in (("transputers", 16), ("islands", 4), ("slaves of an island", 3),
                                ("links from a master to its slaves", 1)):
                self.assertRegex(done.stdout, rf"(?m)^{row} +{number} +{number} ")
            for name in ("figure-e2", "figure-4-2"):
                drawn = (pathlib.Path(folder) / f"{name}.svg").read_bytes()
                self.assertEqual(drawn, (FIGURE_E2.parent / f"{name}.svg").read_bytes())


class Doctor(unittest.TestCase):
    def test_versions_and_parts(self):
        done = placedpar("doctor")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        first, built, *_ = done.stdout.splitlines()
        self.assertEqual(first + "\n", placedpar("--version").stdout)
        self.assertRegex(built, r"^built with \S+ [0-9.]+ \(\w+\): Boost 1\.\d+\S*, Eigen 3\S+, fmt \S+, CLI11 \S+, "
                                r"SQLite 3\S+, toml\+\+ 3\S+, zlib 1\S+, expat 2\S+$")
        self.assertIn(f" {EXAMPLES}\n", done.stdout)
        self.assertRegex(done.stdout, r"(?m)^gnuplot .* gnuplot \d")
        self.assertRegex(done.stdout, r"(?m)^seccomp filters +serve and mark +yes$")

    def test_what_is_missing_is_named_with_its_package(self):
        with tempfile.TemporaryDirectory() as folder:
            done = placedpar("doctor", environment={"PATH": folder})
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"(?m)^gnuplot +plots of \S.* missing: apt-get install gnuplot-nox$")
        self.assertRegex(done.stdout, r"(?m)^mpirun .* missing: apt-get install openmpi-bin$")


if __name__ == "__main__":
    unittest.main()
