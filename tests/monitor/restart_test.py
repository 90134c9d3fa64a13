"""What is known outlives the service, however it ends."""

import signal
import unittest

from service import CONFIGURATION, ServiceTest, boom

SAMPLES = 40
UNSETTLED = ("--population", 8, "--bits", 16)  # a search that is never done, so that every step of it shows


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
            service.stop(signal.SIGKILL)  # somewhere in what is not yet answered
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
            self.assertIn(f"stopped; {state} is written", errors)
            self.assertEqual(client.receive()["type"], "closing")
            self.assertIsNone(client.receive())
            self.assertEqual(len(state.with_name(number.name + ".journal").read_text().splitlines()), 1)
            again = self.service("--state", state)
            self.assertEqual(self.client(again, "digger").welcome["samples"], 20)
            _, errors = again.stop()
            self.assertIn("1 machine restored\n", errors)

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

    def test_torn_journals_are_gone_on_with(self):
        service = self.service("--state", self.state, *UNSETTLED)
        client = self.client(service, "digger")
        client.ask(**CONFIGURATION)
        for i in range(20):
            client.ask(**boom(i))
        service.stop(signal.SIGKILL)
        journal = self.folder / "state.journal"
        journal.write_bytes(journal.read_bytes()[:-10])
        again = self.service("--state", self.state, *UNSETTLED)
        self.assertEqual(self.client(again, "digger").welcome["samples"], 19)
        self.assertIn("torn", again.stop()[1])

    def test_a_full_disk_does_not_end_the_diagnosis(self):
        service = self.service("--state", self.state, file_bytes=4000)
        client = self.client(service, "digger")
        client.ask(**CONFIGURATION)
        for i in range(SAMPLES):
            self.assertEqual(client.ask(**boom(i))["samples"], i + 1)
        _, errors = service.stop(signal.SIGKILL)
        self.assertEqual(errors.count("going on, but a restart would forget"), 1)
        again = self.service("--state", self.state)
        known = self.client(again, "digger").welcome["samples"]
        self.assertGreater(known, 10)
        self.assertLess(known, SAMPLES)

    def test_what_cannot_be_is_refused(self):
        service = self.service("--state", self.state, *UNSETTLED)
        self.assertIn("another placedpar monitor is using it", self.refusal("--state", self.state))
        self.assertIn("Address already in use", self.refusal("--port", service.address[1]))
        service.stop()
        self.assertIn("--seed 1 ", self.refusal("--state", self.state, *UNSETTLED, "--seed", 2))
        self.state.write_text("rubbish")
        self.assertIn(f"{self.state}: this state file cannot be used", self.refusal("--state", self.state, *UNSETTLED))
        self.assertIn("cannot be opened", self.refusal("--state", self.folder / "none" / "state"))
        self.assertIn("cannot be used", self.refusal("--state", self.folder))
        self.assertIn("--address nowhere", self.refusal("--address", "nowhere"))
        self.assertIn("population", self.refusal("--population", 1))
        self.assertIn("bits", self.refusal("--bits", 40))
        for option in ("--port", "--max-clients", "--max-machines", "--max-line", "--max-queue", "--population",
                       "--bits", "--window", "--trials", "--transients"):
            for value in ("-1", "1.5", "010", "99999999999999999999"):
                self.assertIn(f'{option}: "{value}" is no whole number', self.refusal(f"{option}={value}"))
        for option in ("--max-clients", "--max-machines", "--max-line", "--max-queue"):
            self.assertIn(f"{option}: it is at least 1", self.refusal(option, 0))
        for option in ("--sync", "--hello-timeout", "--line-timeout", "--idle-timeout", "--stall-timeout",
                       "--closing-timeout"):
            for value in ("0", "-1", "nan", "inf", "1e300", "x"):
                self.assertIn(f'{option}: "{value}" is no number of seconds', self.refusal(f"{option}={value}"))


if __name__ == "__main__":
    unittest.main()
