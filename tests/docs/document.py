#!/usr/bin/env python3
"""Runs the commands of a document and compares what they print with what the document says.

usage: document.py TREE PROGRAMS DOCUMENT [--write]

--write puts what the commands print into the document, where it shows other output and leaves out lines only at the end.
The document is relative to TREE. Its commands run from the top of a scratch copy, so that they leave nothing behind, with
the folder PROGRAMS first on the path. The copy has the document and TREE's examples; it has all of TREE where a command
names `.`, which takes a second or two. In a block fenced as ```console

    $ placedpar check mine.cfs # exit 1     a command; with the exit code, where that is not 0
    mine.cfs:3:5: ...                       what it prints on either stream, to the letter
    ...                                     any number of lines

A command with no output below it may print anything. A line ended by a backslash goes on in the next. A block fenced as
```LANGUAGE FILE is written to FILE of the scratch copy first. Other blocks are not run.
"""

import dataclasses
import difflib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SECONDS = 120


@dataclasses.dataclass
class Command:
    """A command of a document, with the expected exit code and output."""

    line: int
    text: str
    exit_code: int = 0
    output: list = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class File:
    """A file that a document asks its reader to write."""

    line: int
    name: str
    text: str


def fenced_blocks(text):
    """Yields (number of the first line, info string, lines) of each fenced block."""
    info, first, lines = None, 0, []
    for number, line in enumerate(text.splitlines(), 1):
        fence = re.match(r"```\s*(.*)$", line)
        if fence and info is None:
            info, first, lines = fence[1].strip(), number + 1, []
        elif fence:
            yield first, info, lines
            info = None
        elif info is not None:
            lines.append(line)
    if info is not None:
        raise SyntaxError(f"the block at line {first} is not closed")


def commands(first, lines):
    """Returns the commands of one console block."""
    found = []
    for number, line in enumerate(lines, first):
        if line.startswith("$ "):
            found.append(Command(number, line[2:]))
        elif found and not found[-1].output and found[-1].text.endswith("\\"):
            found[-1].text += "\n" + line
        elif found:
            found[-1].output.append(line)
        else:
            raise SyntaxError(f"line {number}: a console block begins with a command, `$ ...`")
    for command in found:
        stated = re.search(r"\s+# exit (\d+)$", command.text)
        if stated:
            command.text, command.exit_code = command.text[: stated.start()], int(stated[1])
        while command.output and not command.output[-1]:
            command.output.pop()
    return found


def steps(text):
    """Returns what a reader of the document does, in order."""
    for first, info, lines in fenced_blocks(text):
        words = info.split()
        if words == ["console"]:
            yield from commands(first, lines)
        elif len(words) == 2:
            yield File(first, words[1], "\n".join(lines) + "\n")


def matches(expected, printed):
    """Whether the printed lines match the expected ones; an expected line "..." matches any number of lines."""
    lines = [r"(?:.*\n)*" if line == "..." else re.escape(line) + "\n" for line in expected]
    return re.fullmatch("".join(lines), "".join(line + "\n" for line in printed)) is not None


def execute(command, tree, environment):
    """Returns exit code and printed lines of a command; the code is None if the command does not end in time."""
    try:
        done = subprocess.run(["bash", "-c", command.text], cwd=tree, env=environment, text=True, errors="replace",
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None, []
    return done.returncode, done.stdout.rstrip("\n").split("\n") if done.stdout else []


def failure(command, exit_code, printed):
    """Returns a text that says what is wrong, or nothing."""
    if exit_code is None:
        return f"does not end within {SECONDS} s"
    if exit_code != command.exit_code:
        return "\n".join([f"exit code {exit_code}, the document says {command.exit_code}; it printed:", *printed])
    if command.output and not matches(command.output, printed):
        return "\n".join(difflib.unified_diff(command.output, printed, "the document", "the program", lineterm=""))
    return None


def renewed(expected, printed):
    """Returns the printed lines as a document shows them: all, or as many as it showed before a final "..."."""
    if "..." not in expected:
        return printed
    if expected.index("...") == len(expected) - 1:
        return [*printed[: len(expected) - 1], "..."]
    return expected


def with_output(text, printed):
    """Returns the document with the outputs of its commands replaced; printed: pairs of command and lines."""
    lines = text.splitlines()
    for command, output in reversed(printed):
        start = command.line + command.text.count("\n")
        lines[start:start + len(command.output)] = output
    return "\n".join(lines) + "\n"


def run_command(command, tree, environment):
    """Returns exit code and printed lines of a command, and what is wrong with them, if anything."""
    exit_code, printed = execute(command, tree, environment)
    return exit_code, printed, failure(command, exit_code, printed)


def run(document, tree, programs, run_command=run_command):
    """Does what the document says; returns the number of failures, and the document with the program's output."""
    environment = dict(os.environ, PATH=f"{programs}{os.pathsep}{os.environ['PATH']}", LC_ALL="C.UTF-8")
    text = (tree / document).read_text()
    done, failures, other = 0, 0, []
    for step in steps(text):
        if isinstance(step, File):
            (tree / step.name).write_text(step.text)
            continue
        done += 1
        exit_code, printed, wrong = run_command(step, tree, environment)
        if wrong:
            failures += 1
            print(f"{document}:{step.line}: $ {step.text}\n{wrong}\n")
            if exit_code == step.exit_code:
                other.append((step, renewed(step.output, printed)))
    print(f"{document}: {done} commands, {failures} failures")
    return failures, with_output(text, other)


def names_the_tree(text):
    """Whether a command of the document takes the whole tree, `.`, as an argument."""
    return any("." in step.text.split() for step in steps(text) if isinstance(step, Command))


def copy_for(document, source, tree):
    """Copies the source files that the document's commands need into the tree."""
    if names_the_tree((source / document).read_text()):
        shutil.copytree(source, tree, ignore=shutil.ignore_patterns(".git", "build"))
        return
    shutil.copytree(source / "examples", tree / "examples")
    (tree / document).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(source / document, tree / document)


def main(source, programs, document, write=False, run_command=run_command):
    with tempfile.TemporaryDirectory() as scratch:
        tree = pathlib.Path(scratch) / "placedpar"
        copy_for(document, pathlib.Path(source), tree)
        failures, text = run(document, tree, os.path.abspath(programs), run_command)
    if write:
        (pathlib.Path(source) / document).write_text(text)
    return 1 if failures and not write else 0


if __name__ == "__main__":
    if len(sys.argv) != 4 and sys.argv[4:] != ["--write"]:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:4], write=len(sys.argv) == 5))
