"""Tests the trend of a machine over many records: `identify FIRST SECOND ... --trend FILE`."""

import json
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from program import EXAMPLES, PROGRAM, placedpar

RECORDS = EXAMPLES / "hydraulics" / "records"
TRUTH = 0.0086


class Trends(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def record(self, name, seed, *settings):
        run = placedpar("record", "excavator", "--seed", seed, "--out", self.folder / name,
                        *[word for setting in settings for word in ("--set", setting)])
        self.assertEqual(run.returncode, 0, run.stderr)
        return self.folder / name

    def trend(self, records, *options, code=0):
        out = self.folder / "trend.json"
        run = placedpar("identify", *records, "--json", out, *options)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        return json.loads(out.read_text(encoding="utf-8")), run

    def test_a_hose_that_goes_soft_is_found_between_its_records(self):
        days = [self.record(f"day-2024-03-{day:02}.csv", 7000 + day) for day in range(1, 6)]
        days += [self.record(f"day-2024-03-{day:02}.csv", 7000 + day, "boom.inlet_compliance=0.0120") for day in range(6, 9)]
        picture = self.folder / "trend.svg"
        result, run = self.trend(reversed(days), "--trend", picture)
        self.assertEqual([each["date"] for each in result["records"]], [f"2024-03-{day:02}" for day in range(1, 9)])
        (change,) = [each for each in result["changes"] if each["what"] == "compliance"]
        self.assertEqual((change["after"], change["until"]), (str(days[4]), str(days[5])))
        self.assertAlmostEqual(change["before"], TRUTH, delta=0.1 * TRUTH)
        self.assertAlmostEqual(change["now"], 0.0120, delta=0.0012)
        self.assertIn("boom: the compliance rises by ", run.stdout)
        svg = picture.read_text(encoding="utf-8")
        for text in ("boom: the compliance rises by", "2024-03-04", "in³/psi"):
            self.assertIn(text, svg)
        placedpar("identify", *days, "--strict", "--trend", picture)
        self.assertEqual(picture.read_text(encoding="utf-8"), svg)
        self.assertEqual(self.trend(days, "--strict", code=3)[0]["changes"], result["changes"])

    def test_a_sound_machine_does_not_change(self):
        result, run = self.trend([self.record(f"{seed}.csv", 7100 + seed) for seed in range(6)])
        self.assertEqual(result["changes"], [])
        self.assertIn("boom: no change of compliance, leak or spool offset is found", run.stdout)
        said = "with fewer than 6 records only the standard errors decide whether a change is reported"
        self.assertNotIn(said, run.stdout)
        self.assertIn(said, self.trend([each["record"] for each in result["records"][:5]])[1].stdout)
        self.assertIn("not every record has a date, so the records are in the order of the command line", run.stdout)
        for each in result["records"]:
            (boom,) = each["links"]
            found = boom["compliance_in3_per_psi"]
            self.assertLess(abs(found["value"] - TRUTH), 4 * found["standard_error"])

    def test_a_date_in_the_record_precedes_the_date_in_its_name(self):
        loggers = EXAMPLES / "hydraulics" / "loggers"
        shutil.copy(loggers / "gateway.csv", self.folder / "2024-03-06.csv")  # its first time is of March 5
        shutil.copy(loggers / "gateway-zone.csv", self.folder / "b.csv")      # an hour earlier
        result, _ = self.trend([self.folder / "2024-03-06.csv", self.folder / "b.csv"], "--column", "time=timestamp")
        self.assertEqual([(each["record"], each["date"]) for each in result["records"]],
                         [(str(self.folder / "b.csv"), "2024-03-05 13:30"),
                          (str(self.folder / "2024-03-06.csv"), "2024-03-05 14:30")])

    def test_a_date_in_the_folder_counts_if_the_name_has_none(self):
        paths = []
        for day, name in ((7, "boom.csv"), (6, "boom.csv"), (6, "2024-03-08.csv")):
            path = self.folder / f"2024-03-{day:02}" / name
            path.parent.mkdir(exist_ok=True)
            shutil.copy(RECORDS / "boom-4deg.csv", path)
            paths.append(str(path))
        picture = self.folder / "trend.svg"
        result, run = self.trend(paths, "--trend", picture)
        self.assertIn("no change of the compliance is found", picture.read_text(encoding="utf-8"))
        self.assertIn("95 % interval", run.stdout)
        self.assertEqual([each["warnings"] for each in result["records"]], [[], [], []])
        self.assertEqual([(each["record"], each["date"]) for each in result["records"]],
                         [(paths[1], "2024-03-06"), (paths[0], "2024-03-07"), (paths[2], "2024-03-08")])

    def test_a_machine_that_moves_has_a_trend_too(self):
        job = EXAMPLES / "hydraulics" / "digging" / "dig.toml"
        paths = [self.folder / f"{seed}.csv" for seed in (1, 2)]
        for seed, path in enumerate(paths, 1):
            placedpar("record", "excavator", "--job", job, "--seed", seed, "--out", path)
        result, _ = self.trend(paths)
        links = [each["link"] for each in result["records"][0]["links"]]
        self.assertIn("boom", links)
        for each in result["records"]:
            for link in each["links"]:
                if found := link["compliance_in3_per_psi"]:  # the equations' error varies by 3 % of the compliance
                    self.assertGreater(found["standard_error"], 0.025 * found["value"])
        self.assertEqual(result["changes"], [])
        result, _ = self.trend(paths, "--link", "boom")
        self.assertEqual({link["link"] for each in result["records"] for link in each["links"]}, {"boom"})
        for option in (("--window", 8), ("--areas-from", "areas"), ("--offset", 0.01)):
            run = placedpar("identify", *paths, *option)
            self.assertEqual(run.returncode, 1, option)
            self.assertIn("--window, --areas-from and --offset need --configuration", run.stderr)

    def test_records_with_other_sources_of_areas_are_not_compared(self):
        servo = self.record("servo.csv", 7200)
        lines = [line for line in servo.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        spool_at = lines[0].split(",").index("boom.spool [in]")
        servo.write_text("".join(",".join(cell for i, cell in enumerate(line.split(",")) if i != spool_at) + "\n"
                                 for line in lines), encoding="utf-8")
        self.assertIn("boom.servo [V]", lines[0])
        both = self.record("both.csv", 7201)
        run = placedpar("identify", both, servo)
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertIn(f"{servo}: the compliance of the boom is found from the servo-valve's voltage, but in {both} from the "
                      "spool: expected one source in all records; choose it by --areas-from", run.stderr)
        self.trend([both, servo], "--areas-from", "servo")

    def test_wrong_use_is_refused(self):
        step, picture = RECORDS / "boom-4deg.csv", self.folder / "trend.svg"
        for arguments, said in (([step, "--trend", picture], "--trend needs at least two records"),
                                ([step, step, "--way", "thesis"], "2 records are given, but --way thesis takes one"),
                                ([step, step, "--side", "outlet"],
                                 "2 records are given, but --side outlet takes one record; several records need --side "
                                 "inlet and --way service, which shows their trend\n"),
                                ([step, step, "--trend", step], "boom-4deg.csv"),
                                (["-", "-"], "standard input can be read only once"),
                                ([step, self.folder / "none.csv", "--trend", picture], "this file does not exist")):
            run = placedpar("identify", *arguments)
            self.assertEqual(run.returncode, 1, arguments)
            self.assertIn(said, run.stderr)
        run = subprocess.run([PROGRAM, "identify", step, self.folder / "none.csv", "--trend", picture], env={"PATH": str(self.folder)},
                             capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn("gnuplot", run.stderr)  # said before the missing record
        self.assertFalse(picture.exists())

    def test_an_interrupted_trend_shows_what_it_has_and_draws_nothing(self):
        picture = self.folder / "trend.svg"
        with subprocess.Popen(f"cat {RECORDS / 'boom-4deg.csv'}; exec sleep 60", shell=True, stdout=subprocess.PIPE) as logger:
            run = subprocess.Popen([PROGRAM, "identify", RECORDS / "boom-two-steps.csv", "-", "--trend", picture],
                                   stdin=logger.stdout, stdout=subprocess.PIPE, text=True)
            time.sleep(2)
            run.send_signal(signal.SIGINT)
            printed, _ = run.communicate(timeout=20)
            logger.kill()
        self.assertEqual(run.returncode, 130)
        self.assertTrue(re.search(r"boom-two-steps\.csv +-", printed, re.MULTILINE), printed)
        self.assertFalse(picture.exists())


if __name__ == "__main__":
    unittest.main()
