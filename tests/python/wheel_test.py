"""Tests that a wheel of the package is made and can be used, where Debian's python3-build is installed."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

PACKAGE = pathlib.Path(os.environ["PYTHONPATH"])


@unittest.skipIf(importlib.util.find_spec("build") is None or importlib.util.find_spec("setuptools") is None,
                 "python3-build and python3-setuptools are not installed")
class Wheel(unittest.TestCase):
    def test_a_wheel_holds_the_package_for_this_platform(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder, PACKAGE],
                           check=True, stdout=subprocess.DEVNULL, cwd=folder,
                           env={key: value for key, value in os.environ.items() if key != "PYTHONPATH"})
            wheel, = pathlib.Path(folder).glob("placedpar-*-cp311-cp311-linux_*.whl")
            with zipfile.ZipFile(wheel) as archive:
                self.assertIn("placedpar/py.typed", archive.namelist())
                archive.extractall(pathlib.Path(folder, "site"))
            program = "import placedpar; print(placedpar.__file__, placedpar.load('T800 (memory = 1M) t;').cfs)"
            found = subprocess.run([sys.executable, "-c", program], env={"PYTHONPATH": f"{folder}/site"}, check=True,
                                   stdout=subprocess.PIPE, text=True).stdout
        self.assertTrue(found.startswith(f"{folder}/site/placedpar/"), found)
        self.assertIn("T800", found)


if __name__ == "__main__":
    unittest.main()
