"""Tests placedpar optimise: it finds the best machine of a study despite interruptions, and refuses wrong studies."""

import contextlib
import csv
import json
import os
import pathlib
import pty
import re
import signal
import sqlite3
import subprocess
import tempfile
import time
import unittest
import xml.etree.ElementTree

from program import EXAMPLES, PROGRAM, placedpar

MACHINE = EXAMPLES / "explore/best-machine" / "machine.cfs"

# Some settings need more than the four links of a transputer: the netlist itself states this constraint.
NETLIST = """
val wires 1;
val cycles 90000;
T800 a, b;
process source, sink;
use "csp.producer" for source;
use "csp.consumer" for sink;
source (count = 1, cycles = cycles / wires + 1700 * wires);
sink (count = 1);
place source on a;
place sink on a;
connect source.out to sink.in;
rep i = 0 for wires
    connect a.link[i] to b.link[i];
"""
STUDY = """
netlist = "small.cfs"
[search]
minimise = {minimise}
population = 12
generations = 12
[set]
wires = "1..8"
cycles = [100000, 200000, 300000]
"""
FARM = f"""
netlist = "{MACHINE}"
where = "masters <= 4"
[search]
minimise = "time"
population = 12
generations = 6
[set]
samples = 6
masters = "1..6"
links = "1..2"
split = ["individuals", "demand", "evaluations"]
"""
# Only two of the eight machines complete.
MOSTLY_DEADLOCKED = """
val a 0;
T800 t;
process source, sink;
use "csp.producer" for source;
use "csp.consumer" for sink;
source (count = 1, cycles = 100 + a);
sink (count = a < 6 ? 2 : 1);
place source on t;
place sink on t;
connect source.out to sink.in;
"""
# A run takes long enough to be interrupted.
LONG = """
val a 1;
T800 t;
process source, sink;
use "csp.producer" for source;
use "csp.consumer" for sink;
source (count = 300000, cycles = a);
sink (count = 300000);
place source on t;
place sink on t;
connect source.out to sink.in;
"""
SPHERE = """
T800 t;
workstation sun;
connect sun.link[0] to t.link[0];
process host, master;
use "ga.host" for host;
use "ga.master" for master;
host (problem = "sphere", generations = 5, accuracy = 0.1);
master (problem = "sphere", population = 8);
connect host.to_masters[0] to master.from_host;
connect master.to_host to host.from_masters[0];
place host on sun;
place master on t;
"""


def best_line(output):
    return re.search(r"^the best: (.*)$", output, re.MULTILINE).group(1)


