"""Tests that known machines survive the end of the service, however it ends."""

import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

from service import CONFIGURATION, PROGRAM, SECONDS, ServiceTest, boom

SAMPLES = 40
UNSETTLED = ("--population", 8, "--bits", 16)  # this search never ends, so every step of it shows


class Restart(ServiceTest):
    def setUp(self):
        super().setUp()
        self.state = self.folder / "state"

    def uninterrupted(self):
        client = self.client(self.service(*UNSETTLED), "digger")
        client.ask(**CONFIGURATION)
        return [client.ask(**boom(i)) for i in range(SAMPLES)]

    def test_a_kill_at_any_moment_loses_the_last_sample_at_most(self):
        expected = self.uninterrupted()
        for answered in (0, 1, 7, 12, 20, 33):
            self.state = self.folder / f"state-{answered}"
            service = self.service("--state", self.state, *UNSETTLED)
            client = self.client(service, "digger")
            client.ask(**CONFIGURATION)
            sent = min(answered + 5, SAMPLES)
            for i in range(sent):
                client.send(**boom(i))
            for _ in range(answered):
                client.receive()
            service.stop(signal.SIGKILL)  # killed while messages are still unanswered
            again = self.service("--state", self.state, *UNSETTLED)
            client = self.client(again, "digger")
            known = client.welcome["samples"]
            self.assertGreaterEqual(known, answered)
            self.assertLessEqual(known, sent)
            self.assertEqual(client.welcome["configuration"], "a")
            self.assertEqual([client.ask(**boom(i)) for i in range(known, SAMPLES)], expected[known:])

    def test_kill_after_kill(self):
        expected = self.uninterrupted()
        known = 0
        while known < SAMPLES:
            service = self.service("--state", self.state, *UNSETTLED)
            client = self.client(service, "digger")
            self.assertEqual(client.welcome["samples"], known)
            if known == 0:
                client.ask(**CONFIGURATION)
            for _ in range(4):
                self.assertEqual(client.ask(**boom(known)), expected[known])
                known += 1
            service.stop(signal.SIGKILL)

    def test_a_signal_ends_it_cleanly(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            state = self.folder / number.name
            service = self.service("--state", state)
            client = self.client(service, "digger")
            client.ask(**CONFIGURATION)
            for i in range(20):
                client.ask(**boom(i))
            code, errors = service.stop(number)
            self.assertEqual(code, 0)
            self.assertIn(f"stopped; the state was written to {state}", errors)
            self.assertEqual(client.receive()["type"], "closing")
            self.assertIsNone(client.receive())
            self.assertEqual([path.name for path in self.folder.glob(number.name + "*")], [number.name])
            again = self.service("--state", state)
            self.assertEqual(self.client(again, "digger").welcome["samples"], 20)
            _, errors = again.stop()
            self.assertIn("1 machine restored\n", errors)

    def test_a_signal_is_heeded_before_it_is_known_where_it_listens(self):
        reading, writing = os.pipe()
        os.set_blocking(writing, False)
        os.write(writing, b"x" * (1 << 20))  # as many bytes as the pipe holds
        os.set_blocking(writing, True)
        service = subprocess.Popen([PROGRAM, "monitor"], stdout=writing, stderr=subprocess.PIPE, text=True)
        os.close(writing)
        self.addCleanup(service.stderr.close)
        self.addCleanup(service.wait)
        self.addCleanup(service.kill)
        status = pathlib.Path(f"/proc/{service.pid}/status")
        wanted = 1 << signal.SIGTERM - 1 | 1 << signal.SIGINT - 1
        caught, until = 0, time.monotonic() + SECONDS / 4
        while caught & wanted != wanted:  # the service cannot report this: its pipe is full
            self.assertLess(time.monotonic(), until)
            caught = int(re.search(r"SigCgt:\s+(\w+)", status.read_text(encoding="ascii"))[1], 16)
        with open(reading, encoding="ascii") as lines:
            self.assertIn("listening", lines.readline())
        service.terminate()
        self.assertEqual(service.wait(SECONDS), 0)

    def test_a_signal_is_not_held_up_by_who_does_not_read(self):
        service = self.service()
        client = self.client(service)
        client.socket.settimeout(0.2)
        try:
            while True:
                client.send_bytes(b'{"type":"load"}\n' * 1000)
        except OSError:
            pass
        self.assertEqual(service.stop()[0], 0)

    def test_one_service_a_file_by_any_of_its_names(self):
        self.service("--state", self.state)
        for name, link in (("soft", os.symlink), ("hard", os.link)):
            link(self.state, self.folder / name)
            self.assertIn("another placedpar monitor is using the file", self.refusal("--state", self.folder / name))

    def test_a_full_disk_does_not_end_the_diagnosis(self):
        service = self.service("--state", self.state)
        client = self.client(service, "digger")
        client.ask(**CONFIGURATION)
        service.fill_disk(self.state.stat().st_size)
        for i in range(SAMPLES):
            client.send(**boom(i))
            self.assertEqual(client.receive_type("estimates")["samples"], i + 1)
        _, errors = service.stop(signal.SIGKILL)
        self.assertEqual(errors.count("the service continues, but a restart would lose the unwritten state"), 1)
        again = self.service("--state", self.state)
        known = self.client(again, "digger").welcome["samples"]
        self.assertGreater(known, 10)
        self.assertLess(known, SAMPLES)

    def test_samples_lost_to_a_full_disk_leave_no_hole(self):
        expected = self.uninterrupted()
        service = self.service("--state", self.state, *UNSETTLED)
        client = self.client(service, "digger")
        client.ask(**CONFIGURATION)
        for i in range(12):
            client.ask(**boom(i))
        service.fill_disk(1)
        told = client.ask(**boom(12))
        self.assertEqual((told["type"], told["kept"]), ("kept", False))
        self.assertIn(f"{self.state}: cannot be written: ", told["text"])
        self.assertEqual(client.receive(), expected[12])
        late = self.client(service, "digger", role="watch")
        self.assertEqual(late.receive(), told)
        service.free_disk()
        client.send(**boom(13))  # arrives before or after the state file is written
        client.receive_type("estimates")
        service.stop(signal.SIGKILL)
        client = self.client(self.service("--state", self.state, *UNSETTLED), "digger")
        known = client.welcome["samples"]
        self.assertIn(known, (12, 14))
        self.assertEqual([client.ask(**boom(i)) for i in range(known, SAMPLES)], expected[known:])

    def test_after_a_full_disk_all_is_kept_again(self):
        expected = self.uninterrupted()
        service = self.service("--state", self.state, *UNSETTLED)
        client = self.client(service, "digger")
        service.fill_disk(1)
        client.send(**CONFIGURATION)
        self.assertEqual(client.receive_type("kept")["kept"], False)
        for i in range(20):
            client.send(**boom(i))
            client.receive_type("estimates")
        service.free_disk()
        self.assertEqual(client.receive_type("kept")["kept"], True)
        self.assertEqual(client.ask(**boom(20)), expected[20])
        _, errors = service.stop(signal.SIGKILL)
        self.assertEqual(len(re.findall("a restart would lose|written again", errors)), 2, errors)
        self.assertIn("the state file can be written again", errors)
        client = self.client(self.service("--state", self.state, *UNSETTLED), "digger")
        self.assertEqual(client.welcome["samples"], 21)
        self.assertEqual([client.ask(**boom(i)) for i in range(21, SAMPLES)], expected[21:])

    def test_what_cannot_be_is_refused(self):
        service = self.service("--state", self.state, *UNSETTLED)
        self.assertIn("another placedpar monitor is using the file", self.refusal("--state", self.state))
        self.assertIn("Address already in use", self.refusal("--port", service.address[1]))
        service.stop()
        self.assertIn("--seed 1 ", self.refusal("--state", self.state, *UNSETTLED, "--seed", 2))
        self.state.write_text("rubbish")
        self.assertIn(f"{self.state}: this state file cannot be used", self.refusal("--state", self.state, *UNSETTLED))
        self.assertIn("cannot be created", self.refusal("--state", self.folder / "none" / "state"))
        self.assertIn("--address nowhere", self.refusal("--address", "nowhere"))
        self.assertIn("population", self.refusal("--population", 1))
        self.assertIn("bits", self.refusal("--bits", 40))


if __name__ == "__main__":
    unittest.main()
