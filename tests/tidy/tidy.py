#!/usr/bin/env python3
"""Checks the rules of the house that a program can check.

usage: tidy.py TREE

Sources have at most 500 lines, functions at most 50 in rooms and 70 elsewhere; nothing is left unfinished or names a
path of one machine. What includes what: walls.py. What is defined twice: definitions.py. Plain English: english.py.
Rooms as a whole: house.py. Studies that select tests: studies.py.
"""

import pathlib
import re
import sys

import definitions
import english
import functions
import house
import studies
import tree
import walls

FILE_LINES = 500
ROOM_FUNCTION_LINES = 50
FUNCTION_LINES = 70
# One function by nature: labels that lead to each other exist only within a function.
LONG_FUNCTIONS = ("PLACEDPAR_KEEPS_REGISTERS Core::Left Core::execute(HalfCycles until, bool at_once)",)
SOURCES = (".cpp", ".hpp", ".py", ".sh", ".cmake", ".cfs", ".inc", "CMakeLists.txt")

# The brackets keep this file from breaking its own rule.
UNFINISHED = re.compile(r"\b(TO[D]O|FIX[M]E|XX[X]|HA[C]K)\b")
MACHINE_PATH = re.compile(r"(?<![\w.}])/(?:work|root|home)/")
SCRATCH_PATH = re.compile(r"(?<![\w.}])/tmp/")

USING_NAMESPACE = re.compile(r"^\s*using\s+namespace\b")


def line_faults(name, number, line):
    """Returns the faults of one line of any file."""
    unfinished = UNFINISHED.search(line)
    if unfinished:
        yield f"{name}:{number}: {unfinished[0]}: finish it, or make it an issue"
    if MACHINE_PATH.search(line) or (SCRATCH_PATH.search(line) and not name.startswith("tests/")):
        yield f"{name}:{number}: a path of one machine: {line.strip()}"


def cpp_line_faults(name, text):
    """Returns faults of a C++ file's lines: includes, and namespaces opened in headers."""
    for number, line in enumerate(text.splitlines(), 1):
        for included in walls.includes(line):
            fault = walls.include_fault(name, included)
            if fault:
                yield f"{name}:{number}: {fault}"
        fault = walls.library_fault(name, line)
        if fault:
            yield f"{name}:{number}: {fault}"
    if name.endswith(".hpp"):
        for number, line in enumerate(functions.blank(text).splitlines(), 1):
            if USING_NAMESPACE.match(line):
                yield f"{name}:{number}: a header opens no namespace on those who include it"


def cpp_faults(name, text):
    """Returns the faults of a C++ file."""
    misplaced = walls.folder_fault(name)
    if misplaced:
        yield misplaced
    yield from cpp_line_faults(name, text)
    most = ROOM_FUNCTION_LINES if walls.room_of(name) else FUNCTION_LINES
    for function in functions.functions(text):
        if function.lines > most and function.head not in LONG_FUNCTIONS:
            yield f"{name}:{function.first}: {function.lines} lines, more than {most}: {function.head}"


def faults(name, text):
    """Returns the faults of a file, a sentence each."""
    lines = text.splitlines()
    if name.endswith(SOURCES) and len(lines) > FILE_LINES:
        yield f"{name}: {len(lines)} lines, more than {FILE_LINES}: one idea a file"
    for number, line in enumerate(lines, 1):
        yield from line_faults(name, number, line)
    if tree.is_cpp(name):
        yield from cpp_faults(name, text)


def read(top, names):
    """Yields name and text of each text file."""
    for name in names:
        try:
            yield name, (pathlib.Path(top) / name).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            pass  # a picture, or leftovers of a test


def main(top):
    names = tree.names(top)
    texts = dict(read(top, names))
    rooms = house.read(texts)
    found = [fault for name, text in texts.items() for fault in faults(name, text)]
    found += [*definitions.faults(texts), *english.house_faults(texts), *studies.faults(texts),
              *rooms.faults(names)]
    print("\n".join([rooms.line_of(room) for room in sorted(rooms.lines)] + found))
    print(f"{len(names)} files, {len(found)} faults")
    return 1 if found or not names else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
