"""Drives Firefox over Marionette, the protocol of its own tests: a WebDriver command is a line of JSON with its length before it."""

import contextlib
import json
import shutil
import socket
import subprocess
import tempfile
import time

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Firefox:
    def __enter__(self):
        self.stack = contextlib.ExitStack()
        profile = self.stack.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True))
        port = free_port()
        with open(profile + "/user.js", "w", encoding="utf-8") as preferences:
            preferences.write(f'user_pref("marionette.port", {port});\nuser_pref("datareporting.policy.dataSubmissionEnabled", false);\n')
        self.process = self.stack.enter_context(
            subprocess.Popen([FIREFOX, "--headless", "--marionette", "--no-remote", "--profile", profile],
                             stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={"HOME": profile, "PATH": "/usr/bin:/bin"}))
        self.stack.callback(self.process.kill)
        self.socket = self.stack.enter_context(contextlib.closing(self.connect(port)))
        self.received, self.count = b"", 0
        self.read()  # the greeting
        self.command("WebDriver:NewSession", {})
        return self

    def __exit__(self, *failure):
        self.stack.close()

    def connect(self, port):
        for _ in range(600):
            with contextlib.suppress(ConnectionRefusedError):
                return socket.create_connection(("127.0.0.1", port), timeout=60)
            assert self.process.poll() is None, "Firefox has ended"
            time.sleep(0.1)
        raise TimeoutError("Firefox does not answer")

    def read(self):
        while b":" not in self.received:
            self.received += self.socket.recv(65536)
        length, self.received = self.received.split(b":", 1)
        while len(self.received) < int(length):
            self.received += self.socket.recv(65536)
        text, self.received = self.received[:int(length)], self.received[int(length):]
        return json.loads(text)

    def command(self, name, parameters):
        self.count += 1
        text = json.dumps([0, self.count, name, parameters]).encode()
        self.socket.sendall(b"%d:" % len(text) + text)
        _, _, error, result = self.read()
        assert error is None, error
        return result

    def visit(self, address):
        self.command("WebDriver:Navigate", {"url": address})

    def run(self, script):
        """Returns the result of the script, which runs like a script of the page."""
        script = f"return window.eval({json.dumps('(() => {' + script + '})()')})"
        return self.command("WebDriver:ExecuteScript", {"script": script, "args": []})["value"]
