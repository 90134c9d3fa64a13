"""Tests identification as the monitor does it, on whole records: movements, verdicts, real logs, pipes."""

import json
import pathlib
import random
import signal
import subprocess
import tempfile
import time
import unittest

from program import EXAMPLES, PROGRAM, placedpar

RECORDS = EXAMPLES / "hydraulics" / "records"
STEP = RECORDS / "boom-4deg.csv"
TRUTH = 0.0086
SECONDS = 60


def rows_of(path):
    """Returns the lines up to the header, and the rows below it as cells."""
    lines = path.read_text(encoding="utf-8").splitlines()
    header = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    return lines[:header + 1], [line.split(",") for line in lines[header + 1:]]


class Movements(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, head, rows, name="log.csv"):
        path = self.folder / name
        path.write_text("\n".join([*head, *(",".join(row) for row in rows)]) + "\n", encoding="utf-8")
        return path

    def log_of(self, *machines, name="log.csv", pause_s=2.0):
        """Returns one record of many movements, each made with a seed and settings of the measured machine."""
        head, log, begin_s = [], [], 0
        for seed, *settings in machines:
            path = self.folder / "one.csv"
            run = placedpar("record", "excavator", "--seed", seed, "--out", path,
                            *[word for setting in settings for word in ("--set", setting)])
            self.assertEqual(run.returncode, 0, run.stderr)
            head, rows = rows_of(path)
            log += [[f"{begin_s + float(row[0]):.2f}", *row[1:]] for row in rows]
            begin_s = float(log[-1][0]) + pause_s
        return self.write(head, log, name)

    def result(self, *arguments, code=0, **options):
        path = self.folder / "result.json"
        run = placedpar("identify", *arguments, "--json", path, **options)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        return json.loads(path.read_text(encoding="utf-8")), run

    # Findings

    def test_all_movements_of_a_record_and_what_is_said_of_the_machine(self):
        log = self.log_of(*[[seed] for seed in range(2001, 2007)])
        result, run = self.result(log)
        self.assertEqual(len(result["movements"]), 6)
        for movement in result["movements"]:
            (boom,) = movement["links"]
            self.assertAlmostEqual(boom["compliance"], TRUTH, delta=0.2 * TRUTH)
            whole = boom["whole_movement"]
            self.assertAlmostEqual(whole["compliance"], TRUTH, delta=0.1 * TRUTH)
            self.assertLess(whole["standard_error"], 0.1 * TRUTH)
            self.assertLess(movement["from_s"], movement["to_s"])
        self.assertEqual(result["verdicts"][0]["verdict"], "sound")
        self.assertEqual(result["alarms"], [])
        self.assertIn("boom: sound, ", run.stdout)
        self.assertEqual(run.stdout.count("C_BOi"), 6)

    def test_a_leak_that_comes_is_told_and_strict_ends_with_3(self):
        log = self.log_of(*[[seed] for seed in range(2001, 2005)],
                          *[[seed, "fault.leak=0.0028"] for seed in range(2005, 2009)])
        result, run = self.result(log)
        (alarm,) = result["alarms"]
        self.assertEqual((alarm["alarm"], alarm["links"]), ("leak", ["boom"]))
        self.assertIn("leak: boom: a leak of 0.00", run.stdout)
        self.assertEqual(placedpar("identify", log, "--strict").returncode, 3)

    def test_a_soft_hose_is_followed(self):
        log = self.log_of([2001, "boom.inlet_compliance=0.0172"])
        (boom,) = self.result(log)[0]["movements"][0]["links"]
        self.assertAlmostEqual(boom["compliance"], 2 * TRUTH, delta=0.2 * TRUTH)

    def test_a_quick_logger_accuses_no_sound_machine(self):
        for seed in range(1, 5):
            for period_s, said in ((0.005, "200 Hz averaged to 50 Hz, 4 readings each"),
                                   (0.001, "1 kHz averaged to 50 Hz, 20 readings each")):
                path = self.folder / "quick.csv"
                placedpar("record", "excavator", "--seed", seed, "--set", f"sensors.period={period_s}",
                          "--set", "excavator.duration=12", "--out", path)
                result, run = self.result(path)
                self.assertEqual(result["alarms"], [], run.stdout)
                self.assertIn(f"\n{said}\n", run.stdout)
                self.assertEqual(result["sampling"], {"reading_s": period_s, "readings_a_sample": round(0.02 / period_s),
                                                      "sample_s": 0.02})
                self.assertEqual(result["verdicts"][0]["verdict"], "not enough evidence")

    def test_a_soft_hose_is_followed_at_any_rate(self):
        for period_s in (0.0001, 0.0002, 0.001, 0.0077, 0.0167, 0.025):
            path = self.folder / "quick.csv"
            placedpar("record", "excavator", "--seed", 2001, "--set", f"sensors.period={period_s}",
                      "--set", "boom.inlet_compliance=0.0172", "--out", path)
            for way in ([], ["--way", "thesis", "--rising", "--offset", "none"]):
                result, run = self.result(path, *way)
                (boom,) = result["links"] if way else result["movements"][0]["links"]
                compliance = boom["compliance"] if way else boom["whole_movement"]["compliance"]
                self.assertAlmostEqual(compliance, 2 * TRUTH, delta=(0.3 if way else 0.1) * TRUTH, msg=f"{period_s} {way}")
                self.assertEqual("averaged" in run.stdout, period_s < 0.0133)

    def test_a_quick_clock_that_jitters_or_loses_rows_changes_little(self):
        path = self.folder / "quick.csv"
        placedpar("record", "excavator", "--seed", 2001, "--set", "sensors.period=0.001", "--out", path)
        head, rows = rows_of(path)
        draw = random.Random(5)
        for spoil in (lambda row: [f"{float(row[0]) + draw.uniform(-0.0001, 0.0001):.6f}", *row[1:]],
                      lambda row: row if draw.random() < 0.98 else None):
            spoiled = [row for row in map(spoil, rows) if row]
            result = self.result(self.write(head, spoiled))[0]
            whole = result["movements"][0]["links"][0]["whole_movement"] # lost rows end a movement
            self.assertAlmostEqual(whole["compliance"], TRUTH, delta=0.1 * TRUTH)

    def test_rates_that_are_too_slow_or_too_quick_are_refused_with_the_reason(self):
        head, rows = rows_of(STEP)
        for period_s, said in ((0.2, "the readings are 0.2 s apart, expected at most"),
                               (0.00005, "the readings are 5e-05 s apart, expected at least 0.0001 s (10 kHz)")):
            log = self.write(head, [[f"{i * period_s:.5f}", *row[1:]] for i, row in enumerate(rows)])
            for way in ("service", "thesis"):
                run = placedpar("identify", log, "--way", way)
                self.assertEqual(run.returncode, 1, run.stdout)
                self.assertIn(said, run.stderr)

    def test_all_links_that_the_record_has_unless_told(self):
        path = self.folder / "links.csv"
        run = placedpar("record", "links", "--link", "boom,stick", "--configuration", "a", "--noise", "none", "--out", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual([m["set"] for m in self.result(path)[0]["movements"]], ["P1b", "P1c"])
        self.assertEqual([m["set"] for m in self.result(path, "--link", "stick")[0]["movements"]], ["P1c"])
        self.assertIn("no channel bucket.inlet_pressure", placedpar("identify", path, "--link", "bucket").stderr)

    def test_areas_that_are_read_have_no_offset(self):
        log, path = [], self.folder / "one.csv"
        for seed in range(4):
            placedpar("record", "links", "--link", "boom", "--noise", "low", "--seed", 5001 + seed, "--out", path)
            head, rows = rows_of(path)
            log += [[f"{float(row[0]) + 10 * seed:.3f}", *row[1:]] for row in rows]
        result, run = self.result(self.write(head, log))
        (verdict,) = result["verdicts"]
        self.assertEqual((verdict["verdict"], verdict["offset_in"]), ("sound", None))
        self.assertNotIn("spool", run.stdout)

    def test_what_is_of_the_thesis_way_is_refused(self):
        for option in (["--samples", 9], ["--rising"], ["--coding", "gray"], ["--offset", "auto"],
                       ["--on", EXAMPLES / "thesis/table-e1" / "cluster.cfs"]):
            run = placedpar("identify", STEP, *option)
            self.assertEqual(run.returncode, 1)
            also = " or whole;" if option[0] in ("--samples", "--coding") else ""
            self.assertIn("works only with --way thesis" + also, run.stderr)

    def test_an_offset_is_told_and_can_be_taken_off(self):
        for taken_off, left in ((0, -0.01), (-0.01, 0)):
            (boom,) = self.result(RECORDS / "boom-offset.csv", "--offset", taken_off)[0]["movements"][0]["links"]
            offset = boom["whole_movement"]["offset_in"]
            self.assertAlmostEqual(offset["by"], left, delta=2 * offset["standard_error"])
            self.assertLess(offset["standard_error"], 0.005)
        self.assertAlmostEqual(boom["compliance"], TRUTH, delta=0.15 * TRUTH)

    # Logs as control systems write them

    def test_a_valve_that_reads_shut_while_the_boom_rises_is_told(self):
        head, rows = rows_of(STEP)
        dead = self.write(head, [[*row[:4], rows[0][4], *row[5:]] for row in rows])
        result, run = self.result(dead, "--strict", code=3)
        self.assertEqual([alarm["alarm"] for alarm in result["alarms"]], ["sensor"])
        self.assertIn("sensor: boom: the readings are impossible", run.stdout)

    def test_through_a_pipe_it_is_the_same(self):
        whole = placedpar("identify", STEP)
        with open(STEP, encoding="utf-8") as text:
            piped = subprocess.run([PROGRAM, "identify", "-"], stdin=text, capture_output=True, text=True, timeout=SECONDS)
        slow = subprocess.run(f"(head -n 40 {STEP}; sleep 0.5; tail -n +41 {STEP}) | {PROGRAM} identify -", shell=True,
                              capture_output=True, text=True, timeout=SECONDS)
        self.assertEqual((piped.stdout, slow.stdout), (whole.stdout, whole.stdout))
        nothing = subprocess.run([PROGRAM, "identify", "-"], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                 timeout=SECONDS)
        self.assertEqual(nothing.returncode, 1)
        self.assertIn("<standard input>: error: standard input is empty or closed", nothing.stderr)

    def test_a_pipe_that_gives_nothing_more_can_be_interrupted(self):
        with subprocess.Popen(f"cat {STEP}; exec sleep 60", shell=True, stdout=subprocess.PIPE) as logger:
            run = subprocess.Popen([PROGRAM, "identify", "-"], stdin=logger.stdout, stdout=subprocess.PIPE, text=True)
            time.sleep(1)
            run.send_signal(signal.SIGINT)
            printed, _ = run.communicate(timeout=10)
            logger.kill()
        self.assertEqual(run.returncode, 130)
        self.assertIn("C_BOi", printed)  # the results up to that point

    @staticmethod
    def weigh(path):
        """Returns the exit code, the peak memory in kilobytes, and the printed text."""
        script = (f"import resource, subprocess; r = subprocess.run(['{PROGRAM}', 'identify', '{path}'], "
                  "capture_output=True, text=True); print(r.returncode, "
                  "resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss); print(r.stdout + r.stderr)")
        said = subprocess.run(["python3", "-c", script], capture_output=True, text=True, timeout=4 * SECONDS, check=True)
        code, kilobytes = said.stdout.split("\n", 1)[0].split()
        return int(code), int(kilobytes), said.stdout

    def test_many_movements_take_no_more_memory_than_few(self):
        head, rows = rows_of(STEP)
        shut, opened = rows[5][1:], [row[1:] for row in rows[30:52]]

        def movements(count, most=1500):
            """Writes `count` movements, then rest up to the length of `most` movements, so that all files are equally
            long."""
            cells = [shut] * 6 + [*opened, *[shut] * 6] * count + [shut] * 28 * (most - count)
            return self.write(head, [[f"{0.02 * i:.2f}", *row] for i, row in enumerate(cells)], f"{count}.csv")

        few, many = self.weigh(movements(50)), self.weigh(movements(1500))
        self.assertEqual((few[2].count("C_BOi  "), many[2].count("C_BOi  ")), (50, 1500))
        self.assertLess(many[1], few[1] + 1600)  # the rows of the movements alone would be 2 Mbyte

    def test_a_long_log_takes_bounded_memory_and_errors_keep_their_lines(self):
        head, rows = rows_of(STEP)
        times, period_s = [], 0.02
        still = [rows[0][1:]] * 3000  # a minute at rest between movements

        def write(path, movements):
            with open(path, "w", encoding="utf-8") as log:
                log.write("\n".join(head) + "\n")
                line = len(head)
                for i in range(movements * (len(rows) + len(still))):
                    place = i % (len(rows) + len(still))
                    row = rows[place][1:] if place < len(rows) else still[place - len(rows)]
                    log.write(f"{i * period_s:.2f}," + ",".join(row) + "\n")
                    line += 1
            return line

        short, long = self.folder / "short.csv", self.folder / "long.csv"
        write(short, 10)
        last = write(long, 60)
        self.assertGreater(long.stat().st_size, 6 * 2 ** 20)  # the reader takes it in several pieces
        few, many = self.weigh(short), self.weigh(long)
        self.assertEqual((few[0], many[0]), (0, 0))
        self.assertEqual(few[2].count("C_BOi"), 10)
        self.assertEqual(many[2].count("C_BOi"), 60)
        self.assertLess(many[1], few[1] + 8 * 1024)
        with open(long, "a", encoding="utf-8") as log:
            log.write("1e9,1,2,x,4,5\n")
        code, _, said = self.weigh(long)
        self.assertEqual(code, 1)
        self.assertIn(f"long.csv:{last + 1}:", said)
        self.assertIn("1e9,1,2,x,4,5", said)

    def test_rows_that_lack_a_reading_are_left_out_if_asked(self):
        head, rows = rows_of(STEP)
        angle = next(i for i, name in enumerate(head[-1].split(",")) if "angle" in name)
        for i in (3, 60, 61, 150):
            rows[i][angle] = ("", "NaN", "-", "null")[i % 4]
        log = self.write(head, rows)
        refused = placedpar("identify", log)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("--missing skip", refused.stderr)
        result, run = self.result(log, "--missing", "skip")
        self.assertIn("4 rows left out", run.stderr)
        self.assertIn("log.csv:" + str(len(head) + 4), run.stderr)
        self.assertGreaterEqual(len(result["movements"]), 1)
        self.assertIn("4 rows left out",
                      placedpar("identify", log, "--missing", "skip", "--way", "thesis").stderr)

    def test_empty_cells_of_channels_that_are_not_needed_do_not_matter(self):
        head, rows = rows_of(STEP)
        outlet = next(i for i, name in enumerate(head[-1].split(",")) if "outlet" in name)
        for row in rows[10:20]:
            row[outlet] = ""
        log = self.write(head, rows)
        whole = placedpar("identify", STEP)
        self.assertEqual(placedpar("identify", log).stdout, whole.stdout)
        self.assertEqual(placedpar("identify", log, "--way", "thesis").stdout,
                         placedpar("identify", STEP, "--way", "thesis").stdout)

    def test_a_clock_that_jitters_by_a_millisecond_changes_little(self):
        head, rows = rows_of(STEP)
        draw = random.Random(1)
        log = self.write(head, [[f"{float(row[0]) + draw.uniform(-0.001, 0.001):.5f}", *row[1:]] for row in rows])
        result, run = self.result(log)
        self.assertIn("from whole periods of 0.02 s", run.stderr)
        (boom,) = result["movements"][0]["links"]
        self.assertAlmostEqual(boom["whole_movement"]["compliance"], TRUTH, delta=0.1 * TRUTH)

    def test_a_record_at_rest_and_one_without_links_are_refused(self):
        head, rows = rows_of(STEP)
        rest = placedpar("identify", self.write(head, [[f"{0.02 * i:.2f}", *rows[0][1:]] for i in range(100)]))
        self.assertEqual(rest.returncode, 1)
        self.assertIn("no movement was found in 100 samples", rest.stderr)
        bare = self.write(["time [s],boom.angle [deg]"], [[f"{0.02 * i:.2f}", str(i)] for i in range(20)])
        self.assertIn("no channel boom.inlet_pressure; it has boom.angle", placedpar("identify", bare).stderr)


if __name__ == "__main__":
    unittest.main()
