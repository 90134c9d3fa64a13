"""Tests that each wall holds, and that no wall is too wide."""

import unittest

import walls


def may_include(folder, other):
    return walls.include_fault(f"{folder}/a.cpp", f"{other}/b.hpp") is None


class Arrows(unittest.TestCase):
    def test_between_rooms(self):
        for folder, other in [("hydraulics/data", "text"), ("netlist", "runtime/hardware"), ("netlist/print", "text"),
                              ("gaprocs/processes", "netlist"), ("identification", "hydraulics/data"),
                              ("monitor/service", "identification"), ("report", "runtime"), ("explore", "identification"),
                              ("app/commands", "runtime"),
                              ("experiments/chapter_3", "explore"), ("app/commands", "hydraulics/circuit")]:
            self.assertTrue(may_include(folder, other), (folder, other))
        for folder, other in [("text", "runtime"), ("runtime", "netlist"), ("netlist", "gaprocs"),
                              ("hydraulics/plant", "runtime"), ("hydraulics/circuit", "gaprocs"),
                              ("gaprocs/processes", "hydraulics/data"),
                              ("identification", "monitor/protocol"), ("monitor/service", "report"), ("picture", "gaprocs"), ("report", "identification"),
                              ("report", "observe/trace"), ("observe/page", "explore"), ("identification", "identification/report"),
                              ("explore", "monitor/service"), ("explore", "experiments/kit"),
                              ("experiments/kit", "app"), ("app", "bench"), ("runtime", "tests/runtime")]:
            self.assertFalse(may_include(folder, other), (folder, other))

    def test_inside_rooms(self):
        for upper, lower in [("runtime/hardware", "runtime"), ("netlist/elaborate", "netlist/language"),
                             ("netlist", "netlist/complete"), ("gaprocs/processes", "gaprocs"),
                             ("hydraulics/plant", "hydraulics/circuit"), ("hydraulics/circuit", "hydraulics/data"),
                             ("identification/on_line", "identification"), ("monitor/memory", "monitor/protocol"),
                             ("monitor/service", "monitor/memory"), ("experiments/chapter_2", "experiments/kit"),
                             ("experiments/chapter_3", "experiments/chapter_3/kit"), ("app/commands", "app/options")]:
            self.assertTrue(may_include(upper, lower), (upper, lower))
            self.assertTrue(may_include(upper, upper), upper)
            self.assertFalse(may_include(lower, upper), (lower, upper))

    def test_what_stands_side_by_side(self):
        for folder, other in [("experiments/chapter_2", "experiments/chapter_3"), ("netlist/print", "netlist/complete"),
                              ("experiments/appendix_e", "experiments/chapter_2")]:
            self.assertFalse(may_include(folder, other))
            self.assertFalse(may_include(other, folder))

    def test_tests_and_benchmarks_may_include_everything(self):
        for folder in ("tests/runtime", "bench", "bench/identification"):
            self.assertTrue(may_include(folder, "app"))

    def test_includes_begin_at_the_top(self):
        self.assertIsNotNone(walls.include_fault("runtime/a.cpp", "b.hpp"))
        self.assertIsNotNone(walls.include_fault("runtime/a.cpp", "../app/b.hpp"))

    def test_which_includes_are_ours(self):
        text = '#include "a.hpp"\n  #  include <runtime/b.hpp>\n#include <boost/c.hpp>\n// "d"\n'
        self.assertEqual(walls.includes(text), ["a.hpp", "runtime/b.hpp"])

    def test_the_table_has_no_circle(self):
        self.assertEqual(walls.circle(walls.BELOW), [])


class Folders(unittest.TestCase):
    def test_known_ones(self):
        for name in ("app/a.cpp", "runtime/hardware/a.hpp", "bench/a.cpp", "bench/identification/a.cpp",
                     "tests/main.cpp", "tests/netlist/a.cpp", "tests/hydraulics/a.cpp", "tests/netlist/print/a.cpp",
                     "tests/consumer/installed/a.cpp"):
            self.assertIsNone(walls.folder_fault(name), name)

    def test_unknown_ones(self):
        for name in ("a.cpp", "attic/a.cpp", "runtime/attic/a.cpp", "hydraulics/a.cpp", "tests/attic/a.cpp",
                     "tests/runtime/attic/a.cpp", "netlist/print/attic/a.hpp"):
            self.assertIsNotNone(walls.folder_fault(name), name)


