"""Tests commands on configurations of several processors in occam.

PLACEDPAR_D7205 names the folder of INMOS's occam toolset, unpacked from its itools. Without it, what INMOS's configurer
makes of the examples is not compared.
"""

import pathlib
import re
import shutil
import tempfile
import unittest

import occam_test
from program import EXAMPLES, placedpar

SIXTEEN = EXAMPLES / "occam/sixteen"
NAMES = ("sixteen.pgm", "farm.pgm", "ring.occ")


class Configurations(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def test_every_command_reads_the_examples(self):
        for name in NAMES:
            with self.subTest(name):
                file = SIXTEEN / name
                trace, page = self.folder / "trace.json", self.folder / "page.html"
                done = placedpar("run", file, "--trace", trace, "--page", page)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(done.stdout, placedpar("run", file).stdout)
                for command in (("check",), ("show",), ("show", "--format", "json"), ("show", "--format", "svg"),
                                ("explain",)):
                    done = placedpar(command[0], file, *command[1:])
                    self.assertEqual((done.returncode, done.stderr), (0, ""), command)

    def test_a_printed_configuration_runs_the_same(self):
        for name in NAMES:
            with self.subTest(name):
                file, printed = (SIXTEEN / name).resolve(), self.folder / "printed.cfs"
                printed.write_text(placedpar("show", file, "--format", "cfs").stdout, encoding="utf-8")
                reports = [placedpar("run", each).stdout.replace(str(each), "") for each in (file, printed)]
                self.assertRegex(reports[0], "fingerprint: [0-9a-f]{16}")
                self.assertEqual(*reports)
                hashes = [re.search(r"hash \w+", placedpar("check", each).stdout).group() for each in (file, printed)]
                self.assertEqual(*hashes)

    def test_parameters_are_set_and_swept(self):
        done = placedpar("run", SIXTEEN / "farm.pgm", "--set", "farmer.limit=20")
        self.assertIn("set: farmer.limit = 20, for farmer\n", done.stdout)
        self.assertNotEqual(done.stdout, placedpar("run", SIXTEEN / "farm.pgm").stdout)
        swept = placedpar("sweep", SIXTEEN / "farm.pgm", "farmer.limit=10,20", "--results", self.folder / "r.sqlite")
        self.assertEqual(swept.returncode, 0, swept.stderr)

    def test_vals_are_set_and_swept(self):
        farm = SIXTEEN / "farm.pgm"
        for file in SIXTEEN.iterdir():
            shutil.copy(file, self.folder)
        two = self.folder / "two.pgm"
        two.write_text(farm.read_text(encoding="ascii").replace("workers IS 3", "workers IS 2"), encoding="ascii")
        done = placedpar("run", farm, "--set", "workers=2")
        self.assertIn("set: workers = 2\n", done.stdout)
        self.assertEqual(done.stdout.replace("set: workers = 2\n", "").replace(str(farm), str(two)), placedpar("run", two).stdout)
        shown = placedpar("show", farm, "--set", "workers=K / 512", "--format", "cfs").stdout
        self.assertIn("T800 (memory = 65536) t[2];", shown)
        swept = placedpar("sweep", farm, "workers=1..3", "--results", self.folder / "r.sqlite")
        self.assertEqual(swept.returncode, 0, swept.stderr)
        for setting, said in (("workers=4", r"farm\.pgm:17:30: error: link 4 does not exist"),
                              ("workers=2.5", r'wrong type for the val "workers": 2\.5 is a real number'),
                              ("workers=8589934592", r"farm\.pgm:5:5: error: workers cannot be set to 8589934592: INT holds whole numbers from -2147483648 to 2147483647"),
                              ("wokers=2", 'did you mean "workers"'), ("sps_success=1", "vals: K = 1024, M = 1048576, workers = 3")):
            done = placedpar("check", farm, "--set", setting)
            self.assertEqual(done.returncode, 1, setting)
            self.assertRegex(done.stderr, said)

    def test_errors_have_their_places_in_the_configuration(self):
        for file in SIXTEEN.iterdir():
            shutil.copy(file, self.folder)
        wrong = self.folder / "wrong.pgm"
        text = (SIXTEEN / "farm.pgm").read_text(encoding="ascii")
        wrong.write_text(text.replace("root[link][i + 1]", "root[link][1]"), encoding="ascii")
        for command in ("run", "check", "show"):
            done = placedpar(command, wrong)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertRegex(done.stderr, r'wrong\.pgm:17:17: error: the link "root\.link\[1\]" is connected twice')

    def test_a_deadlock_names_lines_of_the_programs(self):
        for file in SIXTEEN.iterdir():
            shutil.copy(file, self.folder)
        worker = self.folder / "worker.occ"
        text = worker.read_text(encoding="ascii")
        worker.write_text(text.replace("    task ? n\n    W", "    answer ! 0\n    task ? n\n    W"), encoding="ascii")
        done = placedpar("run", self.folder / "farm.pgm")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stdout + done.stderr, r"worker\.occ:5:\d+")
        self.assertRegex(done.stdout + done.stderr, r"farmer\.occ:1\d:\d+")

    def test_compile_refuses_a_configuration(self):
        done = placedpar("compile", SIXTEEN / "ring.occ", "-o", self.folder / "ring.btl")
        self.assertEqual(done.returncode, 1)
        self.assertIn("the file is a configuration", done.stderr)


