"""Tests fronts and constraints of functions in Python, and of problem objects as pymoo and pygmo have them."""

import os
import pathlib
import signal
import tempfile
import threading
import traceback
import unittest

import placedpar as pp

try:
    import numpy
except ImportError:
    numpy = None

SRN_BOX = [(-20, 20)] * 2


def zdt1(rows):
    """Adds up column by column, as the library does."""
    total = numpy.zeros(len(rows))
    for column in rows.T[1:]:
        total = total + column
    g = 1 + 9 * total / (rows.shape[1] - 1)
    return numpy.column_stack([rows[:, 0], g * (1 - numpy.sqrt(rows[:, 0] / g))])


def g06(rows):
    x, y = rows.T
    u, v = x - 10, y - 20
    return u * u * u + v * v * v, numpy.column_stack([100 - (x - 5) * (x - 5) - (y - 5) * (y - 5),
                                                      (x - 6) * (x - 6) + (y - 5) * (y - 5) - 82.81])


def srn(rows):
    """The problem of N. Srinivas and K. Deb, "Multiobjective optimization using nondominated sorting in genetic
    algorithms", 1994. Its front is x = -2.5, y from 2.5 to 14.79 (K. Deb, "Multi-Objective Optimization using
    Evolutionary Algorithms", 2001, section 8.3)."""
    x, y = rows.T
    return (numpy.column_stack([2 + (x - 2)**2 + (y - 1)**2, 9 * x - (y - 1)**2]),
            numpy.column_stack([x**2 + y**2 - 225, x - 3 * y + 10]))


class Pymoo:
    """SRN as pymoo has it, a population or, if `elementwise`, an individual at a time."""
    n_var, n_obj, n_ieq_constr, xl, xu = 2, 2, 2, -20, 20

    def __init__(self, elementwise):
        self.elementwise = elementwise

    def _evaluate(self, x, out, *arguments, **more):
        values, constraints = srn(numpy.atleast_2d(x))
        out["F"], out["G"] = (values[0], list(constraints[0])) if self.elementwise else (values, constraints)


class Pygmo:
    """SRN as pygmo has it."""

    def fitness(self, x):
        values, constraints = srn(x.reshape(1, -1))
        return [*values[0], *constraints[0]]

    def get_bounds(self):
        return [-20, -20], [20, 20]

    def get_nobj(self):
        return 2

    def get_nic(self):
        return 2


