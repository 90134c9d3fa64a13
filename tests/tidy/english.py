"""Finds comments and prose that break the rules of plain English in CONTRIBUTING.md, as far as a pattern can.

A comment is a run of lines that begin with `//` or `///`, or what follows `//` at the end of a line of code. Prose is
what a page holds outside of code blocks, tables and headings.
"""

import collections
import re

SENTENCE_WORDS = 40
PROSE_LINE = 160

HEADLESS = re.compile(r"(Of|The same|Those)\b(?! (kind|type))")
PEOPLE = re.compile(r"\b([Nn]obody|[Ww]hoever|[Ss]omebody|[Aa]nybody|[Ee]verybody)\b")
DIALECT = re.compile(r"(?<![Tt]here )\b(is no|are no|comes to|is told) (?!longer|more than|one\b)[a-z]+")
COMMENT = re.compile(r"^\s*///?<?\s?(.*)$")
TRAILING = re.compile(r"^[^\"']*[;,{}()]\s*///?<?\s?(.*)$")

# Faults that a room may still have. Lower the number when you mend some; a room with 0 needs no entry.
LEFT = {}


def comments(text):
    """Yields (number of the first line, text) of each comment of a C++ source."""
    first, lines = 0, []
    for number, line in enumerate(text.splitlines() + [""], 1):
        whole = COMMENT.match(line)
        if whole:
            first = first or number
            lines.append("." if whole[1].startswith("    ") else whole[1])  # a table or a formula
            continue
        if lines:
            yield first, " ".join(lines)
        first, lines = 0, []
        trailing = TRAILING.match(line)
        if trailing:
            yield number, trailing[1]


def prose(text):
    """Yields (number of the line, text) of each line of prose of a page."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced and not line.startswith(("|", "#", "    ", "!", "<")):
            yield number, line


def sentences(text):
    """Returns the sentences of a comment or a paragraph."""
    return re.split(r"(?<=[.:;?!])\s+", text)


def faults(name, text):
    """Returns the faults of a file that a pattern can find, a sentence each."""
    if name.endswith((".cpp", ".hpp")):
        for number, comment in comments(text):
            where = f"{name}:{number}"
            if HEADLESS.match(comment):
                yield f"{where}: the first sentence needs a subject and a verb: {comment[:60]}"
            for word in PEOPLE.findall(comment):
                yield f"{where}: \"{word}\" is for people"
            for word in DIALECT.finditer(comment):
                yield f"{where}: \"{word[0]}\": say it plainly"
            for sentence in sentences(comment):
                if len(sentence.split()) > SENTENCE_WORDS:
                    yield f"{where}: a sentence of more than {SENTENCE_WORDS} words: {sentence[:60]}"
    if name.endswith(".md"):
        for number, line in prose(text):
            if len(line) > PROSE_LINE and "](" not in line:
                yield f"{name}:{number}: a line of prose of more than {PROSE_LINE} characters"


def room_of(name):
    """Returns the room whose allowance covers a file: tests and pages count separately."""
    return name.split("/")[0] if "/" in name else "top"


def house_faults(texts):
    """Returns the faults of a tree's rooms that have more faults, or fewer, than LEFT says."""
    found = collections.defaultdict(list)
    for name, text in texts.items():
        for fault in faults(name, text):
            found[room_of(name)].append(fault)
    for room in sorted(found.keys() | LEFT.keys()):
        left = LEFT.get(room, 0)
        if len(found[room]) > left:
            yield from found[room]
            yield f"{room}: {len(found[room])} faults of English, more than {left}"
        elif len(found[room]) < left:
            yield f"{room}: {len(found[room])} faults of English are left: lower its number in tests/tidy/english.py"
