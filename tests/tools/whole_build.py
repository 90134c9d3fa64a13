#!/usr/bin/env python3
"""Makes one piece of each sort in a copy of the tree, builds of it what they touch, and runs the tests of that.

usage: whole_build.py

It takes half an hour of one processor, less where a compiler cache has the rest of the house.
"""

import pathlib
import sys
import tempfile

from beside_build import run
from copied_tree import MADE, copy_tree, make_all

ROOMS = ("runtime", "netlist", "classics", "problems", "experiments")


def main():
    with tempfile.TemporaryDirectory() as folder:
        top, build = copy_tree(folder), pathlib.Path(folder) / "build"
        make_all(top)
        run(["cmake", "--preset", "release", "-B", build], cwd=top)
        run(["cmake", "--build", build, "--target", "placedpar", *(f"test_{room}" for room in ROOMS)])
        pages = "|".join(MADE.values())
        tests = f"^({'|'.join(ROOMS)})$|^documents/examples/[0-9]+-({pages})/|^app/({pages.replace('-', '_')}|kinds)$|^tidy"
        print(run(["ctest", "--test-dir", build, "--output-on-failure", "-R", tests]))


if __name__ == "__main__":
    if len(sys.argv) != 1:
        sys.exit(__doc__)
    sys.exit(main())