class Optimise(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("small.cfs", NETLIST)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def small(self, minimise='"time"'):
        return self.write("small.toml", STUDY.format(minimise=minimise))

    def optimise(self, *arguments, code=0, **options):
        done = placedpar("optimise", *arguments, folder=self.folder, **options)
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        return done.stdout if code == 0 else done.stderr

    def refuses(self, text, *messages, arguments=(), name="refused.toml"):
        said = self.optimise(self.write(name, text), *arguments, code=1)
        for message in messages:
            self.assertIn(message, said)

    def rows(self, path="small.sqlite"):
        with contextlib.closing(sqlite3.connect(self.folder / path)) as database:
            return list(database.execute("SELECT * FROM runs ORDER BY settings, seed"))


class Found(Optimise):
    def test_the_best_is_that_of_the_exhaustive_search_and_can_be_run_again(self):
        said = self.optimise(self.small(), "--exhaustive", "--random")
        least = {line.split()[0]: line.split()[2] for line in said.splitlines()
                 if line.startswith(("genetic", "random", "exhaustive"))}
        self.assertEqual(set(least), {"genetic", "random", "exhaustive"})
        self.assertEqual(least["genetic"], least["exhaustive"])
        again = placedpar(*best_line(said).split()[1:], folder=self.folder).stdout
        self.assertIn("completed at", again)
        self.assertAlmostEqual(float(again.split("completed at ")[1].split()[0]), float(least["genetic"]), places=5)

    def test_the_best_is_that_of_whichever_way_found_it(self):
        self.write("farm.toml", FARM)
        random_was_better = False
        for seed in range(1, 7):
            said = self.optimise("farm.toml", "--population", 4, "--generations", 1, "--random", "--seed", seed)
            least = {line.split()[0]: float(line.split()[2]) for line in said.splitlines() if line.startswith(("genetic", "random"))}
            random_was_better |= least["random"] < least["genetic"]
            again = placedpar(*best_line(said).split()[1:], folder=self.folder).stdout
            best = float(again.split("completed at ")[1].split()[0])
            self.assertAlmostEqual(best, min(least.values()), delta=1e-5 * best)
        self.assertTrue(random_was_better)

    def test_the_four_links_are_never_exceeded(self):
        said = self.optimise(self.small(), "--exhaustive")
        run = {row[0] for row in self.rows() if row[2] == "completed"}
        refused = {row[0] for row in self.rows() if row[2] == "refused"}
        self.assertTrue(all(re.search(r'"wires":"[1-4]"', settings) for settings in run - {"{}"}))
        self.assertTrue(all(re.search(r'"wires":"[5-8]"', settings) for settings in refused))
        self.assertIn("wires=4", best_line(said))
        self.assertRegex(said, r"exhaustive +12 ")

    def test_two_measures_give_a_front(self):
        self.optimise(self.small('["time", "links"]'), "--csv", "front.csv", "--svg", "front.svg")
        with open(self.folder / "front.csv", encoding="utf-8", newline="") as file:
            front = list(csv.DictReader(file))
        self.assertEqual([int(row["wires"]) for row in front], [4, 3, 2, 1])
        times = [float(row["time [ms] mean"]) for row in front]
        self.assertEqual(times, sorted(times))
        xml.etree.ElementTree.parse(self.folder / "front.svg")

    def test_why_it_is_the_best_adds_up_to_both_runs(self):
        said = self.optimise(self.write("farm.toml", FARM))
        table = said[said.index("on the critical path"):].split("\n\n")[0].splitlines()[1:]
        parts = [[float(cell) for cell in line.split()[:3]] for line in table]
        for column in range(2):
            self.assertAlmostEqual(sum(part[column] for part in parts[:-1]), parts[-1][column], places=1)
        again = placedpar(*best_line(said).split()[1:], folder=self.folder).stdout
        self.assertAlmostEqual(float(again.split("completed at ")[1].split()[0]), parts[-1][1], places=2)
        start = placedpar("run", MACHINE, "--set", "samples=6").stdout
        self.assertAlmostEqual(float(start.split("completed at ")[1].split()[0]), parts[-1][0], places=2)


    def test_another_way_that_finds_none_takes_nothing_away(self):
        self.write("mostly.cfs", MOSTLY_DEADLOCKED)
        for minimise in ('"time"', '["time", "links"]'):
            study = self.write("mostly.toml", f'netlist = "mostly.cfs"\n[search]\nminimise = {minimise}\n'
                                              'population = 4\ngenerations = 1\n[set]\na = "0..7"\n')
            said = self.optimise(study, "--random", "--exhaustive", "--svg", "mostly.svg")
            self.assertRegex(said, r"(?m)^random +3 +none$")
            self.assertRegex(said, r"(?m)^exhaustive +8 ")
            drawing = (self.folder / "mostly.svg").read_text(encoding="utf-8")
            self.assertIn("exhaustive", drawing)
            self.assertNotIn("random", drawing)

    def test_what_the_study_measures_is_in_its_report_too(self):
        study = self.write("small.toml", 'measure = ["max(a.busy)", "time"]\n' + STUDY.format(minimise='["time", "links"]'))
        self.optimise(study)
        self.assertRegex(placedpar("report", study, folder=self.folder).stdout,
                         r"runs +time \[ms\] +links +max\(a.busy\)")

    def test_parts_have_prices(self):
        """The machine has two T800s and `wires` wires: the cheapest has one wire."""
        study = self.write("small.toml", "price = {T800 = 300}\n" + STUDY.format(minimise='["price", "time"]'))
        self.optimise(study, "--price", "link=20")
        prices = {(json.loads(row[0]).get("wires", 1), json.loads(row[8])["price"][0]) for row in self.rows() if row[2] == "completed"}
        self.assertTrue(prices)
        for wires, price in prices:
            self.assertEqual(price, 600 + 20 * int(wires))
        self.assertIn("expected a number from 0", self.optimise(study, "--price", "link=-1", code=1))
        self.assertIn('unknown part with a price "T80"', self.optimise(study, "--price", "T80=1", code=1))

    def test_a_sweep_of_the_study_shows_what_is_minimised(self):
        said = placedpar("sweep", self.small('"links"'), folder=self.folder).stdout
        self.assertRegex(said, r"cycles +wires +runs +links\n")


class TimeToAccuracy(unittest.TestCase):
    TRUTH = 0.0086 # in^3/psi, the boom's compliance in the record

    @staticmethod
    def host(samples, accuracy, *settings):
        """Returns what the host measured over this many samples. A longer run begins with the same events."""
        said = placedpar("run", MACHINE, "--set", f"samples={samples}", "--set", f"accuracy={accuracy}", *settings)
        measured = re.findall(r"^host +(\S+) +(\S+)", said.stdout, re.MULTILINE)
        return {**dict(measured), "whole": said.stdout.split("completed at ")[1].split()[0]}

    def test_it_is_since_when_the_fittest_estimate_is_accurate_for_good(self):
        accuracy, since = 0.02, 0
        for samples in range(5, 21):
            host = self.host(samples, accuracy)
            accurate = abs(float(host["C_BOi"]) - self.TRUTH) <= accuracy * self.TRUTH
            self.assertEqual("accurate_after" in host, accurate, samples)
            if accurate:
                after = float(host["accurate_after"])
                self.assertGreaterEqual(after, since)
                self.assertLessEqual(after, float(host["whole"]))
            else: # permanently accurate only after this sample's last estimates
                since = float(self.host(samples, 1)["whole"]) - 45 # a sample takes 44.6 ms at most
        self.assertGreater(since, 0)

    def test_nobody_looks_unless_asked_and_without_a_truth_it_is_refused(self):
        self.assertNotIn("host", [line.split()[0] for line in placedpar("run", MACHINE).stdout.splitlines()[3:8]])
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder) / "sphere.cfs"
            netlist.write_text(SPHERE, encoding="utf-8")
            refused = placedpar("run", netlist)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("true parameters", refused.stderr)


