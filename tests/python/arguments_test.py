"""Tests that no public function answers wrong arguments by a list of signatures in C++."""

import inspect
import unittest

import placedpar as pp

WRONG = ((), (1,), (1,) * 40)


def callables():
    """Yields the name of each public function and class of the package, and of their public methods."""
    for name, thing in vars(pp).items():
        if name.startswith("_") or inspect.ismodule(thing) or not callable(thing):
            continue
        yield name, thing
        for method, function in vars(thing).items() if isinstance(thing, type) else ():
            if not method.startswith("_") and callable(function):
                yield f"{name}.{method}", function


class Arguments(unittest.TestCase):
    def refused(self, function, *arguments, **named):
        with self.assertRaises(TypeError) as caught:
            function(*arguments, **named)
        self.assertNotRegex(str(caught.exception), "incompatible|supported|arg0|self: ")
        return str(caught.exception)

    def test_too_many_arguments_and_unknown_names_are_refused_in_plain_words(self):
        names = []
        for name, function in callables():
            if inspect.isclass(function) and issubclass(function, BaseException):
                continue
            with self.subTest(name):
                names.append(name)
                takes_all = name in ("alt", "par", "load", "Monitor", "RandomStream.uniform")
                self.refused(function, no_such_name=1) if name not in ("sweep", "identify", "Monitor") else None
                if not takes_all:
                    self.refused(function, *(1,) * 40)
        self.assertGreater(len(names), 30)

    def test_functions_of_the_module_say_what_they_take(self):
        random = pp.RandomStream(1, "stream")
        packet = pp.Packet()
        for usage, function, arguments in (
                ("after(ticks)", pp.after, ()), ("stop()", pp.stop, (1,)), ("skip()", pp.skip, (1,)),
                ("never()", pp.never, (1,)), ("Packet(number=0, bytes=4)", pp.Packet, (1, 2, 3)),
                ("RandomStream(seed, name)", pp.RandomStream, ()), ("uniform()", random.uniform, (1,)),
                ("below(n)", random.below, ()), ("normal()", random.normal, (1,)),
                ("chance(probability)", random.chance, ())):
            self.assertIn(f"expected {usage}", self.refused(function, *arguments))
        self.assertIn("expected alt(*guards)", self.refused(pp.alt, guard=1))
        self.assertIn("expected par(*components)", self.refused(pp.par, component=1))
        self.assertIn("number is 'x', expected a whole number", self.refused(setattr, packet, "number", "x"))
        packet.bytes = 7
        self.assertEqual((packet.number, packet.bytes), (0, 7))

    def test_arguments_of_wrong_types_are_named(self):
        network = "T800 a; process p; use \"csp.producer\" for p; place p on a;"
        self.assertIn("faults is", self.refused(pp.load, network, faults=[5]))
        for function in (pp.sweep, pp.explain):
            self.assertIn('expected a network, such as pp.load("ring.cfs"), not 5', self.refused(function, 5))
        self.assertIn("use is", self.refused(pp.load, network, use={"p": 5}))
        self.assertIn("settings is", self.refused(pp.load, network, settings={5: 1}))
        self.assertIn("bits is", self.refused(pp.search, lambda rows: rows, bounds=[(0, 1)], bits=[1.5]))


if __name__ == "__main__":
    unittest.main()
