"""Tests idle machine names, peers that want every place, and which connections are accepted."""

import os
import signal
import time
import unittest

from service import CONFIGURATION, SECONDS, ServiceTest, boom

TOKEN = "correct-horse-battery"


class Crowd(ServiceTest):
    def until(self, true):
        end = time.monotonic() + SECONDS
        while not true():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)

    def names(self, service, count, **options):
        for i in range(count):
            client = self.client(service, f"name-{i}", **options)
            self.assertEqual(client.welcome["type"], "welcome", client.welcome)
            client.close()

    def test_a_thousand_names_leave_room_for_a_machine(self):
        state = self.folder / "state"
        options = ("--state", state, "--max-machines-per-peer", 2000)
        service = self.service(*options)
        used = self.client(service, "used")
        used.ask(**CONFIGURATION)
        used.ask(**boom(0))
        self.names(service, 1200)
        time.sleep(0.3)  # a client is removed only when another needs its place
        self.assertEqual(self.client(service).ask(type="load")["machines"], 1000)
        self.assertEqual(self.client(service, "digger").welcome["type"], "welcome")
        service.stop(signal.SIGKILL)
        service = self.service(*options)
        self.assertEqual(self.client(service, "another").welcome["type"], "welcome")
        self.assertEqual(self.client(service, "used").welcome["samples"], 1)
        service.stop()
        again = self.service(*options, "--newcomer-timeout", 0.2)
        self.until(lambda: self.client(again).ask(type="load")["machines"] == 1)
        self.assertEqual(self.client(again, "used", role="watch").welcome["samples"], 1)

    def test_a_name_without_samples_goes_when_its_connection_has_gone(self):
        service = self.service("--newcomer-timeout", 0.2)
        stays, goes = self.client(service, "stays"), self.client(service, "goes")
        load = self.client(service)
        time.sleep(0.5)
        self.assertEqual(load.ask(type="load")["machines"], 2)
        goes.close()
        self.until(lambda: load.ask(type="load")["machines"] == 1)
        self.assertEqual(stays.ask(**CONFIGURATION)["type"], "configured")

    def test_a_peer_introduces_so_many_machines(self):
        path = str(self.folder / "socket")
        service = self.service("--max-machines-per-peer", 3, "--unix", path, "--port", 0)
        clients = [self.client(service, f"name-{i}") for i in range(3)]
        refused = self.client(service, "one-more").welcome
        self.assertIn("loopback has already announced 3 machines", refused["wrong"])
        self.assertEqual(self.client(service, "one-more", path=path).welcome["type"], "welcome")
        clients[0].ask(type="bye")
        self.assertIsNone(clients[0].receive())
        self.assertEqual(self.client(service, "in-its-place").welcome["type"], "welcome")

    def test_a_peer_has_so_many_connections(self):
        path = str(self.folder / "socket")
        service = self.service("--max-clients-per-peer", 2, "--unix", path, "--port", 0)
        first, _ = self.client(service, "digger"), self.client(service, "dozer")
        third = self.client(service, "crane")
        self.assertIn("the monitor already has 2 clients", third.welcome["wrong"])
        self.assertIsNone(third.receive())
        self.assertEqual(self.client(service, "lorry", path=path).welcome["type"], "welcome")
        first.ask(type="bye")
        self.assertIsNone(first.receive())
        self.assertEqual(self.client(service, "crane").welcome["type"], "welcome")

    def test_a_peer_takes_over_so_often(self):
        service = self.service("--max-takeovers", 3)
        clients = [self.client(service, "digger") for _ in range(5)]
        self.assertEqual([client.welcome["type"] for client in clients], 4 * ["welcome"] + ["error"])
        self.assertIn("taken over 3 machines within a minute", clients[4].welcome["wrong"])
        self.assertEqual(clients[2].receive()["type"], "closing")
        self.assertEqual(clients[3].ask(type="ping")["type"], "pong")  # it stays connected

    def test_forget(self):
        service = self.service("--state", self.folder / "state")
        client = self.client(service, "digger")
        client.ask(**CONFIGURATION)
        client.ask(**boom(0))
        other = self.client(service)
        self.assertIn("still has open connections: 1", other.ask(type="forget", machine="digger")["wrong"])
        client.ask(type="bye")
        self.assertIsNone(client.receive())
        self.assertEqual(other.ask(type="forget", machine="digger"), {"type": "forgotten", "text": "digger"})
        self.assertIn("unknown machine", other.ask(type="forget", machine="digger")["wrong"])
        service.stop(signal.SIGKILL)
        again = self.service("--state", self.folder / "state")
        self.assertEqual(self.client(again).ask(type="load")["machines"], 0)

    def token_file(self, text=TOKEN + "\n", mode=0o600):
        file = self.folder / "token"
        file.write_text(text)
        file.chmod(mode)
        return file

    def test_who_does_not_know_the_token(self):
        service = self.service("--token-file", self.token_file())
        self.assertEqual(self.client(service, "digger", token=TOKEN).welcome["type"], "welcome")
        for wrong in ({}, {"token": TOKEN + "x"}, {"token": TOKEN[:-1] + "x"}):
            client = self.client(service, "digger", **wrong)
            self.assertEqual((client.welcome["type"], client.welcome["field"]), ("error", "token"))
            self.assertIsNone(client.receive())
        client = self.client(service)
        for message in ("ping", "load", "status", "alarms", "bye"):
            self.assertEqual(client.ask(type=message)["field"], "token")
        self.assertEqual(client.ask(type="forget", machine="digger")["field"], "token")
        self.assertEqual(client.ask(**CONFIGURATION)["field"], "token")
        self.assertEqual(client.ask(type="token", token=TOKEN), {"type": "accepted"})
        self.assertEqual(client.ask(type="load")["machines"], 1)

    def test_a_token_that_is_none_is_refused(self):
        for text in ("", "short", "two words of them here", "x" * 1001):
            self.assertIn("the file has no valid token", self.refusal("--token-file", self.token_file(text)))
        self.assertIn("every user", self.refusal("--token-file", self.token_file(mode=0o644)))
        self.assertIn("cannot be read", self.refusal("--token-file", self.folder / "none"))

    def test_nobody_listens_beyond_loopback_without_a_token(self):
        for address in ("0.0.0.0", "::"):
            self.assertIn("--token-file FILE", self.refusal("--address", address))
        service = self.service("--address", "0.0.0.0", "--token-file", self.token_file())
        self.assertEqual(self.client(service, "digger", token=TOKEN).welcome["type"], "welcome")

    def test_a_socket_in_the_file_system(self):
        path = self.folder / "socket"
        service = self.service("--unix", path)
        self.assertIsNone(service.address)
        self.assertEqual(path.stat().st_mode & 0o777, 0o660)
        client = self.client(service, "digger", path=str(path))
        client.ask(**CONFIGURATION)
        self.assertEqual(client.ask(**boom(0))["samples"], 1)
        self.assertIn("another program already listens on this socket", self.refusal("--unix", path))
        self.assertIn("is not a socket", self.refusal("--unix", self.token_file()))
        self.assertIn("more than 107 bytes", self.refusal("--unix", "x" * 108))
        _, errors = service.stop(signal.SIGKILL)
        self.assertIn(f"of user {os.getuid()} is its control system", errors)
        both = self.service("--unix", path, "--port", 0)  # replaces the socket that the killed service left
        self.assertEqual(self.client(both).ask(type="ping")["type"], "pong")
        self.assertEqual(self.client(both, path=str(path)).ask(type="ping")["type"], "pong")
        self.assertEqual(both.stop()[0], 0)
        self.assertFalse(path.exists())


if __name__ == "__main__":
    unittest.main()
