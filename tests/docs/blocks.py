#!/usr/bin/env python3
"""Checks every code block of the documents that document.py does not run.

usage: blocks.py TREE PROGRAMS COMPILER

    ```cpp              compiled, all in one go: the blocks of a page in one namespace, in their order; with a FILE, too
    ```netlist          `placedpar check` accepts it; or, in an example's page, its lines stand in a netlist beside the page
    ```toml FILE        and every other block with the name of a file: a command of the page uses the file
    ```sh, ```python    the shell, or Python, can parse it
    ```monitor          said to the service by tests/monitor/service/document_test.py
    ```console          run by document.py
    ```text             no code, but what something printed that takes too long to be run again

A block of another language, or of none, is refused: nobody would notice when it is wrong.
"""

import ast
import pathlib
import re
import subprocess
import sys
import tempfile

from document import Command, fenced_blocks, steps

RUN_ELSEWHERE = {"console", "text", "monitor"}
# What the blocks of a page may use without including it.
PROLOGUE = """#include "app/program.hpp"
#include "gaprocs/objective_problem.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/environment.hpp"
#include "runtime/alternation.hpp"
#include "runtime/executive.hpp"
#include "runtime/parallel.hpp"
#include <algorithm>
"""


def pages(tree):
    """Returns every document, relative to the tree."""
    found = {path for pattern in ("*.md", "docs/**/*.md", "examples/**/README.md", "*/README.md") for path in tree.glob(pattern)}
    return sorted(path.relative_to(tree) for path in found)


def blocks(tree, page):
    """Yields (line, words of the info string, text) of the blocks of a page."""
    for first, info, lines in fenced_blocks((tree / page).read_text(encoding="utf-8")):
        yield first, info.split(), "\n".join(lines) + "\n"


def source_of(page, number, found):
    """The C++ blocks of a page as a part of one source: its includes, and the rest in a namespace."""
    includes, body = [], [f"namespace page_{number} {{", "using namespace ::placedpar;"]
    for first, text in found:
        body.append(f'#line {first} "{page}"')
        for line in text.splitlines():
            include = re.match(r'#include ([<"])(?:placedpar/)?(.*)[>"]$', line)
            if include:
                staged = include[1] == '"' or "<placedpar/" in line
                includes.append(f'#include "{include[2]}"' if staged else line)
            body.append("" if include else re.sub(r"\bint main\(", "int main_of_the_page(", line))
    return includes, [*body, "}"]


def wrong_cpp(tree, compiler, of_pages):
    """Returns what the compiler says of all C++ blocks together; "" if all are right."""
    includes, bodies = [], []
    for number, (page, found) in enumerate(of_pages):
        more, body = source_of(page, number, found)
        includes += more
        bodies += body
    source = PROLOGUE + "\n".join([*dict.fromkeys(includes), *bodies]) + "\n"
    command = [compiler, "-std=c++20", "-fsyntax-only", f"-I{tree}", "-x", "c++", "-"]
    done = subprocess.run(command, input=source, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return [done.stdout] if done.returncode else []


def stands_beside(tree, page, text):
    """Whether each line is one of a netlist in the page's folder."""
    known = {line.strip() for path in (tree / page).parent.glob("*.cfs") for line in path.read_text().splitlines()}
    return all(line.strip() in known for line in text.splitlines() if line.strip())


def wrong_in(command, text):
    """Returns what a program prints about a text in a file if it does not accept it."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "block"
        path.write_text(text)
        done = subprocess.run([*command, path], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.stdout if done.returncode else ""


def wrong_python(text):
    try:
        ast.parse(text)
    except SyntaxError as error:
        return str(error)
    return ""


def is_used(tree, page, name):
    """Whether a command of the page names the file, or the program whose table of lines it is."""
    program = name.replace(".lines", ".btl")
    return any(name in step.text or program in step.text for step in steps((tree / page).read_text(encoding="utf-8")) if isinstance(step, Command))


def wrong_block(tree, programs, page, words, text):
    """Returns what is wrong with a block that is not C++; "" if nothing is."""
    language = words[0] if words else ""
    if len(words) == 2:
        wrong = "" if is_used(tree, page, words[1]) else f"no command of the page uses {words[1]}"
        return wrong_in(["bash", "-n"], text) if wrong and language == "sh" else wrong
    if len(words) == 1 and language in RUN_ELSEWHERE:
        return ""
    if language == "netlist":
        return "" if stands_beside(tree, page, text) else wrong_in([f"{programs}/placedpar", "check"], text)
    if language == "sh":
        return wrong_in(["bash", "-n"], text)
    if language == "python":
        return wrong_python(text)
    return f"nothing checks a block of the language \"{' '.join(words)}\": see tests/docs/blocks.py"


def wrong_blocks(tree, programs, compiler):
    """Returns all faults, each with its place."""
    wrong, of_pages = [], []
    for page in pages(tree):
        cpp = []
        for first, words, text in blocks(tree, page):
            if words[:1] == ["cpp"]:
                cpp.append((first, text))
            if words != ["cpp"] and (said := wrong_block(tree, programs, page, words, text)):
                wrong.append(f"{page}:{first}: {said}")
        if cpp:
            of_pages.append((page, cpp))
    return wrong + wrong_cpp(tree, compiler, of_pages)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    found = wrong_blocks(pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3])
    print("\n".join(found))
    sys.exit(1 if found else 0)
