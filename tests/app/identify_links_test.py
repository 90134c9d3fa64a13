"""Tests several links at once, and extreme single readings: every untrustworthy answer must have a flag."""

import json
import pathlib
import tempfile
import unittest

from program import placedpar

CONFIGURATIONS = {"a": "bucket,boom", "b": "boom,stick,swing", "c": "bucket,boom,stick",
                  "d": "bucket,boom,stick,swing", "e": "bucket,boom,stick,swing"}
TRUE = {"bucket": 0.005, "boom": 0.0086, "stick": 0.0065, "swing": 0.004}


class Links(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def record(self, *arguments):
        path = self.folder / "record.csv"
        run = placedpar("record", *arguments, "--out", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        return path

    def answers(self, record, *arguments):
        """Returns compliance, standard error and flags of each link, and the printed text."""
        result = self.folder / "result.json"
        run = placedpar("identify", record, *arguments, "--json", result)
        self.assertEqual(run.returncode, 0, run.stderr)
        found = json.loads(result.read_text(encoding="utf-8"))
        alarms = [alarm["alarm"] for alarm in found.get("alarms", [])]
        links = found["links"] if "links" in found else [link for each in found["movements"] for link in each["links"]]
        return [(link, [flag["kind"] for flag in link["flags"]] + alarms) for link in links], run.stdout

    def test_an_answer_that_is_off_by_more_than_a_tenth_is_flagged_in_all_but_one_of_a_hundred(self):
        """Least squares is off by 7 % for the bucket in configurations c and e, so a few answers just beyond 10 % have no
        flag. With these seeds it is one answer: seed 6 without noise in configuration e."""
        silent, right, trusted = [], 0, 0
        for configuration, links in CONFIGURATIONS.items():
            for noise, seed in (("none", 1), ("none", 6), ("none", 8), ("low", 2)):
                record = self.record("links", "--link", links, "--configuration", configuration, "--noise", noise,
                                     "--seed", seed)
                for way in ("service", "thesis"):
                    for link, flags in self.answers(record, "--link", links, "--configuration", configuration,
                                                    "--seed", seed, "--way", way)[0]:
                        off = abs(link["compliance"] / TRUE[link["link"]] - 1) > 0.1
                        right, trusted = right + (not off), trusted + (not off and not flags)
                        if off and not flags:
                            silent.append((configuration, noise, seed, way, link["link"], link["compliance"]))
        self.assertEqual([each for each in silent if each[4] != "bucket"], [])
        self.assertLessEqual(len(silent), 1, silent)
        self.assertGreater(trusted, 0.4 * right)

    def test_a_search_over_the_whole_movement_finds_all_links_and_says_what_it_costs(self):
        for configuration, links in CONFIGURATIONS.items():
            record = self.record("links", "--link", links, "--configuration", configuration, "--noise", "low",
                                 "--seed", 5)
            answers, printed = self.answers(record, "--link", links, "--configuration", configuration, "--seed", 5,
                                            "--way", "whole")
            self.assertEqual(sorted(link["link"] for link, _ in answers), sorted(links.split(",")))
            for link, _ in answers:
                self.assertAlmostEqual(link["compliance"] / TRUE[link["link"]], 1, delta=0.1, msg=(configuration, link))
            self.assertRegex(printed, r"least possible standard error with the noise of these samples \(Cramer-Rao bound\): \w+ [\d.]+ %")
            self.assertRegex(printed, r"cost: \d+ individuals, each evaluated at 1\d\d samples; this takes \d+ s on one T800 of 20 MHz, \d+ s on 16 T800s")

    def test_too_few_generations_over_the_whole_movement_are_flagged_and_strict_exits_with_3(self):
        links = CONFIGURATIONS["e"]
        record = self.record("links", "--link", links, "--configuration", "e", "--noise", "low", "--seed", 5)
        weak = ("identify", record, "--link", links, "--configuration", "e", "--way", "whole", "--population", 10,
                "--trials", 1, "--strict")
        run = placedpar(*weak)
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertIn("unconfirmed: least squares over", run.stdout)
        for option in (("--window", 10), ("--rising",)):
            self.assertIn("works only with --way thesis", placedpar(*weak, *option).stderr)

    def test_the_service_names_the_way_for_more_than_two_links(self):
        links = CONFIGURATIONS["e"]
        record = self.record("links", "--link", links, "--configuration", "e", "--noise", "low", "--seed", 5)
        self.assertIn("try --way whole", placedpar("identify", record, "--link", links, "--configuration", "e").stdout)

    def test_single_readings_far_off_are_flagged_and_every_figure_is_finite(self):
        spikes = {1: ("1e9", "5000", "1"), 2: ("1e9", "50", "3"), 3: ("1e9", "5", "0.5")}  # pressure, angle, spool
        lines = self.record("scenario-a", "--seed", 3).read_text(encoding="utf-8").splitlines()
        first = next(i for i, line in enumerate(lines) if line[:1].isdigit())
        for column, values in spikes.items():
            for value in values:
                for rows in ((20,), (20, 24), (20, 40, 60)):
                    cells = [line.split(",") for line in lines]
                    for row in rows:
                        cells[first + row][column] = value
                    path = self.folder / "spiked.csv"
                    path.write_text("".join(",".join(row) + "\n" for row in cells), encoding="utf-8")
                    for way in ("service", "thesis"):
                        answers, printed = self.answers(path, "--way", way)
                        self.assertNotRegex(printed, r"\b(nan|inf)\b", (column, value, rows, way))
                        for link, flags in answers:
                            self.assertIn("impossible", flags, (column, value, rows, way))

    def test_the_configurations_of_a_machine_that_digs_are_recognised_and_its_links_identified(self):
        job = pathlib.Path(__file__).parents[2] / "examples/hydraulics/digging/dig.toml"
        record = self.record("excavator", "--job", job, "--noise", "low", "--seed", 3)
        result = self.folder / "result.json"
        run = placedpar("identify", record, "--json", result)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        found = json.loads(result.read_text(encoding="utf-8"))
        judged = found["configuration"]
        self.assertGreater(judged["right"], 0.99 * judged["judged"])
        self.assertGreater(judged["within_two_samples"], 0.9 * judged["changes"])
        self.assertGreaterEqual(len({each["set"] for each in found["sets"]}), 4)
        for link in found["links"]:
            if not link["flags"]:
                self.assertLess(abs(link["compliance"] / TRUE[link["link"]] - 1), 0.1, link)
        self.assertGreaterEqual(len([link for link in found["links"] if not link["flags"]]), 2)

    def test_the_outlet_side_is_refused_by_the_way_that_identifies_inlet_sides(self):
        run = placedpar("identify", "record.csv", "--side", "outlet", "--way", "service")
        self.assertEqual((run.returncode, run.stderr),
                         (1, "placedpar: --side outlet works only with --way thesis or whole; --way service identifies "
                             "inlet sides\n"))


if __name__ == "__main__":
    unittest.main()
