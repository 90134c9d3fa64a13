"""Tests the client of examples/hydraulics/monitor with records in every unit that docs/guides/records.md lists."""

import csv
import os
import pathlib
import re
import subprocess
import sys
import unittest

from service import SECONDS, ServiceTest, boom

ROOT = pathlib.Path(os.environ["PLACEDPAR_DOCUMENT"]).parents[2]
EXAMPLE = ROOT / "examples" / "hydraulics/monitor"
# Conversion factors: how many of each unit make one of the monitor's unit.
OF_ONE = {"psi": 1, "Pa": 6894.757293168, "kPa": 6.894757293168, "MPa": 0.006894757293168, "bar": 0.06894757293168,
          "deg": 1, "rad": 0.017453292519943295, "in": 1, "mm": 25.4, "cm": 2.54, "m": 0.0254, "V": 1, "mV": 1000,
          "in^2": 1, "mm^2": 645.16, "cm^2": 6.4516, "m^2": 0.00064516, "s": 1, "ms": 1000}


def promised():
    """Returns the units of each sensor in the table of docs/guides/records.md."""
    units = {}
    page = (ROOT / "docs" / "guides" / "records.md").read_text(encoding="utf-8")
    for line in page.partition("| link | sensor |")[2].partition("\n\n")[0].splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        for sensor in re.findall(r"`(\w+)`", cells[2] if len(cells) > 2 else ""):
            units[sensor] = [cells[3].partition(",")[0], *cells[4].split(", ")]
    return units


def boom_record():
    """Returns a rise of the boom as a record: the columns, one of which the client ignores, and rows of numbers."""
    names = ["time", "BO.inlet_pressure", "boom.angle", "boom.spool", "boom.servo", "boom.outlet_pressure"]
    with open(EXAMPLE / "boom.csv", encoding="utf-8") as text:
        rows = list(csv.reader(line for line in text if not line.startswith("#")))[1:]
    return names, [[*map(float, row), 0.3, None] for row in rows]


def areas_record():
    names = ["time", "boom.inlet_pressure", "boom.angle", "boom.inlet_area", "boom.bypass_area"]
    samples = [boom(i) for i in range(30)]
    return names, [[sample["time_s"], *sample["links"]["BO"].values()] for sample in samples]


class Client(ServiceTest):
    def write(self, record, choose):
        """Returns the record in the units that `choose` picks for each sensor."""
        names, rows = record
        units = [choose(promised()[name.rpartition(".")[2]]) for name in names]
        path = self.folder / "record.csv"
        with open(path, "w", newline="", encoding="utf-8") as text:
            out = csv.writer(text)
            out.writerow([f"{name} [{unit}]" for name, unit in zip(names, units)])
            out.writerows([["" if value is None else repr(value * OF_ONE[unit]) for value, unit in zip(row, units)]
                           for row in rows])
        return path

    def replay(self, *arguments):
        return subprocess.run([sys.executable, EXAMPLE / "replay_record.py", "--speed", "0", "--every", "1",
                               *map(str, arguments)], capture_output=True, text=True, timeout=SECONDS, check=False)

    def test_every_unit_says_the_same(self):
        self.assertEqual(set(promised()) - {"outlet_pressure"},
                         {"time", "inlet_pressure", "angle", "spool", "servo", "inlet_area", "bypass_area"})
        for record in (boom_record(), areas_record()):
            said = set()
            for turn in range(5):
                service = self.service()
                path = self.write(record, lambda units, turn=turn: units[turn % len(units)])
                done = self.replay("--port", service.address[1], path)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("in^3/psi", done.stdout)
                said.add(done.stdout)
            self.assertEqual(len(said), 1, said)

    def test_the_servo_valves_voltage_in_either_unit(self):
        names, rows = boom_record()
        keep = [i for i, name in enumerate(names) if name != "boom.spool"]
        record = [names[i] for i in keep], [[row[i] for i in keep] for row in rows]
        said = set()
        for turn in range(2):
            done = self.replay("--port", self.service().address[1],
                               self.write(record, lambda units, turn=turn: units[turn % len(units)]))
            self.assertEqual(done.returncode, 0, done.stderr)
            said.add(done.stdout)
        self.assertEqual(len(said), 1, said)

    def test_a_token_is_told(self):
        token = self.folder / "token"
        token.write_text("correct-horse-battery\n")
        token.chmod(0o600)
        service = self.service("--token-file", token)
        path = self.write(boom_record(), lambda units: units[0])
        self.assertEqual(self.replay("--port", service.address[1], path).returncode, 1)
        done = self.replay("--port", service.address[1], "--token-file", token, path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("alarms: none", done.stdout)

    def test_a_needed_cell_that_is_no_number_is_named(self):
        names, rows = boom_record()
        rows[3][2] = None
        done = self.replay("--port", 1, self.write((names, rows), lambda units: units[0]))
        self.assertEqual(done.returncode, 1)
        self.assertIn("record.csv: sample 4: could not convert string to float: ''", done.stderr)


if __name__ == "__main__":
    unittest.main()
