"""Tests the output of placedpar --version, and how the build finds the commit."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from program import CLUSTER, PROGRAM, placedpar

TOP = pathlib.Path(__file__).resolve().parents[2]


def run(*command, folder):
    environment = {**os.environ, "GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_SYSTEM": os.devnull}
    for name in [name for name in environment if name.startswith("GIT_") and "CONFIG" not in name]:
        del environment[name]
    for who in ("AUTHOR", "COMMITTER"):
        environment.update({f"GIT_{who}_NAME": "n", f"GIT_{who}_EMAIL": "n@example.org"})
    return subprocess.run([*map(str, command)], cwd=folder, env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=True).stdout.strip()


class Version(unittest.TestCase):
    def test_version_and_commit_are_said_and_recorded(self):
        said = placedpar("--version").stdout
        found = re.fullmatch(r"placedpar (\d+\.\d+\.\d+)(?: \(commit ([0-9a-f]{7,}(?:-dirty)?)\))?\n", said)
        self.assertTrue(found, said)
        if (TOP / ".git").exists():
            self.assertIsNotNone(found[2], said)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.json"
            placedpar("run", CLUSTER, "--json", path)
            manifest = json.loads(path.read_text(encoding="utf-8"))["manifest"]
        self.assertEqual((manifest["version"], manifest["commit"]), (found[1], found[2] or ""))


    def test_in_short(self):
        for option in ("-v", "-V"):
            self.assertEqual(placedpar(option).stdout, placedpar("--version").stdout)

    def test_a_program_with_own_processes_says_whose_it_is(self):
        own = pathlib.Path(PROGRAM).resolve().parent / "own_process"
        said = subprocess.run([str(own), "--version"], stdout=subprocess.PIPE, text=True, check=True).stdout
        self.assertEqual(said, placedpar("--version").stdout.replace("placedpar ", "own_process (PlacedPar ").rstrip() + ")\n")


class Commit(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name) / "placedpar"
        self.output = pathlib.Path(folder.name) / "commit.cpp"
        (self.tree / "cmake").mkdir(parents=True)
        for name in ("cmake/commit.cmake", "cmake/commit.txt", ".gitattributes"):
            shutil.copy(TOP / name, self.tree / name)

    def commit(self, tree=None):
        tree = tree or self.tree
        run("cmake", f"-DTREE={tree}", f"-DOUTPUT={self.output}", "-P", tree / "cmake" / "commit.cmake", folder=tree)
        return re.search(r'commit = "(.*)";', self.output.read_text(encoding="utf-8"))[1]

    def make_repository(self, folder):
        run("git", "init", "-q", folder=folder)
        run("git", "add", "-A", folder=folder)
        run("git", "commit", "-qm", "first", folder=folder)
        return run("git", "rev-parse", "--short", "HEAD", folder=folder)

    def test_of_a_checkout(self):
        head = self.make_repository(self.tree)
        self.assertEqual(self.commit(), head)
        with (self.tree / "cmake" / "commit.cmake").open("a", encoding="utf-8") as script:
            script.write("# changed\n")
        self.assertEqual(self.commit(), head + "-dirty")

    def test_of_sources_without_git(self):
        self.assertEqual(self.commit(), "")

    def test_of_sources_within_another_project(self):
        self.make_repository(self.tree.parent)
        self.assertEqual(self.commit(), "")

    def test_of_an_archive(self):
        head = self.make_repository(self.tree)
        archive = self.tree.parent / "archive.tar"
        run("git", "archive", "-o", archive, "HEAD", folder=self.tree)
        unpacked = self.tree.parent / "unpacked"
        unpacked.mkdir()
        run("tar", "-xf", archive, folder=unpacked)
        self.assertEqual(self.commit(unpacked), head)

    def test_the_same_commit_leaves_the_file_alone(self):
        self.make_repository(self.tree)
        self.commit()
        os.utime(self.output, (1, 1))
        self.commit()
        self.assertEqual(self.output.stat().st_mtime, 1)


if __name__ == "__main__":
    unittest.main()
