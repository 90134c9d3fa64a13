#!/usr/bin/env python3
"""Writes the table of the thesis in examples/thesis/README.md from thesis.toml beside it, and checks both.

usage: thesis.py TREE [PROGRAMS] [--write]

thesis.toml has a row for each figure, table and numbered equation of the thesis, or for some that belong together, and
for statements that it makes only in words ("Claim of section 5.1: exchange"): what it shows, our page and command, and a verdict. The numbers of cells are not typed: they are those of the line "cells judged
against the thesis" that the page shows below the command, which the tests of documents run. This program refuses

- a row missing, or two rows, for an item of the thesis, whose items [thesis] lists;
- a verdict that is none of [verdicts], one that needs a reason (or a picture, or a judged cell) and has none;
- a page, a picture or a command that is not there: the page must show the picture, and run the command;
- with PROGRAMS, a command or an experiment that `placedpar --help` does not list;
- without --write, a README.md that differs from what thesis.toml gives.
"""

import os
import pathlib
import re
import subprocess
import sys
import tomllib

from document import Command, steps

FOLDER = "examples/thesis"
BEGIN, END = "<!-- written by tests/docs/thesis.py from thesis.toml -->", "<!-- end -->"
KINDS = {"Figure": "figures", "Table": "tables", "Equation": "equations"}
CELLS = re.compile(r"cells judged against the thesis: (\d+)(?: \((\d+) of them set constants\))?;")
NEEDS_REASON = {"differs", "not reproduced", "nothing to compare", "not yet"}
FAILS = ("not reproduced", "differs")


def expanded(listed):
    """Returns the numbers of a list such as "2.1 to 2.3, 2.5"."""
    numbers = []
    for part in filter(None, listed.split(", ")):
        first, _, last = part.partition(" to ")
        chapter, start = first.split(".")
        end = (last or first).split(".")[1]
        numbers += [f"{chapter}.{number}" for number in range(int(start), int(end) + 1)]
    return numbers


def is_claim(item):
    return re.match(r"Claim of (section \d(\.\d)+|appendix [A-E]): ", item) is not None


def items_of(row):
    """Returns the items of a row: "Equations 1.1, 1.2" are Equation 1.1 and Equation 1.2; a claim is one item."""
    if is_claim(row["of"]):
        return [row["of"]]
    kind, _, numbers = row["of"].partition(" ")
    kind = kind.removesuffix("s")
    return [f"{kind} {number}" for number in expanded(numbers)] if kind in KINDS else []


def page_of(row):
    """Returns the path of a row's page in the tree."""
    page = row.get("page", "")
    return page if page.endswith(".md") or not page else f"examples/{page}/README.md"


def command_on(page, row):
    """Returns the command of the page that begins with the row's; None if there is none."""
    wanted = row.get("command", "")
    found = (step for step in steps(page) if isinstance(step, Command) and f"{step.text} ".startswith(f"{wanted} "))
    return next(found, None) if wanted else None


def cells_of(row, tree):
    """Returns (judged by the thesis, those of them that set constants) of the row's command; (0, 0) if it judges none."""
    path = tree / page_of(row)
    if not row.get("page") or not path.is_file():
        return 0, 0
    command = command_on(path.read_text(encoding="utf-8"), row)
    found = CELLS.search("\n".join(command.output)) if command else None
    return (int(found[1]), int(found[2] or 0)) if found else (0, 0)


def coverage_faults(rows, thesis):
    wanted = [f"{kind} {number}" for kind, key in KINDS.items() for number in expanded(thesis[key])]
    covered = [item for row in rows for item in items_of(row)]
    faults = [f"{item}: no row" for item in wanted if item not in covered]
    faults += [f"{item}: the thesis has no such item" for item in covered if item not in wanted and not is_claim(item)]
    return faults + [f"{item}: two rows" for item in sorted({item for item in covered if covered.count(item) > 1})]


def verdict_faults(row, verdicts, tree):
    name, verdict = row["of"], row["verdict"]
    if not items_of(row):
        yield f"{name}: begins with none of {', '.join(KINDS)}, and is no \"Claim of section 5.1: ...\""
    if verdict not in verdicts:
        yield f"{name}: \"{verdict}\" is none of the verdicts"
    if verdict in NEEDS_REASON and not row.get("why"):
        yield f"{name}: \"{verdict}\" without a reason"
    if verdict == "drawn" and not row.get("picture"):
        yield f"{name}: drawn, without a picture"
    if verdict == "within tolerance" and cells_of(row, tree)[0] == 0:
        yield f"{name}: within tolerance, but its command shows no cell judged against the thesis"


