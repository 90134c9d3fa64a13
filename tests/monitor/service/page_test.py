"""Tests what browsers, Prometheus and systemd receive; in a browser if one is installed."""

import base64
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import unittest
import urllib.error
import urllib.request

import firefox
from chromium import Chromium
from cut_texts import check_nothing_is_cut
from service import CONFIGURATION, SECONDS, ServiceTest, move_softly

TOKEN = "correct-horse-battery"
FIREFOX = shutil.which("firefox") or shutil.which("firefox-esr")
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")


class Page(ServiceTest):
    def fetch(self, service, path, method="GET", **headers):
        """Returns status, headers and text."""
        request = urllib.request.Request(service.page + path, method=method, headers=headers)
        try:
            with urllib.request.urlopen(request, timeout=SECONDS) as answer:
                return answer.status, answer.headers, answer.read().decode()
        except urllib.error.HTTPError as error:
            with error:
                return error.code, error.headers, error.read().decode()

    def busy(self, *options, machine="digger"):
        """Returns a service with a machine that has moved three times and raised an alarm."""
        service = self.service("--http", 0, *options)
        client = self.client(service, machine)
        client.ask(**CONFIGURATION)
        self.assertIn("alarm", [said["type"] for said in move_softly(client)])
        client.ask(**{**CONFIGURATION, "configuration": "b"})  # a new configuration ends the last movement
        return service, client

    def test_what_the_page_asks(self):
        service, client = self.busy("--state", self.folder / "state")
        code, headers, page = self.fetch(service, "")
        self.assertEqual((code, headers["Content-Type"]), (200, "text/html; charset=utf-8"))
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
        self.assertEqual(re.findall(r"(?:src|href)=\"(?!data:)|@import|https?://(?!www.w3.org/2000/svg)", page), [])
        snapshot = json.loads(self.fetch(service, "snapshot")[2])
        machine, = snapshot["machines"]
        self.assertEqual((machine["machine"], machine["samples"], snapshot["kept"]), ("digger", 120, True))
        self.assertLess(abs(machine["estimates"][0]["settled"] / 0.0086 - 1), 0.05)
        self.assertEqual({alarm["machine"] for alarm in snapshot["alarms"]}, {"digger"})
        history = json.loads(self.fetch(service, "history?machine=digger")[2])
        self.assertEqual(len(history["estimates"]), 3)
        for each in history["estimates"]:  # each estimate has a standard error, the first one too
            self.assertGreater(each["error"], 0)
        self.assertEqual([(said["link"], said["sure"]) for said in machine["verdicts"]], [("BO", "more than 99 % sure")])
        self.assertGreaterEqual(len(history["alarms"]), 1)
        self.assertEqual(json.loads(self.fetch(service, "history?machine=none")[2]), {"estimates": [], "alarms": []})
        client.send(type="ping")
        self.assertEqual(client.receive_type("pong"), {"type": "pong"})

    def test_metrics(self):
        service, client = self.busy()
        code, headers, text = self.fetch(service, "metrics")
        self.assertEqual((code, headers["Content-Type"]), (200, "text/plain; version=0.0.4; charset=utf-8"))
        name, labels = r"[a-z][a-z0-9_]*", r'\{(?:[a-z]+="[^"\\\n]*",?)+\}'
        for line in text.splitlines():
            self.assertRegex(line, rf"^(?:# HELP {name} .+|# TYPE {name} (?:gauge|counter)|"
                                   rf"{name}(?:{labels})? -?[0-9.]+(?:e[+-]?[0-9]+)?)$")
        self.assertIn("\nplacedpar_monitor_samples_total 120\n", text)
        self.assertIn("\nplacedpar_monitor_kept 1\n", text)
        self.assertRegex(text, r'placedpar_monitor_alarm\{machine="digger",alarm="\w+",links="BO",acknowledged="no"\} 1')
        self.assertRegex(text, r'compliance_in3_per_psi\{machine="digger",set="P1b",link="BO"\} 0.008')
        client.send(type="ping")
        self.assertEqual(client.receive_type("pong"), {"type": "pong"})

    def test_health(self):
        service = self.service("--http", 0, "--state", self.folder / "state")
        self.assertEqual(self.fetch(service, "healthz")[::2], (200, "ok\n"))
        client = self.client(service, "digger")
        service.fill_disk(1)
        client.send(**CONFIGURATION)
        client.receive_type("kept")
        code, _, text = self.fetch(service, "healthz")
        self.assertEqual(code, 503)
        self.assertIn("not stored: ", text)

    def test_nothing_can_be_changed_and_nonsense_is_answered(self):
        service = self.service("--http", 0)
        for method in ("POST", "PUT", "DELETE", "OPTIONS"):
            self.assertEqual(self.fetch(service, "snapshot", method)[0], 405)
        self.assertEqual(self.fetch(service, "snapshot", "HEAD")[0], 200)
        self.assertEqual(self.fetch(service, "passwd")[0], 404)
        self.assertEqual(self.fetch(service, "history")[0], 400)
        port = int(re.search(r":(\d+)/", service.page)[1])
        for rubbish in (b"\0\1\2\r\n\r\n", b"GET / HTTP/1.1\r\nX: " + b"x" * 100000, b"{\"type\":\"ping\"}\n\n",
                        b"POST / HTTP/1.1\r\nContent-Length: 1000000000\r\n\r\n"):
            with socket.create_connection(("127.0.0.1", port), SECONDS) as raw:
                try:
                    raw.sendall(rubbish)
                    while raw.recv(4096):
                        pass
                except OSError:
                    pass  # the connection has been closed
        half = [socket.create_connection(("127.0.0.1", port), SECONDS) for _ in range(40)]
        self.assertEqual(self.fetch(service, "healthz")[0], 200)
        for each in half:
            each.close()
        self.assertEqual(self.client(service).ask(type="ping")["type"], "pong")

    def test_the_token_is_wanted_there_too(self):
        token = self.folder / "token"
        token.write_text(TOKEN)
        token.chmod(0o600)
        self.assertIn("--token-file FILE", self.refusal("--address", "0.0.0.0", "--unix", self.folder / "s", "--http", 0))
        service = self.service("--http", 0, "--token-file", token)
        for path in ("", "snapshot", "metrics", "history?machine=x"):
            code, headers, _ = self.fetch(service, path)
            self.assertEqual((code, headers["WWW-Authenticate"]), (401, 'Basic realm="placedpar monitor", Bearer'))
            for said, wanted in ((TOKEN, 200), (TOKEN[:-1] + "x", 401), ("", 401)):
                self.assertEqual(self.fetch(service, path, Authorization="Bearer " + said)[0], wanted)
                basic = base64.b64encode(f"anybody:{said}".encode()).decode()
                self.assertEqual(self.fetch(service, path, Authorization="Basic " + basic)[0], wanted)
        self.assertEqual(self.fetch(service, "healthz")[0], 200)
        self.assertEqual(self.fetch(service, "snapshot", Authorization="bearer " + TOKEN)[0], 200)

    def test_each_wrong_token_costs_a_connection_and_is_in_the_log(self):
        token = self.folder / "token"
        token.write_text(TOKEN)
        token.chmod(0o600)
        service = self.service("--http", 0, "--token-file", token)
        address = "127.0.0.1", int(re.search(r":(\d+)/", service.page)[1])
        with socket.create_connection(address, SECONDS) as raw:
            raw.sendall(b"GET /snapshot HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer wrong-horse-battery\r\n\r\n" * 3)
            answers = b"".join(iter(lambda: raw.recv(4096), b""))
        self.assertEqual(answers.count(b"HTTP/1.1 401"), 1)
        self.assertRegex(service.stop()[1], r"Z placedpar monitor: 127.0.0.1 port \d+ sent a wrong token\n")

    def test_no_peer_takes_the_whole_page(self):
        service = self.service("--http", 0)
        address = "127.0.0.1", int(re.search(r":(\d+)/", service.page)[1])
        idle = [socket.create_connection(address, SECONDS, ("127.0.0.2", 0)) for _ in range(300)]
        self.assertEqual(self.fetch(service, "healthz")[0], 200)
        for each in idle:
            each.close()

    def browse(self, service, width=1400):
        return subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=5000",
                               f"--window-size={width},900", f"--user-data-dir={self.folder / 'browser'}", "--dump-dom",
                               service.page], capture_output=True, text=True, timeout=SECONDS, check=True)

    @unittest.skipUnless(BROWSER, "no Chromium")
    def test_the_chart_is_as_wide_as_there_is_room_and_nothing_stands_beyond_it(self):
        service, _ = self.busy("--state", self.folder / "state")
        for window, most in ((1400, 900), (500, 500)):
            page = self.browse(service, window).stdout
            width, height = map(int, re.search(r'viewBox="0 0 (\d+) (\d+)"', page).groups())
            self.assertTrue(most - 60 < width <= most, (window, width))
            for x, y in re.findall(r'<text x="([\d.]+)" y="([\d.]+)"', page):
                self.assertLess(float(x), width)
                self.assertLess(float(y), height)
            health = float(re.search(r'<text x="([\d.]+)"[^>]*>healthy BO<', page)[1])
            self.assertGreater(health, max(float(x) for x in re.findall(r'<circle cx="([\d.]+)"', page)))
            self.assertIn('<td data-head="raised">', page)  # the column's name is shown where rows are laid out as lists

    @unittest.skipUnless(BROWSER, "no Chromium")
    def test_no_text_is_cut_off(self):
        service, _ = self.busy("--state", self.folder / "state")
        chromium = Chromium()
        self.addCleanup(chromium.close)
        check_nothing_is_cut(self, chromium, service.page, "healthy BO")

    @unittest.skipUnless(BROWSER, "no Chromium")
    def test_in_a_browser(self):
        service, _ = self.busy("--state", self.folder / "state")
        done = self.browse(service)
        self.assertIn('<span class="good">everything is stored</span>', done.stdout)
        self.assertIn("BO by P1b", done.stdout)
        self.assertIn(">1 machine, 1 connection, ", done.stdout)
        self.assertIn(">healthy BO</text>", done.stdout)
        times = re.findall(r">(\d\d:\d\d[\d:.]*)</text>", done.stdout)
        self.assertGreater(len(times), 1)
        self.assertEqual(len(times), len(set(times)), times)  # no time occurs twice
        ticks = re.findall(r'text-anchor="end">([\d.]+)</text>', done.stdout)
        self.assertEqual(ticks[:2], ["0.000", "0.002"])
        self.assertEqual(done.stdout.count("<circle "), 4)  # three transients, and the legend's mark
        self.assertRegex(done.stdout, r'<td[^>]*><span class="alarm">\w+</span></td><td[^>]*>BO</td>')
        self.assertRegex(done.stdout, r"<td[^>]*>BO \w+, more than 99 % sure</td>")

    @unittest.skipUnless(FIREFOX, "no Firefox")
    def test_in_another_browser(self):
        service, _ = self.busy("--state", self.folder / "state")
        page = firefox.page_in(FIREFOX, self.folder, service.page, "BO by P1b")
        self.assertIn('<span class="good">everything is stored</span>', page)
        self.assertEqual(page.count("<circle "), 4)
        self.assertRegex(page, r"<td[^>]*>BO \w+, more than 99 % sure</td>")

    def test_systemd_is_told(self):
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as systemd:
            systemd.bind(str(self.folder / "notify"))
            systemd.settimeout(SECONDS)
            os.environ["NOTIFY_SOCKET"] = str(self.folder / "notify")
            self.addCleanup(os.environ.pop, "NOTIFY_SOCKET")
            service = self.service()
            self.assertEqual(systemd.recv(100), b"READY=1")
            self.assertEqual(systemd.recv(100), b"WATCHDOG=1")
            self.assertEqual(systemd.recv(100), b"WATCHDOG=1")
            service.process.send_signal(signal.SIGTERM)
            said = systemd.recv(100)
            while said == b"WATCHDOG=1":
                said = systemd.recv(100)
            self.assertEqual(said, b"STOPPING=1")
            # Sent again by service.stop(), the signal could arrive after the handler is removed, just before the
            # process ends.
            self.assertEqual(service.process.wait(SECONDS), 0)


if __name__ == "__main__":
    unittest.main()
