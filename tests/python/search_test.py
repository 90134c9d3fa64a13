"""Tests searches from Python: results are those of the library, whatever computes the fitness and the policies."""

import math
import pathlib
import tempfile
import traceback
import unittest

import placedpar as pp

try:
    import numpy
except ImportError:
    numpy = None

BOX = [(-5.12, 5.12)] * 10


def sphere(rows):
    """Adds up the squares column by column, in the order of the library."""
    total = numpy.zeros(len(rows))
    for column in rows.T:
        total = total + column * column
    return total


@unittest.skipIf(numpy is None, "NumPy is not installed: searches need it")
class Searches(unittest.TestCase):
    def same(self, first, second):
        self.assertEqual((first.string, first.value, first.generation, first.island),
                         (second.string, second.value, second.generation, second.island))
        self.assertEqual(list(first.x), list(second.x))
        self.assertEqual(first._csv, second._csv)

    def test_fitness_in_python_gives_the_search_of_the_library(self):
        for settings in ({}, {"coding": "real", "elite": 2}, {"coding": "gray", "schedule": "sequential(2)"},
                         {"topology": "torus", "crossover": "two-point", "reproduction": "tournament(3)"},
                         {"emigration": "best(2)", "acceptance": "random", "mutation": "distance"}):
            for seed in (1, 2):
                common = {"islands": 4, "population": 20, "generations": 25, "seed": seed, **settings}
                self.same(pp.search(sphere, BOX, **common), pp.search("sphere(dimensions = 10, bits = 16)", **common))

    def test_a_policy_in_python_gives_the_search_of_the_library(self):
        def tournament(fitness, count, random):
            size = 2
            chosen = []
            for _ in range(count):
                best = random.below(len(fitness))
                for _ in range(size - 1):
                    other = random.below(len(fitness))
                    best = other if fitness[other] > fitness[best] else best
                chosen.append(best)
            return chosen

        def both(exchange, neighbours):
            return neighbours
        both.every = 3

        def best(fitness, random):
            return [int(numpy.argmax(fitness))]

        def worst(fitness, immigrants, random):
            order = numpy.argsort(fitness, kind="stable")
            return [int(i) for i in order[:len(immigrants)]]
        named = {"reproduction": "tournament(2)", "topology": "ring(2)", "schedule": "broadcast(3)",
                 "emigration": "best", "acceptance": "worst"}
        own = {"reproduction": tournament, "topology": lambda n: [[(i + 1) % n, (i - 1) % n] for i in range(n)],
               "schedule": both, "emigration": best, "acceptance": worst}
        common = {"islands": 4, "population": 20, "generations": 30, "coding": "real"}
        expected = pp.search(sphere, BOX, **common, **named)
        for step, policy in own.items():
            with self.subTest(step):
                self.same(pp.search(sphere, BOX, **common, **{**named, step: policy}), expected)

    def test_crossover_and_mutation_in_python_work_on_arrays(self):
        seen = set()

        def mean(a, b, random):
            seen.add((a.shape, a.dtype.kind))
            return (a + b) / 2, a

        def reset(x, place, random):
            x[place] = 0
            return x
        found = pp.search(sphere, BOX, coding="real", crossover=mean, mutation=reset, generations=60)
        self.assertEqual(seen, {((10,), "f")})
        self.assertLess(found.value, 1e-2)

    def test_bits_and_places_are_whole_numbers(self):
        kinds = set()

        def kept(x, place, random):
            kinds.add((x.dtype.kind, tuple(sorted(set(x.tolist())))))
            return x
        pp.search("one-max(bits = 8)", mutation=kept, mutation_probability=1, population=4, generations=2)
        self.assertLessEqual(kinds, {("i", (0,)), ("i", (1,)), ("i", (0, 1))})
        kinds.clear()
        pp.search("tour-circle(cities = 6)", mutation=kept, mutation_probability=1, population=4, generations=2)
        self.assertEqual(kinds, {("i", tuple(range(6)))})

    def test_what_a_policy_returns_must_be_a_string_of_the_kind(self):
        def search(problem, returned, **more):
            pp.search(problem, mutation=lambda x, place, random: returned(x), mutation_probability=1, generations=2,
                      population=4, **more)
        twice = "returned a permutation with 0, but must return each of the places 0 to 5 once"
        for problem, returned, said in (("tour-circle(cities = 6)", lambda x: x * 0, twice),
                                        ("tour-circle(cities = 6)", lambda x: x + 0.5, "a permutation with [0-9.]+, but must"),
                                        ("one-max(bits = 8)", lambda x: x + 2, "returned [23], but must return bits 0 and 1")):
            with self.subTest(said), self.assertRaisesRegex(pp.Error, said):
                search(problem, returned)
        with self.assertRaisesRegex(pp.Error, "returned nan, but must return numbers"):
            pp.search(sphere, BOX, coding="real", mutation=lambda x, place, random: x * math.nan, generations=2,
                      mutation_probability=1)

    def test_an_exception_of_a_policy_keeps_its_traceback(self):
        def wrong(x, place, random):
            return undefined_name
        with self.assertRaises(pp.Error) as raised:
            pp.search(sphere, BOX, mutation=wrong, mutation_probability=1, generations=2)
        lines = [frame.line for frame in traceback.extract_tb(raised.exception.__cause__.__traceback__)]
        self.assertIn("return undefined_name", lines)

    def test_numbers_of_numpy_are_numbers(self):
        found = pp.search(sphere, BOX, bits=numpy.int64(8), population=numpy.int32(10), generations=numpy.int64(3),
                          islands=numpy.int16(2), seed=numpy.uint8(3), mutation_probability=numpy.float32(0.5))
        self.assertEqual(len(found.string), 8 * len(BOX))

    def test_the_random_stream_of_a_policy_ends_with_its_call(self):
        kept = []

        def all_of_them(fitness, count, random):
            kept.append(random)
            return [random.below(len(fitness)) for _ in range(count)]
        pp.search(sphere, BOX, reproduction=all_of_them, generations=2)
        with self.assertRaisesRegex(pp.Error, "only during the call of the policy"):
            kept[0].below(5)

    def test_a_population_is_one_array(self):
        shapes = []
        pp.search(lambda rows: shapes.append(rows.shape) or rows.sum(axis=1), BOX, population=30, generations=3)
        self.assertEqual(shapes, [(30, 10)] * 3)

    def test_problems_of_pymoo_and_pygmo_are_taken_as_they_are(self):
        class Pymoo:
            n_obj, xl, xu = 1, numpy.array([-5.12] * 10), numpy.array([5.12] * 10)

            def _evaluate(self, x, out, *arguments, **more):
                out["F"] = sphere(x).reshape(-1, 1)

        class Pygmo:
            def fitness(self, x):
                return [sphere(x.reshape(1, -1))[0]]

            def get_bounds(self):
                return [-5.12] * 10, [5.12] * 10
        expected = pp.search(sphere, BOX, generations=10)
        self.same(pp.search(Pymoo(), generations=10), expected)
        self.same(pp.search(Pygmo(), generations=10), expected)
        Pymoo.n_obj = 2
        with self.assertRaisesRegex(pp.Error, "one objective"):
            pp.search(Pymoo())

    def test_maximising_is_minimising_the_negative(self):
        least = pp.search(sphere, BOX, generations=10)
        most = pp.search(lambda rows: -sphere(rows), BOX, generations=10, maximise=True)
        self.assertEqual(list(least.x), list(most.x))
        self.assertEqual(least.value, -most.value)

    def test_a_search_goes_on_from_a_checkpoint(self):
        whole = pp.search(sphere, BOX, islands=3, generations=40, seed=5)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "search.checkpoint")
            pp.search(sphere, BOX, islands=3, generations=25, seed=5, checkpoint=file)
            told = []
            second = pp.search(sphere, BOX, islands=3, generations=40, seed=5, checkpoint=file,
                               progress=lambda *made: told.append(made))
            with self.assertRaisesRegex(pp.Error, "the checkpoint has seed 5, but this run has 6"):
                pp.search(sphere, BOX, islands=3, generations=40, seed=6, checkpoint=file)
        self.assertEqual((second.value, second.string, second.generation), (whole.value, whole.string, whole.generation))
        self.assertEqual(int(second.log["generation"].min()), 21)
        self.assertEqual((len(told), told[-1]), (60, (120, 120)))

    def test_a_checkpoint_of_another_problem_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for first, *others in (
                    (["rastrigin(dimensions = 2)"], ["ackley(dimensions = 2)"], [sphere, [(0, 1)] * 2]),
                    ([sphere, [(0, 1)] * 2], [sphere, [(0, 2)] * 2], [sphere, [(0, 1)] * 2, {"maximise": True}])):
                file = pathlib.Path(folder, str(len(first)))
                pp.search(*first, generations=10, checkpoint=file)
                pp.search(*first, generations=12, checkpoint=file)
                for problem, *more in others:
                    options = more.pop() if len(more) == 2 else {}
                    with self.assertRaisesRegex(pp.Error, r"the checkpoint has .*problem = "):
                        pp.search(problem, *more, generations=20, checkpoint=file, **options)

    def test_a_front_is_searched(self):
        front = pp.search_front("zdt1(dimensions = 5)", generations=100, population=40, coding="real")
        self.assertEqual((front.names, front.evaluations, front.values.shape), (["f_1", "f_2"], 40 * 101, (40, 2)))
        self.assertLess(numpy.abs(front.values[:, 1] - (1 - numpy.sqrt(front.values[:, 0]))).max(), 0.1)
        self.assertEqual(front.x.shape, (40, 5))
        with self.assertRaisesRegex(pp.Error, "several objectives has no fitness"):
            pp.search("zdt1", generations=2)

    def test_bounds_may_be_an_array(self):
        self.same(pp.search(sphere, numpy.array(BOX), generations=5), pp.search(sphere, BOX, generations=5))

    def test_the_log_has_the_values_to_the_last_bit(self):
        for seed in range(11, 15):
            found = pp.search("rastrigin(dimensions = 5)", generations=30, population=30, elite=1, seed=seed)
            rows = found.log.to_dict("records") if hasattr(found.log, "columns") else found.log
            self.assertEqual([row["value"] for row in rows if row["quantity"] == "best_so_far"][-1], found.value)

    def test_progress_counts_the_generations_of_all_islands(self):
        told = []
        pp.search(sphere, BOX, islands=2, generations=5, population=10, progress=lambda *made: told.append(made))
        self.assertEqual(told, [(i + 1, 10) for i in range(10)])

    def test_errors_say_what_would_be_right(self):
        for message, arguments in (
                ("did you mean \"tournament\"", {"reproduction": "tournamnet"}),
                ("one objective, but the function returned 10 for each individual: use search_front", {"problem": lambda rows: rows}),
                ("there are 0 islands, expected at least 1", {"islands": 0}),
                ("bounds are for a function", {"problem": "sphere"}),
                ("maximise is for a function: the problem \"sphere\" states", {"problem": "sphere", "bounds": None, "maximise": True}),
                ("bits is for a function", {"problem": "sphere", "bounds": None, "bits": 5}),
                ("low", {"bounds": [(5, -5)]}), ("a torus of 4 islands cannot have 3 rows", {"topology": "torus(3)", "islands": 4}),
                ("must be numbers", {"problem": lambda rows: ["one"] * len(rows)}),
                ("but have the shape \\(60, 2\\)", {"problem": lambda rows: rows.reshape(-1)[:120].reshape(60, 2)}),
                ("reproduction: ZeroDivisionError", {"reproduction": lambda fitness, count, random: 1 / 0})):
            with self.assertRaises(pp.Error) as caught:
                pp.search(**{"problem": sphere, "bounds": BOX, **arguments})
            self.assertRegex(str(caught.exception), message)
        with self.assertRaises(ZeroDivisionError):
            pp.search(lambda rows: 1 / 0, BOX)

        def interrupts(fitness, count, random):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            pp.search(sphere, BOX, reproduction=interrupts)
        self.assertIn("value nan", repr(pp.search(lambda rows: numpy.full(len(rows), numpy.nan), BOX, generations=2)))
        with self.assertRaisesRegex(TypeError, "mutation is 0.05, expected the name of a policy or a function; "
                                               "mutation_probability sets how often it happens"):
            pp.search(sphere, BOX, mutation=0.05)
        with self.assertRaisesRegex(TypeError, "topology is 3, expected the name of a policy or a function$"):
            pp.search(sphere, BOX, topology=3)
        with self.assertRaisesRegex(TypeError, "needs bounds"):
            pp.search(sphere)
        for message, wrong in (("islands is 'x', expected a whole number", {"islands": "x"}),
                               ("bounds has \\(1, 2, 3\\), expected pairs", {"bounds": [(1, 2, 3)]}),
                               ("population is 1.5", {"population": 1.5}), ("coding is 5", {"coding": 5})):
            with self.assertRaisesRegex(TypeError, message):
                pp.search(sphere, **{"bounds": BOX, **wrong})


if __name__ == "__main__":
    unittest.main()