def place_faults(row, tree):
    """Returns what is wrong with the page, the pictures and the command of a row."""
    name, path = row["of"], tree / page_of(row)
    if not row.get("page"):
        return [f"{name}: no page"] if row.get("command") or row.get("picture") else []
    if not path.is_file():
        return [f"{name}: there is no page {page_of(row)}"]
    text = path.read_text(encoding="utf-8")
    faults = []
    for picture in row.get("picture", "").split():
        if not (path.parent / picture).is_file() or f"]({picture})" not in text:
            faults.append(f"{name}: {page_of(row)} shows no picture {picture}")
    if row.get("command") and not command_on(text, row):
        faults.append(f"{name}: {page_of(row)} does not run {row['command']}")
    return faults


def words_after(program, *arguments):
    """Returns the first words of the lines that a help prints."""
    done = subprocess.run([program, *arguments, "--help"], stdout=subprocess.PIPE, text=True, check=True)
    return {line.split()[0] for line in done.stdout.splitlines() if line.startswith("  ") and line.split()}


def command_faults(rows, program):
    known, experiments = words_after(program), words_after(program, "replay")
    for row in rows:
        words = row.get("command", "").split()
        if words and (words[0] != "placedpar" or words[1] not in known):
            yield f"{row['of']}: there is no command {row['command']}"
        elif words[1:2] == ["replay"] and words[2] not in experiments:
            yield f"{row['of']}: there is no experiment {words[2]}"


def cells_text(cells):
    judged, constants = cells
    return f"{judged}, {constants} set constants" if constants else str(judged or "")


def linked(row):
    """Returns the name of a row, as a link if it has a page."""
    target = os.path.relpath(page_of(row), FOLDER) if row.get("page") else ""
    return f"[{row['of']}]({target})" if target else row["of"]


def row_text(row, tree):
    command = f"`{row['command']}`" if row.get("command") else ""
    verdict = f"**{row['verdict']}**" if row["verdict"] in (*FAILS, "not yet") else row["verdict"]
    verdict += f": {row['why']}" if row.get("why") else ""
    return f"| {linked(row)} | {row['shows']} | {command} | {verdict} | {cells_text(cells_of(row, tree))} |"


def chapter_of(row):
    return re.search(r" ([0-9A-E])[.:]", items_of(row)[0])[1]


def summary(data, tree):
    """Returns the numbers of items by verdict, and the rows that do not hold."""
    count = {verdict: 0 for verdict in data["verdicts"]}
    for row in data["row"]:
        count[row["verdict"]] += len(items_of(row))
    lines = ["| verdict | items | meaning |", "|---|---|---|"]
    lines += [f"| {verdict} | {count[verdict]} | {meaning} |" for verdict, meaning in data["verdicts"].items()]
    lines += ["", "These items do not hold, or hold only in part:", "", "| item of the thesis | verdict |", "|---|---|"]
    for verdict in FAILS:
        lines += [f"| {linked(row)} | {verdict}: {row['why']} |" for row in data["row"] if row["verdict"] == verdict]
    judged = {(page_of(row), row["command"]): cells_of(row, tree)[0] for row in data["row"] if row.get("command")}
    return lines + ["", f"The replays judge {sum(judged.values())} cells against the thesis; a replay of several items counts once."]


def generated(data, tree):
    """Returns the generated part of README.md."""
    lines = summary(data, tree)
    for chapter, title in data["chapters"].items():
        lines += ["", f"## {title}", "", "| item of the thesis | what it shows | command | verdict | cells |", "|---|---|---|---|---|"]
        lines += [row_text(row, tree) for row in data["row"] if chapter_of(row) == chapter]
    return "\n".join([BEGIN, *lines, END])


def with_generated(text, part):
    """Returns README.md with the generated part replaced."""
    before, begin, rest = text.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"README.md has no part between \"{BEGIN}\" and \"{END}\"")
    return before + part + after


def faults_of(data, tree, program=None):
    faults = coverage_faults(data["row"], data["thesis"])
    for row in data["row"]:
        faults += [*verdict_faults(row, data["verdicts"], tree), *place_faults(row, tree)]
    return faults + (list(command_faults(data["row"], program)) if program and not faults else [])


def main(tree, programs=None, write=False):
    data = tomllib.loads((tree / FOLDER / "thesis.toml").read_text(encoding="utf-8"))
    faults = faults_of(data, tree, f"{programs}/placedpar" if programs else None)
    readme = tree / FOLDER / "README.md"
    if not faults:
        text = readme.read_text(encoding="utf-8")
        right = with_generated(text, generated(data, tree))
        if write:
            readme.write_text(right, encoding="utf-8")
        elif text != right:
            faults.append(f"{FOLDER}/README.md differs from thesis.toml: python3 tests/docs/thesis.py . --write")
    print("\n".join(faults) or f"{len(data['row'])} rows of the thesis: each with its page, command and verdict")
    return 1 if faults else 0


if __name__ == "__main__":
    given = [argument for argument in sys.argv[1:] if argument != "--write"]
    if len(given) not in (1, 2):
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(given[0]), *given[1:], write="--write" in sys.argv))
