"""The map of the house and the pages of the rooms name functions with their files: each must be where they say."""

import pathlib
import re
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]
NAMED = re.compile(r"`([A-Za-z_][\w:]*)` \(`([\w/]+\.[ch]pp)`\)")


def named(page):
    """Pairs of a function or a class and the file that a page says it is in; paths are of the top, or of the page's room."""
    text = re.sub(r"\s+", " ", page.read_text(encoding="utf-8"))
    for name, path in NAMED.findall(text):
        yield name, next((folder / path for folder in (TOP, page.parent) if (folder / path).is_file()), None), path


def misplaced(page):
    return [f"{page.relative_to(TOP)}: {name} in {path}" for name, file, path in named(page)
            if file is None or not re.search(rf"\b{name.split('::')[-1]}\b", file.read_text(encoding="utf-8"))]


class Map(unittest.TestCase):
    def test_functions_are_where_the_map_says(self):
        pages = [TOP / "docs" / "house.md", *TOP.glob("*/README.md")]
        self.assertEqual([fault for page in pages for fault in misplaced(page)], [])

    def test_the_map_has_its_walks(self):
        self.assertGreater(len(list(named(TOP / "docs" / "house.md"))), 25)

    def test_every_room_is_on_the_map(self):
        text = (TOP / "docs" / "house.md").read_text(encoding="utf-8")
        for room in TOP.glob("*/README.md"):
            if room.parent.name != "examples":
                self.assertIn(f"../{room.parent.name}/README.md", text)


if __name__ == "__main__":
    unittest.main()