class Pieces(unittest.TestCase):
    def test_a_header_and_its_source_are_one(self):
        self.assertEqual(walls.pieces({"a/b.hpp": {"a/c.hpp"}, "a/b.cpp": {"a/b.hpp", "d/e.hpp"}}),
                         {"a/b": {"a/c", "d/e"}})

    def test_so_is_a_knot(self):
        kernel, process, trace = "runtime/kernel.cpp", "runtime/process.hpp", "runtime/trace.hpp"
        self.assertEqual(walls.pieces({kernel: {process}, process: {"runtime/time.hpp"}, trace: set()}),
                         {"runtime/executive": {"runtime/time"}})

    def test_a_knot_does_not_hide_a_circle_through_others(self):
        around = walls.pieces({"runtime/kernel.cpp": {"runtime/event.hpp"}, "runtime/event.cpp": {"runtime/process.hpp"}})
        self.assertEqual(walls.circle(around), ["runtime/event", "runtime/executive", "runtime/event"])


class LooseEnds(unittest.TestCase):
    KNOTS = ({"a/b", "a/c"},)

    def test_none_while_both_include_each_other(self):
        self.assertEqual(walls.loose_ends({"a/b.cpp": {"a/c.hpp"}, "a/c.cpp": {"a/b.hpp"}}, self.KNOTS), [])

    def test_none_through_a_third(self):
        around = {"a/b.cpp": {"a/d.hpp"}, "a/d.hpp": {"a/c.hpp"}, "a/c.cpp": {"a/b.hpp"}}
        self.assertEqual(walls.loose_ends(around, self.KNOTS), [])

    def test_one_that_includes_the_other_no_more(self):
        self.assertEqual(walls.loose_ends({"a/b.cpp": {"a/c.hpp"}, "a/c.cpp": set()}, self.KNOTS), ["a/c"])


class Chains(unittest.TestCase):
    def test_the_longest(self):
        self.assertEqual(walls.longest_chain({}), ())
        self.assertEqual(walls.longest_chain({"a": ["d", "b"], "b": ["c", "d"], "c": ["d"], "e": ["a"]}), tuple("eabcd"))


class Libraries(unittest.TestCase):
    def test_large_ones_are_no_header_s(self):
        for name, library, is_wrong in [("app/a.hpp", "fmt/format.h", True), ("app/a.hpp", "boost/json.hpp", True),
                                        ("app/a.cpp", "fmt/format.h", False), ("app/a.hpp", "boost/json/fwd.hpp", False),
                                        ("tests/app/a.hpp", "fmt/format.h", False), ("report/field.hpp", "boost/json.hpp", False),
                                        ("report/field.hpp", "fmt/format.h", True), ("app/a.hpp", "boost/json/value.hpp", True),
                                        ("text/a.hpp", "Eigen/Core", True), ("app/commands/a.cpp", "CLI/CLI.hpp", True),
                                        ("app/options.cpp", "CLI/CLI.hpp", False), ("bench/a.cpp", "CLI/CLI.hpp", False)]:
            fault = walls.library_fault(name, f"#include <{library}>")
            self.assertEqual(fault is not None, is_wrong, (name, library))


class Circles(unittest.TestCase):
    def test_none(self):
        self.assertEqual(walls.circle({}), [])
        self.assertEqual(walls.circle({"a": ["b", "c"], "b": ["d"], "c": ["d"]}), [])

    def test_found(self):
        self.assertEqual(walls.circle({"a": ["a"]}), ["a", "a"])
        self.assertEqual(walls.circle({"a": ["b"], "b": ["c", "d"], "d": ["b"]}), ["b", "d", "b"])


if __name__ == "__main__":
    unittest.main()
