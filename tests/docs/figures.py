#!/usr/bin/env python3
"""Finds figures in the prose of documents that stand nowhere in their outputs, and links and names of files that lead
nowhere.

usage: figures.py TREE [PROGRAMS]

A figure is a number with a decimal point or a percentage. It stands in a page's outputs if a number in a block of code or
between backquotes of the page rounds to it, or one on a page that the line links to. A figure that comes from elsewhere is
listed in figures.txt with its source, as is a file that is not of the tree. With the folder PROGRAMS, the commands that are sources there are run from the top of
TREE, and the figures must be in what they print.
"""

import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
LISTED = HERE / "figures.txt"
NUMBER = re.compile(r"\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d*\.?\d+(?:[eE][-+]?\d+)?")
DECIMAL = re.compile(r"(?<![\w.#/-])\d*\.\d+(?![\w.]*\w)")
PERCENTAGE = re.compile(r"(?<![\w.#/-])\d+(?= ?%)")
# Numbers that name something: Table E.1, equations 3.5 to 3.7, (A.4), thesis 3.3, Boost 1.81.
NAMED = re.compile(r"(?i)\b(figures?|tables?|sections?|chapters?|equations?|eqs?\.|appendix|experiments?|pages?|thesis|"
                   r"version|debian|boost|python)\s+\(?(?:[A-Z]\.)?\d+\.\d+(?:\.\d+)*"
                   r"(?:,? (?:,|and|to|or) ?(?:[A-Z]\.)?\d+\.\d+(?:\.\d+)*|, (?:[A-Z]\.)?\d+\.\d+(?:\.\d+)*)*")
TARGET = re.compile(r"\]\(([^)\s]+)\)")
FILE = re.compile(r"`([\w./-]*\w\.(?:md|cfs|inc|toml|cpp|hpp|py|csv|svg|txt))`")
PUNCTUATION = re.compile(r"[^\w -]")


def blocks_and_prose(text):
    """Returns the lines inside fenced blocks, and (number, line) of each line outside them."""
    fenced, blocks, prose = False, [], []
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("```"):
            fenced = not fenced
        elif fenced:
            blocks.append(line)
        else:
            prose.append((number, line))
    return blocks, prose


def words_of(line):
    """Returns a line of prose without code, link targets, tags, and numbers that name something."""
    for pattern in (r"`[^`]*`", r"\]\([^)]*\)", r"<[^>]*>"):
        line = re.sub(pattern, " ", line)
    return line


def numbers_in(text):
    return [float(number.replace(",", "")) for number in NUMBER.findall(text)]


def is_printed(figure, printed):
    """Whether a printed number, taken as it is or as a percentage, rounds to the figure."""
    decimals = len(figure.partition(".")[2])
    half = 0.5 * 10.0**-decimals * (1 + 1e-9)
    value = float(figure)
    return any(abs(number - value) <= half or abs(100 * number - value) <= half for number in printed)


def printed_by(text):
    """Returns the numbers in a page's code blocks and between its backquotes."""
    blocks, prose = blocks_and_prose(text)
    return numbers_in("\n".join([*blocks, *(code for _, line in prose for code in re.findall(r"`([^`]*)`", line))]))


def unprinted(text, printed_at=lambda target: []):
    """Yields (line number, figure) for each figure in the prose that neither the page's outputs contain nor those of a
    page that its line links to. printed_at(target) returns the numbers of that page."""
    printed = printed_by(text)
    for number, line in blocks_and_prose(text)[1]:
        words = NAMED.sub(" ", words_of(line))
        figures = [figure for figure in DECIMAL.findall(words) + PERCENTAGE.findall(words)
                   if not is_printed(figure, printed)]
        linked = [value for target in TARGET.findall(line) for value in printed_at(target)] if figures else []
        yield from ((number, figure) for figure in figures if not is_printed(figure, linked))


def listed_figures(text):
    """Returns the content of figures.txt: {page: {figure: source}}. A source that begins with "$ " is a command."""
    pages, page = {}, None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        if not line.startswith(" "):
            page = pages.setdefault(line.strip(), {})
            continue
        figures, colon, source = line.partition(": ")
        if page is None or not colon or not source.strip():
            raise ValueError(f"figures.txt:{number}: expected \"    FIGURE ...: SOURCE\" below the name of a page")
        page.update(dict.fromkeys(figures.split(), source.strip()))
    return pages


