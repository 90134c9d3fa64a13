"""Tests the rule for studies that select test cases."""

import unittest

import studies

CASES = 'TEST_CASE("All worlds are tried" * doctest::skip()) {\n}\nTEST_CASE("another of them") {\n}\n'


def faults(line, cases=CASES, folder="tests/a"):
    return list(studies.faults({"tests/a/CMakeLists.txt": line, f"{folder}/b/some_test.cpp": cases}))


class Studies(unittest.TestCase):
    def test_patterns_that_select_a_case(self):
        self.assertEqual(faults('COMMAND test_a --no-skip=true "--test-case=all worlds*,another*")'), [])
        self.assertEqual(faults("    --test-case=*of*them*)"), [])

    def test_a_pattern_that_selects_none(self):
        self.assertEqual(faults('COMMAND test_a "--test-case=all worlds*,a thousand*")'),
                         ['tests/a/CMakeLists.txt: no test case has a name like "a thousand*"'])

    def test_cases_of_another_folder(self):
        self.assertEqual(len(faults('COMMAND test_a "--test-case=all worlds*")', folder="tests/b")), 1)


if __name__ == "__main__":
    unittest.main()
