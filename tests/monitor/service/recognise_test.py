"""Tests that the monitor recognises the configuration of a machine that digs, over the socket and over a kill."""

import contextlib
import csv
import pathlib
import signal
import sqlite3
import subprocess
import unittest

from service import PROGRAM, SECONDS, ServiceTest

JOB = pathlib.Path(__file__).resolve().parents[3] / "examples/hydraulics/digging/dig.toml"
READINGS = {"inlet_pressure [psi]": "inlet_psi", "angle [deg]": "angle_deg", "inlet_area [in^2]": "inlet_in2",
            "bypass_area [in^2]": "bypass_in2"}
LINKS = {"bucket": "BU", "boom": "BO", "stick": "ST", "swing": "SW"}


def dug(folder, *settings):
    """Returns the rows of a record of a minute of digging, as dictionaries."""
    path = folder / "dig.csv"
    subprocess.run([PROGRAM, "record", "excavator", "--job", str(JOB), "--noise", "low", "--out", str(path), *settings],
                   check=True, timeout=SECONDS)
    with open(path, encoding="utf-8") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def sample_of(row):
    links = {symbol: {field: max(float(row[f"{link}.{sensor}"]), 0) if "area" in sensor else float(row[f"{link}.{sensor}"])
                      for sensor, field in READINGS.items()} for link, symbol in LINKS.items()}
    return {"type": "sample", "time_s": float(row["time [s]"]), "links": links}


class Recognise(ServiceTest):
    def recognising(self, service, **hello):
        client = self.client(service, "digger", **hello)
        answer = client.ask(type="configuration", configuration="auto")
        self.assertEqual((answer["type"], answer["active"], answer["recognised"]), ("configured", [], True))
        return client

    def send(self, client, rows):
        """Sends the rows; returns the answers, and the names and links of the alarms that were raised."""
        answers, alarms = [], []
        for row in rows:
            client.send(**sample_of(row))
        while len(answers) < len(rows):
            answer = client.receive()
            if answer["type"] == "estimates":
                answers.append(answer)
            elif answer["type"] == "alarm" and answer["state"] == "raised":
                alarms.append((answer["alarm"], answer["links"]))
        return answers, alarms

    def test_a_sound_machine(self):
        rows = dug(self.folder)
        client = self.recognising(self.service())
        answers, alarms = self.send(client, rows)
        self.assertEqual(alarms, [])
        agree = sum(answer["configuration"] == row["configuration"] for answer, row in zip(answers, rows))
        self.assertGreater(agree, 0.99 * len(rows))
        self.assertGreater(len({tuple(answer["active"]) for answer in answers}), 3)
        links = client.ask(type="status")["links"]
        self.assertEqual(links["BO"]["off"]["verdict"], "sound")
        self.assertIsNone(links["BO"]["off"]["leak_in3_per_s_psi"])
        self.assertTrue(links["BO"]["estimates"])

    def test_a_soft_boom_and_a_kill(self):
        rows = dug(self.folder, "--set", "boom.inlet_compliance=.0129")
        expected = self.send(self.recognising(self.service()), rows)[1]
        self.assertEqual(expected, [("compliance", ["BO"])])
        state, half = self.folder / "state", len(rows) // 2
        service = self.service("--state", state)
        first = self.send(self.recognising(service), rows[:half])[1]
        service.stop(signal.SIGKILL)
        service = self.service("--state", state)
        client = self.client(service, "digger")
        self.assertEqual(client.welcome["samples"], half)
        self.assertEqual(first + self.send(client, rows[half:])[1], expected)
        service.stop()
        with contextlib.closing(sqlite3.connect(f"file:{state}?mode=ro", uri=True)) as database:
            kept = database.execute("select compliance from estimates where link = 'BO'").fetchall()
        self.assertTrue(kept)
        self.assertLess(abs(kept[-1][0] / 0.0129 - 1), 0.15)

    def test_alarms_over_a_change_of_mode(self):
        rows = dug(self.folder, "--set", "boom.inlet_compliance=.0129")
        client = self.recognising(self.service("--state", self.folder / "state"))
        self.assertEqual(self.send(client, rows)[1], [("compliance", ["BO"])])
        client.send(type="configuration", configuration="a", active=["BO"])
        answers = [client.receive(), client.receive()]
        self.assertEqual([each["type"] for each in answers], ["configured", "alarm"])
        self.assertEqual((answers[1]["state"], answers[0]["recognised"]), ("cleared", False))
        with contextlib.closing(sqlite3.connect(f"file:{self.folder / 'state'}?mode=ro", uri=True)) as database:
            rows = database.execute("select time_s, population_set, link from estimates").fetchall()
        self.assertEqual(len(rows), len(set(rows)))

    def test_periods(self):
        client = self.client(self.service(), "digger", period_s=0.05)
        answer = client.ask(type="configuration", configuration="auto")
        self.assertEqual((answer["type"], answer["field"]), ("error", "configuration"))

    def test_wrong_messages(self):
        client = self.client(self.service(), "digger")
        answer = client.ask(type="configuration", configuration="auto", active=["BO"])
        self.assertEqual((answer["type"], answer["field"]), ("error", "active"))
        answer = client.ask(type="configuration", configuration="f")
        self.assertIn('"auto"', answer["right"])
        client.ask(type="configuration", configuration="auto")
        sample = sample_of(dug(self.folder)[0])
        del sample["links"]["ST"]
        answer = client.ask(**sample)
        self.assertEqual((answer["type"], answer["field"]), ("error", "links.ST"))


if __name__ == "__main__":
    unittest.main()
