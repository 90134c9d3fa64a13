"""Tests that hostile requests harm nothing: each is refused, and afterwards the service works as before."""

import contextlib
import json
import os
import random
import socket
import subprocess
import unittest

from serving import PROGRAM, SECONDS, ServiceTest

RING = "csp/deadlock/ring.cfs"
SEED = int(os.environ.get("PLACEDPAR_SEED", "1"))
REQUESTS = int(os.environ.get("PLACEDPAR_REQUESTS", "1500"))
WORDS = ["GET", "POST", "PUT", "TRACE", "/", "/job", "/examples", "/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/place?" + "x" * 5000,
         "//etc/passwd", "/job?<script>", "http://evil.example/", "\0", "\r\n", " ", "HTTP/1.1", "HTTP/9.9", "Host: localhost", "Host: evil.example",
         "Host: localhost\r\nHost: localhost", "Origin: http://evil.example", "Content-Type: application/json", "Content-Type: text/plain",
         "Content-Length: 5", "Content-Length: -1", "Content-Length: 99999999999", "Transfer-Encoding: chunked", "\xff\xfe", "{", '{"do":', "[" * 3000,
         "ffffffffffffffff\r\n", "Cookie: " + "a" * 9000, "Authorization: Basic !!!!", "Expect: 100-continue", "Connection: Upgrade", "a: b\r\n" * 300]


