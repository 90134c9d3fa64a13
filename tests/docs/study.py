#!/usr/bin/env python3
"""Runs the page of a study with few seeds, in seconds, and holds what is printed loosely against the page.

usage: study.py TREE PROGRAMS DOCUMENT

As document.py, but `placedpar replay STUDY` runs with few of the seeds that the page shows, and its plots are not compared.
What is printed must have the page's lines in the page's order, whatever the figures and verdicts in them, and the
interval of each claim must not contradict the one that the page has from all seeds. `ctest -C studies -L studies` runs these
pages to the letter, as document.py does.
"""

import re
import sys

import document

SEEDS = 20
FEWER_SEEDS = {"faults": 3, "links-at-once": 3, "drain-side": 10, "closed-loop": 6, "logger-rates": 3}  # whose runs take seconds each
FIGURE = re.compile(r"[+-]?(\d[\d.,]*|\.\d+)(e[+-]?\d+)?%?!?")
FINGERPRINT = re.compile(r"fingerprint: [0-9a-f]{16}")
JUDGED = re.compile(r"every judged cell (of the first reading )?is within its tolerance|"
                    r"a cell (of the first reading )?misses its tolerance")
BOUND = re.compile(r"[<>]= #")  # other seeds may change whether a cell is judged
VERDICT = re.compile(r"\b(holds under this reading|does not hold|holds|undecided|shown|refuted)\b")


def without_figures(line):
    """Returns the lines with everything that depends on the seeds replaced."""
    line = JUDGED.sub("judged", FINGERPRINT.sub("fingerprint:", line))
    return " ".join(BOUND.sub("", VERDICT.sub("?", FIGURE.sub("#", line))).split())


def claims(lines):
    """Returns name and interval of each row of the tables of claims."""
    found, table = [], False
    for line in lines:
        if not line:
            table = False
        elif line.startswith("claims"):
            table = True
        row = re.match(r"(.*?\S)\s{2,}.*\s(\S+)\s+(\S+)$", line)
        if table and row and FIGURE.fullmatch(row[2]) and FIGURE.fullmatch(row[3]):
            found.append((row[1], float(row[2]), float(row[3])))
    return found


def contradictions(page, printed):
    """Returns the claims whose intervals do not overlap; the interval of few seeds is first widened by half on each
    side."""
    for (name, low, high), (_, page_low, page_high) in zip(claims(printed), claims(page)):
        margin = (high - low) / 2
        if high + margin < page_low or page_high < low - margin:
            yield f"{name}: {low} to {high} from few seeds, {page_low} to {page_high} on the page"


def loose_failure(command, exit_code, printed):
    """Returns a text that says what is wrong, or nothing."""
    if exit_code not in (0, 3):  # with few seeds, a figure may miss the tolerance that many seeds keep
        return document.failure(command, exit_code, printed)
    page, lines = ([without_figures(line) for line in text] for text in (command.output, printed))
    if not document.matches(page, lines):
        return "\n".join(document.difflib.unified_diff(page, lines, "the document", "few seeds", lineterm=""))
    return "\n".join(contradictions(command.output, printed))


def run_loosely(command, tree, environment):
    """Replaces document.run_command for studies."""
    if command.text.startswith("cmp plots/"):
        return 0, [], None
    if not command.text.startswith("placedpar replay "):
        return document.run_command(command, tree, environment)
    study = command.text.split()[2]
    seeds = FEWER_SEEDS.get(study, SEEDS)
    few = document.dataclasses.replace(command, text=f"{command.text} --seeds {seeds}")
    exit_code, printed = document.execute(few, tree, environment)
    return exit_code, printed, loose_failure(command, exit_code, printed)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(document.main(*sys.argv[1:4], run_command=run_loosely))
