"""Tests that the installed package is found by python3."""

import os
import subprocess
import sys
import tempfile
import unittest


class Install(unittest.TestCase):
    def test_the_installed_package_is_found(self):
        build = os.path.dirname(os.environ["PYTHONPATH"])
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", prefix], check=True,
                           stdout=subprocess.DEVNULL)
            site = os.path.join(prefix, "lib", f"python{sys.version_info[0]}.{sys.version_info[1]}", "dist-packages")
            found = subprocess.run([sys.executable, "-c", "import placedpar; print(placedpar.__file__, placedpar.search)"],
                                   env={"PYTHONPATH": site}, check=True, stdout=subprocess.PIPE, text=True).stdout
        self.assertIn(f"{site}/placedpar/__init__.py <function search", found)


if __name__ == "__main__":
    unittest.main()
