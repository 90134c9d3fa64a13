"""Tests mpirun placedpar run --native: the results do not depend on the number of ranks, whatever ends the run."""

import concurrent.futures
import os
import pathlib
import random
import signal
import subprocess
import tempfile
import time
import unittest

from native_test import classics, generations, results
from program import EXAMPLES, PROGRAM, placedpar
from ranks_test import ENVIRONMENT, MODULE, MPIRUN, ranks_of

RING = EXAMPLES / "csp/deadlock/ring.cfs"
ISLANDS = EXAMPLES / "genetic/islands/islands.cfs"
# A process that waits ten seconds for a packet that never comes.
IDLE = """T800 t[2];
connect t[0].link[0] to t[1].link[0];
process (interface (input in, output out)) identity;
process (interface (input in, output out[2])) delta;
process (interface (input in)) receiver;
use "csp.identity" for identity;
use "csp.delta" for delta;
use "csp.receiver_or_fail" for receiver;
receiver (timeout = 10000000);
connect identity.out to delta.in;
connect delta.out[0] to identity.in;
connect delta.out[1] to receiver.in;
place identity on t[0]; place delta on t[0]; place receiver on t[1];
"""
SMALL = ("search.cfs", "demonstration.cfs")  # netlists of two processors
# Receivers whose time-outs end again and again just when a message comes.
TIME_OUTS = """val pairs 12;
T800 (clock = 20M, rank = 0) a[pairs];
T800 (clock = 20M, rank = 1) b[pairs];
rep i = 0 for pairs connect a[i].link[0] to b[i].link[0];
process tx[pairs], rx[pairs];
use "csp.producer" for tx;
use "csp.receiver_or_fail" for rx;
tx (count = 1000, cycles = 700);
rx (count = 1000, timeout = 30, patience = 1000000);
rep i = 0 for pairs { connect tx[i].out to rx[i].in; place tx[i] on a[i]; place rx[i] on b[i]; }
"""
LONG = ("run", ISLANDS, "--native", "--set", "trials=1000000")


def start(ranks, *arguments, **options):
    command = [MPIRUN, "--oversubscribe", "-n", str(ranks), PROGRAM, *map(str, arguments)]
    return subprocess.Popen(command, env=ENVIRONMENT, text=True, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, **options)


def on(ranks):
    """Returns a function that runs placedpar on so many ranks, as placedpar() does without mpirun."""
    def run(*arguments):
        with start(ranks, *arguments) as mpirun:
            out, errors = mpirun.communicate(timeout=60)
        return subprocess.CompletedProcess(arguments, mpirun.returncode, out, errors)
    return run


