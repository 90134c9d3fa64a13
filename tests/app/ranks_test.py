"""Tests mpirun placedpar sweep: the results do not depend on the number of ranks, even if one dies."""

import os
import pathlib
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest

from program import FIGURE_E2, PROGRAM
from sweep_test import InFolder, rows

MPIRUN = shutil.which("mpirun")
MODULE = pathlib.Path(PROGRAM).with_name("placedpar_mpi.so")
# For CI: run as root, with more ranks than cores, and on this machine only.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_plm": "isolated"}
STUDY = ["sweep", str(FIGURE_E2), "slaves=0..3", "master.trials=3", "--measure", "master.T_exe"]


def ranks_of(mpirun):
    """Returns {rank: process id} of the ranks that mpirun has started."""
    found = {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            parent = int((folder / "stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[1])
            environment = (folder / "environ").read_bytes().split(b"\0") if parent == mpirun.pid else []
        except OSError:
            continue  # the process has ended meanwhile
        found.update({int(each.split(b"=")[1]): int(folder.name) for each in environment
                      if each.startswith(b"OMPI_COMM_WORLD_RANK=")})
    return found


@unittest.skipUnless(MPIRUN and MODULE.exists(), "built without MPI")
class Ranks(InFolder):
    def start(self, ranks, *arguments):
        command = [MPIRUN, "--oversubscribe", "-n", str(ranks), PROGRAM, *map(str, arguments)]
        return subprocess.Popen(command, cwd=self.folder, env=ENVIRONMENT, text=True, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def finish(self, process, code=0):
        output, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, code, errors)
        return output if code == 0 else errors

    def kept(self, name):
        try:
            return len(rows(self.folder / name))
        except sqlite3.OperationalError:
            return 0  # the table does not exist yet

    def test_any_number_of_ranks_makes_the_same(self):
        self.study(f"""
            netlist = "{FIGURE_E2}"
            measure = ["master.T_exe"]
            seeds = 4
            set = {{slaves = "0..3", master.trials = 3}}""")
        self.sweep("study.toml", "--results", "kept")
        printed, table = self.report("kept", "--csv", "one.csv"), rows(self.folder / "kept")
        self.assertEqual(len(table), 16)
        for ranks, jobs in ((1, 1), (2, 1), (3, 1), (2, 2)):
            with self.subTest(ranks=ranks, jobs=jobs):
                (self.folder / "kept").unlink()
                self.finish(self.start(ranks, "sweep", "study.toml", "--results", "kept", "--jobs", jobs))
                self.assertEqual(rows(self.folder / "kept"), table)
                self.assertEqual(self.report("kept", "--csv", "ranks.csv"), printed)
                self.assertEqual((self.folder / "ranks.csv").read_bytes(), (self.folder / "one.csv").read_bytes())

    def test_all_ranks_work(self):
        with self.start(3, *STUDY, "--seeds", 200, "--results", "kept") as mpirun:
            while self.kept("kept") < 6 and mpirun.poll() is None:
                time.sleep(0.02)
            seconds = {rank: sum(map(int, pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[11:13]))
                       for rank, pid in ranks_of(mpirun).items()}
            mpirun.send_signal(signal.SIGINT)
            mpirun.communicate(timeout=60)
        self.assertEqual(sorted(seconds), [0, 1, 2])
        self.assertGreater(min(seconds.values()), max(seconds.values()) / 5, seconds)

    def test_what_a_dying_rank_has_not_ended_is_made_again(self):
        for dying in (0, 2):
            with self.subTest(rank=dying):
                name = f"killed-{dying}"
                with self.start(3, *STUDY, "--seeds", 400, "--results", name) as mpirun:
                    while self.kept(name) < 4 and mpirun.poll() is None:
                        time.sleep(0.01)
                    os.kill(ranks_of(mpirun)[dying], signal.SIGKILL)
                    mpirun.communicate(timeout=60)
                self.assertNotEqual(mpirun.returncode, 0)
                left = rows(self.folder / name)
                self.assertTrue(4 <= len(left) < 1600, len(left))
                self.finish(self.start(2, *STUDY, "--seeds", 400, "--results", name))
                self.assertEqual(len(rows(self.folder / name)), 1600)
                self.assertLessEqual(set(left), set(rows(self.folder / name)))
        self.assertEqual(rows(self.folder / "killed-0"), rows(self.folder / "killed-2"))
        self.sweep(*STUDY[1:], "--seeds", 400, "--results", "whole")
        self.assertEqual(rows(self.folder / "killed-0"), rows(self.folder / "whole"))

    def test_what_a_rank_leaves_that_alone_is_stopped_is_missed(self):
        with self.start(3, *STUDY, "--seeds", 30, "--results", "left") as mpirun:
            while self.kept("left") < 4 and mpirun.poll() is None:
                time.sleep(0.01)
            os.kill(ranks_of(mpirun)[1], signal.SIGTERM)
            errors = self.finish(mpirun, code=130)
        self.assertIn("type the same command again to continue", errors)
        self.assertTrue(100 < self.kept("left") < 120, self.kept("left")) # the other ranks continued
        self.finish(self.start(2, *STUDY, "--seeds", 30, "--results", "left"))
        self.assertEqual(len(rows(self.folder / "left")), 120)

    def test_what_is_wrong_is_said_once(self):
        errors = self.finish(self.start(3, "sweep", FIGURE_E2, "slavs=1,2"), code=1)
        self.assertEqual(errors.count('the netlist has no val, attribute or parameter "slavs"'), 1, errors)
        errors = self.finish(self.start(3, *STUDY, "--measure", "master.T_ex"), code=1)
        self.assertEqual(errors.count('did you mean "master.T_exe"?'), 1, errors)

    def test_what_ranks_cannot_share_is_refused_once(self):
        (self.folder / "best.toml").write_text(f'netlist = "{FIGURE_E2}"\n[search]\nminimise = "time"\n'
                                               '[set]\nslaves = "0..3"\n', encoding="utf-8")
        for command, what in (("optimise", "best.toml"), ("explain", FIGURE_E2), ("run", FIGURE_E2)):
            errors = self.finish(self.start(2, command, what), code=1)
            self.assertEqual(errors.count(f"start {command} without mpirun"), 1, errors)
            self.assertEqual(errors.count("placedpar:"), 1, errors)
        self.assertFalse((self.folder / "best.sqlite").exists())

    def test_ranks_that_read_other_files_are_refused(self):
        netlist = FIGURE_E2.read_text(encoding="utf-8").replace("../workload.inc", str(FIGURE_E2.parent.parent / "workload.inc"))
        for part in ("software.inc", "mapping.inc"):
            netlist = netlist.replace(f'"{part}"', f'"{FIGURE_E2.parent / part}"')
        for rank, text in ((0, netlist), (1, netlist.replace("val exchange_every 3", "val exchange_every 4"))):
            (self.folder / str(rank)).mkdir()
            (self.folder / str(rank) / "e2.cfs").write_text(text, encoding="utf-8")
        script = 'cd $OMPI_COMM_WORLD_RANK && exec "$@"'
        command = [MPIRUN, "--oversubscribe", "-n", "2", "sh", "-c", script, "sh", PROGRAM, "sweep", "e2.cfs", "slaves=0..3"]
        run = subprocess.run(command, cwd=self.folder, env=ENVIRONMENT, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("rank 1: its netlist, its options or its version of PlacedPar differ from those of rank 0", run.stderr)


class WithoutMpi(InFolder):
    def test_it_says_what_is_missing(self):
        alone = self.folder / "placedpar"
        shutil.copy(PROGRAM, alone)
        run = subprocess.run([alone, *STUDY], cwd=self.folder, capture_output=True, text=True, check=False,
                             env={**os.environ, "OMPI_COMM_WORLD_SIZE": "2"})
        self.assertEqual(run.returncode, 1)
        self.assertIn("built without MPI: install libboost-mpi1.81-dev and openmpi-bin", run.stderr)


if __name__ == "__main__":
    unittest.main()
