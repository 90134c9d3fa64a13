"""Tests the monitor's client with a monitor."""

import os
import re
import subprocess
import unittest

import placedpar as pp


class Clients(unittest.TestCase):
    def setUp(self):
        service = subprocess.Popen([os.environ["PLACEDPAR"], "monitor"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True)
        self.addCleanup(service.stdout.close)
        self.addCleanup(service.wait)
        self.addCleanup(service.terminate)
        self.port = int(re.search(r"port (\d+)", service.stdout.readline())[1])

    def test_a_client_sends_samples_and_gets_estimates(self):
        with pp.Monitor("digger-7", self.port) as monitor:
            self.assertEqual((monitor.welcome["machine"], monitor.welcome["samples"]), ("digger-7", 0))
            self.assertEqual(monitor.configure("a", ["BO"])["sets"], ["P1b"])
            for i in range(3):
                reading = {"inlet_psi": 1555 - i / 10, "angle_deg": 3 + i / 1000, "spool_in": 0.13}
                estimates = monitor.sample(12 + i / 50, {"boom": reading})
            self.assertEqual(estimates["samples"], 3)
        with pp.Monitor("digger-7", self.port, role="watch") as watcher:
            self.assertEqual(watcher.welcome["samples"], 3)

    def test_a_refused_message_is_an_error(self):
        with pp.Monitor("digger-7", self.port) as monitor:
            with self.assertRaisesRegex(pp.Error, 'configuration: it is "f", expected one of "a" "b"'):
                monitor.configure("f", ["BO"])
            self.assertEqual(monitor.configure("a", ["BO"])["active"], ["BO"])


if __name__ == "__main__":
    unittest.main()
