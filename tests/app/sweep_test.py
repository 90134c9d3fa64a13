"""Tests placedpar sweep: results of a study's runs survive interruptions and do not depend on how they are made."""

import contextlib
import fcntl
import json
import os
import pathlib
import pty
import resource
import signal
import sqlite3
import subprocess
import tempfile
import termios
import time
import unittest

from interruption_test import wait_until_it_listens
from program import EXAMPLES, FIGURE_E2, PROGRAM, fingerprint, placedpar
from results_file import opened, renew_checksums

RING = EXAMPLES / "csp/deadlock" / "ring.cfs"
COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
LONG = ["sweep", str(FIGURE_E2), "slaves=0..3", "--seeds", "12", "--measure", "master.T_exe"]


def rows(path):
    """Returns all stored rows."""
    with opened(path) as database:
        return list(database.execute("SELECT * FROM runs ORDER BY settings, seed"))


def figures(path, name):
    """Returns {settings: figure} of the first seed."""
    with opened(path) as database:
        return {settings: json.loads(text)[name][0] for settings, text in
                database.execute("SELECT settings, figures FROM runs WHERE seed = 1")}


def figures_of(path):
    """Returns all names."""
    with opened(path) as database:
        return sorted({name for text, in database.execute("SELECT figures FROM runs") for name in json.loads(text)})


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def sweep(self, *arguments, code=0, **options):
        done = placedpar("sweep", *arguments, folder=self.folder, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout if code == 0 else done.stderr

    def report(self, *arguments):
        done = placedpar("report", *arguments, folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def study(self, text, name="study.toml"):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name


class Sweep(InFolder):
    def test_a_row_is_all_that_is_needed_to_make_a_run_again(self):
        self.sweep(FIGURE_E2, "slaves=0,2", "linkspeed=5M,20M", "master.trials=7", "--seeds", 2)
        kept = rows(self.folder / "figure-e2.sqlite")
        self.assertEqual(len(kept), 8)
        self.assertEqual(len({row[4] for row in kept}), 8)
        for row in kept:
            settings = [word for name, value in json.loads(row[0]).items() for word in ("--set", f"{name}={value}")]
            run = placedpar("run", FIGURE_E2, "--seed", row[1], *settings)
            self.assertEqual(fingerprint(run.stdout), row[4])
        with opened(self.folder / "figure-e2.sqlite") as database:
            texts = dict(database.execute("SELECT path, text FROM texts"))
        self.assertEqual(texts[str(FIGURE_E2)], FIGURE_E2.read_text(encoding="utf-8"))
        self.assertEqual(len(texts), 4) # the netlist and its included files

    def test_it_makes_the_same_on_any_number_of_workers_and_after_any_number_of_deaths(self):
        dumps = []
        for jobs in (1, 2, 5):
            self.sweep(*LONG[1:], "--jobs", jobs, "--results", f"{jobs}.sqlite")
            dumps.append(rows(self.folder / f"{jobs}.sqlite"))
        killed = []
        for seconds in (0.02, 0.05, 0.1, 0.15, 0.2):
            with subprocess.Popen([PROGRAM, *LONG, "--results", "killed.sqlite", "--jobs", "2"], cwd=self.folder,
                                  stdout=subprocess.DEVNULL) as process:
                time.sleep(seconds)
                process.send_signal(signal.SIGKILL)
            try:
                killed.append(len(rows(self.folder / "killed.sqlite")))
            except sqlite3.OperationalError:
                killed.append(0) # killed before there was a table
        self.assertEqual(killed, sorted(killed))
        self.assertTrue(any(0 < count < 48 for count in killed), killed)
        self.sweep(*LONG[1:], "--results", "killed.sqlite")
        dumps.append(rows(self.folder / "killed.sqlite"))
        self.assertEqual(len(dumps[0]), 48)
        for dump in dumps[1:]:
            self.assertEqual(dump, dumps[0])
        self.assertEqual(sorted(each.name for each in self.folder.iterdir()),
                         ["1.sqlite", "2.sqlite", "5.sqlite", "killed.sqlite"])

    def test_what_is_there_is_not_made_again(self):
        self.sweep(FIGURE_E2, "slaves=1", "--seeds", 2)
        with opened(self.folder / "figure-e2.sqlite") as database:
            database.execute("UPDATE runs SET fingerprint = '000000000000abcd'")
            renew_checksums(database)
        self.sweep(FIGURE_E2, "slaves=1", "--seeds", 3)
        self.assertEqual([row[4] == "000000000000abcd" for row in rows(self.folder / "figure-e2.sqlite")],
                         [True, True, False])

    def test_a_signal_ends_it_and_what_ended_is_kept(self):
        with subprocess.Popen([PROGRAM, *LONG[:3], "--seeds", "1000"], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as process:
            wait_until_it_listens(process, signal.SIGINT)
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            output, errors = process.communicate(timeout=20)
        self.assertEqual((process.returncode, output), (130, ""))
        self.assertIn("figure-e2.sqlite keeps the finished runs: type the same command again to continue", errors)
        self.assertGreater(len(rows(self.folder / "figure-e2.sqlite")), 0)
        self.assertEqual(os.listdir(self.folder), ["figure-e2.sqlite"])

    def test_a_file_says_the_same_as_the_command_line(self):
        self.study(f"""
            netlist = "{FIGURE_E2}"
            measure = ["master.T_exe", "max(t.busy)"]
            seeds = 2
            where = "slaves <= 1 || linkspeed == 20M"
            [set]
            slaves = "0..4..2"
            linkspeed = ["5M", "20M"]
            master.trials = 7
            [[also]]
            set = {{slaves = 1}}""")
        self.sweep("study.toml")
        kept = {(row[0], row[1]) for row in rows(self.folder / "study.sqlite")}
        wanted = [(0, "5M"), (0, "20M"), (2, "20M"), (4, "20M")]
        self.assertEqual(kept, {(text, seed) for seed in (1, 2) for text in
                                [f'{{"linkspeed":"{speed}","master.trials":"7","slaves":"{slaves}"}}'
                                 for slaves, speed in wanted] + ['{"slaves":"1"}']})
        self.sweep(FIGURE_E2, "slaves=2", "linkspeed=20M", "master.trials=7")
        text = '{"linkspeed":"20M","master.trials":"7","slaves":"2"}'
        self.assertEqual(figures(self.folder / "figure-e2.sqlite", "master[2].T_exe")[text],
                         figures(self.folder / "study.sqlite", "master[2].T_exe")[text])

    def test_a_study_says_relative_to_what(self):
        text = (f'netlist = "{FIGURE_E2}"\nmeasure = "processors"\nrelative_to = {{slaves = 0, master.trials = 10}}\n'
                '[set]\nslaves = "0..2"\nmaster.trials = 10\n[[also]]\nset = {slaves = 3}\n')
        lines = self.sweep(self.study(text)).splitlines()
        self.assertEqual(lines[1], "relative to master.trials = 10, slaves = 0")
        self.assertEqual([line.split()[-1] for line in lines[3:8]], ["processors", "1", "2", "3", "4"])
        report = placedpar("report", "study.toml", "--relative-to", "slaves=1", folder=self.folder).stdout.splitlines()
        self.assertEqual([line.split()[-1] for line in report[5:9]], ["0.5", "1", "1.5", "-"])  # with trials 10 as well
        self.assertEqual(report[2], "1 run without relative figures, because no matching run with these settings ended in the same way")

    def test_a_run_that_was_stopped_is_not_compared_with_one_that_ended(self):
        self.sweep(COMMSTIME, "count=10,20,1000000000", "--until", "1ms")
        report = placedpar("report", "commstime.cfs", "--relative-to", "count=10", folder=self.folder).stdout.splitlines()
        self.assertEqual([line.split()[2] for line in report[5:8]][::2], ["1", "-"])
        self.assertIn("1 run without relative figures", report[2])

    def test_a_deadlock_a_refusal_and_a_stop_are_results(self):
        self.assertRegex(self.sweep(COMMSTIME, "count=10,1000000000,-1", "--until", "1ms"),
                         r"(?s)-1 +1 +- +refused: .*1000000000 +1 +1 +stopped at the time limit")
        self.assertRegex(self.sweep(RING, "--seeds", 2), "2 +- +deadlock")


class BadInput(InFolder):
    def test_what_a_process_measures_its_kind_describes(self):
        machine = EXAMPLES / "explore/best-machine" / "machine.cfs"
        arguments = [machine, "samples=6", "accuracy=0.1", "--results", "kept"]
        self.sweep(*arguments)
        names = figures_of(self.folder / "kept")
        self.assertIn("host.best_fitness", names)
        self.sweep(*arguments, *(word for name in names for word in ("--measure", name)))

    def test_a_measure_that_no_run_has_is_not_a_misspelling(self):
        machine = EXAMPLES / "explore/best-machine" / "machine.cfs"
        too_short = [machine, "samples=6", "accuracy=0.00001", "--results", "kept"]
        self.sweep(*too_short)
        for measure, about in (("host.accurate_after", "time after which the fittest estimate stays accurate; absent if the last "
                                                       "estimate is not accurate"),
                               ("max(master[0].T_exe)", "mean time of a generation with a full window; all times are absent if the window was never full")):
            told = f'placedpar: no run measured "{measure}": {about}'
            self.assertTrue(self.sweep(*too_short, "--measure", measure, code=1).startswith(told))
            reported = placedpar("report", "kept", "--measure", measure, folder=self.folder)
            self.assertEqual((reported.returncode, reported.stdout), (1, ""))
            self.assertTrue(reported.stderr.startswith(told), reported.stderr)
        for measure in ("host.accurate_aftr", "host.T_exe", "hosts.accurate_after", "master[7].generations", "accurate_after"):
            reported = placedpar("report", "kept", "--measure", measure, folder=self.folder)
            self.assertIn(f'unknown measure "{measure}"', reported.stderr)

    def test_what_does_not_exist(self):
        for arguments, message in (
                (["slavs=1,2"], 'the netlist has no val, attribute or parameter "slavs"'),
                (["slaves=1,2", "--measure", "master.T_ex"], 'unknown measure "master.T_ex"; did you mean "master.T_exe"?'),
                (["slaves=1,2", "--measure", "max(master"], '"max(master" is not a measure'),
                (["slaves=7..0"], "slaves=7..0: the range is empty"),
                (["slaves=0..x"], 'slaves=0..x: "x" is not a number; a range is FROM..TO'),
                (["slaves=0..7..0"], "slaves=0..7..0: the step of a range must be more than 0"),
                (["slaves=1,,2"], "slaves=1,,2: a value is missing"),
                (["slaves"], "slaves: expected NAME=VALUES"),
                (["slaves=1", "slaves=2"], "slaves is set twice"),
                (["slaves=1", "--results", "."], ".: this is a folder; name a file"),
                (["slaves=1", "--results", "no/where"], "no/where: the file cannot be created: No such file or directory")):
            with self.subTest(arguments):
                self.assertIn(message, self.sweep(FIGURE_E2, *arguments, code=1))
        self.assertFalse((self.folder / "figure-e2.sqlite").exists())  # nothing was run
        self.assertIn("nowhere.sqlite: this file does not exist", placedpar("report", "nowhere.cfs").stderr)

    def test_equal_values_are_one_however_they_are_spelled(self):
        head = f'netlist = "{FIGURE_E2}"\nmeasure = "processors"\n'
        self.study(head + 'relative_to = {linkspeed = 20000000, slaves = "1.0"}\n[set]\nlinkspeed = ["5M", "20M", 5000000]\n'
                   'slaves = ["1", "3", "1.0"]\n')
        swept = self.sweep("study.toml")
        self.assertEqual(swept.splitlines()[0], f"{FIGURE_E2}: 4 runs of 4 combinations")
        self.assertEqual(swept.splitlines()[1], "relative to linkspeed = 20M, slaves = 1")
        self.assertEqual([line.split() for line in swept.splitlines()[4:8]],
                         [["5M", "1", "1", "1"], ["5M", "3", "1", "2"], ["20M", "1", "1", "1"], ["20M", "3", "1", "2"]])
        self.assertEqual(len(rows(self.folder / "study.sqlite")), 4)
        reported = placedpar("report", "study.toml", "--relative-to", "linkspeed=5000k", "--relative-to", "slaves=1.0", folder=self.folder)
        self.assertIn("relative to linkspeed = 5M, slaves = 1\n", reported.stdout, reported.stderr)
        self.study(head + '[set]\nlinkspeed = [5000000, "20M"]\nslaves = "1..3"\n')  # some of its runs exist already
        self.assertEqual([line.split() for line in self.report("study.toml").splitlines()[3:]],
                         [["5000000", "1", "1", "8"], ["5000000", "3", "1", "16"], ["20M", "1", "1", "8"], ["20M", "3", "1", "16"]])
        self.sweep("study.toml")  # runs with another spelling of the settings are not counted twice
        self.assertEqual(self.report("study.toml").splitlines()[0], f"{FIGURE_E2}: 6 runs of 6 combinations")

    def test_nothing_is_relative_to_what_no_run_has(self):
        message = "no combination has slaves = 9, so figures cannot be relative to it; the runs set "
        self.study(f'netlist = "{FIGURE_E2}"\nrelative_to = {{slaves = 9}}\n[set]\nslaves = "0..2"\n')
        self.assertIn(message, self.sweep("study.toml", code=1))
        self.assertFalse((self.folder / "study.sqlite").exists())  # nothing was run
        self.sweep(FIGURE_E2, "slaves=0,1", "master.trials=5")
        for setting, said in (("slaves=9", message + "slaves, master.trials"),
                              ("slavs=0", "no combination has slavs = 0, "),
                              ("slaves", "--relative-to slaves: expected NAME=VALUE, such as --relative-to slaves=3")):
            done = placedpar("report", "figure-e2.cfs", "--relative-to", setting, folder=self.folder)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(said, done.stderr)
        placed = placedpar("report", "figure-e2.cfs", "--relative-to", "master.trials=5", folder=self.folder)
        self.assertEqual(placed.returncode, 0, placed.stderr)  # the elements that all combinations have

    def test_a_file_that_is_wrong_is_shown_where(self):
        for text, message in (
                ('netlist = "a.cfs"\nsed = 3\n', 'study.toml:2:1: error: a study has no key "sed"'),
                ('netlist = "a.cfs"\nseeds = 0\n', "study.toml:2:9: error: expected a whole number of at least 1"),
                ('netlist = "a.cfs"\n[set]\nslaves = "3..1"\n', "study.toml:3:10: error: slaves=3..1: the range is empty"),
                ('netlist = "a.cfs"\nwhere = "slaves <"\n', "study.toml:2:9: error: the text cannot be read: where:1:9: error: "),
                ("netlist = \n", "study.toml:1:"), ("seeds = 3\n", "the study names no netlist"),
                ('netlist = "a.cfs"\nrelative_to = {slaves = 1}\n[search]\nminimise = "time"\n',
                 "study.toml:2:15: error: a search cannot use relative figures"),
                ('netlist = "a.cfs"\n[set]\nslaves = "0..2"\nrelative_to = {slaves = 1}\n',
                 'study.toml:4:15: error: "relative_to" belongs to the whole study, not to this table\n    relative_to = {slaves = 1}\n'
                 '                  ^\nhint: move it above [set] and [[also]]\n'),
                ('netlist = "a.cfs"\n[set]\nslaves = "0..2"\n[set.relative_to]\nslaves = 1\n',
                 'study.toml:4:1: error: "relative_to" belongs to the whole study'),
                ('netlist = "a.cfs"\n[[also]]\nrelative_to = {slaves = 1}\nset = {slaves = 1}\n',
                 'study.toml:3:15: error: "relative_to" belongs to the whole study'),
                ('netlist = "a.cfs"\n[[also]]\nset = {slaves = 1, relative_to = {slaves = 1}}\n',
                 'study.toml:3:34: error: "relative_to" belongs to the whole study'),
                ('netlist = "a.cfs"\n[[also]]\nseeds = 3\n', 'study.toml:3:9: error: "seeds" belongs to the whole study'),
                ('netlist = "a.cfs"\n[[also]]\nwere = 3\n', 'study.toml:3:1: error: a study has no key "were"'),
                ('netlist = "a.cfs"\nrelative_to = 3\n', "study.toml:2:15: error: expected a table"),
                ('netlist = "a.cfs"\nrelative_to = {slaves = "1..2"}\n',
                 'study.toml:2:15: error: "slaves" has several values here'),
                ('netlist = "a.cfs"\n[set]\nslaves = []\n', 'study.toml:3:10: error: "slaves" has no values'),
                ('netlist = "a.cfs"\n[set]\n"a.b" = 1\n[set.a]\nb = 2\n', 'study.toml:5:5: error: "a.b" is set twice')):
            with self.subTest(text):
                self.assertIn(message, self.sweep(self.study(text), code=1))
        self.study(f'netlist = "{FIGURE_E2}"\nwhere = "slavs < 3"\n[set]\nslaves = [1, 2]\n')
        self.assertIn('the name "slavs" is undefined', self.sweep("study.toml", code=1))
        self.study(f'netlist = "{FIGURE_E2}"\nwhere = "slaves > 3"\n[set]\nslaves = [1, 2]\n')
        self.assertIn("no combination satisfies the study's condition", self.sweep("study.toml", code=1))

    def test_a_billion_runs_are_not_begun_unasked(self):
        many = [FIGURE_E2, "slaves=0..3", "--seeds", "250000000"]
        self.assertRegex(self.sweep(*many, code=1), r"1,000,000,000 runs of about \S+ s, \d+ \w+ on \d+ cores?; add --yes")

    def test_nothing_large_is_run_before_the_question(self):
        # The last combination has 4,000 transputers. One combination in a hundred is refused, and so are more than a
        # thousand combinations at the start.
        many = FIGURE_E2, "slaves=0..999", "population=1..1000", "master.trials=1..1000"
        self.assertIn("1,000,000,000 runs of about", self.sweep(*many, code=1))

    def test_more_runs_than_can_be_counted_are_refused(self):
        for arguments, message in (
                (["slaves=0..65535", "linkspeed=1..65536", "population=1..65536", "master.trials=1..65536"],
                 "the study has too many runs to count: all combinations of 4 settings with several values (65536 of slaves,"),
                (["slaves=0..3", "--seeds", 2 ** 62], "(4 of slaves), each run with 4611686018427387904 seeds, are more than"),
                (["--seed", 2 ** 64 - 1, "--seeds", 2], "2 seeds from 18446744073709551615 on are too many: the greatest seed")):
            with self.subTest(arguments):
                self.assertIn(message, self.sweep(FIGURE_E2, *arguments, "--yes", code=1))
        self.assertEqual(os.listdir(self.folder), [])

    def test_no_runs_at_once_or_more_than_there_are_threads_are_refused(self):
        for jobs in ("0", "1001", str(2 ** 63), "-1", "two"):
            with self.subTest(jobs):
                self.assertIn(f'"{jobs}" is not a whole number from 1 to 1000', self.sweep(FIGURE_E2, "slaves=0..1", "--jobs", jobs, code=1))
        self.assertEqual(os.listdir(self.folder), [])

    def test_what_a_condition_leaves_is_found_wherever_it_is(self):
        self.study(f'netlist = "{COMMSTIME}"\nwhere = "count == 7"\n[set]\ncount = "1..1000"\n')
        self.assertIn("count = 7", self.sweep("study.toml"))

    def test_results_of_another_study_or_version_are_left_alone(self):
        self.sweep(FIGURE_E2, "slaves=1", "--results", "kept")
        before = rows(self.folder / "kept")
        self.assertIn("kept: the file's runs were made from", self.sweep(RING, "--results", "kept", code=1))
        self.assertIn("with other options", self.sweep(FIGURE_E2, "--until", "1ms", "--results", "kept", code=1))
        with opened(self.folder / "kept") as database:
            database.execute("UPDATE study SET version = '0.0.1'")
            renew_checksums(database)
        self.assertIn("kept: the file's runs were made by version 0.0.1", self.sweep(FIGURE_E2, "--results", "kept", code=1))
        self.assertEqual(rows(self.folder / "kept"), before)
        self.sweep(FIGURE_E2, "--results", "kept", "--any-version")
        self.assertEqual(len(rows(self.folder / "kept")), 2)
        with opened(self.folder / "kept") as database:
            database.execute("PRAGMA user_version = 99")
        self.assertIn("from a later version of PlacedPar", self.sweep(FIGURE_E2, "--results", "kept", code=1))
        with opened(self.folder / "other") as database:
            database.execute("CREATE TABLE t(x)")
        self.assertIn("a database of another program", self.sweep(FIGURE_E2, "--results", "other", code=1))
        self.study("text", "note")
        self.assertIn("note: the file is not a results file", self.sweep(FIGURE_E2, "--results", "note", code=1))
        self.assertEqual((self.folder / "note").read_text(encoding="utf-8"), "text")

    def test_a_full_disk_loses_nothing(self):
        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

        done = subprocess.run([PROGRAM, *LONG], cwd=self.folder, capture_output=True, text=True, check=False,
                              preexec_fn=little_room, restore_signals=False) # SIGXFSZ stays ignored, so the error is reported
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("its finished runs are kept: type the same command again to continue", done.stderr)
        kept = rows(self.folder / "figure-e2.sqlite")
        self.assertGreater(len(kept), 0)
        self.sweep(*LONG[1:])
        self.assertLess(set(kept), set(rows(self.folder / "figure-e2.sqlite")))
        self.assertEqual(len(rows(self.folder / "figure-e2.sqlite")), 48)

    def test_two_sweeps_do_not_share_a_file(self):
        with subprocess.Popen([PROGRAM, "sweep", str(COMMSTIME), "count=1000000000"], cwd=self.folder,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as first:
            wait_until_it_listens(first, signal.SIGINT)
            self.assertIn("commstime.sqlite: another placedpar sweep or optimise is using the file", self.sweep(COMMSTIME, code=1))
            first.send_signal(signal.SIGINT)


class Question(InFolder):
    """Tests the question before a billion runs, asked on the program's controlling terminal."""

    def setUp(self):
        super().setUp()
        self.terminal, end = pty.openpty()
        self.addCleanup(os.close, self.terminal)
        self.process = subprocess.Popen([PROGRAM, "sweep", FIGURE_E2, "slaves=0..3", "--seeds", "250000000"], cwd=self.folder,
                                        stdin=end, stderr=end, stdout=subprocess.PIPE, start_new_session=True,
                                        preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
        self.addCleanup(self.process.kill)
        os.close(end)
        self.told = b""
        while not self.told.endswith(b"Begin? [y/N] "):
            self.told += os.read(self.terminal, 4096)

    def end(self, code):
        """Returns the output after the question. The stored runs are complete: two were made to estimate the time of a
        run, since other seeds may be quicker than the first."""
        said = len(self.told)
        self.assertEqual(self.process.communicate(timeout=20)[0], b"")
        with contextlib.suppress(OSError): # on Linux: the other end is closed
            while part := os.read(self.terminal, 4096):
                self.told += part
        self.assertEqual(self.process.returncode, code, self.told)
        self.assertEqual(os.listdir(self.folder), ["figure-e2.sqlite"])
        with opened(self.folder / "figure-e2.sqlite") as database:
            self.assertEqual(database.execute("PRAGMA integrity_check").fetchall(), [("ok",)])
        self.assertEqual(len(rows(self.folder / "figure-e2.sqlite")), 2)
        return self.told[said:]

    def ends_interrupted(self):
        told = self.end(code=130)
        self.assertTrue(told.endswith(b"\r\ninterrupted; figure-e2.sqlite keeps the finished runs: "
                                      b"type the same command again to continue\r\n"), told)

    def test_no_begins_nothing(self):
        os.write(self.terminal, b"n\n")
        self.assertEqual(self.end(code=0), b"n\r\n")

    def test_no_answer_is_a_no(self):
        os.write(self.terminal, b"\n")
        self.assertEqual(self.end(code=0), b"\r\n")

    def test_the_end_of_all_answers_is_a_no(self):
        os.write(self.terminal, b"\x04") # Ctrl-D
        self.assertEqual(self.end(code=0), b"\r\n")

    def test_ctrl_c_is_an_interruption(self):
        os.write(self.terminal, b"y\x03") # an unfinished answer does not count
        self.ends_interrupted()

    def test_sigint_is_an_interruption(self):
        self.process.send_signal(signal.SIGINT)
        self.ends_interrupted()

    def test_sigterm_is_an_interruption(self):
        self.process.send_signal(signal.SIGTERM)
        self.ends_interrupted()

    def test_a_yes_begins(self):
        os.write(self.terminal, b"y\n")
        while b" runs, " not in self.told:
            self.told += os.read(self.terminal, 4096)
        self.process.send_signal(signal.SIGTERM)
        self.process.communicate(timeout=20)
        self.assertEqual(self.process.returncode, 130)
        self.assertGreaterEqual(len(rows(self.folder / "figure-e2.sqlite")), 1)


if __name__ == "__main__":
    unittest.main()
