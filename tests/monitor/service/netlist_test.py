"""Tests `placedpar monitor --on`: what a simulated machine answers to each movement, and when."""

import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest
import urllib.request

from service import CONFIGURATION, PROGRAM, SECONDS, ServiceTest, boom

EXAMPLES = pathlib.Path(os.environ["PLACEDPAR_DOCUMENT"]).parents[2] / "examples"
FIGURE_E2 = EXAMPLES / "thesis/figure-e2/figure-e2.cfs"
FIGURE_D1 = EXAMPLES / "machine/figure-d1/figure-e2-on-d1.cfs"
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
SENSORS = EXAMPLES / "machine/figure-d1/sensor-to-alarm.cfs"
SLOW = f"""#include "{FIGURE_E2}"
T800 a, b; /* 200,000 messages between them take some tenths of a second to simulate */
connect a.link[0] to b.link[0];
process (interface (output out)) source;
process (interface (input in)) sink;
use "csp.producer" for source;
use "csp.consumer" for sink;
source (count = 200000);
sink (count = 200000);
connect source.out to sink.in;
place source on a;
place sink on b;
"""
PERIOD_S = 0.020
FIELDS = {"inlet_pressure": "inlet_psi", "angle": "angle_deg", "spool": "spool_in", "servo": "servo_V",
          "inlet_area": "inlet_in2", "bypass_area": "bypass_in2"}
SYMBOLS = {"bucket": "BU", "boom": "BO", "stick": "ST", "swing": "SW"}
END = {"type": "configuration", "configuration": "a", "active": []}  # a new configuration ends the movement


def in_time(answers):
    """Returns the time from the last sample to its answer, and whether every answer comes within a period, for a
    machine that begins to work on a sample when it is taken."""
    first_s = answers[0]["taken_s"] - 4 * PERIOD_S  # the first answer needs five samples
    done_s, before_s, late_s = first_s, 0, []
    for each in answers:
        done_s = max(done_s, each["taken_s"]) + each["ready_s"] - before_s
        before_s = each["ready_s"]
        late_s.append(done_s - each["taken_s"])
    return late_s[-1], max(late_s) <= PERIOD_S


