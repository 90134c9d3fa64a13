"""Finds the functions of a C++ file by its braces, to measure them. This is not a parser."""

import dataclasses
import re

# Matches comments, raw strings, strings, characters and directives; the order matters. A quote after a digit or letter
# separates digits.
OPAQUE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z])\'(?:\\.|[^\'\\\n])+\''
    r"|^[ \t]*#(?:\\\n|[^\n])*", re.DOTALL | re.MULTILINE)
TEMPLATE = re.compile(r"^\s*template\s*<")
TYPE_OR_NAMESPACE = re.compile(
    r"^\s*(?:(?:inline|static|constexpr|const|typedef|friend)\s+)*(?:namespace|class|struct|union|enum|extern\s*$)\b")


@dataclasses.dataclass
class Function:
    head: str
    first: int
    lines: int


def blank(text):
    """Returns the text with everything opaque replaced by blanks, lines kept."""
    return OPAQUE.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def without_template(head):
    """Returns the head of a definition without a leading template <...>, whose `class` would mislead."""
    while TEMPLATE.match(head):
        depth, position = 0, head.index("<")
        for position in range(position, len(head)):
            depth += {"<": 1, ">": -1}.get(head[position], 0)
            if depth == 0:
                break
        head = head[position + 1:]
    return head


def is_function(head):
    head = without_template(head)
    return "(" in head and not TYPE_OR_NAMESPACE.match(head)


def functions(text):
    """Returns the outermost functions of the text, including members and test cases."""
    text = blank(text)
    found, open_blocks, head_start, inside = [], [], 0, None
    for position, character in enumerate(text):
        if character == "{":
            head = text[head_start:position]
            open_blocks.append(inside is None and is_function(head))
            if open_blocks[-1]:
                inside = (" ".join(head.split()), text.count("\n", 0, position - len(head.lstrip())) + 1)
            elif inside is None:
                head_start = position + 1
        elif character == "}" and open_blocks:
            if open_blocks.pop():
                last = text.count("\n", 0, position) + 1
                found.append(Function(*inside, last - inside[1] + 1))
                inside = None
            if inside is None:
                head_start = position + 1
        elif character == ";" and inside is None:
            head_start = position + 1
    return found
