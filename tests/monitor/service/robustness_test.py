"""Tests that the service survives whatever clients do."""

import json
import random
import socket
import threading
import unittest

from service import CONFIGURATION, SECONDS, ServiceTest, boom


class Robustness(ServiceTest):
    def still_well(self, service):
        self.assertEqual(self.client(service).ask(type="ping")["type"], "pong")

    def test_a_web_page_cannot_speak_through_a_browser(self):
        service = self.service()
        self.client(service, "digger").ask(type="bye")
        body = b'{"type":"forget","machine":"digger"}\n' * 3
        with socket.create_connection(service.address, SECONDS) as raw:
            raw.sendall(b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 111\r\n\r\n" + body)
            answers = b"".join(iter(lambda: raw.recv(4096), b""))
        self.assertIn(b'"wrong":"the line is an HTTP request"', answers)
        self.assertEqual(answers.count(b"\n"), 1)
        self.assertEqual(self.client(service).ask(type="load")["machines"], 1)

    def test_garbage_is_answered_line_by_line(self):
        client = self.client(self.service())
        generator = random.Random(1)
        count = 200
        for _ in range(count):
            line = bytes(generator.randrange(256) for _ in range(generator.randrange(1, 300)))
            client.send_bytes(b"\x00" + line.replace(b"\n", b" ").replace(b"\r", b" ") + b"\n")
        for number in range(1, count + 1):
            answer = client.receive()
            self.assertEqual((answer["type"], answer["line"]), ("error", number))
        self.assertEqual(client.ask(type="ping")["type"], "pong")

    def test_truths_cut_or_bent_anywhere_are_answered(self):
        client = self.client(self.service(), "digger")
        client.ask(**CONFIGURATION)
        line = json.dumps(boom(0)).encode()
        generator = random.Random(2)
        for cut in range(1, len(line)):
            client.send_bytes(line[:cut] + b"\n")
            self.assertEqual(client.receive()["type"], "error")
        for _ in range(300):
            bent = bytearray(line)
            bent[generator.randrange(len(bent))] = generator.randrange(32, 127)
            client.send_bytes(bytes(bent) + b"\n")
            self.assertIn(client.receive()["type"], ("error", "estimates"))
        self.assertEqual(client.ask(type="ping")["type"], "pong")

    def test_half_a_line_and_gone(self):
        service = self.service()
        for cut in (b"", b"{", b'{"type":"hello","version":1,"machine":"digger"}', b'{"type":"ping"}\n{"type'):
            client = self.client(service)
            client.send_bytes(cut)
            client.close()
        half = self.client(service)
        half.send_bytes(b'{"type":"ping"}\n{"type":"pi')
        half.socket.shutdown(socket.SHUT_WR)
        self.assertEqual(half.receive()["type"], "pong")
        self.assertEqual(half.receive()["line"], 2)  # an invalid message is answered with an error
        self.assertIsNone(half.receive())
        self.still_well(service)

    def test_a_gigabyte_without_an_end(self):
        service = self.service("--closing-timeout", 60)
        before = service.memory_kilobytes()
        client = self.client(service)
        answers = []
        reader = threading.Thread(target=lambda: answers.extend([client.receive(), client.receive()]))
        reader.start()
        chunk = b"x" * (1 << 20)
        for _ in range(1024):
            client.send_bytes(chunk)
        client.socket.shutdown(socket.SHUT_WR)
        reader.join()
        self.assertEqual(answers[0]["type"], "error")
        self.assertIn("65536 bytes", answers[0]["wrong"])
        self.assertIsNone(answers[1])
        self.assertLess(service.memory_kilobytes() - before, 4096)
        self.still_well(service)

    def test_the_longest_line_allowed_is_taken(self):
        client = self.client(self.service("--max-line", 100))
        client.send_bytes(b'{"type":"ping"}' + b" " * 85 + b"\n")
        self.assertEqual(client.receive()["type"], "pong")
        client.send_bytes(b'{"type":"ping"}' + b" " * 86 + b"\n")
        self.assertIn("more than 100 bytes", client.receive()["wrong"])
        self.assertIsNone(client.receive())

    def test_a_flood_is_held_back_and_nothing_lost(self):
        service = self.service("--stall-timeout", 60)
        before = service.memory_kilobytes()
        client = self.client(service)
        count = 400000  # 6 MB of questions and 6 MB of answers, unread at first
        flood = threading.Thread(target=client.send_bytes, args=(b'{"type":"ping"}\n' * count,))
        flood.start()
        self.still_well(service)
        for _ in range(count):
            self.assertEqual(client.lines.readline(), b'{"type":"pong"}\n')
        flood.join()
        self.assertLess(service.memory_kilobytes() - before, 8192)

    def test_a_slow_watcher_is_told_and_dropped_and_holds_nobody_up(self):
        service = self.service("--max-queue", 20000, "--closing-timeout", 60)
        control = self.client(service, "digger")
        slow = self.client(service, "digger", role="watch")
        control.ask(**CONFIGURATION)
        load = self.client(service)
        asked = 0
        while load.ask(type="load")["clients"] == 3:
            for _ in range(100):
                self.assertEqual(control.ask(**boom(0, start_s=asked))["type"], "estimates")
                asked += 1
            self.assertLess(asked, 200000)
        last = message = slow.receive()
        while message is not None:
            last, message = message, slow.receive()
        self.assertEqual(last["type"], "error")
        self.assertIn("client reads too slowly", last["wrong"])
        self.assertEqual(control.ask(type="status")["samples"], asked)

    def test_who_never_reads_is_dropped(self):
        service = self.service("--stall-timeout", 0.2)
        client = self.client(service)
        load = self.client(service)
        flood = threading.Thread(target=self.flood_until_closed, args=(client,))
        flood.start()
        flood.join()
        while load.ask(type="load")["clients"] > 1:
            pass

    @staticmethod
    def flood_until_closed(client):
        try:
            while True:
                client.send_bytes(b'{"type":"load"}\n' * 1000)
        except OSError:
            pass

    def test_who_says_no_hello_is_told_and_dropped(self):
        silent = self.client(self.service("--hello-timeout", 0.2))
        self.assertIn("no hello has arrived within 0.2 s", silent.receive()["wrong"])
        self.assertIsNone(silent.receive())

    def test_who_falls_silent_is_told_and_dropped(self):
        idle = self.client(self.service("--idle-timeout", 0.5), "digger")
        self.assertIn("no line has arrived for 0.5 s", idle.receive()["wrong"])
        self.assertIsNone(idle.receive())

    def test_who_dribbles_is_told_and_dropped(self):
        dribbling = self.client(self.service("--line-timeout", 0.3), "digger")
        answers = []
        reader = threading.Thread(target=lambda: answers.append(dribbling.receive()))
        reader.start()
        pause = threading.Event()
        try:
            while reader.is_alive():
                dribbling.send_bytes(b" ")
                pause.wait(0.02)
        except OSError:
            pass  # the connection has been closed
        reader.join()
        self.assertIn("the line is still incomplete after 0.3 s", answers[0]["wrong"])

    def test_two_hundred_clients_at_once(self):
        service = self.service("--max-clients-per-peer", 256)
        clients = [self.client(service, f"digger-{i}") for i in range(200)]
        for client in clients:
            client.send(**CONFIGURATION)
        for i in range(12):
            for client in clients:
                client.send(**boom(i))
        for client in clients:
            self.assertEqual(client.receive()["type"], "configured")
            samples = [client.receive()["samples"] for _ in range(12)]
            self.assertEqual(samples, list(range(1, 13)))
        load = self.client(service).ask(type="load")
        self.assertEqual((load["clients"], load["machines"], load["samples"]), (201, 200, 2400))
        self.assertEqual(load["generations"], 200 * 4 * 5)

    def test_one_too_many_is_turned_away(self):
        service = self.service("--max-clients", 2, "--max-machines", 1)
        first, second = self.client(service, "digger"), self.client(service)
        self.assertIn("already has 1 machines", second.ask(type="hello", version=1, machine="other")["wrong"])
        self.client(service, "digger", role="watch")
        third = self.client(service, "digger", role="watch")
        self.assertIn("already has 2 clients", third.welcome["wrong"])
        self.assertIsNone(third.receive())
        first.ask(type="bye")
        self.assertIsNone(first.receive())
        self.still_well(service)


if __name__ == "__main__":
    unittest.main()