class OnNetlist(ServiceTest):
    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=SECONDS, check=True)

    def movement(self, *arguments, valve=("spool",)):
        """Returns the columns and rows of a record, with these sensors of the valves only."""
        path = self.folder / "movement.csv"
        self.run_program("record", *arguments, "--out", path)
        lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        table = list(csv.reader(lines))
        keep = [i for i, name in enumerate(table[0])
                if re.match(rf"time|\w+\.(inlet_pressure|angle|{'|'.join(valve)}) ", name)]
        return [table[0][i] for i in keep], [[float(row[i]) for i in keep] for row in table[1:]]

    @staticmethod
    def sample(columns, row, later_s=0):
        links = {}
        for name, value in list(zip(columns, row))[1:]:
            link, sensor = name.split()[0].split(".")
            value = value if sensor in ("inlet_pressure", "angle", "servo") else max(value, 0)
            links.setdefault(SYMBOLS[link], {})[FIELDS[sensor]] = value
        return {"type": "sample", "time_s": round(row[0] + later_s, 6), "links": links}

    def identified(self, columns, rows, *arguments):
        """Returns what `identify --way thesis --on` finds in these rows."""
        path, found = self.folder / "rows.csv", self.folder / "found.json"
        path.write_text("\n".join([",".join(columns)] + [",".join(map(repr, row)) for row in rows]) + "\n", encoding="utf-8")
        self.run_program("identify", path, "--way", "thesis", "--json", found, *arguments)
        return json.loads(found.read_text(encoding="utf-8"))["on_machine"]["answers"]

    def check_equal(self, said, answers):
        """Checks that an answer of the service has the compliances of the last answer of identify."""
        last = answers[-1]
        fittest = last["found"][int(re.search(r"\[(\d+)\]|$", last["fittest"])[1] or 0)]
        self.assertEqual(list(said["compliance_in3_per_psi"].values()), [float(f"{value:.6g}") for value in fittest])
        self.assertEqual(said["process"], last["fittest"])
        after_s, keeps_pace = in_time(answers)
        self.assertAlmostEqual(said["after_s"], after_s, 5)
        self.assertEqual(said["keeps_pace"], keeps_pace)
        self.assertAlmostEqual(said["sample_s"], last["taken_s"], 6)

    def test_each_movement_is_answered_as_identify_answers_it(self):
        for valve in ("spool", "servo"):
            client = self.client(self.service("--seed", 7, "--on", FIGURE_E2), "digger")
            client.ask(**CONFIGURATION)
            sent, begin_s = [], 0
            for seed in range(3001, 3004):
                columns, rows = self.movement("excavator", "--seed", seed, valve=(valve,))
                for row in rows:
                    sent.append([round(begin_s + row[0], 6), *row[1:]])
                    client.send(**self.sample(columns, sent[-1]))
                begin_s += 7
            client.send(**END)
            for _ in range(3):
                said = client.receive_type("netlist")
                rows = [row for row in sent if said["from_s"] - 1e-6 < row[0] < said["to_s"] + 1e-6]
                self.assertGreater(len(rows), 100)
                self.check_equal(said, self.identified(columns, rows, "--seed", 7, "--offset", "none", "--on", FIGURE_E2))
                self.assertLess(abs(said["compliance_in3_per_psi"]["BO"] / 0.0086 - 1), 0.35, valve)

    def test_several_links_and_another_configuration(self):
        columns, rows = self.movement("links", "--link", "bucket,boom", "--noise", "low", valve=("inlet_area", "bypass_area"))
        client = self.client(self.service("--on", FIGURE_E2), "digger")
        client.ask(type="configuration", configuration="a", active=["BU", "BO"])
        for row in rows:
            client.send(**self.sample(columns, row))
        client.send(**END)
        said = client.receive_type("netlist")
        self.assertEqual((said["set"], set(said["compliance_in3_per_psi"])), ("P2a", {"BU", "BO"}))
        self.check_equal(said, self.identified(columns, rows, "--link", "bucket,boom", "--on", FIGURE_E2))
        self.assertIn('string_bytes = 2, but a string of "boom" has 3 bytes', said["warnings"])  # made for one link

    def test_fast_readings_are_averaged_as_identify_averages_them(self):
        columns, rows = self.movement("excavator", "--set", "sensors.period=0.005", "--seed", 4)
        self.assertAlmostEqual(rows[1][0], 0.005)
        client = self.client(self.service("--on", FIGURE_E2), "digger", period_s=0.005)
        client.ask(**CONFIGURATION)
        for row in rows:
            client.send(**self.sample(columns, row))
        client.send(**END)
        self.check_equal(client.receive_type("netlist"),
                         self.identified(columns, rows, "--offset", "none", "--on", FIGURE_E2))

    def answer_to(self, *options, machine="digger"):
        """Returns the answer to one movement of a boom, and the service."""
        service = self.service(*options)
        client = self.client(service, machine)
        client.ask(**CONFIGURATION)
        for i in range(40):
            client.send(**boom(i))
        client.send(**END)
        return client.receive_type("netlist"), service

    def test_the_time_is_that_of_a_machine_whose_sensors_read_in_time(self):
        for trials, keeps_pace in ((1, True), (2, True), (3, False), (5, False)):
            computed, _ = self.answer_to("--trials", trials, "--on", FIGURE_D1)
            simulated, _ = self.answer_to("--trials", trials, "--on", SENSORS, "--set", 'problem="boom"')
            self.assertEqual(computed["compliance_in3_per_psi"], simulated["compliance_in3_per_psi"])
            self.assertAlmostEqual(computed["after_s"], simulated["after_s"], delta=0.006)
            self.assertEqual((computed["keeps_pace"], simulated["keeps_pace"]), (keeps_pace, keeps_pace))

    def test_nobody_waits_for_a_search_and_movements_beyond_the_queue_are_skipped(self):
        slow = self.folder / "slow.cfs"
        slow.write_text(SLOW, encoding="utf-8")
        service = self.service("--on", slow)
        client, other = self.client(service, "digger"), self.client(service)
        client.ask(**CONFIGURATION)
        for movement in range(30):
            for i in range(20):
                client.send(**boom(i, start_s=10 * movement))
        client.send(**END)
        client.send(type="ping")
        answers, searched_before_pong = [], None
        while len(answers) < 30:
            message = client.receive()
            if message["type"] == "netlist":
                answers.append(message)
                self.assertEqual(other.ask(type="ping")["type"], "pong")
            if message["type"] == "pong":
                searched_before_pong = sum("keeps_pace" in each for each in answers)
        searched = sum("keeps_pace" in each for each in answers)
        self.assertLess(searched_before_pong, 10)  # a service that waited for its searches would have made all 30
        self.assertEqual([each["text"] for each in answers if "keeps_pace" not in each],
                         (30 - searched) * ["skipped: too many movements wait for the search"])
        self.assertTrue(16 <= searched < 26, searched)
        self.assertEqual(sorted(each["from_s"] for each in answers), [10 * movement for movement in range(30)])
        client.send(**CONFIGURATION)
        for i in range(20):
            client.send(**boom(i, start_s=1000))
        client.send(**END)
        client.receive_type("configured")
        self.assertEqual(service.stop()[0], 0)  # it does not wait for more than the search under way

    def test_the_same_samples_and_seed_give_the_same_answer(self):
        answers = [self.answer_to("--on", FIGURE_E2, "--seed", seed)[0] for seed in (3, 3, 4)]
        self.assertEqual(answers[0], answers[1])
        self.assertNotEqual(answers[0]["process"] + str(answers[0]["compliance_in3_per_psi"]),
                            answers[2]["process"] + str(answers[2]["compliance_in3_per_psi"]))

    def test_watchers_the_page_and_the_log_have_it_and_a_forgotten_machine_has_none(self):
        said, service = self.answer_to("--on", FIGURE_E2, "--http", 0)
        snapshot = lambda: json.load(urllib.request.urlopen(service.page + "snapshot"))["machines"]
        self.assertEqual(snapshot()[0]["netlist"], [said])
        silent = self.client(service, "digger", role="watch", answers="none")
        control = self.client(service, "digger", anew=True)
        self.assertEqual(snapshot()[0]["netlist"], [])
        control.ask(**CONFIGURATION)
        for i in range(40):
            control.send(**boom(i))
        control.send(**END)
        self.assertEqual(control.receive_type("netlist")["compliance_in3_per_psi"], said["compliance_in3_per_psi"])
        self.assertEqual(silent.ask(type="ping")["type"], "configured")
        self.assertRegex(service.stop()[1], r"digger: answer of the netlist's processes for BO, samples from 0\.00 to 0\.7\d s: BO 0\.008\d\d in\^3/psi, "
                                            r"0\.\d{3} s after the sample at 0\.\d\d s; keeps pace: no\n")

    @unittest.skipUnless(BROWSER, "no Chromium")
    def test_the_page_shows_the_answer(self):
        said, service = self.answer_to("--on", FIGURE_E2, "--http", 0)
        page = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=5000",
                               f"--user-data-dir={self.folder / 'browser'}", "--dump-dom", service.page],
                              capture_output=True, text=True, timeout=SECONDS, check=True).stdout
        self.assertIn(f"netlist: {said['text']} (P1b)</td>", page)

    def test_a_movement_that_the_netlist_cannot_search_is_answered_with_the_reason(self):
        service = self.service("--on", SENSORS, "--set", 'problem="boom"')
        slow = self.client(service, "slow", period_s=0.03)
        slow.ask(**CONFIGURATION)
        for i in range(40):
            slow.send(**{**boom(i), "time_s": round(0.03 * i, 6)})
        slow.send(**END)
        self.assertIn('period = 20 ms in the netlist for "sensors", but the samples are 30 ms apart',
                      slow.receive_type("netlist")["text"])
        steady = self.client(service, "steady")
        steady.ask(**CONFIGURATION)
        for i in range(60):  # the pressure hardly rises
            links = {"BO": {**boom(1)["links"]["BO"], "angle_deg": 0.1 * i}}
            steady.send(type="sample", time_s=round(0.02 * i, 6), links=links)
        steady.send(**END)
        self.assertIn("0 usable samples, expected at least 5", steady.receive_type("netlist")["text"])

    def test_a_netlist_that_cannot_search_is_refused_at_the_start(self):
        wrong = self.folder / "wrong.cfs"
        wrong.write_text("T800 t;\nprocess (interface (input in)) p;\nuse \"csp.consumer\" for p;\nplace p on u;\n")
        said = self.refusal("--on", wrong)
        self.assertRegex(said, r"wrong\.cfs:4:12: error: .*\"u\"")
        self.assertRegex(self.refusal("--on", SENSORS), r"sensor-to-alarm\.cfs:\d+:\d+: error: unknown search problem "
                                                        r"'leaking-boom'; known: boom, boom-by-voltage")
        self.assertIn("the netlist's searches have 120 individuals in all, but the identification has 60: give --population 120",
                      self.refusal("--on", FIGURE_E2, "--set", "population=30", "--population", 60))
        self.assertIn("no process searches", self.refusal("--on", EXAMPLES / "machine/links/link.cfs"))
        self.assertIn("none.cfs", self.refusal("--on", self.folder / "none.cfs"))
        self.assertIn("--set requires --on", self.refusal("--set", "clusters=1"))


if __name__ == "__main__":
    unittest.main()
