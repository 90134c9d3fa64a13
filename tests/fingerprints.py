#!/usr/bin/env python3
"""Runs each row of fingerprints.csv and compares the fingerprint that the program prints.

usage: fingerprints.py PROGRAM              the table's fingerprints must come out
       fingerprints.py PROGRAM REFERENCE    and the whole report, to the letter, be that of another build
       fingerprints.py PROGRAM --write      puts what the program prints into the table

The fingerprint is of the order and the times of events. Times that do not depend on what was computed leave it the same when
a result changes; hence the comparison of whole reports between compilers. Predicted native runs are compared only by
placedpar itself: the small program that another compiler builds (netlist_reports.cpp) has no options for them.
"""

import concurrent.futures
import csv
import difflib
import os
import pathlib
import re
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[1]
TABLE = TOP / "tests" / "fingerprints.csv"


def report(program, row):
    """Returns what the program prints for the row, on either stream."""
    command = [program, "run", row["netlist"], *row["arguments"].split()]
    done = subprocess.run(command, cwd=TOP, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300,
                          check=False)
    return f"exit code {done.returncode}\n{done.stdout}"


def fingerprint(printed):
    """Returns the fingerprint in a report, or the whole report if there is none."""
    found = re.search(r"^fingerprint: ([0-9a-f]+)$", printed, re.MULTILINE)
    return found[1] if found else printed


def compare(program, row, reference):
    """Returns the difference, "" if there is none. The row gets the program's fingerprint."""
    name = f"{row['netlist']} {row['arguments']}"
    printed, wanted = report(program, row), row["fingerprint"]
    row["fingerprint"] = fingerprint(printed)
    if row["fingerprint"] != wanted:
        return f"{name}\n  table:   {wanted}\n  program: {row['fingerprint']}\n"
    if reference and printed != (other := report(reference, row)):
        return "\n".join(difflib.unified_diff(other.splitlines(), printed.splitlines(), reference, program, lineterm="")) + "\n"
    return ""


def write(rows):
    with open(TABLE, "w", newline="") as file:
        writer = csv.DictWriter(file, ["netlist", "arguments", "fingerprint"], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main(program, reference=None):
    with open(TABLE, newline="") as file:
        rows = list(csv.DictReader(file))
    if os.path.basename(program) == "netlist_reports":
        rows = [row for row in rows if "--predict" not in row["arguments"]]
    if not rows and any(TOP.glob("examples/**/*.cfs")):
        print(f"{TABLE} is empty, though there are netlists in examples")
        return 1
    writing = reference == "--write"
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() if reference else 1) as pool:
        different = [each for each in pool.map(lambda row: compare(program, row, None if writing else reference), rows) if each]
    print(*different, f"{len(rows)} runs, {len(different)} different", sep="")
    if writing:
        write(rows)
    return 1 if different and not writing else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