@unittest.skipUnless(occam_test.D7205, "PLACEDPAR_D7205 names no folder of the occam toolset")
class Toolset(unittest.TestCase):
    SQUARE = """T800 (memory = 1M) square[4][4];
connect square[0][0].link[0] to host;
rep r = 0 for 4 rep c = 0 for 4 {
  if c < 3 connect square[r][c].link[3] to square[r][c + 1].link[1];
  if r < 3 connect square[r][c].link[2] to square[r + 1][c].link[0];
}
use "sixteen.btl" for square[0][0];
"""
    STAR = """T800 (memory = 2M) root;
T800 (memory = 64K) t[3];
connect root.link[0] to host;
rep i = 0 for 3 connect root.link[i + 1] to t[i].link[1];
use "farm.btl" for root;
"""

    def tool(self, folder, name, *arguments):
        done = placedpar("run", pathlib.Path(occam_test.D7205) / "itools" / f"{name}.btl", "--processor", "T414",
                         "--host-folder", folder, "--", *arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def by_inmos(self, name, programs, machine):
        """Returns what the configuration prints if INMOS's tools compile, link, configure and collect it."""
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            for file in (*(pathlib.Path(occam_test.D7205) / "libs").iterdir(), *SIXTEEN.iterdir()):
                shutil.copy(file, folder)
            for each in programs:
                (folder / f"{each}.lnk").write_text(f"{each}.t8h\nhostio.lib\nconvert.lib\n#include occam8.lnk\n",
                                                    encoding="ascii")
                self.tool(folder, "oc", each, "-t8", "-h", "-y", "-o", f"{each}.t8h")
                self.tool(folder, "ilink", "-f", f"{each}.lnk", "-t8", "-h", "-y", "-o", f"{each}.c8h")
            self.tool(folder, "occonf", f"{name}.pgm", "-h", "-y", "-o", f"{name}.cfb")
            self.tool(folder, "icollect", f"{name}.cfb", "-y", "-o", f"{name}.btl")
            (folder / "machine.cfs").write_text(machine, encoding="ascii")
            done = placedpar("run", folder / "machine.cfs")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            return occam_test.output_of(done.stdout)

    def test_inmos_configures_the_sixteen_to_the_same_output(self):
        ours = occam_test.output_of(placedpar("run", SIXTEEN / "sixteen.pgm").stdout)
        self.assertEqual(self.by_inmos("sixteen", ("root", "branch", "leaf"), self.SQUARE), ours)

    def test_inmos_configures_the_farm_to_the_same_sum(self):
        # Which worker gets which task depends on times, so only the tasks and steps in all are compared.
        ours = occam_test.output_of(placedpar("run", SIXTEEN / "farm.pgm").stdout)
        theirs = self.by_inmos("farm", ("farmer", "worker"), self.STAR)
        for text in (ours, theirs):
            self.assertEqual(sum(int(tasks) for tasks in re.findall(r"did +(\d+) tasks", text)), 40)
        self.assertEqual(ours.splitlines()[-1], theirs.splitlines()[-1])


if __name__ == "__main__":
    unittest.main()
