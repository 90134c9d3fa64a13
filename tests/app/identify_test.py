"""Tests identification as in the thesis: right answers, flags, refusals, the machine-readable result, --on."""

import json
import pathlib
import random
import re
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, FIGURE_E2, placedpar

RECORDS = EXAMPLES / "hydraulics" / "records"
STEP = RECORDS / "boom-4deg.csv"
MATRIX = EXAMPLES / "csp" / "matrix" / "matrix.cfs"  # no process of this netlist searches
TRUTH = 0.0086


def by_thesis(*arguments):
    return placedpar("identify", "--way", "thesis", *arguments)


class Identification(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def record(self, *arguments):
        path = self.folder / "record.csv"
        run = placedpar("record", *arguments, "--out", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        return path

    def identify(self, *arguments):
        """Returns the printed text."""
        run = by_thesis(*arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def result(self, *arguments):
        """Returns the document that --json writes."""
        path = self.folder / "result.json"
        self.identify(*arguments, "--json", path)
        return json.loads(path.read_text(encoding="utf-8"))

    def boom(self, *arguments):
        return self.result(*arguments)["links"][0]

    def refused(self, *arguments):
        run = by_thesis(*arguments)
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        self.assertEqual(run.stdout, "")
        return run.stderr

    def rows(self, edit, source=STEP):
        """Writes a record with each row of cells changed by `edit`; rows for which it returns nothing are left out."""
        lines = []
        for line in source.read_text(encoding="utf-8").splitlines():
            row = edit(line.split(",")) if line[:1].isdigit() else line.split(",")
            lines += [",".join(row)] if row else []
        return self.file("edited.csv", "\n".join(lines) + "\n")

    # Answers and flags

    def test_the_records_of_the_project_give_the_true_compliance(self):
        for record in sorted(RECORDS.glob("*.csv")):
            boom = self.boom(record)
            self.assertAlmostEqual(boom["compliance"], TRUTH, delta=0.1 * TRUTH, msg=record)
            self.assertEqual(boom["flags"], [], record)
            self.assertLess(boom["standard_error"], 0.1 * TRUTH)

    def test_an_offset_that_is_not_taken_off_ends_at_the_lower_bound(self):
        boom = self.boom(RECORDS / "boom-offset.csv", "--offset", "none")
        self.assertEqual(boom["flags"][0]["kind"], "lower_bound")
        self.assertRegex(boom["flags"][0]["text"], "^at the lower bound")
        self.assertAlmostEqual(self.boom(RECORDS / "boom-offset.csv", "--offset", -0.01)["compliance"], TRUTH,
                               delta=0.1 * TRUTH)

    def test_a_leak_that_passes_for_an_offset_is_flagged(self):
        leak = self.record("excavator", "--set", "fault.leak=0.0028", "--set", "fault.leak_start=0.192")
        self.assertRegex(self.boom(leak)["flags"][0]["text"], r"^the calibration found an offset of \+0\.004\d in, but a leak looks the same")
        self.assertNotIn("leak", self.identify(leak, "--offset", 0.0045))

    def test_angles_that_are_radians_are_uncertain(self):
        radians = self.rows(lambda row: row[:3] + [str(float(row[3]) * 0.01745)] + row[4:])
        self.assertRegex(self.boom(radians, "--offset", "none")["flags"][0]["text"], r"^uncertain: .* standard error is \d\d %")

    def test_the_compliance_stands_with_its_standard_error_in_both_systems_of_units(self):
        printed = re.search(r"(?m)^C_BOi +(\S+) +(\S+) +(\S+) +(\S+)", self.identify(STEP))
        compliance, error, si, si_error = map(float, printed.groups())
        self.assertAlmostEqual(compliance, TRUTH, delta=0.1 * TRUTH)
        m3_per_pascal = 0.0254 ** 3 / 6894.757293168361
        self.assertAlmostEqual(si / (compliance * m3_per_pascal), 1, delta=2e-3)
        self.assertAlmostEqual(si_error / (error * m3_per_pascal), 1, delta=0.06)  # the printed error has two digits

    def test_a_clock_that_jitters_by_a_millisecond_changes_little(self):
        draw = random.Random(1)
        jittered = self.rows(lambda row: [f"{float(row[0]) + draw.uniform(-0.001, 0.001):.5f}"] + row[1:])
        run = by_thesis(jittered)
        self.assertIn("from whole periods of 0.02 s", run.stderr)
        self.assertAlmostEqual(self.boom(jittered)["compliance"], TRUTH, delta=0.1 * TRUTH)

    def test_strict_tells_a_script_that_an_answer_is_doubted(self):
        offset = RECORDS / "boom-offset.csv"
        for record, option, code in ((STEP, "--strict", 0), (offset, "--offset=none", 0)):
            self.assertEqual(by_thesis(record, option).returncode, code)
        doubted = by_thesis(offset, "--offset", "none", "--strict", "--json", self.file("found.json", ""))
        self.assertEqual(doubted.returncode, 3)
        self.assertIn("! C_BOi: at the lower bound", doubted.stdout)

    def test_each_setting_is_heeded(self):
        plain = self.result(STEP)
        for option, value in (("--bias", 0.25), ("--population", 8), ("--trials", 2), ("--window", 7), ("--elite", 3),
                              ("--coding", "gray"), ("--bits", 12), ("--samples", 9), ("--seed", 2)):
            changed = self.result(STEP, option, value)
            self.assertNotEqual(changed["estimates"], plain["estimates"], option)
        self.assertNotEqual(self.result(STEP, "--rising")["estimates"], plain["estimates"])
        self.assertIn("more than the bias allows (0.5 in^3/s)", self.identify(STEP, "--bias", 0.25))

    def test_the_offset_is_not_looked_for_where_no_spool_is_used(self):
        links = self.record("two-links", "--noise", "low")
        self.assertNotIn("spool", self.identify(links, "--link", "bucket,boom"))
        self.assertIn("has no effect", self.refused(links, "--link", "bucket,boom", "--offset", 0.01))
        self.assertIn("spool offset", self.identify(STEP, "--areas-from", "servo"))

    def test_the_offset_of_a_sensor_that_is_not_used_does_not_matter(self):
        record = self.record("excavator", "--noise", "none")
        shifted = self.rows(lambda row: row[:4] + [str(float(row[4]) + 0.01)] + row[5:], record)
        by_servo = ("--areas-from", "servo")
        plain, other = self.boom(record, *by_servo), self.boom(shifted, *by_servo)
        self.assertEqual(other["compliance"], plain["compliance"])
        self.assertAlmostEqual(plain["compliance"], 0.0086, delta=0.1 * 0.0086)
        self.assertIn("spool offset: +0.01", self.identify(shifted))

    # Records with gaps

    def test_rows_lost_before_the_transient_change_little_by_the_voltage(self):
        whole = self.record("excavator", "--noise", "none")
        by_servo = ("--areas-from", "servo", "--offset", "none")
        compliance = self.boom(whole, *by_servo)["compliance"]
        gap = self.rows(lambda row: None if 0.11 < float(row[0]) < 0.19 else row, whole)
        self.assertAlmostEqual(self.boom(gap, *by_servo)["compliance"], compliance, delta=0.05 * compliance)

    def test_no_window_reaches_over_a_gap(self):
        gap = self.rows(lambda row: None if 0.39 < float(row[0]) < 0.45 else row)
        result = self.result(gap)
        times = [estimate["time_s"] for estimate in result["estimates"]]
        # The first slope after the gap is at 0.5 s, so the window's fifth sample is at 0.58 s.
        self.assertEqual([time for time in times if 0.35 < time < 0.579], [])
        self.assertIn(0.58, times)
        self.assertEqual(result["warnings"][0]["message"], "3 samples are missing before this one")

    # Machine-readable results

    def test_json_holds_everything_and_the_same_seed_the_same_bytes(self):
        path = self.folder / "result.json"
        texts = []
        for _ in range(2):
            self.identify(STEP, "--seed", 3, "--json", path)
            texts.append(path.read_bytes())
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(list(self.folder.iterdir()), [path])
        result = json.loads(texts[0])
        self.assertEqual((result["seed"], result["warnings"]), (3, []))
        self.assertIn("--seed 3", result["command"])
        (boom,) = result["links"]
        self.assertEqual((boom["link"], boom["unit"]), ("boom", "in^3/psi"))
        self.assertLessEqual(boom["codes_from_optimum"], 3)
        last = result["estimates"][-1]
        self.assertEqual(sorted(last), ["compliance", "error_in3_per_s", "sample", "time_s"])
        self.assertLess(abs(result["spool_offset_in"]), 0.001)

    def test_json_tells_what_the_record_was_warned_of(self):
        still = self.rows(lambda row: row[:2] + ["0.0"] + row[3:])
        (warning,) = self.result(still)["warnings"]
        self.assertIn("boom.outlet_pressure is 0 psi in every sample", warning["message"])
        self.assertEqual(sorted(warning), ["column", "hint", "line", "message"])

    def test_a_result_is_written_whole_or_not_at_all(self):
        before = "before"
        path = self.file("result.json", before)
        for arguments in (("--samples", 4), ("--link", "bucket"), ("--on", MATRIX), ("--areas-from", "areas")):
            self.refused(STEP, *arguments, "--json", path)
            self.assertEqual(path.read_text(encoding="utf-8"), before)
        self.assertEqual(list(self.folder.iterdir()), [path])
        record = self.file("own.csv", STEP.read_text(encoding="utf-8"))
        self.assertIn("the output file is also the input", self.refused(record, "--json", record))
        self.assertEqual(record.read_text(encoding="utf-8"), STEP.read_text(encoding="utf-8"))
        self.assertIn("cannot be written", self.refused(STEP, "--json", self.folder / "none" / "result.json"))

    # Searches on a simulated machine

    def test_the_processes_find_the_same_whatever_the_way(self):
        ways = ((), ("--rising",), ("--coding", "gray", "--elite", 1),
                ("--window", 8, "--population", 60, "--trials", 3, "--bias", 100, "--coding", "gray", "--elite", 2),
                ("--samples", 60))
        for way in ways:
            result = self.result(STEP, "--on", CLUSTER, *way)
            self.assertEqual(result["by_processes"], result["estimates"][-1]["compliance"], way)
        printed = self.identify(STEP, "--on", CLUSTER, "--set", "slaves=1")
        self.assertRegex(printed, r"(?m)^C_BOi: 0\.00(\d+) in\^3/psi from the direct search, 0\.00\1 from the netlist's processes: equal$")

    def test_a_netlist_that_fixes_a_setting_otherwise_is_refused_with_its_place(self):
        text = CLUSTER.read_text(encoding="utf-8").replace('"../', f'"{EXAMPLES}/thesis/')
        fixed = self.file("fixed.cfs", text.replace("elite = elite,", "elite = elite, trials = 4,"))
        said = self.refused(STEP, "--on", fixed).splitlines()
        self.assertRegex(said[0], r'fixed\.cfs:\d+:\d+: error: trials = 4 in the netlist for "master", but the identification has 5$')
        self.assertEqual(said[2].strip(), "^")
        self.assertTrue(said[1][len(said[2]) - 1:].startswith("trials = 4"), said)
        self.assertIn("equal\n", self.identify(STEP, "--on", fixed, "--trials", 4))
        self.assertIn('population = 60 in the netlist for "master", but the identification has 120',
                      self.refused(STEP, "--on", CLUSTER, "--set", "population=60"))
        self.assertIn("samples = 15", self.refused(STEP, "--on", CLUSTER, "--set", "samples=15"))

    def test_sixteen_transputers_identify_a_record_by_spool_and_by_voltage(self):
        record = self.record("excavator", "--noise", "low", "--seed", 5)
        for source in ("spool", "servo"):
            machine = self.result(record, "--on", FIGURE_E2, "--areas-from", source)["on_machine"]
            self.assertEqual(machine["searches"], [f"master[{i}]" for i in range(4)])
            last = machine["answers"][-1]
            found = [island[0] for island in last["found"]]
            self.assertLess(abs(found[machine["searches"].index(last["fittest"])] / TRUTH - 1), 0.1, source)
            self.assertAlmostEqual(last["spread"][0], max(found) - min(found), 12)
            times = [answer["ready_s"] for answer in machine["answers"]]
            self.assertEqual(times, sorted(times))
            self.assertEqual(len(times), 16)  # one for each of 20 samples from the fifth on
            self.assertAlmostEqual(times[-1], machine["ended_s"], 3)  # about 8.9 ms for each of 80 generations
            self.assertAlmostEqual(machine["ended_s"], 0.671, 2)

    def test_the_islands_of_a_netlist_are_no_copies_of_each_other(self):
        machine = self.result(STEP, "--on", FIGURE_E2)["on_machine"]
        first = [island[0] for island in machine["answers"][0]["found"]]
        self.assertGreater(len(set(first)), 1)

    def test_several_searches_divide_the_population(self):
        printed = self.identify(STEP, "--on", FIGURE_E2, "--set", "clusters=2")
        self.assertRegex(printed, r"(?m)^C_BOi: 0\.00\d+ in\^3/psi from the direct search, 0\.00\d+ from master\[\d\], "
                                  r"the fittest of 2 searches, which differ by up to 0\.0\d+$")
        said = self.refused(STEP, "--on", FIGURE_E2, "--set", "population=20")
        self.assertIn("the netlist's searches have 80 individuals in all, but the identification has 120: give --population 80",
                      said)
        self.identify(STEP, "--on", FIGURE_E2, "--set", "population=20", "--population", 80)

    def test_netlists_that_cannot_search_the_record_are_refused(self):
        self.assertIn("no process searches, expected ga.traditional", self.refused(STEP, "--on", MATRIX))
        pair = EXAMPLES / "genetic" / "coarse-fine" / "pair.cfs"
        self.assertIn("unknown search problem 'plant'", self.refused(STEP, "--on", pair))
        text = pair.read_text(encoding="utf-8")
        for was, becomes in (('"plant"', '"boom"'), ('"2 5 5 5 5 5"', '"5"'), ('"2 7 7 7 7 7"', '"10"'),
                             ('"../../', f'"{EXAMPLES}/'), ("window = 30", "window = 10")):
            text = text.replace(was, becomes)
        self.assertIn("is a coarse or a fine search", self.refused(STEP, "--on", self.file("pair.cfs", text)))

    def test_processes_that_do_not_find_the_same_end_with_3(self):
        # identify uses another crossover.
        other = self.file("other.cfs", """
            T800 t; workstation sun; connect sun.link[0] to t.link[0];
            process host, master;
            use "ga.host" for host; use "ga.master" for master; master (crossover_operator = "uniform");
            connect host.to_masters[0] to master.from_host;
            place host on sun; place master on t;""")
        run = by_thesis(STEP, "--population", 20, "--on", other)
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertIn("from the netlist's processes: different\n", run.stdout)

    def test_processes_that_cannot_search_as_natively_are_refused(self):
        gap = self.rows(lambda row: None if 0.39 < float(row[0]) < 0.45 else row)
        self.assertIn("which the netlist's processes cannot handle; --samples", self.refused(gap, "--on", CLUSTER))

    # Refusals

    def test_wrong_options_say_what_would_be_right(self):
        for arguments, said in (
                (("--offset", "nan"), "auto, none, or a number of inches from -0.08 to 0.08"),
                (("--offset", "-5"), "auto, none, or a number of inches from -0.08 to 0.08"),
                (("--offset", "0.01x"), "auto, none, or a number of inches"),
                (("--set", "x=1"), "--set requires --on"),
                (("--link", "boom,boom"), "boom is named twice"),
                (("--link", "boom,"), 'unknown link ""; the links are bucket, boom, stick and swing'),
                (("--link", "boom,crane"), 'unknown link "crane"'),
                (("--link", "boom,stick"), "boom,stick are not hydraulically coupled"),
                (("--samples", 4), "--samples 4: expected at least 5"),
                (("--bits", 1), "--bits: \"1\" is not a whole number from 6 to 52"),
                (("--population", 10**10), "is not a whole number from 2 to 1000000"),
                (("--window", 0), "is not a whole number from 1 to 1024"),
                (("--trials", -1), "is not a whole number from 1 to"),
                (("--elite", 119), "the elite is 119 of a population of 120"),
                (("--bias", 0), "the fitness bias is 0"), (("--bias", "nan"), "the fitness bias is nan")):
            self.assertIn(said, self.refused(STEP, *arguments), arguments)

    def test_a_machine_that_cannot_be_is_refused_with_its_place(self):
        for row, column, what in (('flow.orifice,-5,in^3/(s in^2 psi^0.5),ours,""', 14, "flow.orifice cannot be -5"),
                                  ('flow.pump,0,in^3/s,ours,""', 11, "flow.pump cannot be 0"),
                                  ('boom.inlet_area,0,cm^2,ours,""', 17, "boom.inlet_area cannot be 0")):
            machine = self.file("machine.csv", "name,value,unit,mark,source\n" + row + "\n")
            said = self.refused(STEP, "--machine", machine).splitlines()
            self.assertTrue(said[0].endswith(f"machine.csv:2:{column}: error: {what}"), said)
            self.assertEqual(said[2], " " * (3 + column) + "^")
            self.assertEqual(said[3], "hint: above 0")

    def test_what_a_record_lacks_is_said_with_its_name_and_what_it_has(self):
        self.assertEqual(self.refused(STEP, "--link", "bucket"),
                         f"{STEP}: error: the record has no channel bucket.inlet_pressure; it has boom.inlet_pressure, "
                         "boom.outlet_pressure, boom.angle, boom.spool, boom.servo\n")
        self.assertIn("has no channel boom.inlet_area", self.refused(STEP, "--areas-from", "areas"))
        rest = self.rows(lambda row: row if float(row[0]) < 0.15 else None)
        self.assertRegex(self.refused(rest), r"edited\.csv: error: 0 usable samples, expected at least 5: the transient")

    def test_a_record_without_rows_is_refused(self):
        header = "time [s],boom.inlet_pressure [psi],boom.angle [deg],boom.spool [in]"
        for text in (header, header + "\n", header + "0.00,1555,20,0.1297" * 9, "# a\n" + header + "\n# b\n"):
            said = self.refused(self.file("empty.csv", text))
            self.assertRegex(said, r"^\S*empty\.csv: error: the record has 0 samples, expected at least 5\n")
        self.assertIn("the record has 4 samples, expected at least 5",
                      self.refused(self.rows(lambda row: row if float(row[0]) < 0.07 else None)))

    def test_help_names_every_choice(self):
        said = placedpar("identify", "--help").stdout
        for words in ("service|thesis|whole", "auto|none|INCHES", "areas|spool|servo", "6..52", "refuse|skip=refuse",
                      "search over the first transient, as in chapter 3"):
            self.assertIn(words, said)
        self.assertNotRegex(said, re.compile(r"TEXT|UINT|FLOAT"))


if __name__ == "__main__":
    unittest.main()
