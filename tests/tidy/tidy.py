#!/usr/bin/env python3
"""Checks the rules of the house that a program can check.

usage: tidy.py TREE

Sources have at most 500 lines, functions at most 70; nothing is left unfinished or names a path of somebody's machine;
a room includes only itself and the rooms that it may know.
"""

import pathlib
import re
import sys

import functions
import tree

FILE_LINES = 500
FUNCTION_LINES = 70
SOURCES = (".cpp", ".hpp", ".py", ".sh", ".cmake", ".cfs", ".inc", "CMakeLists.txt")

# Written so that this file does not break its own rules.
UNFINISHED = re.compile(r"\b(TO[D]O|FIX[M]E|XX[X]|HA[C]K)\b")
MACHINE_PATH = re.compile(r"(?<![\w.}])/(?:work|root|home)/")
SCRATCH_PATH = re.compile(r"(?<![\w.}])/tmp/")

ROOMS = {"runtime", "netlist", "gaprocs", "hydraulics", "app", "bench", "tests"}
MAY_INCLUDE = {
    "runtime": {"runtime"},
    "netlist": {"netlist", "runtime"},
    "gaprocs": {"gaprocs", "netlist", "runtime"},
    "hydraulics": {"hydraulics"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](\w+)/')


def line_faults(name, number, line):
    """What is wrong with one line of any file."""
    unfinished = UNFINISHED.search(line)
    if unfinished:
        yield f"{name}:{number}: {unfinished[0]}: finish it, or make it an issue"
    if MACHINE_PATH.search(line) or (SCRATCH_PATH.search(line) and not name.startswith("tests/")):
        yield f"{name}:{number}: a path of one machine: {line.strip()}"


def include_faults(name, number, line):
    """Whether the line includes a room that this one may not know."""
    room = name.split("/")[0]
    included = INCLUDE.match(line)
    if included and included[1] in ROOMS - MAY_INCLUDE.get(room, ROOMS):
        yield f"{name}:{number}: {room} may not include {included[1]}"


def faults(name, text):
    """What is wrong with a file, a sentence each."""
    lines = text.splitlines()
    if name.endswith(SOURCES) and len(lines) > FILE_LINES:
        yield f"{name}: {len(lines)} lines, more than {FILE_LINES}: one idea a file"
    for number, line in enumerate(lines, 1):
        yield from line_faults(name, number, line)
        if tree.is_cpp(name):
            yield from include_faults(name, number, line)
    if tree.is_cpp(name):
        for function in functions.functions(text):
            if function.lines > FUNCTION_LINES:
                yield f"{name}:{function.first}: {function.lines} lines, more than {FUNCTION_LINES}: {function.head}"


def main(top):
    found = []
    names = tree.names(top)
    for name in names:
        try:
            text = (pathlib.Path(top) / name).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # a picture, or the rubbish of a test
        found += faults(name, text)
    print("\n".join(found + [f"{len(names)} files, {len(found)} faults"]))
    return 1 if found or not names else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