def seconds_of(process):
    """Returns how long a process has computed."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@unittest.skipUnless(MPIRUN and MODULE.exists(), "built without MPI")
class OnRanks(unittest.TestCase):
    def compare(self, netlists, measured):
        """Compares what a function measures, of a simulated run and of runs on 2 and 3 ranks. Several mpiruns run at
        once, since each waits most of the time."""
        cases = [(netlist, ranks) for netlist in netlists for ranks in (2, 3) if ranks == 2 or netlist.name not in SMALL]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            simulated = dict(zip(netlists, pool.map(measured, netlists)))
            found = pool.map(lambda case: measured(case[0], "--native", program=on(case[1])), cases)
            for (netlist, ranks), each in zip(cases, found):
                with self.subTest(netlist=netlist, ranks=ranks):
                    self.assertEqual(each, simulated[netlist])
        return simulated

    def test_generations_are_those_of_the_simulated_run(self):
        netlists = [each for each in (*EXAMPLES.glob("genetic/*/*.cfs"), *EXAMPLES.glob("thesis/*/*.cfs"))
                    if not each.parent.name.startswith("own-")]  # those need a program of their own
        self.assertGreater(len(netlists), 7)
        self.assertTrue(all(len(each) > 10 for each in self.compare(netlists, generations).values()))

    def test_results_of_every_classic_are_those_of_the_simulated_run(self):
        self.compare(classics(), results)

    def test_a_deadlock_has_its_cycle_over_ranks(self):
        run = on(3)("run", RING, "--native")
        self.assertEqual(run.returncode, 2)
        self.assertIn("wait cycle: buffer[0] -> buffer[2] -> buffer[1] -> buffer[0]", run.stdout)
        self.assertIn("buffer[2]  rank 2", run.stdout)
        self.assertEqual(run.stdout.count("wait cycle"), 1)  # rank 0 alone prints

    def test_ctrl_c_ends_all_ranks_soon_and_prints_the_results_so_far(self):
        with start(3, *LONG) as mpirun:
            while len(ranks_of(mpirun)) < 3:
                time.sleep(0.01)
            time.sleep(3)  # MPI begins slowly while tests run beside
            for rank in ranks_of(mpirun).values():  # as mpirun does, which itself ends the output of the ranks
                os.kill(rank, signal.SIGINT)
            begun = time.monotonic()
            out, _ = mpirun.communicate(timeout=20)
        self.assertLess(time.monotonic() - begun, 4)  # a second alone; tests run beside
        self.assertEqual(mpirun.returncode, 130)
        self.assertIn("interrupted", out)
        self.assertIn("island[7]", out)

    def test_an_interrupted_mpirun_prints_the_results_so_far_and_leaves_no_rank(self):
        with start(2, *LONG) as mpirun:
            while len(ranks_of(mpirun)) < 2:
                time.sleep(0.01)
            time.sleep(0.5)
            ranks = ranks_of(mpirun).values()
            mpirun.send_signal(signal.SIGINT)
            out, _ = mpirun.communicate(timeout=20)
        self.assertNotEqual(mpirun.returncode, 0)
        self.assertIn("interrupted", out)
        until = time.monotonic() + 3
        while time.monotonic() < until and any(pathlib.Path(f"/proc/{each}").exists() for each in ranks):
            time.sleep(0.01)
        self.assertLess(time.monotonic(), until)

    def test_ctrl_c_while_loads_are_simulated_ends_all_ranks(self):
        with start(2, *LONG, "--map", "balance") as mpirun:
            while len(ranks_of(mpirun)) < 2:
                time.sleep(0.01)
            time.sleep(1)
            for rank in ranks_of(mpirun).values():
                os.kill(rank, signal.SIGINT)
            _, errors = mpirun.communicate(timeout=20)
        self.assertEqual(mpirun.returncode, 1)
        self.assertEqual(errors.count("interrupted before the run began"), 1, errors)

    def test_a_killed_rank_ends_the_run(self):
        chance = random.Random(1)
        for dying in (0, 1, 2):
            with self.subTest(rank=dying), start(3, *LONG) as mpirun:
                while len(ranks_of(mpirun)) < 3:
                    time.sleep(0.01)
                time.sleep(chance.uniform(0, 0.5))
                os.kill(ranks_of(mpirun)[dying], signal.SIGKILL)
                begun = time.monotonic()
                _, errors = mpirun.communicate(timeout=20)
                self.assertLess(time.monotonic() - begun, 5)
                self.assertNotEqual(mpirun.returncode, 0)
                self.assertIn(f"rank {dying} ", errors)

    def test_a_killed_run_goes_on_from_its_checkpoint_with_another_number_of_ranks(self):
        expected = results(ISLANDS)
        chance = random.Random(2)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "search.checkpoint")
            kept = ("--native", "--checkpoint", file, "--checkpoint-every", "1")
            for ranks in (3, 2, 3):
                before = file.read_bytes() if file.exists() else b""
                with start(ranks, "run", ISLANDS, *kept) as mpirun:
                    while (not file.exists() or file.read_bytes() == before) and mpirun.poll() is None:
                        time.sleep(0.001)
                    time.sleep(chance.uniform(0, 0.02))
                    os.kill(ranks_of(mpirun)[1], signal.SIGKILL)
                    _, errors = mpirun.communicate(timeout=20)
                    self.assertNotEqual(mpirun.returncode, 0)
                    self.assertIn("rank 1 ", errors)
            self.assertEqual(results(ISLANDS, *kept, program=on(2)), expected)
            self.assertEqual(results(ISLANDS, "--checkpoint", file), expected)

    def test_a_message_that_comes_just_when_an_input_is_given_up_is_not_lost(self):
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder, "time-outs.cfs")
            netlist.write_text(TIME_OUTS, encoding="utf-8")
            for _ in range(3):
                self.assertEqual(on(2)("run", netlist, "--native", "--pace", "1").returncode, 0)

    def test_an_idle_rank_uses_hardly_any_of_a_core(self):
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder, "wait.cfs")
            netlist.write_text(IDLE, encoding="utf-8")
            with start(2, "run", netlist, "--native") as mpirun:
                while len(ranks_of(mpirun)) < 2:
                    time.sleep(0.01)
                time.sleep(1)
                ranks = ranks_of(mpirun).values()
                before = [seconds_of(each) for each in ranks]
                time.sleep(2)
                used = [seconds_of(each) - earlier for each, earlier in zip(ranks, before)]
                for rank in ranks:
                    os.kill(rank, signal.SIGINT)
                mpirun.communicate(timeout=20)
        self.assertLess(max(used), 0.1, "of 2 s; a rank that polls uses 2 s")


@unittest.skipUnless(MPIRUN and MODULE.exists(), "built without MPI")
class Refused(unittest.TestCase):
    def refused(self, run, message):
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertEqual(run.stderr.count(message), 1, run.stderr)

    def test_more_ranks_than_processors(self):
        self.refused(on(4)("run", RING, "--native"), "there are 4 ranks, but only 3 processors have processes: start at most 3 ranks")

    def test_threads_of_a_rank(self):
        self.refused(on(2)("run", RING, "--native", "--threads", 2), "start more ranks")

    def test_wrong_netlists_and_options_are_reported_once(self):
        self.refused(on(2)("run", "/nowhere/at-all.cfs", "--native"), "/nowhere/at-all.cfs")
        self.refused(on(2)("run", RING, "--native", "--seeds", 2), "--seeds: only simulated runs have this option")
        self.refused(on(2)("run", RING, "--native", "--log", "log.csv"), "so no generations can be logged")

    def test_a_rank_with_another_netlist(self):
        with tempfile.TemporaryDirectory() as folder:
            for rank, capacity in enumerate(("1M", "2M")):
                text = RING.read_text(encoding="utf-8").replace("memory = 1M", f"memory = {capacity}")
                pathlib.Path(folder, f"{rank}.cfs").write_text(text, encoding="utf-8")
            script = f'exec "$0" run {folder}/$OMPI_COMM_WORLD_RANK.cfs --native'
            with subprocess.Popen([MPIRUN, "--oversubscribe", "-n", "2", "sh", "-c", script, PROGRAM], env=ENVIRONMENT,
                                  text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as mpirun:
                out, errors = mpirun.communicate(timeout=60)
        self.refused(subprocess.CompletedProcess([], mpirun.returncode, out, errors), "rank 1: its netlist, its options")

    def test_one_rank_is_a_run_on_threads(self):
        run = on(1)("run", RING, "--native", "--threads", 3)
        self.assertEqual(run.returncode, 2)
        self.assertIn("thread 2", run.stdout)


if __name__ == "__main__":
    unittest.main()
