#!/usr/bin/env python3
"""Checks, or mends, the formatting of every C++ file with clang-format 14.

usage: format.py TREE [--mend]

Exit code 77, which ctest counts as skipped, when there is no clang-format 14: another version formats otherwise.
"""

import shutil
import subprocess
import sys

import tree


def clang_format():
    """Returns the name of a clang-format of version 14, or nothing."""
    for name in ("clang-format-14", "clang-format"):
        if shutil.which(name):
            version = subprocess.run([name, "--version"], capture_output=True, text=True, check=False).stdout
            if " version 14." in version:
                return name
    return None


def badly_formatted(program, top, names):
    """Returns the files whose text clang-format would change; one call checks many files."""
    check = [program, "--dry-run", "--ferror-limit=1", *names]
    said = subprocess.run(check, cwd=top, capture_output=True, text=True, check=True).stderr
    return sorted({line.split(":")[0] for line in said.splitlines() if "[-Wclang-format-violations]" in line})


def main(top, mend):
    program = clang_format()
    if not program:
        print("skipped: clang-format 14 is not installed (Debian's clang-format-14)")
        return 77
    names = [name for name in tree.names(top) if tree.is_cpp(name)]
    if mend:
        return subprocess.run([program, "-i", *names], cwd=top, check=False).returncode
    wrong = badly_formatted(program, top, names)
    print("\n".join(wrong + [f"{len(names)} files, {len(wrong)} not as {program} would have them"]))
    if wrong:
        print("mend them by: python3 tests/tidy/format.py . --mend")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) < 2 or set(sys.argv[2:]) - {"--mend"}:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], "--mend" in sys.argv))
