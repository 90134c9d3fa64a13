"""Tests the messages to a control system and to watchers."""

import unittest

from service import CONFIGURATION, ServiceTest, boom


class Diagnosis(ServiceTest):
    def test_the_compliance_is_found(self):
        client = self.client(self.service(), "digger")
        self.assertEqual(client.welcome["samples"], 0)
        self.assertEqual(client.ask(**CONFIGURATION)["sets"], ["P1b"])
        for i in range(30):
            answer = client.ask(**boom(i))
            self.assertEqual(answer["generations"], 5 if i >= 8 else 0)
        found = answer["sets"]["P1b"]["links"]["BO"]
        self.assertLess(abs(found["compliance_in3_per_psi"] / 0.0086 - 1), 0.05)
        self.assertEqual(found["flags"], [])

    def test_a_compliance_that_grows_is_told_and_cleared(self):
        client = self.client(self.service(), "digger")
        client.ask(**CONFIGURATION)
        moved = 0

        def move(times, compliance):
            """Sends movements of 30 samples, each after a gap; returns the alarms."""
            nonlocal moved
            alarms = []
            for _ in range(times):
                for i in range(30):
                    client.send(**boom(i, start_s=100 * moved, compliance=compliance))
                moved += 1
            client.send(type="ping")
            while (message := client.receive())["type"] != "pong":
                if message["type"] == "alarm":
                    alarms.append((message["alarm"], message["links"], message["state"]))
            return alarms

        self.assertEqual(move(4, 0.0086), [])
        self.assertEqual(move(4, 0.0120), [("compliance", ["BO"], "raised")])
        said = client.ask(type="status")["links"]["BO"]["off"]
        self.assertEqual(said["verdict"], "compliance")
        self.assertAlmostEqual(said["compliance_in3_per_psi"], 0.0034, delta=0.0005)
        self.assertGreater(said["probability"], 0.9)
        self.assertEqual(move(8, 0.0086), [("compliance", ["BO"], "cleared")])
        status = client.ask(type="baseline", links={"BO": 0.0043})
        self.assertEqual(status["links"]["BO"]["baseline_in3_per_psi"], 0.0043)
        self.assertEqual(move(4, 0.0086), [("compliance", ["BO"], "raised")])  # twice the compliance of its kind

    def test_same_seed_same_answers(self):
        def answers(seed):
            client = self.client(self.service("--seed", seed, "--population", 8, "--bits", 16), "digger")
            client.ask(**CONFIGURATION)
            return [client.ask(**boom(i)) for i in range(12)]

        self.assertEqual(answers(7), answers(7))
        self.assertNotEqual(answers(7), answers(8))

    def test_watchers_see_what_the_control_system_sees_and_cannot_tell(self):
        service = self.service()
        self.assertEqual(self.client(service, "digger", role="watch").welcome["type"], "error")
        control = self.client(service, "digger")
        watchers = [self.client(service, "digger", role="watch") for _ in range(3)]
        moved = self.client(service, "digger", role="watch", answers="moved")
        control.ask(**CONFIGURATION)
        answers = [control.ask(**boom(i)) for i in range(10)]
        for watcher in watchers:
            self.assertEqual(watcher.receive()["type"], "configured")
            self.assertEqual([watcher.receive() for _ in range(10)], answers)
        self.assertEqual(moved.receive()["type"], "configured")
        self.assertEqual([moved.receive(), moved.receive()], answers[8:])
        self.assertEqual(watchers[0].ask(**boom(10))["field"], "type")
        self.assertEqual(watchers[0].ask(type="status")["samples"], 10)

    def test_a_new_control_system_takes_over(self):
        service = self.service()
        first = self.client(service, "digger")
        second = self.client(service, "digger")
        self.assertEqual(first.receive()["type"], "closing")
        self.assertIsNone(first.receive())
        self.assertEqual(second.ask(**CONFIGURATION)["type"], "configured")

    def test_the_load_is_told_when_asked_and_now_and_then(self):
        service = self.service()
        self.assertEqual(self.client(service).ask(type="load")["clients"], 1)
        client = self.client(service, "digger", load_every_s=0.1)
        client.ask(**CONFIGURATION)
        for i in range(20):
            client.send(**boom(i))
        loads = [client.receive_type("load")]
        while loads[-1]["samples"] < 20:
            loads.append(client.receive_type("load"))
        self.assertEqual(loads[-1]["generations"], 60)
        self.assertEqual(loads[-1]["machines"], 1)
        while loads[-1]["over_s"] < 1 or loads[-1]["samples_per_s"] == 0:  # until the first whole second
            loads.append(client.receive_type("load"))
        counted = loads[-1]["samples_per_s"] * loads[-1]["over_s"]  # all 20 samples, unless the interval ended earlier
        self.assertAlmostEqual(counted, round(counted), delta=0.01)
        self.assertLessEqual(round(counted), 20)
        self.assertGreater(loads[-1]["work_of_core"], 0)
        self.assertLess(loads[-1]["work_of_core"], 1)

    def test_what_is_said_wrong_is_named(self):
        client = self.client(self.service())
        self.assertEqual(client.ask(type="status")["field"], "type")
        error = client.ask(type="hello", version=3, machine="digger")
        self.assertEqual((error["type"], error["line"], error["field"], error["right"]), ("error", 2, "version", "1"))
        client.ask(type="hello", version=1, machine="digger")
        self.assertIn("configuration", client.ask(**boom(0))["right"])
        client.ask(**CONFIGURATION)
        error = client.ask(type="sample", time_s=1, links={"BO": {"inlet_psi": "high"}})
        self.assertEqual((error["line"], error["field"]), (6, "links.BO.inlet_psi"))
        client.send_bytes(b'{"type":"status",}\n')
        self.assertEqual(client.receive()["column"], 18)
        self.assertEqual(client.ask(type="ping")["type"], "pong")


if __name__ == "__main__":
    unittest.main()