class TheSame(Optimise):
    def test_whatever_runs_at_once_and_whatever_has_been_run(self):
        study = self.write("farm.toml", FARM)
        one = self.optimise(study, "--jobs", 1, "--results", "one.sqlite")
        two = self.optimise(study, "--jobs", 3, "--results", "two.sqlite")
        self.assertEqual(one.replace("one.sqlite", ""), two.replace("two.sqlite", ""))
        self.assertEqual(self.rows("one.sqlite"), self.rows("two.sqlite"))
        self.assertEqual(self.optimise(study, "--results", "one.sqlite"), one)
        self.assertEqual(self.rows("one.sqlite"), self.rows("two.sqlite"))

    def test_after_it_was_killed(self):
        study = self.write("farm.toml", FARM)
        whole = self.optimise(study, "--results", "whole.sqlite")
        for patience in (0.1, 0.4):
            with subprocess.Popen([PROGRAM, "optimise", study], cwd=self.folder, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) as process:
                time.sleep(patience)
                process.kill()
        self.assertEqual(self.optimise(study).replace("farm.sqlite", "whole.sqlite"), whole)
        self.assertEqual(self.rows("farm.sqlite"), self.rows("whole.sqlite"))

    def test_interrupted_it_says_so(self):
        study = self.write("farm.toml", FARM.replace("generations = 6", "generations = 600000"))
        with subprocess.Popen([PROGRAM, "optimise", study, "--seed", "2"], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as process:
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            said = process.communicate(timeout=60)[1]
        self.assertIn("type the same command again to continue", said)
        self.assertEqual(process.returncode, 130)

    def test_interrupted_when_the_best_is_known_it_says_what_it_is(self):
        self.write("long.cfs", LONG)
        study = self.write("long.toml", 'netlist = "long.cfs"\n[search]\nminimise = "time"\npopulation = 4\n'
                                        'generations = 1\n[set]\na = [1, 5]\n')
        outer, inner = pty.openpty()
        with subprocess.Popen([PROGRAM, "optimise", study, "--csv", "long.csv"], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=inner, text=True) as process:
            os.close(inner)
            told = b""
            while b"critical paths" not in told:
                told += os.read(outer, 4096)
            process.send_signal(signal.SIGINT)
            said = process.communicate(timeout=60)[0]
            with contextlib.suppress(OSError):
                while chunk := os.read(outer, 4096):
                    told += chunk
        os.close(outer)
        self.assertEqual(process.returncode, 130)
        self.assertIn(b"type the same command again to continue", told)
        self.assertNotIn("on the critical path", said)
        self.assertIn("a=1", best_line(said))
        self.assertTrue((self.folder / "long.csv").exists())

    def test_a_terminal_is_told_how_far_it_is(self):
        outer, inner = pty.openpty()
        study = self.write("farm.toml", FARM)
        with subprocess.Popen([PROGRAM, "optimise", study], cwd=self.folder, stdout=subprocess.DEVNULL,
                              stderr=inner) as process:
            os.close(inner)
            told = b""
            with contextlib.suppress(OSError):
                while chunk := os.read(outer, 4096):
                    told += chunk
        os.close(outer)
        self.assertEqual(process.returncode, 0)
        self.assertRegex(told, rb"generation \d of 6: \d+ machines")


class Prices(Optimise):
    def test_the_price_of_a_machine_can_be_minimised(self):
        study = STUDY.format(minimise='"price"').replace("[search]", "[price]\nlink = 20\n[search]")
        out = self.optimise(self.write("priced.toml", study))
        self.assertRegex(out, r"the best: .*--set wires=1 ")


class Refused(Optimise):
    def test_a_price_below_0(self):
        self.refuses(STUDY.format(minimise='"time"'), "--price T800=-1: expected a number from 0 to 1e12",
                     arguments=("--price", "T800=-1"))

    def test_what_is_no_search(self):
        self.refuses('netlist = "small.cfs"\n[set]\nwires = "1..2"\n', "the study has no table [search]")
        self.assertIn("a table [search]", self.optimise("small.cfs", code=1))
        self.refuses('netlist = "small.cfs"\n[search]\nminimise = []\n', "a search minimises one or two measures", "refused.toml:2:1")
        self.refuses('netlist = "small.cfs"\n[search]\nminimise = ["time", "links", "processors"]\n',
                     "a search minimises one or two measures")
        self.refuses('netlist = "small.cfs"\n[search]\nminimize = "time"\n', 'a search has no key "minimize"',
                     'did you mean "minimise"?')
        self.refuses(STUDY.format(minimise='"time"') + "[search]\n", "search")
        self.refuses(STUDY.format(minimise='"time"').replace("[search]", "[[search]]"), "the search must be a single table")
        for size, message in (("population = 3", "at least 4"), ("population = 10001", "at most 10000"),
                              ("generations = 0", "at least 1"), ("generations = 1000001", "at most 1000000")):
            name = size.split(" = ", maxsplit=1)[0]
            self.refuses(STUDY.format(minimise='"time"').replace(f"{name} = 12", size), message)

    def test_a_measure_that_no_run_has_before_any_is_made(self):
        for minimise, name, meant in (("tine", "tine", "time"), ("snik.time", "snik.time", "sink.time"),
                                      ("max(sink.tine)", "sink.tine", "sink.time"), ("a.bussy", "a.bussy", "a.busy")):
            self.refuses(STUDY.format(minimise=f'"{minimise}"'),
                         f'unknown measure "{name}"; did you mean "{meant}"?')
        self.refuses('measure = "sink.tine"\n' + STUDY.format(minimise='"time"'), 'did you mean "sink.time"?')
        self.refuses(STUDY.format(minimise='"sink.rat"').replace("[100000, 200000, 300000]", '"1..1000000"'),
                     'did you mean "sink.rate"?')
        self.assertFalse((self.folder / "refused.sqlite").exists())

    def test_a_measure_of_a_process_that_there_is_not(self):
        self.refuses(STUDY.format(minimise='"sink[3].time"'),
                     'unknown measure "sink[3].time"; did you mean "sink.time"?')

    def test_a_measure_that_some_machines_alone_have_is_none_to_refuse(self):
        self.write("small.cfs", NETLIST + "if wires > 3 {\n    process more, still;\n"
                                          '    use "csp.producer" for more;\n    use "csp.consumer" for still;\n'
                                          "    more (count = 1);\n    still (count = 1);\n    place more on a;\n"
                                          "    place still on a;\n    connect more.out to still.in;\n}\n")
        self.assertIn("wires=4", best_line(self.optimise(self.small('"still.time"'))))

    def test_a_measure_that_is_to_be_minimised_twice(self):
        self.refuses(STUDY.format(minimise='["time", "time"]'), "refused.toml:4:12", '"time" is named twice in minimise')

    def test_a_name_that_the_netlist_does_not_have(self):
        self.refuses(STUDY.format(minimise='"time"').replace("wires", "wirs"), "wirs", "wires")

    def test_a_space_without_machines(self):
        self.refuses(STUDY.format(minimise='"time"').replace("[search]", 'where = "wires > 9"\n[search]'),
                     "no combination satisfies the study's condition")
        self.refuses(STUDY.format(minimise='"time"').replace("1..8", "3").replace("[100000, 200000, 300000]", "100000"),
                     "the search has nothing to choose")
        self.refuses(STUDY.format(minimise='"time"') + "[[also]]\nset = {wires = 2}\n", "[[also]]")

    def test_more_machines_than_can_be_counted_before_any_is_run(self):
        self.refuses(STUDY.format(minimise='"time"') + 'a.clock = "1..100000000000000"\nb.clock = "1..100000000000000"\n',
                     "too many runs to count")
        self.assertFalse((self.folder / "refused.sqlite").exists())

    def test_nothing_is_written_over_what_is_read_or_kept(self):
        self.write("part.inc", "val unused 1;\n")
        self.write("small.cfs", '#include "part.inc"\n' + NETLIST)
        study = self.small()
        self.optimise(study)
        files = ("small.toml", "small.cfs", "part.inc", "small.sqlite")
        before = [(self.folder / file).read_bytes() for file in files]
        for file in files:
            for option in ("--csv", "--svg"):
                self.assertIn(f"{file}: cannot be written: the output file is also the input", self.optimise(study, option, file, code=1))
        self.assertEqual([(self.folder / file).read_bytes() for file in files], before)

    def test_all_infeasible_says_what_refused_them(self):
        self.refuses(STUDY.format(minimise='"time"').replace("1..8", "5..8"),
                     "can be built and completes its runs", '"b" has no link 4', "a T800 has the links 0 to 3")
        self.refuses(STUDY.format(minimise='"time"').replace("[search]", 'until = "1us"\n[search]'),
                     "stopped at the time limit", name="stopped.toml")
        self.refuses(STUDY.format(minimise='"time"'), "stopped at the time limit", arguments=["--until", "1us"],
                     name="until.toml")

    def test_very_many_runs_are_begun_only_if_they_are_meant(self):
        text = STUDY.format(minimise='"time"').replace("[100000, 200000, 300000]", '"1..100000"')
        self.refuses(text, "up to 800,000 runs of about ", " on 2 cores; add --yes to start them",
                     arguments=["--exhaustive", "--jobs", 2])
        self.refuses(text.replace("population = 12", "population = 2000"), "up to 13,000 runs")
        self.refuses("seeds = 1000\n" + text, "up to 78,000 runs", name="seeds.toml")
        self.refuses(f"seeds = {2 ** 62}\n" + text, f"up to {2 ** 64 - 1:,} runs", arguments=["--exhaustive"], name="seeds.toml")
        self.assertLess(len(self.rows("refused.sqlite")), 3)
        self.assertLess(len(self.rows("seeds.sqlite")), 3)
        few = text.replace("1..100000", "1..2500").replace("[search]", 'where = "wires == 1 && cycles < 30"\n[search]')
        said = self.optimise(self.write("few.toml", few), "--exhaustive", "--yes")
        self.assertRegex(said, r"(?m)^exhaustive +29 ")


if __name__ == "__main__":
    unittest.main()
