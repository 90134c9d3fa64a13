"""Tests programs in occam: compiled, run and checked by the program.

PLACEDPAR_D7205 names the folder of INMOS's occam toolset, unpacked from its itools. Without it, what INMOS's compiler
makes of the same programs is not compared.
"""

import itertools
import json
import os
import pathlib
import re
import shutil
import tempfile
import unittest

from program import EXAMPLES, placedpar

TESTS = pathlib.Path(__file__).parent.parent / "occam"
BESIDE_INMOS = EXAMPLES / "occam/beside-inmos"
D7205 = os.environ.get("PLACEDPAR_D7205")

OUTPUTS = ("integers", "channels", "reals", "arrays", "functions", "predefined", "bits")


def output_of(text):
    """Returns what a program printed, without the report of the run."""
    return text[:re.search(r"^.*: completed at ", text, re.MULTILINE).start()]


class Programs(unittest.TestCase):
    def run_program(self, file, *options):
        done = placedpar("run", file, *options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return output_of(done.stdout)

    def test_programs_print_what_those_that_inmos_compiled_printed(self):
        for name in OUTPUTS:
            expected = (TESTS / "code/programs" / f"{name}.txt").read_text(encoding="ascii")
            for mode, processor in itertools.product(("halt", "stop", "universal"), ("T800", "T414")):
                with self.subTest(name=name, mode=mode, processor=processor):
                    self.assertEqual(self.run_program(TESTS / "code/programs" / f"{name}.occ", "--mode", mode,
                                                      "--processor", processor), expected)

    def test_a_compiled_file_runs_like_the_program(self):
        program = BESIDE_INMOS / "ring-seq.occ"
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "ring.btl"
            done = placedpar("compile", program, "-o", file)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, r"ring\.btl: \d+ bytes for a T800; the code's source lines are in .*ring\.lines\n")
            self.assertEqual(self.run_program(file), self.run_program(program))

    def test_standard_input_is_compiled_and_warned_of_once(self):
        text = "PROC main (CHAN BYTE keyboard?, screen!, error!)\n  INT x:\n  SEQ\n    screen ! 'h'\n    screen ! '*n'\n:\n"
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "h.btl"
            done = placedpar("compile", "-", "-o", file, typed=text)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr.count('<standard input>:2:7: warning: the variable "x" is never used'), 1, done.stderr)
            self.assertIn(" <standard input>\n", (pathlib.Path(folder) / "h.lines").read_text(encoding="ascii"))
            self.assertEqual(self.run_program(file), "h\n")

    def run_text(self, text, *options, command="run", typed=None):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "test.occ"
            file.write_text(text, encoding="ascii")
            return placedpar(command, file, *options, typed=typed)

    def test_reports_name_places_of_the_program(self):
        deadlock = self.run_text("""PROC stuck ()
  CHAN OF INT a, b:
  PAR
    INT x:
    SEQ
      a ? x
      b ! x
    INT y:
    SEQ
      b ? y
      a ! y
:
""")
        self.assertEqual(deadlock.returncode, 2, deadlock.stdout + deadlock.stderr)
        self.assertRegex(deadlock.stderr + deadlock.stdout, r"inputs .*test\.occ:6:")
        self.assertRegex(deadlock.stderr + deadlock.stdout, r"inputs .*test\.occ:10:")
        error = self.run_text("""PROC wrong ()
  [4]INT a:
  INT i:
  SEQ
    i := 4
    a[i] := 1
:
""")
        self.assertEqual(error.returncode, 1, error.stdout + error.stderr)
        self.assertRegex(error.stdout + error.stderr, r"stopped at .*test\.occ:6:\d+: ")
        stopped = self.run_text("""PROC wild ()
  [4]REAL64 a:
  INT i:
  SEQ
    i := 200000000
    SEQ k = 0 FOR 4
      a[k] := 0.0(REAL64)
    a[0] := a[i]
:
""", "--mode", "stop")
        self.assertEqual(stopped.returncode, 2, stopped.stdout + stopped.stderr)
        self.assertNotIn("uses the address", stopped.stdout + stopped.stderr)
        listing = self.run_text("""PROC short ()
  INT i:
  i := 4
:
""", "--listing")
        self.assertRegex(listing.stdout, r"test\.occ:3:")

    def test_reports_tell_instances_of_one_proc_apart(self):
        done = self.run_text("""PROC both ()
  PROC partner (CHAN OF INT out, in)
    INT x:
    SEQ
      out ! 1
      in ? x
  :
  CHAN OF INT a, b:
  PAR
    partner (a, b)
    partner (b, a)
:
""")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("wait cycle: root.partner 11:5 -> root.partner 10:5 -> root.partner 11:5", done.stdout + done.stderr)

    def test_a_program_that_ends_without_telling_the_host_is_named(self):
        done = self.run_text("""#INCLUDE "hostio.inc"
PROC hello (CHAN OF SP fs, ts)
  #USE "hostio.lib"
  so.write.string.nl (fs, ts, "hello")
:
""")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("has no process left, and did not tell the host to exit (so.exit in occam)", done.stdout + done.stderr)

    def test_a_program_for_a_terminal_gets_keyboard_and_screen(self):
        done = self.run_text("""PROC echo (CHAN BYTE keyboard?, screen!, error!)
  BYTE ch:
  SEQ i = 0 FOR 3
    SEQ
      keyboard ? ch
      screen ! ch
:
""", "--keys", "abc")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("abc"), done.stdout)

    def test_a_terminal_asks_for_no_key_after_the_last_one(self):
        done = self.run_text("""PROC ask (CHAN BYTE keyboard?, screen!, error!)
  BYTE ch:
  SEQ i = 0 FOR 2
    SEQ
      keyboard ? ch
      screen ! ch
:
""", "--keys", "a")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"deadlock at \d+\.\d+ ms")
        self.assertIn("waits; an earlier request for a key found no key", done.stdout)
        self.assertRegex(done.stdout, r"root\.\d+:5 +inputs")

    def test_a_line_from_a_pipe_ends_where_the_return_key_is_pressed(self):
        done = self.run_text("""#INCLUDE "hostio.inc"
PROC ask (CHAN OF SP fs, ts, []INT memory)
  #USE "hostio.lib"
  [20]BYTE line:
  INT length:
  BYTE result:
  SEQ
    so.read.line (fs, ts, length, line, result)
    so.write.string.nl (fs, ts, [line FROM 0 FOR length])
    so.exit (fs, ts, sps.success)
:
""", typed="one\ntwo\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith("one\n"), done.stdout)

    def test_a_program_that_waits_for_a_key_after_the_last_one_waits_for_ever(self):
        done = self.run_text("""#INCLUDE "hostio.inc"
PROC ask (CHAN OF SP fs, ts, []INT memory)
  #USE "hostio.lib"
  BYTE key, result:
  SEQ
    SEQ i = 0 FOR 2
      so.getkey (fs, ts, key, result)
    so.exit (fs, ts, sps.success)
:
""", "--keys", "a")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn("waits for a key, but the input has ended", done.stdout)

    def test_the_exit_code_tells_failure_from_success_and_a_status_of_its_own(self):
        for status, code in (("sps.success", 0), ("sps.failure", 1), ("INT32 7", 0)):
            done = self.run_text(f"""#INCLUDE "hostio.inc"
PROC leave (CHAN OF SP fs, ts, []INT memory)
  #USE "hostio.lib"
  so.exit (fs, ts, {status})
:
""")
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)

    def test_a_program_without_a_host_ends_with_success(self):
        done = self.run_text("PROC main ()\n  INT x:\n  x := 1\n:\n")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_million_processes_run_in_enough_memory(self):
        text = """PROC million ()
  VAL n IS 1000000:
  [n]CHAN OF INT link:
  PAR
    PAR i = 0 FOR n - 1
      INT token:
      SEQ
        link[i] ? token
        link[i + 1] ! token + 1
    INT token:
    SEQ
      link[0] ! 1
      link[n - 1] ? token
      IF
        token = n
          SKIP
:
"""
        done = self.run_text(text)
        self.assertEqual(done.returncode, 1)
        needed = int(re.search(r"test\.occ: the program needs (\d+) bytes of memory, but the transputer has 2M\n"
                               r"hint: use --memory \d+M\n", done.stderr).group(1))
        self.assertLess(needed, 200_000_000)
        done = self.run_text(text, "--memory", f"{(needed + 1023) // 1024}K")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_an_error_halts_the_processor(self):
        done = self.run_text("PROC main ()\n  INT x, y:\n  SEQ\n    x := 0\n    y := 1 / x\n:\n")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"stopped at \S*test\.occ:5:5: division by zero: 1 / 0, in main, at \d+\.\d+ us\n")

    STOPPING = """PROC main ()
  PROC share (VAL INT of)
    INT x:
    x := 100 / of
  :
  PAR i = 0 FOR 3
    share (i)
:
"""

    def test_in_mode_stop_the_report_lists_the_processes_that_have_stopped(self):
        done = self.run_text(self.STOPPING, "--mode", "stop")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertRegex(done.stdout, r"\nroot\.share\[0\] stopped at \S*test\.occ:4:5: division by zero: 100 / 0, at \d+\.\d+ us\n")
        self.assertEqual(done.stdout.count(" stopped at "), 1)
        halted = self.run_text(self.STOPPING)
        self.assertEqual(halted.returncode, 1)
        self.assertRegex(halted.stdout, r"stopped at \S*test\.occ:4:5: division by zero: 100 / 0, in share\[0\], at ")

    def test_a_run_that_ends_after_a_process_has_stopped_is_no_success(self):
        text = """#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC main (CHAN OF SP fs, ts)
  PAR
    STOP
    SEQ
      so.write.string.nl (fs, ts, "done")
      so.exit (fs, ts, STATUS)
:
""".replace("STATUS", "sps.success")
        done = self.run_text(text, "--mode", "stop")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("done\n", done.stdout)
        self.assertIn("exited with success", done.stdout)
        self.assertRegex(done.stdout, r"\nroot\.5:5 stopped at \S*test\.occ:5:5: STOP, at ")

    def test_an_alt_without_a_true_guard_is_reported(self):
        done = self.run_text("""PROC main ()
  CHAN OF INT c:
  INT x:
  BOOL open:
  SEQ
    open := FALSE
    ALT
      open & c ? x
        SKIP
:
""")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertRegex(done.stdout, r"alternates +no guard of this ALT is true +\S*test\.occ:7:")

    def test_too_small_a_memory_is_refused_before_the_run(self):
        text = "PROC main ()\n  [300000]INT a:\n  a[0] := 1\n:\n"
        done = self.run_text(text, "--memory", "1M")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"test\.occ: the program needs 12\d{5} bytes of memory, but the transputer has 1M\nhint: use --memory 2M\n")
        self.assertEqual(self.run_text(text, "--memory", "2M").returncode, 0)
        million = "PROC main ()\n  PAR i = 0 FOR 1000000\n    INT x:\n    x := i\n:\n"
        done = self.run_text(million)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        memory = re.search(r"hint: use --memory (\d+M)\n", done.stderr).group(1)
        self.assertEqual(self.run_text(million, "--memory", memory).returncode, 0)

    def test_a_program_gets_all_values_of_a_sample(self):
        cluster = EXAMPLES / "occam/genetic/cluster.cfs"
        done = placedpar("check", cluster, "--set", "record.sample_bytes=16")
        self.assertEqual(done.returncode, 1)
        self.assertIn('sample_bytes = 16, but the program of "t[0]" must receive all values of a sample', done.stderr)
        self.assertIn("hint: set sample_bytes to 40, the length of all values as REAL64", done.stderr)
        done = placedpar("check", cluster, "--set", "record.problem=sphere")
        self.assertEqual(done.returncode, 1)
        self.assertIn('"sphere" has no record, but the program of "t[0]" waits for samples', done.stderr)

    def test_errors_have_places(self):
        for command in ("run", "check"):
            done = self.run_text("PROC main ()\n  x := 1\n:\n", command=command)
            self.assertEqual(done.returncode, 1)
            self.assertIn('test.occ:2:3: error: unknown name "x"', done.stderr)
        done = self.run_text("PROC main ()\n  SKIP\n:\n", command="check")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("no errors; PROC main would be run", done.stdout)
        for option in (["--set", "x=1"], ["--use", "a=b"], ["--fault", "zzz"]):
            done = self.run_text("PROC main ()\n  SKIP\n:\n", *option, command="check")
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"{option[0]} has no effect on", done.stderr)
        for parameters, runs in (("CHAN OF INT in, out, VAL INT n, k", False), ("CHAN OF ANY a, b", True), ("VAL INT n", False),
                                 ("CHAN OF INT a, b", False), ("CHAN OF INT16::[]BYTE a, b", True),
                                 ("CHAN OF BYTE keyboard, screen, error", True), ("CHAN OF ANY a, b, []INT m", True),
                                 ("CHAN OF ANY a, b, []BYTE m", False), ("CHAN OF ANY a, b, [9]INT m", False)):
            done = self.run_text(f"PROC worker ({parameters})\n  SKIP\n:\n", command="check")
            self.assertEqual("PROC worker would be run" in done.stdout, runs, parameters)
            self.assertEqual("only a netlist can use PROC worker, because of its parameters" in done.stdout, not runs)
        done = self.run_text("#INCLUDE \"nowhere.inc\"\nPROC p (CHAN OF INT a, b)\n  SKIP\n:\n", command="check")
        self.assertEqual(done.returncode, 1)
        self.assertIn('the file "nowhere.inc" is missing', done.stderr)
        done = self.run_text("VAL x IS 1:\n")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the file has no PROC that can be run", done.stderr)
        done = self.run_text("PROC main (VAL INT n)\n  SKIP\n:\n")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the main procedure cannot have this parameter", done.stderr)
        done = self.run_text("PROC main ()\n  SKIP\n:\n", "--no-checks", "bounds")
        self.assertEqual(done.returncode, 1)
        self.assertIn('--no-checks: "bounds" is not the name of a check: the names are usage, alias, range and all', done.stderr)

    def test_unused_names_are_warnings(self):
        text = """PROC main (CHAN BYTE keyboard?, screen!, error!)
  VAL n IS 3:
  INT used, unused:
  CHAN OF INT c:
  TIMER clock:
  [4]INT a:
  b IS a[2]:
  PROC never (VAL INT p)
    SKIP
  :
  INT FUNCTION f (VAL INT x) IS 1:
  SEQ
    used := f (2)
    screen ! BYTE used
:
"""
        done = self.run_text(text, command="check")
        self.assertEqual(done.returncode, 0, done.stderr)
        warned = re.findall(r'test\.occ:(\d+):\d+: warning: the (\w+) "([\w.]+)" is never used', done.stderr)
        self.assertEqual(warned, [("2", "constant", "n"), ("3", "variable", "unused"), ("4", "channel", "c"), ("5", "timer", "clock"),
                                  ("7", "abbreviation", "b"), ("8", "procedure", "never"), ("8", "parameter", "p"),
                                  ("11", "parameter", "x")])

    def test_usage_is_checked_unless_it_is_left_out(self):
        text = "PROC main ()\n  INT x:\n  PAR\n    x := 1\n    x := 2\n:\n"
        self.assertEqual(self.run_text(text, command="check").returncode, 1)
        self.assertEqual(self.run_text(text, "--no-checks", "usage,alias", command="check").returncode, 0)