def linked_numbers(page, tree):
    """Returns a function from a link's target to the numbers that the page there prints."""
    def numbers(target):
        path = (tree / page).parent / target.partition("#")[0]
        return printed_by(path.read_text(encoding="utf-8")) if path.suffix == ".md" and path.is_file() else []
    return numbers


def figure_faults(page, text, listed, printed_at=lambda target: []):
    """Returns faults in the figures of a page: those without a source, and listed ones that are not needed."""
    found = list(unprinted(text, printed_at))
    faults = [f"{page}:{number}: {figure} is in no output of the page, and figures.txt names no source for it"
              for number, figure in found if figure not in listed]
    needed = {figure for _, figure in found}
    faults += [f"figures.txt: {page}: {figure} is not in the prose, or the page prints it: remove it"
               for figure in sorted(listed.keys() - needed) if NUMBER.fullmatch(figure)]
    return faults


def anchors(text):
    """Returns the anchors of a Markdown page's headings."""
    _, prose = blocks_and_prose(text)
    headings = [re.sub(r"^#+\s+", "", line) for _, line in prose if re.match(r"#+\s", line)]
    plain = [re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading) for heading in headings]
    return {PUNCTUATION.sub("", heading.strip().lower()).replace(" ", "-") for heading in plain}


def link_faults(page, text, tree):
    """Returns the page's links to files and headings that do not exist."""
    faults = []
    for number, line in blocks_and_prose(text)[1]:
        for target in TARGET.findall(re.sub(r"`[^`]*`", "", line)):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            path = (tree / page).parent / name if name else tree / page
            if not path.exists():
                faults.append(f"{page}:{number}: the link to {target} leads to no file")
            elif anchor and path.suffix == ".md" and anchor not in anchors(path.read_text(encoding="utf-8")):
                faults.append(f"{page}:{number}: {name or page} has no heading #{anchor}")
    return faults


def named_file_faults(page, text, tree, names, listed=()):
    """Returns files that the page names in backquotes but that are not in the tree, in a block of the page, or in the
    list. `names` are all files of the tree; X.cpp stands for any file."""
    blocks, prose = blocks_and_prose(text)
    written = "\n".join([*blocks, *(code for _, line in prose for code in re.findall(r"`([^`]* [^`]*)`", line))])
    faults = []
    for number, line in prose:
        for name in FILE.findall(line):
            there = (tree / page).parent / name, tree / name.removeprefix("placedpar/")
            known = name in names or name in written or name in listed or name.rpartition("/")[2].startswith("X.")
            if not known and not any(path.exists() for path in there):
                faults.append(f"{page}:{number}: there is no file {name}")
    return faults


def command_faults(listed, tree, programs):
    """Returns the figures that the commands of figures.txt do not print."""
    environment = dict(os.environ, PATH=f"{programs}{os.pathsep}{os.environ['PATH']}", LC_ALL="C.UTF-8")
    faults, printed = [], {}
    for page, figures in listed.items():
        for figure, source in figures.items():
            if not source.startswith("$ "):
                continue
            if source not in printed:
                done = subprocess.run(["bash", "-c", source[2:]], cwd=tree, env=environment, text=True, check=False,
                                      stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                printed[source] = numbers_in(done.stdout)
            if not is_printed(figure, printed[source]):
                faults.append(f"figures.txt: {page}: {figure} is not in what this prints: {source}")
    return faults


def pages_with_figures(tree):
    return sorted([*tree.glob("*.md"), *tree.glob("docs/**/*.md"), *tree.glob("examples/**/README.md")])


def main(tree, programs=None, listing=LISTED):
    listed = listed_figures(listing.read_text(encoding="utf-8"))
    pages = pages_with_figures(tree)
    faults = command_faults(listed, tree, programs) if programs else []
    names = {path.name for path in tree.rglob("*.*") if "build" not in path.relative_to(tree).parts}
    for path in sorted({*pages, *tree.glob("*/README.md")}):
        page, text = str(path.relative_to(tree)), path.read_text(encoding="utf-8")
        from_elsewhere = listed.pop(page, {})
        if path in pages:
            faults += figure_faults(page, text, from_elsewhere, linked_numbers(page, tree))
        faults += link_faults(page, text, tree) + named_file_faults(page, text, tree, names, from_elsewhere)
    faults += [f"figures.txt: there is no page {page}" for page in listed]
    print("\n".join(faults) if faults else f"{len(pages)} pages: every figure has a source, every link a target")
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), *map(os.path.abspath, sys.argv[2:])))
