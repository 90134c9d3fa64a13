"""Tests runs on threads: `placedpar run --native` makes the generations and results of the simulated run."""

import csv
import io
import json
import pathlib
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from program import EXAMPLES, PROGRAM, placedpar

# Netlists whose generations do not depend on the order of messages.
SEARCHES = {
    "genetic/islands/islands.cfs": [],
    "genetic/coarse-fine/pair.cfs": [],
    "genetic/farms/farm.cfs": [],
    "thesis/figure-e2/figure-e2.cfs": [],
    "thesis/table-e1/cluster.cfs": [],
}
THREADS = (1, 2, 3, 5)


def generations(netlist, *arguments, program=placedpar):
    """Returns the rows of the log, without their times. `program` runs placedpar."""
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "log.csv")
        run = program("run", netlist, "--log", log, *arguments)
        if run.returncode != 0:
            raise AssertionError(run.stdout + run.stderr)
        return [{**row, "time_ms": ""} for row in csv.DictReader(io.StringIO(log.read_text(encoding="utf-8")))]


def results(netlist, *arguments, program=placedpar):
    """Returns how the run ended, and what its processes measured that does not depend on times. Who gets a task of the
    farm does, and how many packets a buffer holds; so tasks are added up."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        program("run", netlist, "--json", report, *arguments)
        found = json.loads(report.read_text(encoding="utf-8"))
    timed = {"s", "ms", "us", "ns", "Kbyte/s", "1/s", "%"}
    lasting = [each for each in found["measurements"]
               if each["unit"] not in timed and each["name"] not in ("tasks", "most_held", "last_number")]
    last = {each["value"] for each in found["measurements"] if each["name"] == "last_number"}
    return (found["outcome"], lasting, sum(each["value"] for each in found["measurements"] if each["name"] == "tasks"),
            last if netlist.parent.name != "farm" else set())


def classics():
    """Returns the netlists of pure CSP."""
    return [each for each in sorted(EXAMPLES.glob("csp/*/*.cfs")) if "own-process" not in str(each)]


class Generations(unittest.TestCase):
    def test_are_those_of_the_simulated_run(self):
        for name, arguments in SEARCHES.items():
            netlist = EXAMPLES / name
            simulated = generations(netlist, *arguments)
            self.assertGreater(len(simulated), 10)
            for threads in THREADS:
                with self.subTest(netlist=name, threads=threads):
                    self.assertEqual(generations(netlist, "--native", "--threads", threads, *arguments), simulated)


class Results(unittest.TestCase):
    def test_of_every_classic_are_those_of_the_simulated_run(self):
        netlists = classics()
        self.assertGreater(len(netlists), 5)
        for netlist in netlists:
            simulated = results(netlist)
            for threads in THREADS:
                with self.subTest(netlist=netlist, threads=threads):
                    self.assertEqual(results(netlist, "--native", "--threads", threads), simulated)


class Messages(unittest.TestCase):
    def test_between_threads_have_the_bytes_of_the_simulated_links(self):
        with tempfile.TemporaryDirectory() as folder:
            def reported(*arguments):
                path = pathlib.Path(folder, "report.json")
                run = placedpar("run", EXAMPLES / "genetic/coarse-fine/pair.cfs", "--json", path, *arguments)
                self.assertEqual(run.returncode, 0, run.stderr)
                return json.loads(path.read_text(encoding="utf-8"))
            simulated, native = reported(), reported("--native", "--threads", 3)
        thread_of = {one["on"]: other["on"] for one, other in zip(simulated["processes"], native["processes"])}
        links = {(thread_of[each["from"].split(".")[0]], thread_of[each["to"].split(".")[0]]): each["bytes"]
                 for each in simulated["links"] if each["bytes"] > 0}
        self.assertEqual({(each["from"], each["to"]): each["bytes"] for each in native["messages"]}, links)
        self.assertEqual(len(links), 3)


FARM = EXAMPLES / "genetic/farms/farm.cfs"


def threads_of_processes(*arguments):
    """Returns the thread on which each process of the farm ran."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        run = placedpar("run", FARM, "--native", "--threads", 2, "--json", report, *arguments)
        if run.returncode != 0:
            raise AssertionError(run.stdout + run.stderr)
        return {each["name"]: each["on"]
                for each in json.loads(report.read_text(encoding="utf-8"))["processes"]}


