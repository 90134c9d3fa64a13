"""Tests that each function named in the rooms' pages is in the file that the page gives for it."""

import pathlib
import re
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
NAMED = re.compile(r"`([A-Za-z_][\w:]*(?:\(\))?)` \(`([\w/]+\.[ch]pp)`\)")
# Text that may stand between the closing parenthesis of a function's definition and its body.
BEFORE_BODY = re.compile(r"\s*(const)?\s*(noexcept)?\s*(override)?\s*(try|:[^;]*)?\s*\{")


def named(page):
    """Yields (name, file, path as written) of each function or class that a page places in a file. Paths start at the
    top folder or at the page's room."""
    text = re.sub(r"\s+", " ", page.read_text(encoding="utf-8"))
    for name, path in NAMED.findall(text):
        yield name, next((folder / path for folder in (TOP, page.parent) if (folder / path).is_file()), None), path


def after_parentheses(text, start):
    """Returns the text after the parenthesis that closes the one just before `start`."""
    depth = 1
    while depth > 0 and start < len(text):
        depth += {"(": 1, ")": -1}.get(text[start], 0)
        start += 1
    return text[start:]


def has_class(text, name):
    return re.search(rf"^(template <.*>\s)?\s*(class|struct|enum class|concept) (\w+::)*{name}\b(?!;)", text, re.MULTILINE)


def defines(text, name):
    """Whether a source defines this function or class; a declaration or a call is not enough."""
    *scope, last = name.split("::")
    if not scope and has_class(text, name):
        return True
    inside = not scope or has_class(text, scope[-1])
    before = r"(^|[\s&*~]|\b\w+::)" if inside else rf"\b{scope[-1]}::"
    return any(BEFORE_BODY.match(after_parentheses(text, found.end()))
               for found in re.finditer(rf"{before}{re.escape(last)}\(", text, re.MULTILINE))


def misplaced(page):
    return [f"{page.relative_to(TOP)}: {name} in {path}" for name, file, path in named(page)
            if file is None or not defines(file.read_text(encoding="utf-8"), name)]


class Map(unittest.TestCase):
    def test_functions_are_where_the_map_says(self):
        pages = [TOP / "docs" / "reference" / "house.md", *TOP.glob("*/README.md")]
        self.assertEqual([fault for page in pages for fault in misplaced(page)], [])

    def test_a_definition_is_told_from_a_declaration_and_a_call(self):
        for text in ("int spin(int turn) {", "void Wheel::spin(double (*turn)(int))\n    const {", "class spin {",
                     "Wheel::spin(int turn)\n    : turn_(turn) {", "struct Wheel {\n    int spin() const { return 1; }\n};"):
            self.assertTrue(defines(text, "spin"), text)
        for text in ("int spin(int turn);", "    return spin(1);", "if (spin(1)) {", "for (int i : spin(2)) {", "class spin;",
                     "// spin", "int respin(int turn) {", "int spins = spin(1); {"):
            self.assertFalse(defines(text, "spin"), text)
        self.assertTrue(defines("int Wheel::spin() {", "Wheel::spin"))
        self.assertTrue(defines("Parents Wheel::operator()(int balls) const {", "Wheel::operator()"))
        self.assertFalse(defines("int Ball::spin() { return 1; } int a = Wheel::spin();", "Wheel::spin"))

    def test_the_map_has_its_walks(self):
        self.assertGreater(len(list(named(TOP / "docs" / "reference" / "house.md"))), 25)

    def test_every_room_is_on_the_map(self):
        text = (TOP / "docs" / "reference" / "house.md").read_text(encoding="utf-8")
        for room in TOP.glob("*/README.md"):
            if room.parent.name != "examples":
                self.assertIn(f"../../{room.parent.name}/README.md", text)


if __name__ == "__main__":
    unittest.main()
