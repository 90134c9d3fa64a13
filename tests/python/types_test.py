"""Tests the package's types with mypy, where it is installed."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = """import placedpar as pp
class Relay(pp.Process):
    out = pp.Output(int)
    def body(self):
        yield pp.wait(WAIT)
run: pp.Run = pp.load("a.cfs", kinds=[Relay], slaves=4).run(seed=1)
value: float = pp.search(lambda rows: rows.sum(axis=1), [(0, 1)], topology="torus").value
"""


@unittest.skipUnless(shutil.which("mypy", path="/usr/bin"), "mypy is not installed")
class Types(unittest.TestCase):
    def test_the_package_and_programs_that_use_it_have_right_types(self):
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "right.py").write_text(PROGRAM.replace("WAIT", '"5ms"'), encoding="utf-8")
            pathlib.Path(folder, "wrong.py").write_text(PROGRAM.replace("WAIT", "[5]"), encoding="utf-8")
            package = os.path.join(os.environ["PLACEDPAR_SOURCE"], "python")
            found = subprocess.run(
                ["/usr/bin/mypy", "--python-executable", sys.executable, "--cache-dir", os.devnull, "--check-untyped-defs",
                 "--warn-return-any", "-p", "placedpar", "-m", "right", "-m", "wrong"],
                env={**os.environ, "MYPYPATH": f"{package}:{folder}"}, stdout=subprocess.PIPE, text=True)
        errors = [line for line in found.stdout.splitlines() if ": error: " in line]
        self.assertEqual(len(errors), 1, found.stdout)
        self.assertRegex(errors[0], r'wrong.py:5: error: Argument 1 to "wait" has incompatible type "List\[int\]"')


if __name__ == "__main__":
    unittest.main()