class Placement(unittest.TestCase):
    def test_is_in_turn_or_by_the_loads_of_a_simulated_run(self):
        in_turn = threads_of_processes()
        self.assertEqual(in_turn, threads_of_processes("--map", "modulo"))
        self.assertEqual([in_turn[f"slave[{i}]"] for i in range(3)], ["thread 1", "thread 0", "thread 1"])
        # The simulated master is busy for 98 % of the time, each slave for 58 %: 98 + 58 or 3 * 58 on a thread.
        by_load = threads_of_processes("--map", "balance", "--set", "slaves=4", "--set", "links=3")
        self.assertEqual(by_load["master"], "thread 0")
        self.assertEqual(sorted(by_load[f"slave[{i}]"] for i in range(4)), ["thread 0"] + 3 * ["thread 1"])

    def test_follows_ranks_and_keeps_the_generations(self):
        by_rank = threads_of_processes("--map", "balance", "--set", "t[1].rank=1", "--set", "t[2].rank=1",
                                       "--set", "t[3].rank=1")
        self.assertEqual({by_rank[f"slave[{i}]"] for i in range(3)}, {"thread 1"})
        self.assertEqual(by_rank["master"], "thread 0")
        simulated = generations(FARM)
        self.assertEqual(generations(FARM, "--set", "rank=7"), simulated)
        self.assertEqual(generations(FARM, "--native", "--threads", 3, "--map", "balance"), simulated)

    def test_refuses_a_rank_without_a_thread(self):
        run = placedpar("run", FARM, "--native", "--threads", 2, "--set", "t[1].rank=2")
        self.assertEqual(run.returncode, 1)
        self.assertIn('farm.cfs:19:', run.stderr)
        self.assertIn('"t[1]" has rank = 2, but the run has 2 threads', run.stderr)
        run = placedpar("run", FARM, "--map", "balance")
        self.assertEqual((run.returncode, "--map is for native runs: give --native" in run.stderr), (1, True))


class Endings(unittest.TestCase):
    def test_a_deadlock_has_its_cycle_and_exit_code(self):
        run = placedpar("run", EXAMPLES / "csp/deadlock/ring.cfs", "--native", "--threads", 3)
        self.assertEqual(run.returncode, 2)
        self.assertIn("wait cycle: buffer[0] -> buffer[2] -> buffer[1] -> buffer[0]", run.stdout)

    def test_a_thousand_threads_run_and_more_are_refused(self):
        ring = EXAMPLES / "csp/deadlock/ring.cfs"
        run = placedpar("run", ring, "--native", "--threads", 1024, "--set", "n=1024")
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("thread 1023", run.stdout)
        run = placedpar("run", ring, "--native", "--threads", 5000)
        self.assertEqual((run.returncode, '"5000" is not a whole number from 1 to 1024' in run.stderr), (1, True))

    def test_ctrl_c_ends_a_run_within_a_second(self):
        run = subprocess.Popen([PROGRAM, "run", EXAMPLES / "genetic/islands/islands.cfs", "--native", "--set",
                                "trials=1000000"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(1)
        self.assertIsNone(run.poll())
        run.send_signal(signal.SIGINT)
        begun = time.monotonic()
        out, _ = run.communicate(timeout=20)
        self.assertLess(time.monotonic() - begun, 1)
        self.assertEqual(run.returncode, 130)
        self.assertIn("interrupted", out)

    def test_a_thread_that_cannot_be_started_ends_the_run(self):
        def few_threads():
            resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))  # 2 Gbyte have no room for the stacks of 400
            resource.setrlimit(resource.RLIMIT_STACK, (8 << 20, 8 << 20))
        run = subprocess.run([PROGRAM, "run", EXAMPLES / "csp/deadlock/ring.cfs", "--native", "--set", "n=400",
                              "--threads", "400"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             preexec_fn=few_threads, timeout=60, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"thread \d+ of 400 cannot be started: .*: give a smaller number to --threads")

    def test_what_only_simulated_runs_have_is_refused(self):
        netlist = EXAMPLES / "csp/deadlock/ring.cfs"
        for option in (["--until", "1ms"], ["--seeds", "2"], ["--shuffle", "1"]):
            run = placedpar("run", netlist, "--native", *option)
            self.assertEqual(run.returncode, 1, option)
            self.assertIn(f"{option[0]}: only simulated runs have this option", run.stderr)
        for option in (["--threads", 2], ["--pace", 1]):
            run = placedpar("run", netlist, *option)
            self.assertEqual((run.returncode, f"{option[0]} is for native runs: give --native" in run.stderr), (1, True))
        for pace in ("0", "-1", "nan", "1e9", "fast"):
            run = placedpar("run", netlist, "--native", "--pace", pace)
            self.assertEqual((run.returncode, "is not a number from 1e-06 to 1000000" in run.stderr), (1, True), pace)
        run = placedpar("run", EXAMPLES / "occam/network/table.cfs", "--native")
        self.assertEqual((run.returncode, "executes the code of a transputer" in run.stderr), (1, True))


if __name__ == "__main__":
    unittest.main()
