"""Tests that the monitor and `placedpar identify` find the same in the same samples, to the bit."""

import csv
import json
import pathlib
import subprocess
import tempfile
import unittest

from service import PROGRAM, SECONDS, ServiceTest

READINGS = {"inlet_pressure": "inlet_psi", "angle": "angle_deg", "spool": "spool_in", "servo": "servo_V"}


class OneIdentifier(ServiceTest):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=SECONDS, check=True)

    def log(self, settings):
        """Returns a record of seven movements with rests between them; the last three have these settings."""
        path, lines, begin_s = self.folder / "log.csv", [], 0
        for seed in range(3001, 3008):
            one = self.folder / "one.csv"
            faults = [word for each in settings for word in ("--set", each)] if seed > 3004 else []
            self.run_program("record", "excavator", "--seed", seed, "--out", one, *faults)
            text = [line for line in one.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
            lines = lines or [text[0]]
            rows = [line.split(",") for line in text[1:]]
            lines += [",".join([f"{begin_s + float(row[0]):.2f}", *row[1:]]) for row in rows]
            begin_s += float(rows[-1][0]) + 3
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path

    def told(self, log, valve):
        """Sends the record; returns the status and the names of the alarms."""
        with open(log, encoding="utf-8") as text:
            rows = list(csv.DictReader(text))
        client = self.client(self.service("--seed", 7), "record")
        client.ask(type="configuration", configuration="a", active=["BO"])
        for row in rows:
            reading = {field: float(row[column]) for column in row for sensor, field in READINGS.items()
                       if column.startswith(f"boom.{sensor} ") and (sensor not in ("spool", "servo") or sensor == valve)}
            if valve == "spool":
                reading["spool_in"] = max(reading["spool_in"], 0)
            client.send(type="sample", time_s=float(row["time [s]"]), links={"BO": reading})
            client.receive()
        client.send(type="configuration", configuration="b", active=["BO"])  # a new configuration ends the movement
        client.receive()
        client.send(type="sample", time_s=float(rows[-1]["time [s]"]) + 9, links={"BO": reading})
        client.send(type="status")
        while (status := client.receive())["type"] != "status":
            pass
        return status

    def test_the_same_record_the_same_answer(self):
        for settings, valve in (([], "spool"), (["fault.leak=0.0028"], "spool"),
                                (["boom.inlet_compliance=0.0172"], "spool"), ([], "servo")):
            log = self.log(settings)
            found = self.folder / "found.json"
            self.run_program("identify", log, "--seed", 7, "--areas-from", valve, "--json", found)
            result = json.loads(found.read_text(encoding="utf-8"))
            status = self.told(log, valve)
            estimate = status["sets"]["P1b"]["links"]["BO"]
            (boom,) = result["movements"][-1]["links"]
            six = lambda number: float(f"{number:.6g}")
            self.assertEqual(len(result["movements"]), 7)
            self.assertEqual(six(boom["compliance"]), estimate["settled_in3_per_psi"], (settings, valve))
            self.assertEqual(six(boom["standard_error"]), estimate["settled_error_in3_per_psi"])
            (verdict,), off = result["verdicts"], status["links"]["BO"]["off"]
            self.assertEqual((verdict["verdict"], verdict["movements"]), (off["verdict"], off["movements"]))
            for field, error in (("compliance_in3_per_psi", "compliance_error_in3_per_psi"),
                                 ("leak_in3_per_s_psi", "leak_error_in3_per_s_psi"), ("offset_in", "offset_error_in")):
                self.assertEqual(six(verdict[field]["by"]), off[field])
                self.assertEqual(six(verdict[field]["standard_error"]), off[error])
            self.assertEqual([each["alarm"] for each in result["alarms"]], [each["alarm"] for each in status["alarms"]])


if __name__ == "__main__":
    unittest.main()