@unittest.skipIf(numpy is None, "NumPy is not installed: searches need it")
class Fronts(unittest.TestCase):
    def same(self, first, second):
        numpy.testing.assert_array_equal(first.x, second.x)
        numpy.testing.assert_array_equal(first.values, second.values)
        self.assertEqual((first.names, first.least_violation, first.evaluations),
                         (second.names, second.least_violation, second.evaluations))

    def test_objectives_in_python_give_the_front_of_the_library(self):
        for coding in ("natural", "gray(dont_care = 1)", "real"):
            for seed in (1, 2):
                common = {"generations": 25, "population": 20, "coding": coding, "seed": seed}
                self.same(pp.search_front(zdt1, [(0, 1)] * 6, bits=12, **common),
                          pp.search_front("zdt1(dimensions = 6, bits = 12)", **common))

    def test_constraints_in_python_give_the_search_of_the_library(self):
        box = [(13, 100), (0, 100)]
        for settings in ({"coding": "real", "elite": 1}, {"islands": 3}, {"coding": "gray(dont_care = 1)"}):
            for seed in (1, 2):
                common = {"generations": 40, "population": 30, "seed": seed, **settings}
                own, named = pp.search(g06, box, bits=30, **common), pp.search("g06", **common)
                self.assertEqual((own.string, own._csv, own.violation), (named.string, named._csv, named.violation))
                self.assertEqual(own.violation, max(0, g06(own.x.reshape(1, -1))[1].clip(min=0).sum()))
        self.same(pp.search_front(g06, box, bits=30, generations=20), pp.search_front("g06", generations=20))

    def test_strings_without_parameters_are_texts(self):
        for problem, letters in (("tour-circle(cities = 6)", " 012345"), ("one-max(bits = 8)", "01")):
            front = pp.search_front(problem, generations=2, population=4)
            self.assertEqual(front.x.shape, (len(front.values), 0))
            self.assertEqual(len(front.strings), len(front.values))
            self.assertEqual(set("".join(front.strings)) - set(letters), set())

    def test_the_front_of_a_problem_with_constraints_is_the_known_one(self):
        front = pp.search_front(srn, SRN_BOX, coding="real", population=60, generations=120)
        y = front.x[:, 1]
        self.assertEqual((len(y), front.least_violation), (60, 0))
        above = front.values.sum(axis=1) + 0.25  # (x + 2.5)^2, by the objectives
        self.assertTrue((above >= -1e-9).all())
        self.assertLess(numpy.median(above), 0.5)
        self.assertLess(numpy.abs(y - numpy.linspace(2.5, 14.79, 30).reshape(-1, 1)).min(axis=1).max(), 0.8)
        numpy.testing.assert_array_equal(front.values, srn(front.x)[0])
        self.assertTrue((srn(front.x)[1] <= 0).all())
        self.assertEqual([len(each.split()) for each in front.strings], [2] * 60)  # real numbers
        self.assertGreater(pp.search_front(lambda rows: srn(rows)[0], SRN_BOX, coding="real").x[:, 1].max(), 19)

    def test_problem_objects_give_the_front_of_their_function(self):
        settings = {"coding": "real", "population": 20, "generations": 10}
        expected = pp.search_front(srn, SRN_BOX, **settings)
        for problem in (Pymoo(True), Pymoo(False), Pygmo()):
            self.same(pp.search_front(problem, **settings), expected)
            with self.assertRaisesRegex(pp.Error, r"this problem has 2: use search_front"):
                pp.search(problem)

    def test_equations_of_problem_objects_have_a_tolerance(self):
        class OnLine(Pymoo):
            n_obj, n_ieq_constr, n_eq_constr = 1, 0, 1

            def _evaluate(self, x, out, *arguments, **more):
                out["F"], out["H"] = x[:, 0]**2, x[:, 0] - x[:, 1]

        class OnLineToo(Pygmo):
            def fitness(self, x):
                return [x[0]**2, x[0] - x[1]]

            def get_nobj(self):
                return 1

            def get_nec(self):
                return 1

            def get_nic(self):
                return 0

        settings = {"generations": 3, "population": 10}
        first, second = (pp.search(problem, **settings) for problem in (OnLine(False), OnLineToo()))
        self.assertEqual((first.string, first.violation), (second.string, second.violation))
        self.assertAlmostEqual(first.violation, max(0, abs(first.x[0] - first.x[1]) - 1e-4), 12)
        OnLineToo.get_nec = lambda problem: 2
        with self.assertRaisesRegex(pp.Error, r"returned 2 numbers, but get_nobj, get_nec and get_nic say 1 \+ 2 \+ 0"):
            pp.search(OnLineToo())

    def test_individuals_without_usable_objectives_are_not_in_the_front(self):
        def partly(rows):
            return numpy.where(rows[:, :1] > 0, srn(rows)[0], numpy.nan)
        self.assertTrue((pp.search_front(partly, SRN_BOX, generations=20).x[:, 0] > 0).all())
        none = pp.search_front(lambda rows: srn(rows)[0] * numpy.nan, SRN_BOX, generations=3)
        self.assertEqual((none.x.shape, none.values.shape, none.least_violation), ((0, 2), (0, 2), numpy.inf))
        best = pp.search(lambda rows: (rows[:, 0], rows[:, 0] + 30), SRN_BOX, generations=30)
        self.assertTrue(numpy.isnan(best.value))
        self.assertAlmostEqual(best.violation, best.x[0] + 30)

    def test_a_front_of_maxima_is_that_of_the_negative_minima(self):
        least = pp.search_front(zdt1, [(0, 1)] * 3, generations=10)
        most = pp.search_front(lambda rows: -zdt1(rows), [(0, 1)] * 3, generations=10, maximise=True)
        numpy.testing.assert_array_equal(least.x, most.x)
        numpy.testing.assert_array_equal(least.values, -most.values)

    def test_a_front_search_goes_on_from_a_checkpoint_and_tells_its_progress(self):
        told = []
        whole = pp.search_front(zdt1, [(0, 1)] * 4, generations=30, population=20)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "front.checkpoint")
            pp.search_front(zdt1, [(0, 1)] * 4, generations=25, population=20, checkpoint=file)
            second = pp.search_front(zdt1, [(0, 1)] * 4, generations=30, population=20, checkpoint=file,
                                     progress=lambda *made: told.append(made))
            with self.assertRaisesRegex(pp.Error, "population = 20, but this run has 30"):
                pp.search_front(zdt1, [(0, 1)] * 4, generations=30, population=30, checkpoint=file)
        numpy.testing.assert_array_equal(second.x, whole.x)
        self.assertEqual(told, [(generation, 30) for generation in range(21, 31)])
        self.assertEqual(second.evaluations, 20 * (10 + 1))

    def test_errors_say_what_would_be_right(self):
        calls = []

        def changes(rows):
            calls.append(1)
            return zdt1(rows) if len(calls) < 3 else zdt1(rows)[:, 0]
        for message, function in (
                (r"population of shape \(200, 2\) must have the shape \(200,\) or \(200, k\), but have the shape \(2, 200\)",
                 lambda rows: rows.T),
                (r"the constraints of .* have the shape \(3,\)", lambda rows: (rows, [1, 2, 3])),
                (r"have the shape \(200, 0\)", lambda rows: rows[:, :0]),
                (r"have the shape \(\)", lambda rows: 5),
                ("a tuple of length 3, expected an array of objectives, or a tuple", lambda rows: (rows, rows, rows)),
                ("the objectives must be numbers", lambda rows: ["one"] * len(rows)),
                ("1 objectives and 0 constraints for each individual, but 2 and 0 in its first call", changes)):
            with self.assertRaisesRegex(pp.Error, message):
                pp.search_front(function, SRN_BOX, generations=5)
        for message, settings in (("population is 'x', expected a whole number", {"population": "x"}),
                                  ("bits is .*, expected a list in which each element", {"bits": [1.5, 2]}),
                                  ("maximise is 'x', expected True or False", {"maximise": "x"})):
            with self.assertRaisesRegex(TypeError, message):
                pp.search_front(zdt1, SRN_BOX, **settings)
        with self.assertRaisesRegex(TypeError, "not 5"):
            pp.search_front(5)
        for population in (0, 1):
            with self.assertRaisesRegex(pp.Error, f"a population of {population}, expected at least 2"):
                pp.search_front(zdt1, SRN_BOX, population=population)

    def test_an_exception_of_the_function_keeps_its_traceback(self):
        def divides(rows):
            return 1 / 0
        try:
            pp.search_front(divides, SRN_BOX)
            self.fail("no exception")
        except ZeroDivisionError as error:
            self.assertEqual(traceback.extract_tb(error.__traceback__)[-1].name, "divides")

    def test_ctrl_c_ends_a_search_of_a_named_problem_and_of_a_function(self):
        for problem, box in (("zdt1", None), (zdt1, [(0, 1)] * 2)):
            threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaises(KeyboardInterrupt):
                pp.search_front(problem, box, generations=10**6)


if __name__ == "__main__":
    unittest.main()
