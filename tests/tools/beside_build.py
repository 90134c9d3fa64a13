"""Compiles new and changed sources of a copied tree, and links them before the libraries of the tested build. This
takes seconds, where a build of the copy would take minutes."""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import unittest

from copied_tree import ROOT

BUILD = pathlib.Path(os.environ.get("PLACEDPAR_BUILD", ROOT / "build" / "release"))
PROGRAM = "app/placedpar"


def ninja(*arguments):
    done = subprocess.run(["ninja", "-C", str(BUILD), "-t", *arguments], capture_output=True, text=True, check=True)
    return done.stdout


def run(command, **options):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    if done.returncode:
        raise AssertionError(f"{shlex.join(map(str, command))}\n{done.stdout}")
    return done.stdout


class BesideBuild:
    """The copy `top`, compiled to `folder`."""

    def __init__(self, top, folder):
        if not (BUILD / "build.ninja").exists():
            raise unittest.SkipTest(f"{BUILD} is no build by Ninja")
        self.top, self.folder = top, pathlib.Path(folder)
        self.compilations = [each for each in json.loads(ninja("compdb")) if each["file"].endswith(".cxx") or
                             each["file"].endswith(".cpp")]
        links = [part for part in ninja("commands", "-s", PROGRAM).split(" && ") if f" -o {PROGRAM} " in part]
        self.link_words = shlex.split(links[-1])

    def flags(self, target):
        """Returns the compiler and its options for a target's sources, without optimisation, which would double the
        time."""
        command = next(each["command"] for each in self.compilations if f"/{target}.dir/" in each["output"])
        words = shlex.split(command.split(" -o ")[0])
        kept = [word for word in words if not re.match(r"-M|-O|-D_FORTIFY_SOURCE|.*\.d$|.*\.o$", word)]
        return [word.replace(str(ROOT), str(self.top)) if str(BUILD) not in word else word for word in kept] + ["-O0", "-Werror"]

    def compile(self, sources, target):
        """Compiles all the sources as one object, with the target's options."""
        unit = self.folder / f"{target}.cpp"
        unit.write_text("".join(f'#include "{source}"\n' for source in sources), encoding="utf-8")
        run([*self.flags(target), "-c", unit, "-o", unit.with_suffix(".o")], cwd=BUILD)
        return unit.with_suffix(".o")

    def link(self, name, objects, *libraries, main=True):
        """Links a program from the objects; without `main`, the objects or libraries must contain main()."""
        words = [word for word in self.link_words if main or f"{PROGRAM}.dir/" not in word.replace("CMakeFiles/", "")]
        words[words.index("-o") + 1] = str(self.folder / name)
        first = next(i for i, word in enumerate(words) if word.endswith(".a"))
        words[first:first] = [*map(str, objects), *libraries, "-Wl,--allow-multiple-definition"]
        run(words, cwd=BUILD)
        return self.folder / name

    def list_experiments(self):
        """Writes the source that CMake generates from the experiments' file names."""
        listing = (self.top / "experiments" / "CMakeLists.txt").read_text(encoding="utf-8").split("placedpar_room(")[0]
        script = self.folder / "list.cmake"
        script.write_text(f'list(APPEND CMAKE_MODULE_PATH "{self.top}/cmake")\n' + listing.replace("CONFIGURE_DEPENDS ", ""),
                          encoding="utf-8")
        run(["cmake", "-P", script], cwd=self.top / "experiments")
        return pathlib.Path(shutil.move(self.top / "experiments" / "experiments.cpp", self.folder))
