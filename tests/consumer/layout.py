#!/usr/bin/env python3
"""No installed header's layout depends on a flag of the program that includes it: compiles all doors with the flags of
two programs that differ in all of them, and compares the sizes of all our types.

usage: layout.py g++ INCLUDED_FOLDER FILE_OF_DOORS [FLAG ...]     flags: of both, such as -isystem FOLDER
"""

import concurrent.futures
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

RELEASE = ["-std=c++20", "-O2", "-DNDEBUG"]
OTHER = ["-std=c++23", "-O0", "-fsanitize=address,undefined", "-D_GLIBCXX_ASSERTIONS"]
if platform.machine() == "x86_64":
    OTHER += ["-march=skylake-avx512"]
CLASS = re.compile(r"^Class (placedpar::.*)\n +size=(\d+) align=(\d+)\n +base size=(\d+)", re.MULTILINE)


def layouts(compiler, flags, source):
    """Returns the size and the alignment of each type."""
    with tempfile.TemporaryDirectory() as folder:
        dump = pathlib.Path(folder, "classes")
        subprocess.run([compiler, *flags, "-fsyntax-only", f"-fdump-lang-class={dump}", "-x", "c++", "-"],
                       input=source, text=True, check=True)
        return {match[1]: match.groups()[1:] for match in CLASS.finditer(dump.read_text())}


def main(compiler, folder, door_list, *flags):
    doors = re.search(r"set\(doors (.*)\)", pathlib.Path(door_list).read_text())[1].split(";")
    source = "".join(f'#include "placedpar/{door}"\n' for door in doors)
    flags = [f"-I{folder}", *flags]
    with concurrent.futures.ThreadPoolExecutor() as pool:
        release, other = pool.map(lambda own: layouts(compiler, own + flags, source), (RELEASE, OTHER))
    differing = [name for name in release.keys() | other.keys() if release.get(name) != other.get(name)]
    for name in sorted(differing):
        print(f"{name}: size, alignment and size as a base are {release.get(name)}, with other flags {other.get(name)}")
    print(f"{len(release)} types, {len(differing)} differ")
    return 1 if differing or len(release) < 400 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
