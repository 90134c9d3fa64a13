"""A type of a namespace is defined once: of two with one name the linker takes either's members for both."""

import re

import walls

# As clang-format writes them: a namespace is not indented, and what closes it says so.
OPENED = re.compile(r"namespace(?: ([\w:]+))? \{$")
CLOSED = re.compile(r"\} // (?:anonymous )?namespace")
TYPE = re.compile(r"(?:struct|class|enum class) (\w+)(?: final)?(?: :[^;]*)? \{")


def types(text):
    """Those defined at the top of namespaces that have a name, qualified."""
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
    """What is defined twice in the rooms."""
    files = {}
    for name, text in texts.items():
        if walls.room_of(name) and name.endswith((".cpp", ".hpp")):
            for each in types(text):
                files.setdefault(each, []).append(name)
    for each, where in sorted(files.items()):
        if len(where) > 1:
            yield f"{where[-1]}: {each} is defined in {where[0]}, too: another name for one of them"
