"""Tests that the checker of the rules finds each fault, and none where there is none."""

import unittest

import functions
import tidy


def faults(name, text):
    return list(tidy.faults(name, text))


def measured(text):
    return [(function.first, function.lines) for function in functions.functions(text)]


class Functions(unittest.TestCase):
    def test_free_functions_members_and_templates(self):
        self.assertEqual(measured("int f() {\n}\n"), [(1, 2)])
        self.assertEqual(measured("namespace a {\nint f(int n)\n{\n    if (n) {\n    }\n}\n}\n"), [(2, 5)])
        self.assertEqual(measured("class A {\n    int f() const {\n    }\n};\n"), [(2, 2)])
        self.assertEqual(measured("template <class T>\nvoid f(T) {\n}\n"), [(1, 3)])

    def test_each_of_several(self):
        self.assertEqual(measured("int a = 1;\n\nint f() {\n}\n\nint g() {\n\n}\n"), [(3, 2), (6, 3)])

    def test_types_and_tables_are_no_functions(self):
        self.assertEqual(measured("struct A {\n    int n;\n};\nenum class B { c };\nint t[] = {\n1,\n2};\n"), [])
        self.assertEqual(measured("template <class T>\nstruct A {\n    int n;\n};\n"), [])

    def test_braces_in_text_do_not_count(self):
        self.assertEqual(measured("int f() {\n    // {\n    /* { */ g(\"{\", '{', R\"({)\", 1'000);\n}\n"), [(1, 4)])
        self.assertEqual(measured("#define A {\nint f() {\n}\n"), [(2, 2)])


class Faults(unittest.TestCase):
    def test_long_functions_and_files(self):
        self.assertEqual(faults("app/a.cpp", "int f() {\n" + "\n" * 48 + "}\n"), [])
        self.assertIn("51 lines", faults("app/a.cpp", "int f() {\n" + "\n" * 49 + "}\n")[0])
        self.assertEqual(faults("tests/app/a.cpp", "int f() {\n" + "\n" * 68 + "}\n"), [])
        self.assertIn("71 lines", faults("tests/app/a.cpp", "int f() {\n" + "\n" * 69 + "}\n")[0])
        self.assertEqual(faults("app/a.cpp", "\n" * 500), [])
        self.assertIn("501 lines", faults("app/a.cpp", "\n" * 501)[0])

    def test_unfinished_work(self):
        for word in ("TO" + "DO", "FIX" + "ME", "XX" + "X", "HA" + "CK"):
            self.assertEqual(len(faults("README.md", f"{word}: later\n")), 1)
        self.assertEqual(faults("README.md", "hacks and shacks\n"), [])

    def test_paths_of_a_machine(self):
        self.assertEqual(len(faults("README.md", "see " + "/wo" + "rk/main\n")), 1)
        self.assertEqual(len(faults("README.md", "see " + "/tm" + "p/x\n")), 1)
        self.assertEqual(faults("tests/a.sh", "ls " + "/tm" + "p/x\n"), [])
        self.assertEqual(faults("tests/app/a.cpp", '#include "app/work/root.hpp"\n'), [])

    def test_a_header_opens_no_namespace(self):
        opened = "using namespace hydraulics;\n"
        self.assertEqual(len(faults("app/a.hpp", opened)), 1)
        self.assertEqual(len(faults("app/a.hpp", "namespace a {\n    " + opened + "}\n")), 1)
        self.assertEqual(faults("app/a.cpp", opened), [])
        self.assertEqual(faults("app/a.hpp", "/// " + opened + "using hydraulics::Link;\n"), [])

    def test_arrows_and_folders(self):
        wrong = faults("gaprocs/a.hpp", '#pragma once\n#include "app/b.hpp"\n')
        self.assertEqual(wrong, ["gaprocs/a.hpp:2: gaprocs may not include app/b.hpp"])
        self.assertEqual(len(faults("gaprocs/unheard/a.hpp", "")), 1)
        self.assertEqual(faults("gaprocs/unheard/README.md", '#include "app/b.hpp"\n'), [])


if __name__ == "__main__":
    unittest.main()
