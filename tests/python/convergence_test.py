"""Tests plots of searches over their generations."""

import re
import shutil
import unittest
import xml.etree.ElementTree

import placedpar as pp
from placedpar.convergence import _curve

try:
    import numpy
except ImportError:
    numpy = None


def searches(seeds=3, **settings):
    return [pp.search("sphere(dimensions = 4)", generations=12, population=10, seed=seed, **settings)
            for seed in range(1, seeds + 1)]


@unittest.skipIf(numpy is None or not shutil.which("gnuplot"), "NumPy or gnuplot is not installed")
class Convergence(unittest.TestCase):
    def test_a_curve_is_the_best_value_so_far_of_all_islands(self):
        for settings in ({}, {"islands": 3}):
            found = searches(**settings)
            name, first, runs = _curve("setting", found)
            self.assertEqual((name, first, [len(run) for run in runs]), ("setting", 1, [12] * 3))
            for each, run in zip(found, runs):
                self.assertEqual((run, run[-1]), (sorted(run, reverse=True), each.value))
                self.assertEqual(run[each.generation - 1], each.value)

    def test_a_plot_has_a_curve_and_a_band_for_each_setting(self):
        one, many = searches(), searches(5, islands=2)
        plot = pp.convergence({"one": one, "two islands": many}).text
        xml.etree.ElementTree.fromstring(plot)
        for text in (">one<", ">two islands<", "medians and quartiles of 3 or 5 searches", "generation"):
            self.assertIn(text, plot)

        def shapes(drawing):
            return len(re.findall("<polygon fill", drawing.text))
        alone = shapes(pp.convergence(one[0]))  # a single search has no quartiles
        self.assertEqual(shapes(pp.convergence(one)), alone + 1)
        self.assertEqual(shapes(pp.convergence({"one": one, "two": many})), alone + 2)
        self.assertIn(">mine<", pp.convergence(one, title="mine", logarithmic=True).text)

    def test_errors_say_what_would_be_right(self):
        for wrong in ([], {"nothing": []}, [5], {"five": 5}):
            with self.assertRaises((TypeError, pp.Error)) as caught:
                pp.convergence(wrong)
            self.assertIn("expected", str(caught.exception))
        never = pp.search(lambda rows: numpy.full(len(rows), numpy.nan), [(0, 1)], generations=3)
        with self.assertRaisesRegex(pp.Error, "nothing to draw: no value is a finite number"):
            pp.convergence(never)


if __name__ == "__main__":
    unittest.main()
