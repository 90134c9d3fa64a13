"""Tests checkpoints: a run that goes on from one makes the generations of a run that was never interrupted."""

import csv
import json
import pathlib
import random
import resource
import signal
import subprocess
import tempfile
import time
import unittest

from program import EXAMPLES, PROGRAM, placedpar

ISLANDS = EXAMPLES / "genetic/islands/islands.cfs"
FARM = EXAMPLES / "genetic/farms/farm.cfs"
# Two islands that search for the least value of a function, or for the shortest tour.
OBJECTIVE = """
val problem "rastrigin";
workstation sun;
T800 t[2];
connect t[0].link[0] to t[1].link[0];
rep i = 0 for 2 connect sun.link[i] to t[i].link[3];
process host;
process island[2];
use "ga.host" for host;
host (problem = problem, generations = 60);
place host on sun;
rep i = 0 for 2 {
    use "ga.island" for island[i];
    island[i] (problem = problem, population = 20, elite = 1);
    connect host.to_masters[i] to island[i].from_host;
    connect island[i].to_neighbours[0] to island[1 - i].from_neighbours[0];
    place island[i] on t[i];
}
"""


def crc64(data):
    """Returns the CRC-64 of ECMA-182, as in xz."""
    value = 2 ** 64 - 1
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = value >> 1 ^ (0xC96C5795D7870F42 if value & 1 else 0)
    return value ^ 2 ** 64 - 1


def sealed(stored):
    """Returns the text of a checkpoint file with these contents and their checksum."""
    contents = {name: value for name, value in stored.items() if name != "checksum"}
    text = json.dumps(contents, separators=(",", ":")).encode()
    return json.dumps({**contents, "checksum": f"{crc64(len(text).to_bytes(8, 'little') + text):016x}"})


