"""Tests the run from the sensors to the alarm on Figure D.1."""

import json
import pathlib
import tempfile
import unittest

from program import EXAMPLES, placedpar

NETLIST = EXAMPLES / "machine/figure-d1/sensor-to-alarm.cfs"
IN_TIME = ("trials=2",)  # generations for which the machine needs less than the 20 ms between samples


class SensorToAlarm(unittest.TestCase):
    def run_with(self, *values, seed=1):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.json"
            run = placedpar("run", NETLIST, "--seed", seed, "--json", path, *(f"--set={value}" for value in values))
            self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
            document = json.loads(path.read_text(encoding="utf-8"))
        return {f"{each['process']}.{each['name']}": each["value"] for each in document["measurements"]}

    def test_a_leak_raises_the_alarm_and_a_sound_boom_does_not(self):
        for seed in range(1, 4):
            self.assertIsInstance(self.run_with(*IN_TIME, seed=seed)["alarm.raised"], float)
            self.assertEqual(self.run_with(*IN_TIME, "problem=boom", seed=seed)["alarm.raised"], "no")

    def test_sensors_that_read_more_samples_than_the_record_has_are_refused_with_its_length(self):
        with tempfile.TemporaryDirectory() as folder:
            netlist = pathlib.Path(folder) / "more.cfs"
            netlist.write_text(f'#include "{NETLIST}"\nsensors (samples = 21);\n', encoding="utf-8")
            refused = placedpar("check", netlist)
            self.assertEqual(refused.returncode, 1)
            self.assertIn('more.cfs:2:10: error: samples = 21, but the record of "leaking-boom" has only 20', refused.stderr)
            netlist.write_text(netlist.read_text(encoding="utf-8").replace("21", "20"), encoding="utf-8")
            self.assertEqual(placedpar("check", netlist).returncode, 0)

    def test_the_stages_add_up(self):
        found = self.run_with(*IN_TIME)
        self.assertEqual(found["sensors.samples"], 20)
        stages = found["host.from_sensors"] + found["host.to_masters"]
        self.assertLess(stages, found["alarm.from_sensors"])
        self.assertLess(found["alarm.from_sensors"], 40)
        self.assertGreater(found["alarm.from_host"], 0)

    def test_samples_wait_where_the_islands_take_longer_than_a_period(self):
        self.assertLess(self.run_with(*IN_TIME)["sensors.longest_wait"], 5)
        self.assertGreater(self.run_with("trials=5")["sensors.longest_wait"], 100)

    def test_a_full_bus_delays_what_crosses_it(self):
        idle, full = self.run_with(*IN_TIME), self.run_with(*IN_TIME, "load=8000")
        self.assertGreater(full["host.from_sensors"], 1.2 * idle["host.from_sensors"])


if __name__ == "__main__":
    unittest.main()
