"""Tests that alarms are listed, acknowledged, shelved and kept, and tests the command for that."""

import json
import signal
import subprocess
import unittest

from service import CONFIGURATION, PROGRAM, SECONDS, ServiceTest, move_softly

TOKEN = "correct-horse-battery"


class Alarms(ServiceTest):
    def alarming(self, *options):
        """Returns a service with a machine that has just raised an alarm, and the machine's control system."""
        service = self.service("--state", self.folder / "state", *options)
        client = self.client(service, "digger")
        client.ask(**CONFIGURATION)
        alarm, = self.alarms_of(client, 0)
        return service, client, alarm

    @staticmethod
    def alarms_of(client, start_s):
        return [said for said in move_softly(client, start_s) if said["type"] == "alarm"]

    @staticmethod
    def clear_alarm(client):
        client.send(type="baseline", links={"BO": 0.0086})
        return client.receive_type("status")

    def tell(self, service, *words, code=0):
        done = subprocess.run([PROGRAM, "tell", "--port", str(service.address[1]), *words], capture_output=True,
                              text=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout) if code == 0 else done.stderr

    def test_alarms_are_listed_acknowledged_and_kept(self):
        service, _, alarm = self.alarming()
        self.assertEqual(alarm["state"], "raised")
        other = self.client(service)
        listed, = other.ask(type="alarms")["alarms"]
        self.assertEqual((listed["machine"], listed["alarm"], listed["links"]), ("digger", alarm["alarm"], ["BO"]))
        self.assertIsNone(listed["acknowledged_at"])
        name = {"machine": "digger", "alarm": alarm["alarm"], "links": ["BO"]}
        seen, = other.ask(type="acknowledge", **name)["alarms"]
        self.assertGreaterEqual(seen["acknowledged_at"], listed["raised_at"])
        self.assertEqual(other.ask(type="acknowledge", **name)["alarms"], [seen])  # the first acknowledgement counts
        self.assertIn("has no alarm", other.ask(type="acknowledge", **{**name, "links": ["BU"]})["wrong"])
        self.assertTrue(other.ask(type="acknowledge", **{**name, "links": []})["wrong"].endswith(f'has no alarm "{name["alarm"]}"'))
        _, errors = service.stop(signal.SIGKILL)
        self.assertRegex(errors, r"\dZ placedpar monitor: digger: alarm \w+ BO raised: ")
        self.assertRegex(errors, r"\dZ placedpar monitor: digger: alarm \w+ BO acknowledged by 127.0.0.1 port \d+\n")
        again = self.service("--state", self.folder / "state")
        self.assertEqual(self.client(again).ask(type="alarms")["alarms"], [seen])

    def test_nobody_is_told_of_what_is_on_the_shelf(self):
        service, client, alarm = self.alarming()
        name = {"machine": "digger", "alarm": alarm["alarm"], "links": ["BO"]}
        other = self.client(service)
        shelved, = other.ask(type="shelve", for_s=3600, **name)["alarms"]
        self.assertGreater(shelved["shelved_until"], shelved["raised_at"] + 3000)
        self.clear_alarm(client)
        self.assertEqual(self.alarms_of(client, 100), [])
        listed, = other.ask(type="alarms")["alarms"]
        self.assertEqual(listed["shelved_until"], shelved["shelved_until"])
        service.stop(signal.SIGKILL)
        service = self.service("--state", self.folder / "state")
        client = self.client(service, "digger")
        self.clear_alarm(client)
        self.assertEqual(self.alarms_of(client, 200), [])
        back, = self.client(service).ask(type="shelve", for_s=0, **name)["alarms"]
        self.assertIsNone(back["shelved_until"])
        client.send(type="baseline", links={"BO": 0.0086})
        self.assertEqual(client.receive_type("alarm")["state"], "cleared")

    def test_a_machine_that_begins_anew_has_no_alarms(self):
        service, client, alarm = self.alarming()
        watcher = self.client(service, "digger", role="watch", answers="none")
        again = self.client(service, "digger", anew=True)
        self.assertEqual(again.welcome["samples"], 0)
        told = watcher.receive_type("alarm")
        self.assertEqual((told["state"], told["alarm"]), ("cleared", alarm["alarm"]))
        other = self.client(service)
        self.assertEqual(other.ask(type="alarms")["alarms"], [])
        service.stop(signal.SIGKILL)
        service = self.service("--state", self.folder / "state")
        self.assertEqual(self.client(service).ask(type="alarms")["alarms"], [])

    def test_the_command(self):
        service, client, alarm = self.alarming()
        kind = alarm["alarm"]
        self.assertEqual(self.tell(service, "load")["machines"], 1)
        self.assertEqual(len(self.tell(service, "alarms")["alarms"]), 1)
        self.assertIsNotNone(self.tell(service, "acknowledge", "digger", kind, "BO")["alarms"][0]["acknowledged_at"])
        self.assertIsNotNone(self.tell(service, "shelve", "digger", kind, "boom")["alarms"][0]["shelved_until"])
        self.assertIsNone(self.tell(service, "shelve", "digger", kind, "BO", "--for", "0")["alarms"][0]["shelved_until"])
        self.assertIn("--for has no effect", self.tell(service, "load", "--for", "1", code=1))
        self.assertIn("still has open connections: 1", self.tell(service, "forget", "digger", code=1))
        client.close()
        while self.tell(service, "load")["clients"] > 1:
            pass
        self.assertEqual(self.tell(service, "forget", "digger")["type"], "forgotten")
        self.assertEqual(self.tell(service, "alarms")["alarms"], [])
        self.assertIn("expected one of: alarms, load, forget MACHINE", self.tell(service, "remember", code=1))
        self.assertIn("the command forget has a wrong number of arguments: 0", self.tell(service, "forget", code=1))

    def test_the_command_knows_tokens_and_sockets(self):
        token = self.folder / "token"
        token.write_text(TOKEN)
        token.chmod(0o600)
        path = self.folder / "socket"
        service = self.service("--unix", path, "--port", 0, "--token-file", token)
        self.assertIn("not authenticated", self.tell(service, "load", code=1))
        self.assertEqual(self.tell(service, "load", "--token-file", str(token))["type"], "load")
        done = subprocess.run([PROGRAM, "tell", "--unix", path, "--token-file", token, "load"], capture_output=True,
                              text=True, timeout=SECONDS, check=True)
        self.assertEqual(json.loads(done.stdout)["clients"], 1)
        service.stop()
        self.assertIn("Connection refused", self.tell(service, "load", code=1))


if __name__ == "__main__":
    unittest.main()
