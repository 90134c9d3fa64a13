"""Tests the rules for the whole project."""

import unittest

import house

NAMES = ("app", "explore", "gaprocs", "netlist", "report", "text")
SIX_ROOMS = {f"{room}/a.cpp": "int a;\n" * 50 for room in NAMES}
READMES = [f"{room}/README.md" for room in NAMES]


def faults(texts, names=()):
    return list(house.read(SIX_ROOMS | texts).faults([*READMES, *names]))


def functions_of(*lengths):
    return "".join("int f() {" + "\n" * (lines - 1) + "}\n" for lines in lengths)


class Rooms(unittest.TestCase):
    def test_six_equal_ones(self):
        self.assertEqual(faults({}), [])

    def test_a_large_one(self):
        wrong = faults({"app/b.cpp": "int b;\n" * 3})
        self.assertEqual(wrong, ["app: 17.5 % of the code, more than 17 %"])
        self.assertEqual(faults({"tests/app/b.cpp": "int b;\n", "bench/b.cpp": "int b;\n", "app/b.md": "b\n"}), [])

    def test_one_without_a_readme(self):
        room = {"runtime/a.cpp": "int a;\n"}
        self.assertIn("runtime: there is no README.md", faults(room)[0])
        self.assertEqual(faults(room, ["runtime/README.md"]), [])


class Functions(unittest.TestCase):
    def faults_of(self, *lengths):
        texts = {f"{room}/a.cpp": "int a;\n" * 1000 for room in (*NAMES, "runtime")}
        others = {"text/b.cpp": "int a;\n" * 800, "runtime/b.cpp": functions_of(*[1] * 100)}
        return faults(texts | others | {"text/a.cpp": functions_of(*lengths)}, ["runtime/README.md"])

    def test_half_of_them(self):
        self.assertEqual(self.faults_of(7, 7, 8, 8), [])
        self.assertEqual(self.faults_of(7, 8, 8), ["text: 50 % of the functions have up to 8 lines, more than 7"])

    def test_nine_of_ten(self):
        self.assertEqual(self.faults_of(*[1] * 8, 17, 30), [])
        self.assertEqual(self.faults_of(*[1] * 8, 18, 18),
                         ["text: 90 % of the functions have up to 18 lines, more than 17"])

    def test_all_rooms_together(self):
        texts = {f"{room}/b.cpp": functions_of(7, 7) for room in NAMES}
        self.assertEqual(faults(texts), ["all rooms: 50 % of the functions have up to 7 lines, more than 6"])

    def test_nearest_rank(self):
        self.assertEqual([house.nearest_rank([3, 1, 2, 4], percent) for percent in (1, 25, 50, 75, 90, 100)],
                         [1, 1, 2, 3, 4, 4])


class Files(unittest.TestCase):
    def test_a_circle(self):
        wrong = faults({"app/b.hpp": '#include "app/c.hpp"', "app/c.hpp": '#include "app/b.hpp"'})
        self.assertIn("files include each other in a circle: app/b.hpp -> app/c.hpp -> app/b.hpp", wrong)

    def test_a_circle_of_headers_with_their_sources(self):
        wrong = faults({"app/b.hpp": "", "app/b.cpp": '#include "app/b.hpp"\n#include "app/c.hpp"',
                        "app/c.hpp": '#include "app/b.hpp"'})
        self.assertIn("files include each other in a circle: app/b -> app/c -> app/b", wrong)


    def test_a_long_chain_of_headers(self):
        names = [f"tests/app/{n:02}.hpp" for n in range(13)]
        chain = {name: f'#include "{included}"' for name, included in zip(names, names[1:])}
        self.assertEqual(faults(chain | {"tests/app/a.cpp": f'#include "{names[0]}"'}), [])
        self.assertEqual(faults(chain | {names[-1]: ""}),
                         ["13 headers in a chain, more than 12: " + " > ".join(names)])


class Report(unittest.TestCase):
    def test_a_line_a_room(self):
        text = house.read({"text/a.cpp": functions_of(2, 4, 40)}).line_of("text")
        self.assertEqual(text.split(), "text 46 lines 100.0 % functions: p50 4, p90 40, longest 40".split())


if __name__ == "__main__":
    unittest.main()
