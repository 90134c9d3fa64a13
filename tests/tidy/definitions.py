"""Checks that each type of a namespace is defined once: if two have the same name, the linker may mix their members."""

import re

import walls

# clang-format does not indent namespaces, and marks their closing braces.
OPENED = re.compile(r"namespace(?: ([\w:]+))? \{$")
CLOSED = re.compile(r"\} // (?:anonymous )?namespace")
TYPE = re.compile(r"(?:struct|class|enum class) (\w+)(?: final)?(?: :[^;]*)? \{")


def types(text):
    """Returns the qualified names of types defined at the top of named namespaces."""
    namespaces = []
    for line in text.splitlines():
        opened, defined = OPENED.match(line), TYPE.match(line)
        if opened:
            namespaces.append(opened[1])
        elif CLOSED.match(line):
            namespaces.pop()
        elif defined and None not in namespaces:
            yield "::".join([*namespaces, defined[1]])


def faults(texts):
    """Returns the types that the rooms define twice."""
    files = {}
    for name, text in texts.items():
        if walls.room_of(name) and name.endswith((".cpp", ".hpp")):
            for each in types(text):
                files.setdefault(each, []).append(name)
    for each, where in sorted(files.items()):
        if len(where) > 1:
            yield f"{where[-1]}: {each} is defined in {where[0]}, too: another name for one of them"
