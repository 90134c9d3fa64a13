"""Tests the libraries of occam by programs, whose outputs are in programs/*.expected.

PLACEDPAR_D7205 names the folder of INMOS's occam toolset. With it, INMOS's compiler compiles the programs and our
libraries; the programs are also linked with INMOS's libraries, which must print the same.
`library_test.py --write` writes the expected outputs anew, from our libraries, if INMOS's print the same.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import exact

PROGRAM = os.environ["PLACEDPAR"]
D7205 = os.environ.get("PLACEDPAR_D7205")
HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = HERE / "programs"
LIBRARY = HERE.parent.parent.parent / "occam" / "library"
# In an order in which each uses only those before
LIBRARIES = ["convert", "string", "hostio", "streamio", "dblmath", "snglmath", "course"]
OURS_ALONE = ["kent", "pairs", "special"]  # INMOS has no library of the course, and rounds some results otherwise
EXACT = ["reals", "maths"]  # compared with exact arithmetic
ARGUMENTS = {"files": ["--env", "IBOARDSIZE=100000", "--env", "LONG=abcdefghij", "--", "arg1", "arg2"]}
WAITING = ["keyboard"]  # asks for a line after the last key, and waits for ever
FLAGS = {"T414": "-t4", "T800": "-t8"}
CONFIGURATION = """VAL m IS 1024 * 1024 :
NODE t :
ARC hostlink :
NETWORK example
  DO
    SET t (type, memsize := "PROCESSOR", 2 * m)
    CONNECT t[link][0] TO HOST WITH hostlink
:
NODE application :
MAPPING
  DO
    MAP application ONTO t
:
#INCLUDE "hostio.inc"
#USE "NAME.lku"
CONFIG
  CHAN OF SP fs, ts :
  PLACE fs, ts ON hostlink :
  PLACED PAR
    PROCESSOR application
      NAME (fs, ts)
