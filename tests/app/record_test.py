"""Tests records: their content, that they are reproducible, and messages about wrong options."""

import json
import pathlib
import re
import tempfile
import unittest

from program import EXAMPLES, placedpar

RECORDS = EXAMPLES / "hydraulics" / "records"
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
                         'placedpar: unknown scenario "crane"; there are scenario-a, scenario-b, two-links, links and excavator\n')
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


if __name__ == "__main__":
    unittest.main()
