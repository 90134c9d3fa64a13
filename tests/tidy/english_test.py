"""Tests that the checker of plain English finds each fault, and none where there is none."""

import unittest
from unittest import mock

import english


def faults(text, name="netlist/a.hpp"):
    return list(english.faults(name, text))


class Comments(unittest.TestCase):
    def test_a_first_sentence_needs_a_subject_and_a_verb(self):
        self.assertIn("netlist/a.hpp:2:", faults("int a;\n/// Of the part under way.\nint b;\n")[0])
        self.assertEqual(len(faults("/// The same, backwards.\n")), 1)
        self.assertEqual(len(faults("int b; ///< Those that wait.\n")), 1)
        self.assertEqual(faults("/// Returns the bytes\n/// Of the part.\n"), [])
        self.assertEqual(faults("// Offers a byte.\n"), [])

    def test_words_for_people(self):
        for word in ("nobody", "whoever", "somebody", "anybody", "everybody"):
            self.assertEqual(len(faults(f"// Returns 0 if {word} waits.\n")), 1)
        self.assertEqual(faults('say("nobody waits");\n'), [])

    def test_words_that_are_not_idiom(self):
        self.assertEqual(len(faults("// Refuses a text that is no number.\n")), 1)
        self.assertEqual(len(faults("// The link is told the speed.\n")), 1)
        self.assertEqual(faults("// Returns 0 if there is no row. It is no longer kept.\n"), [])

    def test_long_sentences(self):
        self.assertEqual(faults("// " + "word " * 40 + "\n"), [])
        self.assertEqual(len(faults("// " + "word " * 41 + "\n")), 1)
        self.assertEqual(faults("// " + "word " * 30 + "ends.\n// " + "word " * 30 + "\n"), [])


class Pages(unittest.TestCase):
    def test_long_lines_of_prose(self):
        long = "word " * 33
        self.assertEqual(len(faults(long, "docs/a.md")), 1)
        for exempt in ("| " + long, "```\n" + long + "\n```", "    " + long, "# " + long, "[a](b) " + long):
            self.assertEqual(faults(exempt, "docs/a.md"), [])


class Allowance(unittest.TestCase):
    TEXTS = {"app/a.cpp": "// Of one.\n// b\n\n// Of two.\n"}

    def test_a_room_may_have_as_many_faults_as_are_left_to_it(self):
        with mock.patch.dict(english.LEFT, {"app": 2}, clear=True):
            self.assertEqual(list(english.house_faults(self.TEXTS)), [])

    def test_more_are_refused_and_fewer_lower_the_number(self):
        with mock.patch.dict(english.LEFT, {"app": 1}, clear=True):
            self.assertIn("2 faults of English, more than 1", list(english.house_faults(self.TEXTS))[-1])
        with mock.patch.dict(english.LEFT, {"app": 3}, clear=True):
            self.assertIn("lower its number", list(english.house_faults(self.TEXTS))[0])


if __name__ == "__main__":
    unittest.main()