class GeneticAlgorithm(unittest.TestCase):
    """Compares the strings that programs in occam breed with those of the processes in C++."""

    def hashes(self, netlist, seed, settings):
        options = [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]
        done = placedpar("run", EXAMPLES / netlist, "--seed", seed, *options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        found = re.findall(r"populations +(#?[0-9a-fA-F]+(?:#[0-9a-fA-F]+)?)", done.stdout)
        return sorted(each.replace("#", "").lower() for each in found)

    def test_a_master_and_slaves_breed_the_strings_of_cpp(self):
        for population, slaves, seed in ((31, 2, 5), (30, 3, 9), (7, 1, 2), (120, 0, 12)):
            settings = {"population": population, "slaves": slaves}
            with self.subTest(**settings):
                ours = self.hashes("occam/genetic/cluster.cfs", seed, settings | {"seed": seed})
                self.assertEqual(len(ours), 1)
                self.assertEqual(ours, self.hashes("thesis/table-e1/cluster.cfs", seed, settings))

    def test_islands_breed_the_strings_of_cpp(self):
        for clusters, period, seed in ((2, 2, 3), (3, 1, 8), (5, 4, 1)):
            settings = {"clusters": clusters, "population": 20}
            with self.subTest(**settings):
                ours = self.hashes("occam/genetic/islands.cfs", seed, settings | {"seed": seed, "period": period})
                self.assertEqual(len(ours), clusters)
                self.assertEqual(ours, self.hashes("thesis/figure-e2/figure-e2.cfs", seed,
                                                   settings | {"slaves": 0, "exchange_every": period}))

    def test_islands_with_slaves_breed_the_strings_of_cpp(self):
        for clusters, slaves, seed in ((4, 3, 1), (2, 2, 6)):
            settings = {"clusters": clusters, "slaves": slaves}
            with self.subTest(**settings):
                ours = self.hashes("occam/genetic/figure-e2.cfs", seed, settings | {"seed": seed})
                self.assertEqual(len(ours), clusters)
                self.assertEqual(ours, self.hashes("thesis/figure-e2/figure-e2.cfs", seed, settings))


@unittest.skipUnless(D7205, "PLACEDPAR_D7205 names no folder of the occam toolset")
class Toolset(unittest.TestCase):
    CONFIGURATION = """VAL m IS 1024 * 1024 :
NODE t :
ARC hostlink :
NETWORK example
  DO
    SET t (type, memsize := "T800", 2 * m)
    CONNECT t[link][0] TO HOST WITH hostlink
:
NODE application :
MAPPING
  DO
    MAP application ONTO t
:
#INCLUDE "hostio.inc"
#USE "p.cah"
CONFIG
  CHAN OF SP fs, ts :
  PLACE fs, ts ON hostlink :
  PLACED PAR
    PROCESSOR application
      [65536]INT memory:
      PROCEDURE (fs, ts, memory)
:
"""

    def compiled_by_inmos(self, folder, text):
        """Returns what the program prints that INMOS's tools make, without support of the debugger."""
        (folder / "p.occ").write_text(text, encoding="ascii")
        (folder / "p.lnk").write_text("p.tco\nhostio.lib\nconvert.lib\n#include occam8.lnk\n", encoding="ascii")
        name = re.findall(r"^PROC (\w+)", text, re.MULTILINE)[-1]
        (folder / "p.pgm").write_text(self.CONFIGURATION.replace("PROCEDURE", name), encoding="ascii")
        for tool, arguments in (("oc", "p -t8 -h -y -o p.tco"), ("ilink", "-f p.lnk -t8 -h -y -o p.cah"),
                                ("occonf", "p.pgm -h -y -o p.cfb"), ("icollect", "p.cfb -y -o p.btl")):
            done = placedpar("run", pathlib.Path(D7205) / "itools" / f"{tool}.btl", "--processor", "T414",
                             "--host-folder", folder, "--", *arguments.split())
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return output_of(placedpar("run", folder / "p.btl", "--memorycycles", 1).stdout)

    def test_both_compilers_agree(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file in (pathlib.Path(D7205) / "libs").iterdir():
                shutil.copy(file, folder)
            for program in OUTPUTS:
                text = (TESTS / "code/programs" / f"{program}.occ").read_text(encoding="ascii")
                self.assertEqual(self.compiled_by_inmos(folder, text),
                                 (TESTS / "code/programs" / f"{program}.txt").read_text(encoding="ascii"))
            placedpar("replay", "occam", "--json", folder / "cells.json")
            cells = json.loads((folder / "cells.json").read_text(encoding="utf-8"))["cells"]
            for cell in cells:
                if cell["column"] == "mode halt" and cell["unit"] == "ticks":
                    text = (BESIDE_INMOS / f"{cell['row']}.occ").read_text(encoding="ascii")
                    ticks = int(self.compiled_by_inmos(folder, text).split()[1])
                    self.assertLessEqual(abs(ticks / cell["INMOS"] - 1), 0.01)


if __name__ == "__main__":
    unittest.main()
