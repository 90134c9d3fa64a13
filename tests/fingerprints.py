#!/usr/bin/env python3
"""Runs each row of fingerprints.csv and compares the fingerprint that the program prints.

usage: fingerprints.py PROGRAM [--write]    --write: puts what the program prints into the table
"""

import csv
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[1]
TABLE = TOP / "tests" / "fingerprints.csv"


def fingerprint(program, row):
    """What the program prints for the row, or a sentence that says why there is nothing."""
    command = [program, "run", row["netlist"], *row["arguments"].split()]
    done = subprocess.run(command, cwd=TOP, text=True, capture_output=True, timeout=300)
    found = re.search(r"^fingerprint: ([0-9a-f]+)$", done.stdout, re.MULTILINE)
    return found[1] if found else f"exit code {done.returncode} and no fingerprint: {done.stderr.strip()}"


def main(program, write):
    with open(TABLE, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows and any(TOP.glob("examples/**/*.cfs")):
        print(f"{TABLE} is empty, though there are netlists in examples")
        return 1

    wrong = 0
    for row in rows:
        printed = fingerprint(program, row)
        if printed != row["fingerprint"]:
            wrong += 1
            print(f"{row['netlist']} {row['arguments']}\n  table:   {row['fingerprint']}\n  program: {printed}")
        row["fingerprint"] = printed
    print(f"{len(rows)} runs, {wrong} with another fingerprint than the table")

    if write:
        with open(TABLE, "w", newline="") as file:
            writer = csv.DictWriter(file, ["netlist", "arguments", "fingerprint"], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
        return 0
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) < 2 or set(sys.argv[2:]) - {"--write"}:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], "--write" in sys.argv))