:
"""


def placedpar(*arguments, keys=""):
    typed = keys.replace("\\", "\\\\")  # in standard input, a newline would be the return key
    done = subprocess.run([PROGRAM, "run", "--keys", typed, *map(str, arguments)], timeout=300, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return done.returncode, done.stdout.decode("latin-1"), done.stderr.decode("latin-1")


def keys_of(name):
    file = PROGRAMS / (name + ".keys")
    return file.read_text(encoding="ascii").rstrip("\n").encode().decode("unicode_escape") if file.exists() else ""


def visible(text):
    """Returns the text with control characters as they are written in Python, but without carriage returns."""
    return "".join(c if c == "\n" or " " <= c <= "~" else f"\\x{ord(c):02x}" for c in text.replace("\r", ""))


def ran(file, *options):
    """Runs a program with an empty folder. Returns what it prints itself."""
    with tempfile.TemporaryDirectory() as folder:
        code, text, errors = placedpar(file, *options, "--host-folder", folder,
                                       *ARGUMENTS.get(file.stem, []), keys=keys_of(file.stem))
    assert code == (2 if file.stem in WAITING else 0), text[-2000:] + errors
    return visible(re.split(re.escape(str(file)) + ": (?:completed|deadlock)", text)[0])


class Toolset:
    """INMOS's compiler in a folder of its own, with INMOS's libraries or with ours."""

    def __init__(self, folder, processor, ours):
        self.folder, self.processor = pathlib.Path(folder), processor
        for file in (pathlib.Path(D7205) / "libs").iterdir():
            if not ours or file.stem not in LIBRARIES:
                shutil.copy(file, self.folder)
        if ours:
            for file in [*LIBRARY.glob("*.occ"), *LIBRARY.glob("*.inc")]:
                shutil.copy(file, self.folder)
            for name in LIBRARIES:
                self.compiled(name)
                self.tool("ilibr", name + ".tco", "-o", name + ".lib")

    def tool(self, name, *arguments):
        code, text, errors = placedpar(pathlib.Path(D7205) / "itools" / (name + ".btl"), "--processor", "T414",
                                       "--host-folder", self.folder, "--", *arguments)
        assert code == 0, text[-2000:] + errors

    def compiled(self, name):
        self.tool("oc", name, FLAGS[self.processor], "-h", "-o", name + ".tco")

    def output(self, name):
        """Compiles, links and runs a program of ours."""
        shutil.copy(PROGRAMS / (name + ".occ"), self.folder)
        self.compiled(name)
        libraries = [f"{each}.lib" for each in LIBRARIES if (self.folder / f"{each}.lib").exists()]
        rest = "occam8.lnk" if self.processor == "T800" else "occama.lnk"
        (self.folder / (name + ".lnk")).write_text("\n".join([name + ".tco", *libraries, "#include " + rest, ""]),
                                                   encoding="ascii")
        self.tool("ilink", "-f", name + ".lnk", FLAGS[self.processor], "-h", "-o", name + ".lku")
        (self.folder / (name + ".pgm")).write_text(
            CONFIGURATION.replace("NAME", name).replace("PROCESSOR\"", self.processor + "\""), encoding="ascii")
        self.tool("occonf", name + ".pgm", "-o", name + ".cfb")
        self.tool("icollect", name + ".cfb", "-o", name + ".btl")
        return ran(self.folder / (name + ".btl"), "--processor", self.processor)


def expected(name):
    return (PROGRAMS / (name + ".expected")).read_text(encoding="ascii")


def compared():
    return sorted(file.stem for file in PROGRAMS.glob("*.occ") if file.stem not in EXACT)


def check_reals(test, text):
    """Compares 11,634 reals in their formats with exact ones."""
    lines = text.splitlines()
    test.assertEqual(len(lines), 11634)
    for line in lines:
        bits, Ip, Dp, written, back = re.fullmatch(r"#(\w+) +(\d+) +(\d+) <(.*)> (back|other)", line).groups()
        size = 4 * len(bits)
        test.assertEqual(written, exact.formatted(int(bits, 16), size, int(Ip), int(Dp)), line)
        if abs(exact.of_bits(int(bits, 16), size)) < float("inf"):
            test.assertEqual(back, "back", line)


def check_maths(test, text):
    """Compares 5,600 results of elementary functions with exact ones."""
    lines = text.splitlines()
    test.assertEqual(len(lines), 5600)
    for line in lines:
        name, *bits = line.replace("#", " ").split()
        size = 4 * len(bits[0])
        x, z, y = (exact.of_bits(int(each, 16), size) for each in bits)
        if abs(y) == float("inf"):
            test.assertGreater(x, 709.78 if size == 64 else 88.72, line)
        else:
            off = exact.units_off(name, [x, z] if name in ("ATAN2", "POWER") else [x], y, size)
            test.assertLess(off, 2 if size == 64 else 1, line)


@unittest.skipUnless(D7205, "PLACEDPAR_D7205 names no folder of the occam toolset")
class InmosCompiler(unittest.TestCase):
    def check(self, processor, programs):
        with tempfile.TemporaryDirectory() as theirs, tempfile.TemporaryDirectory() as ours:
            theirs, ours = Toolset(theirs, processor, False), Toolset(ours, processor, True)
            for name in programs:
                with self.subTest(program=name, processor=processor):
                    self.assertEqual(ours.output(name), expected(name))
                    if name not in OURS_ALONE:
                        self.assertEqual(theirs.output(name), expected(name))
            if processor == "T800":
                check_maths(self, ours.output("maths"))
            mine = ours.output("reals")
            check_reals(self, mine)
            # INMOS's library rounds one in a hundred reals otherwise, in the last of its 9 or 17 digits.
            pairs = list(zip(mine.splitlines(), theirs.output("reals").splitlines()))
            self.assertGreater(sum(one == other for one, other in pairs) / len(pairs), 0.97)

    def test_a_t414_prints_what_it_prints_with_libraries_of_inmos(self):
        self.check("T414", ["integers", "keyboard"])

    def test_a_t800_prints_what_it_prints_with_libraries_of_inmos(self):
        self.check("T800", compared())


class OwnCompiler(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if "occam programs cannot be run" in placedpar(PROGRAMS / "sharing.occ")[2]:
            raise unittest.SkipTest("this program does not compile occam")

    def check(self, name, *options):
        with self.subTest(program=name, options=options):
            self.assertEqual(ran(PROGRAMS / (name + ".occ"), *options), expected(name))

    def test_programs_print_what_is_expected(self):
        for name in compared():
            self.check(name)
        for name in ("integers", "strings", "keyboard"):
            self.check(name, "--processor", "T414")
            self.check(name, "--mode", "stop")

    def test_reals_and_functions_are_exact(self):
        for processor in ("T414", "T800"):
            check_reals(self, ran(PROGRAMS / "reals.occ", "--processor", processor))
        check_maths(self, ran(PROGRAMS / "maths.occ"))


def write():
    with tempfile.TemporaryDirectory() as theirs, tempfile.TemporaryDirectory() as ours:
        theirs, ours = Toolset(theirs, "T800", False), Toolset(ours, "T800", True)
        for name in compared():
            text = ours.output(name)
            if name in OURS_ALONE or theirs.output(name) == text:
                (PROGRAMS / (name + ".expected")).write_text(text, encoding="ascii")
            else:
                print(name + ": INMOS's libraries print otherwise")


if __name__ == "__main__":
    if "--write" in sys.argv:
        write()
    else:
        unittest.main()
