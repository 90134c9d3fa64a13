"""Tests records: their content, that they are reproducible, and messages about wrong options."""

import itertools
import json
import pathlib
import re
import statistics
import tempfile
import tomllib
import unittest

from program import EXAMPLES, placedpar

RECORDS = EXAMPLES / "hydraulics" / "records"
DIG = EXAMPLES / "hydraulics" / "digging" / "dig.toml"
SCENARIOS = ("scenario-a", "scenario-b", "two-links", "links", "excavator")


def record(*arguments):
    """Returns the record that the program prints."""
    run = placedpar("record", *arguments)
    assert run.returncode == 0, run.stderr
    return run.stdout


def columns(text):
    """Returns the values of a record by column name."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    rows = [[float(cell) for cell in line.split(",")] for line in lines[1:]]
    return {name.split(" [")[0]: [row[i] for row in rows] for i, name in enumerate(lines[0].split(","))}


def with_configuration(text):
    """Returns the values of a record by column name, and the text of its last column."""
    lines = [line.rpartition(",") for line in text.splitlines() if not line.startswith("#")]
    assert lines[0][2] == "configuration", lines[0]
    return columns("\n".join(line[0] for line in lines)), "".join(line[2] for line in lines[1:])


class Records(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refused(self, *arguments):
        """Returns the message about wrong use."""
        run = placedpar(*arguments)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertEqual(run.stdout, "")
        return run.stderr

    def test_the_same_seed_gives_the_same_bytes_and_another_does_not(self):
        for scenario in SCENARIOS:
            self.assertEqual(record(scenario, "--seed", 5), record(scenario, "--seed", 5))
            first, second = (columns(record(scenario, "--seed", seed)) for seed in (5, 6))
            self.assertNotEqual(first["boom.inlet_pressure"], second["boom.inlet_pressure"])

    def test_a_records_own_description_makes_it_again(self):
        given = ("excavator", "--seed", 9, "--noise", "low", "--set", "fault.leak=0.002", "--set",
                 "boom.inlet_compliance=4e-11 m^3/Pa", "--set", "sensors.resolver_bits=12")
        text = record(*given)
        command = re.search(r"^# made by: placedpar record (.*)$", text, re.MULTILINE)[1]
        self.assertEqual(record(*command.split()), text)
        self.assertIn("# fault.leak = 0.002 in^3/(s psi), not 0\n", text)
        compliance = float(re.search(r"true boom.inlet_compliance (\S+)", text)[1])
        self.assertAlmostEqual(compliance, 4e-11 / 2.37672e-9, delta=1e-6)

    def test_any_links_in_any_configuration_and_each_compliance_is_found_again(self):
        true = {"bucket": 0.0050, "boom": 0.0086, "stick": 0.0065, "swing": 0.0040}
        path = self.folder / "links.csv"
        for links, configuration in (("bucket", "a"), ("swing", "c"), ("bucket,boom", "a"), ("stick,swing", "a"),
                                     ("boom,stick", "b"), ("bucket,stick", "d"), ("bucket,swing", "e")):
            choice = ("--link", links, "--configuration", configuration)
            text = record("links", *choice, "--noise", "none")
            command = re.search(r"^# made by: placedpar record (.*)$", text, re.MULTILINE)[1]
            self.assertEqual(record(*command.split()), text)
            self.assertEqual({name.split(".")[0] for name in columns(text)} - {"time"}, set(links.split(",")))
            self.assertEqual(set(re.findall(r"true (\w+)\.inlet_compliance", text)), set(links.split(",")))
            path.write_text(text)
            found = placedpar("identify", path, "--json", self.folder / "found.json", *choice)
            self.assertEqual(found.returncode, 0, found.stderr)
            movements = json.loads((self.folder / "found.json").read_text())["movements"]
            answers = [answer for movement in movements for answer in movement["links"]]
            self.assertEqual({answer["link"] for answer in answers}, set(links.split(",")))
            for answer in answers:
                whole = answer["whole_movement"]["compliance"] / true[answer["link"]]
                self.assertAlmostEqual(whole, 1, delta=0.05, msg=str(choice))
                if not answer["flags"]:
                    self.assertAlmostEqual(answer["compliance"] / true[answer["link"]], 1, delta=0.1, msg=str(choice))

    def test_links_are_chosen_where_they_can_be(self):
        self.assertIn("the scenario \"scenario-a\" has fixed links",
                      self.refused("record", "scenario-a", "--link", "boom"))
        self.assertIn("--configuration: the scenario \"excavator\" has", self.refused("record", "excavator", "--configuration", "b"))
        self.assertIn('unknown link "arm"', self.refused("record", "links", "--link", "boom,arm"))

    def test_stored_records_are_what_their_descriptions_make(self):
        stored = sorted(RECORDS.glob("*.csv"))
        self.assertGreaterEqual(len(stored), 3)
        for path in stored:
            text = path.read_text(encoding="utf-8")
            command = re.search(r"^# made by: placedpar record (.*)$", text, re.MULTILINE)[1]
            self.assertEqual(record(*command.split()), text, path)

    def test_out_writes_what_would_be_printed(self):
        path = self.folder / "record.csv"
        run = placedpar("record", "scenario-a", "--out", path)
        self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
        self.assertEqual(path.read_text(encoding="utf-8"), record("scenario-a"))
        self.assertIn(str(self.folder), self.refused("record", "scenario-a", "--out", self.folder))

    def test_scenario_a_and_b_are_the_reference_simulations(self):
        a = columns(record("scenario-a", "--noise", "none", "--set", "scenario_a.duration=4"))
        peak = max(a["boom.inlet_pressure"])
        self.assertAlmostEqual(peak, 2068, delta=10)
        self.assertAlmostEqual(a["time"][a["boom.inlet_pressure"].index(peak)], 0.48, delta=0.02)
        self.assertAlmostEqual(a["boom.inlet_pressure"][-1], 1850, delta=8)
        b = columns(record("scenario-b", "--noise", "none", "--set", "scenario_b.duration=6"))
        self.assertAlmostEqual(b["boom.inlet_pressure"][0], 1524, delta=2)
        self.assertAlmostEqual(max(b["boom.inlet_pressure"]), 2070, delta=10)
        self.assertAlmostEqual(b["boom.inlet_pressure"][-1], 1835, delta=10)

    def test_faults_show_in_the_record(self):
        good = columns(record("excavator", "--noise", "none"))
        soft = columns(record("excavator", "--noise", "none", "--set", "boom.inlet_compliance=0.0172"))
        self.assertLess(soft["boom.inlet_pressure"][18], good["boom.inlet_pressure"][18] - 50)
        leak = columns(record("excavator", "--noise", "none", "--set", "fault.leak=0.004"))
        self.assertLess(leak["boom.angle"][-1], good["boom.angle"][-1] - 0.5)
        drift = columns(record("excavator", "--noise", "none", "--set", "fault.servo_drift=0.01"))
        self.assertEqual(drift["boom.servo"], good["boom.servo"])
        self.assertGreater(drift["boom.spool"][-1], good["boom.spool"][-1] + 0.01)
        offset = columns(record("excavator", "--noise", "none", "--set", "fault.spool_offset=-0.01"))
        self.assertEqual(offset["boom.servo"], good["boom.servo"])
        self.assertAlmostEqual(offset["boom.spool"][-1], good["boom.spool"][-1], delta=0.0003)
        self.assertGreater(offset["boom.angle"][-1], good["boom.angle"][-1] + 1)

    def test_the_list_is_a_machine_file_and_names_every_parameter_with_its_mark(self):
        for scenario in SCENARIOS:
            listed = record(scenario, "--list", "--set", "boom.mass=1234")
            lines = listed.splitlines()
            self.assertEqual(lines[0], "name,value,unit,mark,source")
            self.assertIn("boom.mass,1234,lbf s^2/in,ours", listed)
            self.assertTrue(all(line.split(",")[3].strip('"') in ("thesis", "fitted", "ours") for line in lines[1:]))
            path = self.folder / "machine.csv"
            path.write_text(listed, encoding="utf-8")
            if scenario != "scenario-b":  # its machine replaces any other
                self.assertEqual(record(scenario, "--machine", path), record(scenario, "--set", "boom.mass=1234"))

    def test_wrong_use_says_what_would_be_right(self):
        self.assertEqual(self.refused("record", "crane"),
                         'placedpar: unknown scenario "crane"; the scenarios are scenario-a, scenario-b, two-links, links and excavator\n')
        self.assertIn('did you mean "boom.mass"?', self.refused("record", "excavator", "--set", "boom.mas=1"))
        self.assertIn("no such parameter", self.refused("record", "scenario-a", "--set", "pump.ripple=0"))
        self.assertIn("is not a unit of mass; expected lbf s^2/in or kg",
                      self.refused("record", "excavator", "--set", "boom.mass=5 m"))
        for value in ("", "x", "nan", "inf", "1e999", "1 2"):
            self.refused("record", "excavator", "--set", "boom.mass=" + value)
        self.assertIn("above 0", self.refused("record", "excavator", "--set", "boom.mass=0"))
        self.assertIn("at most", self.refused("record", "excavator", "--set", "excavator.integration_step=0.01"))
        self.assertIn("at most", self.refused("record", "scenario-a", "--set", "scenario_a.duration=1e12"))
        self.assertIn("whole number from 0 to 32", self.refused("record", "excavator", "--set", "sensors.spool_bits=99"))
        self.assertIn("none, low, mid or high", self.refused("record", "excavator", "--noise", "loud"))

    def test_parameters_out_of_their_range_are_refused(self):
        for scenario, setting, said in (("scenario-a", "boom.moment_arm=0", "expected above 0"),
                                        ("two-links", "bucket.inlet_area=-1 cm^2", "expected above 0"),
                                        ("excavator", "boom.inlet_compliance=0", "expected above 0"),
                                        ("scenario-b", "noise.pressure=-5", "expected 0 or above"),
                                        ("excavator", "fault.leak=-1", "expected 0 or above")):
            self.assertEqual(self.refused("record", scenario, "--set", setting),
                             f"placedpar: --set {setting}: {said}\n")

    def test_a_record_that_no_sensor_could_have_read_is_refused_with_instant_and_channel(self):
        path = self.folder / "record.csv"
        for scenario, setting, where in (("scenario-a", "boom.inlet_compliance=1e-12", r"inlet_pressure .* at 0\.\d+ s"),
                                         ("excavator", "fault.leak=1e9", r"inlet_pressure would be nan psi at 0\.\d+ s"),
                                         ("links", "boom.inlet_compliance=1e-12", "no pressure balances the flows"),
                                         ("scenario-a", "noise.pressure=1e308", r"inlet_pressure would be -?inf psi at 0"),
                                         ("scenario-a", "noise.spool=1e200", r"boom\.spool .* at 0\.000 s")):
            said = self.refused("record", scenario, "--set", setting, "--out", path)
            self.assertRegex(said, f"^placedpar: {scenario} cannot be simulated with these parameters: .*{where}")
            self.assertFalse(path.exists())

    def test_a_wrong_record_is_refused_with_line_column_and_caret(self):
        path = self.folder / "wrong.csv"
        lines = (RECORDS / "boom-4deg.csv").read_text(encoding="utf-8").splitlines()
        lines[20] = lines[20].replace(",", ",x", 1)
        path.write_text("\n".join(lines), encoding="utf-8")
        said = self.refused("identify", path).splitlines()
        self.assertRegex(said[0], r"wrong\.csv:21:7: error: \"x\S+\" is not a finite number$")
        self.assertEqual(said[2], "    " + " " * 6 + "^")
        self.assertTrue(said[3].startswith("hint: "))

    def test_of_many_faults_twenty_are_shown(self):
        path = self.folder / "wrong.csv"
        text = (RECORDS / "boom-4deg.csv").read_text(encoding="utf-8")
        path.write_text(re.sub(r"^0\.\d+,", "x,", text, flags=re.MULTILINE), encoding="utf-8")
        said = self.refused("identify", path)
        self.assertEqual(said.count(": error: "), 1)
        self.assertIn('"x" is not a finite number (and 49 more lines, the last is line 55)', said)
        numbers = itertools.count()
        path.write_text(re.sub(r"^0\.\d+,", lambda _: f"x{next(numbers)},", text, flags=re.MULTILINE), encoding="utf-8")
        said = self.refused("identify", path)
        self.assertEqual(said.count(": error: "), 20)
        self.assertIn("... 30 more errors not shown", said)

    def test_files_that_are_no_records(self):
        self.assertIn("this file does not exist", self.refused("identify", self.folder / "none.csv"))
        self.assertIn("directory", self.refused("identify", self.folder))
        rubbish = self.folder / "rubbish.csv"
        rubbish.write_bytes(bytes(range(256)) * 20)
        self.assertIn("binary", self.refused("identify", rubbish))
        rubbish.write_bytes(b"")
        self.assertIn("the header is missing", self.refused("identify", rubbish))


class Jobs(unittest.TestCase):
    """Tests records of an excavator that does a job."""

    START = "start = {reach = 300, height = -20, pitch = -60, swing = 0}\n"
    LOWER = "[[move]]\nseconds = 1\n[[move]]\nseconds = 2\nheight = -20\n"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.job = self.folder / "job.toml"
        self.job.write_text(self.START + self.LOWER, encoding="utf-8")

    def refused(self, text, *arguments):
        """Returns the lines of the message about a wrong job; nothing is written."""
        self.job.write_text(text, encoding="utf-8")
        out = self.folder / "record.csv"
        run = placedpar("record", "excavator", "--job", "job.toml", "--out", out, *arguments, folder=self.folder)
        self.assertEqual((run.returncode, run.stdout), (1, ""), run.stderr)
        self.assertFalse(out.exists())
        return run.stderr.splitlines()

    def dig(self, *arguments):
        """Returns the columns of a record of the short job, and its configurations."""
        return with_configuration(record("excavator", "--job", self.job, *arguments))

    def test_the_record_lasts_as_long_as_the_job_and_the_configuration_changes(self):
        job = tomllib.loads(DIG.read_text(encoding="utf-8"))
        values, configuration = with_configuration(record("excavator", "--job", DIG))
        self.assertEqual(values["time"][0], 0)
        self.assertAlmostEqual(values["time"][-1], job["repeat"] * sum(move["seconds"] for move in job["move"]))
        self.assertEqual({name.split(".")[0] for name in values} - {"time"}, {"bucket", "boom", "stick", "swing"})
        self.assertLessEqual(set(configuration), set("abcde"))
        self.assertGreaterEqual(len(set(configuration)), 3)
        self.assertEqual(configuration[0], "a")
        self.assertGreater(max(values["swing.angle"]) - min(values["swing.angle"]), 30)

    def test_the_same_seed_gives_the_same_bytes_and_another_gives_other_noise_on_the_same_motion(self):
        first = record("excavator", "--job", self.job, "--seed", 5)
        self.assertEqual(first, record("excavator", "--job", self.job, "--seed", 5))
        values, configuration = with_configuration(first)
        others, same = self.dig("--seed", 6)
        self.assertNotEqual(values["boom.inlet_pressure"], others["boom.inlet_pressure"])
        self.assertEqual(configuration, same)

    def test_the_noise_has_the_stated_deviations(self):
        exact, configuration = self.dig("--noise", "none")
        for level, psi, deg, share in (("low", 2, 0.003, 0.001), ("mid", 5, 0.005, 0.002), ("high", 10, 0.01, 0.004)):
            noisy, same = self.dig("--noise", level)
            self.assertEqual(configuration, same)
            for name in set(exact) - {"time"}:
                pairs = [(n, e) for n, e in zip(noisy[name], exact[name], strict=True)
                         if not name.endswith("area") or e > 0.001]
                area = name.endswith("area")
                errors = [(n - e) / (e if area else 1) for n, e in pairs]
                if len(errors) < 100: # the inlet of a link that hardly moves
                    continue
                stated = psi if name.endswith("pressure") else share if area else deg
                self.assertAlmostEqual(statistics.pstdev(errors) / stated, 1, delta=0.25, msg=f"{level} {name}")

    def test_a_records_own_description_makes_it_again(self):
        text = record("excavator", "--job", self.job, "--seed", 3, "--noise", "low", "--set", "cross_over.shift=900")
        command = re.search(r"^# made by: placedpar record (.*)$", text, re.MULTILINE)[1]
        self.assertEqual(record(*command.split()), text)
        self.assertEqual(len(re.findall(r"true \w+\.inlet_compliance", text)), 4)

    def test_a_wrong_job_is_refused_with_line_and_cure(self):
        for text, place, said, cure in (
                (self.START + "[[move]]\nsecond = 1\n", "3:1", 'a move has no key "second"', 'did you mean "seconds"?'),
                (self.START + "turbo = 1\n" + self.LOWER, "2:1", 'a job has no key "turbo"',
                 "its keys are about, move, repeat, start"),
                (self.START + "[[move]]\nreach = 5\n", "2:1", "the move has no duration", "seconds = 2"),
                (self.START + "[[move]]\nseconds = 2\nreach = -200\n", "2:1", "the arm does not reach", "a shorter or slower move"),
                ("repeat = 300\n" + self.START + self.LOWER, "3:1", "the job lasts 900 s, expected at most 600", "a smaller repeat"),
                (self.LOWER, "1:1", "a job needs a start and at least one move", "start = {reach = 300"),
                (self.START, "1:1", "a job needs a start and at least one move", "[[move]]"),
                ("start = 3\n" + self.LOWER, "1:9", "expected a table with the pose of the arm", "start = {reach = 300"),
                (self.START + "[[move]]\nseconds = \n", "3:", "", "a job is written in TOML")):
            message = self.refused(text)
            self.assertRegex(message[0], rf"^job\.toml:{place}.*error: .*{re.escape(said)}", text)
            self.assertRegex("\n".join(message), rf"(?m)^hint: .*{re.escape(cure)}", text)
        for value in ("nan", "inf", "-1", '"4"', "1e9", "0", "true"):
            self.assertRegex(self.refused(f"{self.START}[[move]]\nseconds = {value}\n")[0],
                             r"^job\.toml:3:11: error: expected a number from 0.02 to 600$")

    def test_a_soil_that_lifts_the_machine_is_refused_with_move_and_line(self):
        said = self.refused(self.START + self.LOWER + "soil = 1e6\n")
        self.assertRegex(said[0], r"^placedpar: --job job\.toml: move 2 \(line \d+\): the soil's force of 1e\+06 lbf cancels the \w+'s load")

    def test_any_beginning_of_a_job_is_read_or_refused(self):
        text = DIG.read_text(encoding="utf-8")
        for end in range(0, len(text), 97):
            self.job.write_text(text[:end], encoding="utf-8")
            run = placedpar("record", "excavator", "--job", self.job, "--list")
            self.assertIn(run.returncode, (0, 1), run.stderr)

    def test_the_job_belongs_to_one_scenario(self):
        said = "--job job.toml: the scenario links takes no job; the scenario excavator does"
        run = placedpar("record", "links", "--job", "job.toml", folder=self.folder)
        self.assertEqual((run.returncode, run.stderr), (1, f"placedpar: {said}\n"))
        run = placedpar("record", "excavator", "--job", self.job, "--set", "fault.leak=1")
        self.assertEqual(run.returncode, 1)
        run = placedpar("record", "excavator", "--job", self.job, "--out", self.job)
        self.assertEqual(run.returncode, 1)
        self.assertEqual(self.job.read_text(encoding="utf-8"), self.START + self.LOWER)


if __name__ == "__main__":
    unittest.main()
