"""Tests that types defined in two rooms are found, and no others."""

import unittest

import definitions


def header(name, more=""):
    return (f"namespace placedpar{more} {{\n\nstruct {name} {{\n    struct Inner {{}};\n}};\n\n"
            f"}} // namespace placedpar{more}\n")


class Definitions(unittest.TestCase):
    def test_two_of_one_name(self):
        found = list(definitions.faults({"app/a.hpp": header("Study"), "explore/b.cpp": header("Study")}))
        self.assertEqual(found, ["explore/b.cpp: placedpar::Study is defined in app/a.hpp, too: "
                                 "another name for one of them"])

    def test_other_names_namespaces_and_what_is_hidden(self):
        for other in (header("Sweep"), header("Study", "::monitor"),
                      "namespace placedpar {\nnamespace {\nclass Study final : Base {\n};\n} // namespace\n"
                      "} // namespace placedpar\n",
                      "namespace placedpar {\nstruct Study;\n} // namespace placedpar\n"):
            self.assertEqual(list(definitions.faults({"app/a.hpp": header("Study"), "explore/b.cpp": other})), [])
        self.assertEqual(list(definitions.faults({"app/a.hpp": header("Study"), "tests/b.cpp": header("Study")})), [])


if __name__ == "__main__":
    unittest.main()