class Hostile(ServiceTest):
    def raw(self, data):
        """Returns what the service answers to these bytes, after which nothing is sent."""
        with socket.create_connection((self.service.host, self.service.port), SECONDS) as connection:
            try:
                connection.sendall(data)
                connection.shutdown(socket.SHUT_WR)
                return b"".join(iter(lambda: connection.recv(65536), b""))
            except OSError:
                return b""  # the service has closed the connection

    def tearDown(self):
        self.assertEqual(self.service.answer("run", RING)["ended"], "deadlock")
        self.assertEqual(list(self.folder.iterdir()), [])
        self.assertEqual(self.service.stop(), (0, ""))

    def test_only_requests_of_its_own_page_are_done(self):
        job = json.dumps({"do": "run", "main": "a.cfs", "files": {"a.cfs": "T800 t;"}})
        own = f"http://127.0.0.1:{self.service.port}"
        for headers, status in (({"Content_Type": "application/json"}, 200), ({"Content_Type": "application/json", "Origin": own}, 200),
                                ({"Content_Type": "application/json", "Origin": "http://evil.example"}, 403),
                                ({"Content_Type": "application/json", "Origin": "http://127.0.0.1:1"}, 403),
                                ({"Content_Type": "application/json", "Origin": "null"}, 403), ({"Content_Type": "text/plain"}, 415), ({}, 415),
                                ({"Content_Type": "application/json", "Host": "evil.example"}, 421)):
            self.assertEqual(self.service.ask("POST", "/job", job, **headers)[0], status, headers)

    def test_only_paths_of_the_table_exist(self):
        for path in ("/../serve.cpp", "/%2e%2e/%2e%2e/etc/passwd", "/examples/../../../etc/passwd", "//etc/passwd", "/examples/", "/job", "/page.js"):
            self.assertEqual(self.service.ask("GET", path)[0], 404, path)
        self.assertEqual(self.service.ask("POST", "/examples", "{}", Content_Type="application/json")[0], 405)
        status, headers, text = self.service.ask("GET", "/")
        self.assertEqual((status, headers["X-Content-Type-Options"]), (200, "nosniff"))
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
        self.assertNotRegex(text, r'(src|href)\s*=\s*"(http|//)')

    def test_what_is_not_a_job_is_refused(self):
        good = {"do": "run", "main": "a.cfs", "files": {"a.cfs": ""}}
        place = 'the text of each file must be a string, and its name must have no ".." and not begin with "/"'
        for job, why in ((None, "it must be a JSON object"), ([], "it must be a JSON object"), ("x", "it must be a JSON object"), ({}, '"do" is missing'),
                         ({"do": "run"}, '"main" is missing'), ({"do": "run", "main": "a.cfs"}, '"files" is missing'),
                         (good | {"do": "rm"}, '"do" must be check, run, explain, listing or exercise'),
                         (good | {"main": "b.cfs"}, '"main" must be the name of one of the files'), (good | {"main": 1}, '"main" must be a string'),
                         (good | {"files": 1}, '"files" must be an object'), (good | {"files": {"a.cfs": 1}}, place),
                         (good | {"main": "../a.cfs", "files": {"../a.cfs": ""}}, place), (good | {"main": "/a.cfs", "files": {"/a.cfs": ""}}, place),
                         (good | {"seed": "x"}, '"seed" must be a whole number'), (good | {"seed": 1.5}, '"seed" must be a whole number'),
                         (good | {"files": good["files"] | {f"{i}.cfs": "" for i in range(30)}}, "the job has more than 20 files")):
            status, _, text = self.service.post(job)
            self.assertEqual((status, text), (400, f"the request is not a job: {why}\n"), job)
            if "more than 20" not in why:  # the service adds the examples to a job, so --job has no such limit
                self.assertEqual(self.refusal_of_job(json.dumps(job)), f"this is not a job: {why}")
        self.assertEqual(self.refusal_of_job('{"do": '), "this is not a job: it is not JSON: incomplete JSON")
        self.assertEqual(self.service.ask("POST", "/job", "[" * 100000, Content_Type="application/json")[0], 400)
        answer = self.raw(b"POST /job HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 300000\r\n\r\n")
        self.assertIn(b" 413 ", answer)
        self.assertIn(b"the body has more than 262144 bytes\n", answer)

    @staticmethod
    def refusal_of_job(text):
        """Returns why "serve --job" refuses this text."""
        run = subprocess.run([PROGRAM, "serve", "--job"], input=text, capture_output=True, text=True, timeout=SECONDS, check=False)
        answer = json.loads(run.stdout)
        return answer["refused"] if (run.returncode, answer["ended"]) == (1, "refused") else run

    def test_scripts_in_names_stay_text(self):
        name = "<script>alert(1)</script>.cfs"
        text = 'T800 (memory = 1M) t;\nprocess p;\nuse "</script><script>alert(2)</script>" for p;'
        _, headers, _ = self.service.post({"do": "check", "main": name, "files": {name: text}})
        self.assertEqual(headers["Content-Type"], "application/json")
        answer = self.service.answer("run", name, {name: (
            "T800 (memory = 1M) t;\nprocess (interface (input in, output out)) p;\nuse \"csp.identity\" for p;\n"
            "connect p.out to p.in;\nplace p on t;")})
        self.assertEqual(answer["ended"], "deadlock")
        self.assertNotIn("<script>alert", answer["page"])

    def test_random_requests(self):
        draw = random.Random(SEED)
        for i in range(REQUESTS):
            parts = draw.choices(WORDS, k=draw.randint(1, 8))
            if draw.random() < 0.6:
                parts = [f"{draw.choice(WORDS[:4])} {draw.choice(WORDS[4:13])} HTTP/1.1", *parts]
            data = draw.choice(["\r\n", "\n", " "]).join(parts) + draw.choice(["", "\r\n\r\n", '\r\n\r\n{"do":'])
            answer = self.raw(data.encode("latin-1"))
            with self.subTest(again=f"PLACEDPAR_SEED={SEED}", request=i, data=data):
                self.assertTrue(answer == b"" or answer.startswith(b"HTTP/1."), answer)
                self.assertNotIn(b"root:", answer)
        self.assertLess(self.service.memory_megabytes(), 200)

    def connections(self, number, data):
        """Opens connections, each of which sends data and then waits."""
        all_of_them = []
        for _ in range(number):
            connection = self.enterContext(socket.create_connection((self.service.host, self.service.port), SECONDS))
            with contextlib.suppress(OSError):  # the service may close the connection before it has read everything
                connection.sendall(data)
            all_of_them.append(connection)
        return all_of_them

    def test_slow_clients_keep_nothing_from_others(self):
        slow = self.connections(700, b"POST /job HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 1000\r\n\r\n{")
        self.assertEqual(self.service.answer("run", RING)["ended"], "deadlock")
        for connection in slow[:100]:  # a client may have 600 connections: the oldest have been closed
            with contextlib.suppress(ConnectionResetError):
                self.assertEqual(connection.recv(1), b"")
        slow[-1].setblocking(False)
        self.assertRaises(BlockingIOError, slow[-1].recv, 1)  # the youngest is still open

    def test_bodies_of_refused_requests_need_no_memory(self):
        before = self.service.memory_megabytes()
        head = b"POST /job HTTP/1.1\r\nHost: localhost\r\nOrigin: http://evil.example\r\nContent-Type: application/json\r\nContent-Length: 200000\r\n\r\n"
        self.connections(300, head + bytes(190000))
        self.assertEqual(self.service.answer("run", RING)["ended"], "deadlock")
        self.assertLess(self.service.memory_megabytes() - before, 20)


class WithToken(ServiceTest):
    def test_other_addresses_need_the_token(self):
        token = self.folder / "token"
        token.write_text("correct-horse-battery")
        token.chmod(0o600)
        service = self.serve("--address", "127.0.0.2", "--token-file", token)
        for path in ("/", "/examples", "/place?x"):
            status, headers, _ = service.ask("GET", path)
            self.assertEqual((status, headers["WWW-Authenticate"]), (401, 'Basic realm="placedpar serve", Bearer'))
            self.assertEqual(service.ask("GET", path, Authorization="Bearer correct-horse-battery")[0], 200)
        self.assertEqual(service.post({"do": "run"})[0], 401)
        self.assertEqual(service.ask("GET", "/healthz")[0], 200)


if __name__ == "__main__":
    unittest.main()
