"""Tests the experiments of the thesis: figures, tolerances, the JSON record."""

import contextlib
import json
import pathlib
import re
import shutil
import sqlite3
import subprocess
import tempfile
import time
import unittest

from program import CLUSTER, EXAMPLES, FIGURE_E2, PROGRAM, placedpar

CELL = {"row", "column", "unit", "thesis", "simulated", "error_percent", "tolerance_percent", "origin",
        "judged_by"}
DOCUMENT = {"experiment", "version", "seed", "fingerprint", "cells", "within_tolerance"}


def replay(experiment, folder, *arguments, environment=None):
    path = pathlib.Path(folder) / "cells.json"
    run = placedpar("replay", experiment, "--json", path, *arguments, environment=environment)
    return run, json.loads(path.read_text(encoding="utf-8"))


def runs_in(kept):
    """Returns the runs that a study has stored so far."""
    try:
        with contextlib.closing(sqlite3.connect(kept)) as file:
            return file.execute("SELECT settings, seed, figures FROM runs ORDER BY settings, seed").fetchall()
    except sqlite3.OperationalError:  # no tables yet
        return []


class Replay(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def cell(self, document, row, column):
        return next(c for c in document["cells"] if c["row"] == row and c["column"] == column)

    def test_table_e1_is_within_its_tolerances(self):
        run, document = replay("table-e1", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertLessEqual(DOCUMENT, set(document))
        self.assertTrue(document["within_tolerance"])
        self.assertEqual(len(document["cells"]), 24)
        for cell in document["cells"]:
            self.assertEqual(set(cell), CELL)
            if cell["thesis"]:
                error = 100 * (cell["simulated"] - cell["thesis"]) / cell["thesis"]
                self.assertAlmostEqual(cell["error_percent"], error)
                self.assertLessEqual(abs(error), 10 if cell["row"] == "C_BOi" else 3)
        self.assertEqual([c["row"] for c in document["cells"] if c["origin"] == "calibrated"], ["C_time2"])
        self.assertEqual({c["row"] for c in document["cells"] if c["judged_by"] == "own"}, {"C_BOi"})
        shown = sum(len(each["cells"]) for each in document["other_readings"])
        self.assertEqual(document["judged"], {"thesis": 26, "set_from_thesis": 4, "published": 0, "own": 4,
                                              "not_judged": shown - 6})

    def test_table_e1_without_communication_misses_what_judges_it(self):
        examples = pathlib.Path(self.folder) / "examples"
        shutil.copytree(EXAMPLES, examples)
        workload = examples / "thesis" / "workload.inc"
        text = workload.read_text(encoding="utf-8")
        for costs, nothing in (("measurement_bytes 148", "measurement_bytes 1"), ("library_call 201", "library_call 0"),
                               ("cycles_per_measurement_word 134", "cycles_per_measurement_word 0")):
            self.assertIn(costs, text)
            text = text.replace(costs, nothing)
        workload.write_text(text, encoding="utf-8")
        run, document = replay("table-e1", self.folder, environment={"PLACEDPAR_EXAMPLES": str(examples)})
        self.assertEqual(run.returncode, 3, run.stdout)
        missed = {(c["row"], c["column"]) for c in document["cells"]
                  if abs(c["simulated"] - c["thesis"]) > 0.01 * c["tolerance_percent"] * c["thesis"]}
        self.assertLessEqual(len([row for row, _ in missed if row in ("T_exe", "T_sr")]), 1)  # at most 1 of 8 cells
        communication = document["other_readings"][0]
        self.assertEqual(communication["reading"], "cells that judge the communication")
        self.assertFalse(communication["within_tolerance"])

    def test_examples_that_were_changed_are_refused_not_called_a_defect(self):
        examples = pathlib.Path(self.folder) / "examples"
        shutil.copytree(EXAMPLES, examples)
        renamed = re.sub(r"(?<!\.)\bmaster\b", "chief", CLUSTER.read_text(encoding="utf-8"))
        (examples / "thesis/table-e1" / "cluster.cfs").write_text(renamed, encoding="utf-8")
        run = placedpar("replay", "table-e1", environment={"PLACEDPAR_EXAMPLES": str(examples)})
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn('unknown measure "master.', run.stderr)

    def test_a_slave_more_is_a_column_of_its_own_and_not_a_copy(self):
        _, document = replay("table-e1", self.folder)
        times = [self.cell(document, "T_exe", f"{n} slave" + "s" * (n != 1))["simulated"] for n in range(4)]
        self.assertEqual(times, sorted(times, reverse=True))
        self.assertLess(times[3], times[0] / 2.8)

    def test_programs_in_occam_take_the_time_of_inmos_code_and_breed_the_generations_of_cpp(self):
        run, document = replay("occam", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        ticks = [cell for cell in document["cells"] if cell["unit"] == "ticks"]
        self.assertEqual(len(ticks), 15)
        self.assertEqual(self.cell(document, "sieve", "mode stop")["INMOS"], 11345)
        for cell in ticks:
            self.assertEqual(cell["tolerance_percent"], 6)
        evaluation, cluster, congruential, _, islands, _ = document["other_readings"]
        judged = [cell for cell in cluster["cells"] + islands["cells"] if "judged_by" in cell]
        self.assertEqual([cell["simulated"] for cell in judged], [1] * 12)
        self.assertEqual(len([cell for cell in evaluation["cells"] if "judged_by" in cell]), 3)
        # Messages take the same time, whatever the generator is.
        for slaves in ("0 slaves", "1 slave", "2 slaves", "3 slaves"):
            first, second = (self.cell(each, "C_time2", slaves) for each in (cluster, congruential))
            self.assertAlmostEqual(first["simulated"], second["simulated"], delta=0.01)
        self.assertLess(self.cell(congruential, "S_time2", "0 slaves")["simulated"],
                        self.cell(cluster, "S_time2", "0 slaves")["simulated"] / 2)

    def test_programs_in_occam_have_the_seed_of_the_replay(self):
        run, document = replay("occam", self.folder, "--seed", 7)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        self.assertTrue(document["within_tolerance"])

    def test_the_evidence_is_every_constant_and_every_published_figure_with_its_source(self):
        # A constant that a netlist states is the netlist's. The farm takes as long as all others: its page runs it.
        examples = pathlib.Path(self.folder) / "examples"
        shutil.copytree(EXAMPLES, examples)
        workload = examples / "thesis" / "workload.inc"
        text = workload.read_text(encoding="utf-8")
        workload.write_text(text.replace("cycles_per_measurement_word 134", "cycles_per_measurement_word 135"))
        _, evidence = replay("evidence", self.folder, environment={"PLACEDPAR_EXAMPLES": str(examples)})
        self.assertTrue(evidence["within_tolerance"])
        figures = {}
        for experiment in ("emulated", "links", "poznan", "processor"):
            _, document = replay(experiment, self.folder)
            for part in [document, *document["other_readings"]]:
                figures.update((c["row"], c["simulated"]) for c in part["cells"])
        self.assertEqual({c["row"]: c["simulated"] for c in evidence["cells"] if not c["row"].startswith("farm of")}, figures)
        self.assertEqual(len(evidence["cells"]), len(figures) + 9)
        self.assertTrue(all(c["source"] for c in evidence["cells"]))
        constants = {c["name"]: c for c in evidence["constants"]}
        self.assertEqual({c["mark"] for c in evidence["constants"]},
                         {"published", "workload", "calibrated", "ours", "fitted"})
        self.assertTrue(all(c["source"] for c in evidence["constants"]))
        self.assertEqual(constants["preparing a word of measurements"]["value"], 135)

    def test_studies_of_chapter_6_hold_over_few_seeds(self):
        for experiment in ("coarse-fine", "encoding", "crossover-by-difference"):
            run, document = replay(experiment, self.folder, "--seeds", 3)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            self.assertTrue(document["within_tolerance"])

    def test_islands_on_sixteen_transputers_find_what_one_search_finds(self):
        for experiment in ("figure-4-9", "figure-4-10"):
            run, document = replay(experiment, self.folder, "--seeds", 20)
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            tables = [document, *document["other_readings"]]
            self.assertEqual(len(tables), 4)
            for table in tables[1::2]:
                after = {cell["column"]: cell["simulated"] for cell in table["cells"]
                         if cell["row"] == "last answer after"}
                # The speed-up of 16 T800s over one T800 of 20 MHz is about 10.4 (Table E.2), for the same samples.
                self.assertAlmostEqual(after["GA, 1 T800"] / after["PGA, fittest"], 10.4, 0)

    def test_a_study_goes_on_where_it_was_killed(self):
        kept = pathlib.Path(self.folder) / "kept"
        with subprocess.Popen([PROGRAM, "replay", "crossover-by-difference", "--seeds", "50", "--resume", kept]) as run:
            while not runs_in(kept):
                time.sleep(0.01)
            run.kill()
        before = runs_in(kept)
        _, resumed = replay("crossover-by-difference", self.folder, "--seeds", 2, "--resume", kept)
        _, whole = replay("crossover-by-difference", self.folder, "--seeds", 2)
        self.assertEqual(resumed["cells"], whole["cells"])
        after = runs_in(kept)
        self.assertGreaterEqual(len(after), 2 * 18)
        self.assertLessEqual(set(before), set(after))
        other = placedpar("replay", "crossover-by-difference", "--seeds", 1, "--seed", 2, "--resume", kept)
        self.assertEqual(other.returncode, 1)
        self.assertIn("name another file, or move this file away", other.stderr)
        self.assertEqual(runs_in(kept), after)

    def test_kept_runs_of_islands_are_read_as_they_were_made(self):
        kept = pathlib.Path(self.folder) / "kept"
        _, alone = replay("pga-4", self.folder, "--seeds", 2)
        for _ in range(2):  # runs are made and stored, then read
            _, document = replay("pga-4", self.folder, "--seeds", 2, "--resume", kept)
            self.assertEqual(document["cells"], alone["cells"])
            self.assertEqual(len(runs_in(kept)), 2 * 8)

    def test_seeds_of_a_study_are_a_number_that_it_can_run(self):
        for number in ("0", "-1", "100000000000", "many"):
            run = placedpar("replay", "pga-4", "--seeds", number)
            self.assertEqual((run.returncode, run.stdout), (1, ""))
            self.assertIn(f'--seeds: "{number}" is not a whole number from 1 to 1000000\n', run.stderr)

    def test_what_is_no_study_has_no_seeds_to_count(self):
        run = placedpar("replay", "table-e1", "--seeds", 3)
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        self.assertIn("table-e1 has a fixed number of runs, so --seeds and --resume have no effect", run.stderr)

    def test_table_e2_is_within_its_tolerances(self):
        run, document = replay("table-e2", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        for column, thesis in (("GA", 1), ("B", 4), ("A", 3)):
            self.assertLessEqual(abs(self.cell(document, "speedup", column)["simulated"] / thesis - 1), 0.05)
        combined = self.cell(document, "speedup", "A + B")
        self.assertEqual((combined["judged_by"], combined["thesis"], combined["tolerance"]), ("thesis", 10.39, 0.66))
        self.assertAlmostEqual(97.0 / (21.8 / 4 + 10.5 / 4 + 22.5 - 21.8), 10.39 + 0.66, delta=0.006)
        self.assertAlmostEqual(97.0 / (21.8 / 4 + 10.5 / 4 + 1.89), 10.39 - 0.66, delta=0.006)
        self.assertLessEqual(abs(combined["simulated"] - 10.39), 0.66)

    def test_the_printed_speedup_of_12_is_missed_where_it_is_judged(self):
        for against, code in (("expected", 0), ("printed", 3)):
            run, document = replay("table-e2", self.folder, "--against", against)
            self.assertEqual(run.returncode, code, run.stdout)
            printed = document["other_readings"][0]
            self.assertEqual((printed["judged"], printed["within_tolerance"]), (code == 3, False))
            self.assertRegex(run.stdout, r"\nspeedup +10\.86 +12 +-9\.5%!")
        run = placedpar("replay", "table-e1", "--against", "printed")
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        self.assertIn("it affects table-e2", run.stderr)

    def test_the_compliance_stands_beside_the_true_one_and_is_judged(self):
        for experiment, columns in (("table-e1", 4), ("table-e2", 4)):
            _, document = replay(experiment, self.folder)
            cells = [c for c in document["cells"] if c["row"] == "C_BOi"]
            self.assertEqual(len(cells), columns)
            for cell in cells:
                self.assertEqual((cell["thesis"], cell["unit"], cell["tolerance_percent"]), (0.0086, "in^3/psi", 10))
        # With this seed all four islands end 10.3 % too low: the table's times are right, the identification is not.
        run, document = replay("table-e2", self.folder, "--seed", 2)
        self.assertEqual(run.returncode, 3, run.stdout)
        missed = [(c["row"], c["column"]) for c in document["cells"]
                  if c["tolerance_percent"] and abs(c["error_percent"]) > c["tolerance_percent"]]
        self.assertEqual(missed, [("C_BOi", "B"), ("C_BOi", "A + B")])

    def test_the_forms_of_a_farm(self):
        run, document = replay("farms", self.folder)
        self.assertEqual(run.returncode, 0, run.stdout)
        cell = lambda row: self.cell(document, row, "C_time2")["simulated"]  # noqa: E731
        chain, star = cell("the chain, to which a constant is fitted"), cell("a star, with the chain's software")
        self.assertAlmostEqual(chain, 1.89, delta=0.06)
        self.assertAlmostEqual(cell("what the thesis computed: 628 bytes over a link"), 0.4, delta=0.05)
        self.assertLess(star, 0.8 * chain)
        self.assertGreater(star, 2 * 0.4)  # even a link for each slave is far from .4 ms
        sweep = next(each for each in document["other_readings"] if each["reading"].startswith("C_time2"))
        times = {(c["row"], c["column"]): c["simulated"] for c in sweep["cells"]}
        for slaves in (4, 5, 6, 8, 10, 12, 15):
            row = f"{slaves} slaves"
            self.assertLess(times[row, "tree"], times[row, "chain"])
        under_way = document["other_readings"][-1]["cells"]
        busy = {(c["row"], c["column"]): c["simulated"] for c in under_way}
        self.assertGreater(busy["chain of 3, the least busy", "2 under way"],
                           busy["chain of 3, the least busy", "1 under way"] + 5)

    def test_chapter_2_is_within_its_tolerances(self):
        for experiment in ("table-2-6", "figure-2-3", "figures-2-8-2-9"):
            run, document = replay(experiment, self.folder)
            self.assertEqual(run.returncode, 0, run.stdout)
            self.assertTrue(document["within_tolerance"])
            readings = [document, *document["other_readings"]]
            judged = [c for reading in readings for c in reading["cells"] if c.get("tolerance") is not None]
            self.assertGreater(len(judged), 12)
            for cell in judged:
                figure = cell["known"] if cell["thesis"] is None else cell["thesis"]
                self.assertLessEqual(abs(cell["simulated"] - figure), cell["tolerance"], cell)

    def test_table_2_6_is_the_thesis_s(self):
        _, document = replay("table-2-6", self.folder)
        for flow, spools in ((60, (0.2741, 0.2688, 0.2627)), (50, (0.2650, 0.2592, 0.2527)),
                             (40, (0.2561, 0.2499, 0.2427))):
            for psi, spool in zip((2030, 1830, 1630), spools):
                cell = self.cell(document, f"spool at {flow} in^3/s", f"{psi} psi")
                self.assertEqual((cell["thesis"], cell["unit"]), (spool, "in"))
                self.assertLessEqual(abs(cell["simulated"] - spool), 2e-4)

    def test_the_first_attempt_stands_beside_the_prototype_s_figures(self):
        _, document = replay("first-attempt", self.folder)
        known = [self.cell(document, "  its error", column)["known"]
                 for column in ("-0.02 in", "-0.015 in", "-0.01 in", "no offset", "+0.01 in")]
        self.assertEqual(known, [-142, None, -51, 0, 53])

    def test_bounds_from_one_side_are_told(self):
        _, document = replay("figures-3-9-to-3-11", self.folder)
        for cell in (c for c in document["cells"] if c["row"] == "both within 10 %"):
            self.assertIsNone(cell["tolerance_percent"])
            self.assertLess(cell["at_least"], cell["known"])
            self.assertGreaterEqual(cell["simulated"], cell["at_least"])
        states = next(r for r in document["other_readings"] if "Figure 3.10" in r["reading"])
        self.assertEqual([c.get("at_most") for c in states["cells"]], [None, 10] * 6)

    def test_studies_of_any_seed_are_within_their_tolerances(self):
        for experiment in ("experiments-1-2", "first-attempt", "figure-3-8", "identification-study",
                           "figures-3-9-to-3-11", "loss-of-excitation"):
            figures = set()
            for seed in (201, 18446744073709551615):
                run, document = replay(experiment, self.folder, "--seed", seed)
                self.assertEqual(run.returncode, 0, run.stdout)
                figures.add(document["fingerprint"])
            self.assertEqual(len(figures), 2)

    def test_other_costs_miss_the_tolerance(self):
        examples = pathlib.Path(self.folder) / "examples"
        shutil.copytree(EXAMPLES, examples)
        workload = examples / "thesis" / "workload.inc"
        text = workload.read_text(encoding="utf-8")
        self.assertIn("cycles_per_measurement_word 134", text)
        workload.write_text(text.replace("cycles_per_measurement_word 134", "cycles_per_measurement_word 400"),
                            encoding="utf-8")
        run, document = replay("table-e1", self.folder, environment={"PLACEDPAR_EXAMPLES": str(examples)})
        self.assertEqual(run.returncode, 3, run.stdout)
        self.assertFalse(document["within_tolerance"])

    def test_the_seed_changes_the_search_and_not_the_table(self):
        for seed in (2, 3):
            run, document = replay("table-e1", self.folder, "--seed", seed)
            self.assertEqual(run.returncode, 0, run.stdout)
            self.assertEqual(document["seed"], seed)


class Identification(unittest.TestCase):
    """Tests how often the compliance is within 10 % of the truth; the examples' pages state it for 150 seeds."""

    def errors(self, netlist, process, seeds, *settings):
        """Returns the error in percent, by seed."""
        errors = {}
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.json"
            for seed in seeds:
                run = placedpar("run", netlist, "--seed", seed, "--json", path,
                                *(word for setting in settings for word in ("--set", setting)))
                self.assertEqual(run.returncode, 0, run.stderr)
                measurements = json.loads(path.read_text(encoding="utf-8"))["measurements"]
                found = next(m["value"] for m in measurements if m["name"] == "C_BOi" and m["process"] == process)
                errors[seed] = 100 * (found / 0.0086 - 1)
        return errors

    def check_share(self, errors, least_percent):
        missed = {seed: round(error, 1) for seed, error in errors.items() if abs(error) > 10}
        self.assertGreater(len({round(error, 3) for error in errors.values()}), 3)
        self.assertGreaterEqual(100 * (1 - len(missed) / len(errors)), least_percent, f"missed: {missed}")

    def test_one_population_of_120(self):
        self.check_share(self.errors(CLUSTER, "master", range(1, 41), "slaves=0"), 90)

    def test_four_islands_of_30(self):
        self.check_share(self.errors(FIGURE_E2, "master[0]", range(1, 41), "slaves=0"), 90)

    def test_the_islands_owe_it_to_their_exchange(self):
        alone = self.errors(FIGURE_E2, "master[0]", range(1, 41), "slaves=0", "exchange_every=1000000")
        self.assertGreater(sum(abs(error) > 10 for error in alone.values()), 4)

    def test_what_misses_is_found_by_an_elite_and_while_the_pressure_rises(self):
        seeds = (65, 104)
        for error in self.errors(CLUSTER, "master", seeds, "slaves=0").values():
            self.assertGreater(abs(error), 10)
        for setting in ("elite=1", "samples=14"):
            for error in self.errors(CLUSTER, "master", seeds, "slaves=0", setting).values():
                self.assertLess(abs(error), 10, setting)


if __name__ == "__main__":
    unittest.main()