def results(netlist, *arguments):
    """Returns what the searches found, and the hash of all their generations."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder, "report.json")
        run = placedpar("run", netlist, "--json", report, *arguments)
        if run.returncode != 0:
            raise AssertionError(run.stdout + run.stderr)
        found = json.loads(report.read_text(encoding="utf-8"))
    timed = {"s", "ms", "1/s"}
    return [each for each in found["measurements"] if each["unit"] not in timed and each["name"] != "tasks"]


class Checkpoints(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name, "search.checkpoint")
        self.objective = pathlib.Path(folder.name, "objective.cfs")
        self.objective.write_text(OBJECTIVE, encoding="utf-8")

    def searches(self):
        return (
            (ISLANDS, ()),
            (ISLANDS, ("--set", "schedule=sequential", "--set", "topology=ring", "--set", "acceptance=offspring")),
            (self.objective, ()),
            (self.objective, ("--set", "problem=tour-random")),
            (FARM, ()),
        )

    def generation(self):
        return json.loads(self.file.read_text(encoding="utf-8"))["generation"]

    def stop_in_the_middle(self, netlist, *arguments):
        whole = placedpar("run", netlist, *arguments, "--json", "-")
        half = json.loads(whole.stdout)["time_ps"] // 2
        run = placedpar("run", netlist, *arguments, "--checkpoint", self.file, "--until", f"{half}ps")
        self.assertEqual(run.returncode, 0, run.stderr)
        return self.generation()

    def test_a_run_goes_on_with_the_same_generations(self):
        for netlist, arguments in self.searches():
            expected = results(netlist, *arguments)
            for other in ((), ("--native", "--threads", "2"), ("--native", "--threads", "3")):
                with self.subTest(netlist=netlist, arguments=arguments, other=other):
                    begin = self.stop_in_the_middle(netlist, *arguments)
                    self.assertGreater(begin, 0)
                    self.assertEqual(results(netlist, *arguments, "--checkpoint", self.file, *other), expected)
                    self.assertGreater(self.generation(), begin)
                    self.file.unlink()

    def test_generations_of_the_first_run_are_not_made_again(self):
        begin = self.stop_in_the_middle(ISLANDS)
        log = self.file.with_name("log.csv")
        run = placedpar("run", ISLANDS, "--checkpoint", self.file, "--log", log)
        self.assertIn(f"placedpar: continues from {self.file}, after generation {begin}\n", run.stderr)
        rows = log.read_text(encoding="utf-8").splitlines()
        numbers = {int(row.split(",")[rows[0].split(",").index("generation")]) for row in rows[1:]}
        self.assertEqual(min(numbers), begin + 1)

    def best_values(self, *arguments):
        """Returns the best value so far of each search and generation in the log of a run."""
        log = self.file.with_name("log.csv")
        run = placedpar("run", *arguments, "--log", log)
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(log, newline="", encoding="utf-8") as file:
            return {(int(row["generation"]), row["process"]): row["value"] for row in csv.DictReader(file)
                    if row["quantity"] == "best_so_far"}

    def test_best_values_include_those_before_the_checkpoint(self):
        cruel = ("--set", "mutation=0.3", "--set", "population=8")  # the best individual is often lost
        for netlist, arguments in ((ISLANDS, ()), (self.objective, cruel)):
            with self.subTest(netlist=netlist):
                whole = self.best_values(netlist, *arguments)
                begin = self.stop_in_the_middle(netlist, *arguments)
                later = self.best_values(netlist, *arguments, "--checkpoint", self.file)
                self.assertEqual(later, {place: value for place, value in whole.items() if place[0] > begin})
                self.file.unlink()

    def progress(self, *arguments):
        """Returns who first found the best value and when, and the generation of 99 % of each search."""
        report = self.file.with_name("report.json")
        run = placedpar("run", self.objective, "--json", report, *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        searches = json.loads(report.read_text(encoding="utf-8"))["searches"]
        finder = [line for line in run.stdout.splitlines() if line.startswith("best of all: ")]
        return finder, {each["process"]: each["generation_at_99_percent"] for each in searches}

    def test_a_report_names_the_generations_before_the_checkpoint(self):
        cruel = ("--set", "mutation=0.3", "--set", "population=8")  # the best individual is often lost
        for arguments in ((), cruel):
            with self.subTest(arguments=arguments):
                whole = self.progress(*arguments)
                self.assertRegex(whole[0][0], r"first found by island\[\d\] in generation \d+$")
                for generations in (20, 40, 60):
                    part = self.progress(*arguments, "--checkpoint", self.file, "--set", f"generations={generations}")
                self.assertEqual(part, whole)
                self.file.unlink()

    def test_it_goes_on_with_another_number_of_processors(self):
        expected = results(ISLANDS)
        self.stop_in_the_middle(ISLANDS)
        self.assertEqual(results(ISLANDS, "--checkpoint", self.file, "--set", "processors=2"), expected)

    def test_a_killed_run_leaves_a_whole_file(self):
        expected = results(ISLANDS)
        chance = random.Random(5)
        begun = []
        for _ in range(12):
            with subprocess.Popen([PROGRAM, "run", ISLANDS, "--native", "--checkpoint", self.file,
                                   "--checkpoint-every", "1"], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as run:
                time.sleep(chance.uniform(0.02, 0.2))
                run.send_signal(signal.SIGKILL)
            begun.append(self.generation() if self.file.exists() else 0)
        self.assertEqual(begun, sorted(begun))
        self.assertGreater(begun[-1], 0)
        self.assertEqual(results(ISLANDS, "--native", "--checkpoint", self.file), expected)

    def test_a_checkpoint_that_cannot_be_written_ends_the_run(self):
        self.stop_in_the_middle(ISLANDS)
        before = self.file.read_bytes()

        def limited():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

        run = subprocess.run([PROGRAM, "run", ISLANDS, "--checkpoint", self.file], capture_output=True, text=True,
                             check=False, preexec_fn=limited)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, r"search\.checkpoint.*File too large")
        self.assertEqual(self.file.read_bytes(), before)


class Refusals(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name, "search.checkpoint")

    def refused(self, *arguments, netlist=ISLANDS):
        run = placedpar("run", netlist, "--checkpoint", self.file, *arguments)
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        return run.stderr

    def test_of_another_seed_or_other_searches(self):
        placedpar("run", ISLANDS, "--checkpoint", self.file)
        self.assertIn("the checkpoint has seed 1, but this run has 2: ", self.refused("--seed", "2"))
        self.assertIn("the checkpoint has search count 8, but this run has 4: ",
                      self.refused("--set", "islands=4", "--set", "processors=4", "--set", "population=15"))
        self.assertIn("the checkpoint has island[0].population = 15, but this run has 20: ",
                      self.refused("--set", "population=20"))

    def test_of_a_later_generation_than_the_last_one(self):
        placedpar("run", ISLANDS, "--checkpoint", self.file)
        stored = json.loads(self.file.read_text(encoding="utf-8"))
        for generation in (10000, 2 ** 64 - 1):
            self.file.write_text(sealed({**stored, "generation": generation}), encoding="utf-8")
            self.assertIn("this search ends with generation 80, before the generation of the checkpoint: ",
                          self.refused())

    def test_of_searches_whose_results_no_checkpoint_holds(self):
        self.assertIn("belongs to a pair of a coarse and a fine search, and has a bias point, which a checkpoint cannot store",
                      self.refused(netlist=EXAMPLES / "genetic/coarse-fine/pair.cfs"))
        self.assertIn("no process of", self.refused(netlist=EXAMPLES / "csp/commstime/commstime.cfs"))
        self.assertIn("--seeds asks for 3 runs", self.refused("--seeds", "3"))

    def test_of_files_that_are_no_checkpoints(self):
        placedpar("run", ISLANDS, "--checkpoint", self.file)
        good = self.file.read_text(encoding="utf-8")
        stored = json.loads(good)
        for name, value in (("generation", -1), ("generation", 0), ("searches", {})):
            self.file.write_text(sealed({**stored, name: value}), encoding="utf-8")
            self.assertIn("this is not a checkpoint of a search", self.refused())
        self.file.write_text(json.dumps({**stored, "placedpar": "checkpoint 1"}), encoding="utf-8")
        self.assertIn("another version of PlacedPar wrote this checkpoint", self.refused())
        for text in ("", "{", good[:len(good) // 2], good + "x", "[" * 100000, "\0"):
            self.file.write_text(text, encoding="utf-8")
            self.assertIn("this is not a checkpoint of a search", self.refused())
        self.file.write_text(good.replace('"generation": ', '"generation": 1'), encoding="utf-8")
        self.assertIn("its checksum is not that of its contents, so the file is damaged", self.refused())
        self.file.write_text(sealed(json.loads(good.replace('"population": [', '"population": ["01",'))), encoding="utf-8")
        self.assertIn("the checkpoint belongs to another search: expected 15 strings of this search's representation", self.refused())
        self.file.unlink()
        self.file.mkdir()
        self.assertIn("Is a directory", self.refused())


if __name__ == "__main__":
    unittest.main()
