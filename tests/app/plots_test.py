"""Tests the plots of the experiments: well-formed, complete, and identical each time."""

import os
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree

from program import placedpar

# Required texts of legends and titles.
PLOTS = {
    "table-2-6": {"table-2-6": ["2030 psi", "1830 psi", "1630 psi", "thesis, 2030 psi", "thesis, 1830 psi",
                                "thesis, 1630 psi", "40 in³/s", "50 in³/s", "60 in³/s", "+20 %", "+50 %"]},
    "figure-2-3": {"figure-2-3": ["no air", "0.1 % air", "1 % air", "2 % air", "5 % air", "10 % air",
                                  "an order of magnitude"]},
    "figures-2-8-2-9": {"figures-2-8-2-9": ["Figure 2.8: compliance C", "Figure 2.9: compliance 4 C", "C", "4 C",
                                            "desired"],
                        "pole-loci": ["real pole ← to -49", "pair", "at C", "at 4 C", "at 6 C", "at 7 C", "limit of stability"]},
    "schemata": {"schemata": ["rates .8 and .01", "no crossover", "reproduction alone", "the bound"]},
    "circuits": {"figure-2-10": ["in b, d", "in c, e"],
                 "figure-2-11": ["configuration e: bucket, boom, stick, swing", "configuration b: bucket", "shut", "a_iSW"],
                 "figure-b-1": ["bucket", "boom", "C_BUi", "C_BOi", "a_eBU", "a_eBO", "tank", "Q"],
                 "figure-a-1": ["boom", "C_BOi", "a_iBO", "a_eBO", "tank", "Q"]},
    "hypercube": {"figure-6-1": ["F 10", "maximum among its neighbours"],
                  "figure-6-1-line": ["F(x)", "maximum among two neighbours"],
                  "figure-6-5": ["impulse at 1011", "share of right bits"],
                  "figure-6-2": ["12", "1100", "5", "0101", "15", "1111"],
                  "figure-6-3": ["0 new of 0", "2 new of 2", "4 new of 6", "6 new of 14", "possible offspring"]},
}

# Drawings without curves.
DRAWINGS = {"figure-2-10", "figure-2-11", "figure-a-1", "figure-b-1", "figure-6-1", "figure-6-2", "figure-6-3"}


def texts(svg):
    """Returns the texts of a well-formed SVG."""
    root = xml.etree.ElementTree.fromstring(svg)
    return {" ".join("".join(element.itertext()).split())
            for element in root.iter("{http://www.w3.org/2000/svg}text")}


class Plots(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_every_series_is_there_and_two_runs_give_equal_bytes(self):
        for experiment, plots in PLOTS.items():
            first, second = self.folder / "first" / experiment, self.folder / "second" / experiment
            run = placedpar("replay", experiment, "--plots", first)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            placedpar("replay", experiment, "--plots", second)
            curves = [f"{name}.csv" for name in plots if name not in DRAWINGS]
            self.assertEqual(sorted(os.listdir(first)), sorted([*curves, *(f"{name}.svg" for name in plots)]))
            for name in curves:
                self.assertTrue((first / name).read_text(encoding="utf-8").startswith("panel,curve,x axis,x,y axis,y\n"))
                self.assertEqual((first / name).read_bytes(), (second / name).read_bytes())
            for name, names in plots.items():
                svg = (first / f"{name}.svg").read_bytes()
                self.assertIn(f"plot: {first / name}.svg\n", run.stdout)
                self.assertLessEqual(set(names), texts(svg))
                self.assertEqual(svg, (second / f"{name}.svg").read_bytes())

    def test_an_experiment_without_plots_says_so(self):
        run = placedpar("replay", "table-e1", "--plots", self.folder)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("no plots", run.stdout)
        self.assertEqual(os.listdir(self.folder), [])

    def test_without_gnuplot_it_says_what_to_install_and_runs_nothing(self):
        run = placedpar("replay", "figure-2-3", "--plots", self.folder / "new", environment={"PATH": str(self.folder)})
        self.assertEqual(run.returncode, 1)
        self.assertIn("gnuplot-nox", run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_folder_that_cannot_be_is_refused_before_the_run(self):
        (self.folder / "file").write_text("kept", encoding="utf-8")
        run = placedpar("replay", "figure-2-3", "--plots", self.folder / "file")
        self.assertEqual(run.returncode, 1)
        self.assertIn(str(self.folder / "file"), run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertEqual((self.folder / "file").read_text(encoding="utf-8"), "kept")

    def test_a_gnuplot_that_fails_leaves_no_file(self):
        broken = self.folder / "bin" / "gnuplot"
        broken.parent.mkdir()
        broken.write_text("#!/bin/sh\necho half a picture\necho no more ink >&2\nexit 1\n", encoding="utf-8")
        broken.chmod(0o755)
        run = placedpar("replay", "figure-2-3", "--plots", self.folder / "out", environment={"PATH": str(broken.parent)})
        self.assertEqual(run.returncode, 1)
        self.assertIn("no more ink", run.stderr)
        self.assertEqual(os.listdir(self.folder / "out"), [])

    def test_the_users_settings_of_gnuplot_are_not_read(self):
        (self.folder / ".gnuplot").write_text("set title 'mine'\nset terminal dumb\nexit\n", encoding="utf-8")
        run = placedpar("replay", "figure-2-3", "--plots", self.folder / "out",
                        environment={"HOME": str(self.folder), "GNUTERM": "dumb"})
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("no air", texts((self.folder / "out" / "figure-2-3.svg").read_bytes()))


if __name__ == "__main__":
    unittest.main()
