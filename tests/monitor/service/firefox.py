"""Gets a page as Firefox renders it, by Marionette, the browser's protocol: a length, a colon and JSON."""

import json
import socket
import subprocess
import time

SECONDS = 60  # to start the browser, and to load the page


class Firefox:
    def __init__(self, program, folder):
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = free.getsockname()[1]
        profile = folder / "firefox"
        profile.mkdir()
        (profile / "user.js").write_text(f'user_pref("marionette.port", {port});\n')
        self.process = subprocess.Popen([program, "--headless", "--no-remote", "--profile", profile, "--marionette"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.socket = self.connected(port)
        self.lines = self.socket.makefile("rwb")
        self.number = 0
        self.receive()  # the browser's greeting

    def connected(self, port):
        until = time.monotonic() + SECONDS
        while True:
            try:
                return socket.create_connection(("127.0.0.1", port), SECONDS)
            except OSError:
                if time.monotonic() > until:
                    raise
                time.sleep(0.1)

    def receive(self):
        length = b""
        while not length.endswith(b":"):
            length += self.lines.read(1)
        return json.loads(self.lines.read(int(length[:-1])))

    def ask(self, name, **parameters):
        self.number += 1
        message = json.dumps([0, self.number, name, parameters]).encode()
        self.lines.write(b"%d:%s" % (len(message), message))
        self.lines.flush()
        _, _, error, answer = self.receive()
        assert error is None, error
        return answer


def page_in(program, folder, address, wanted):
    """Returns the page as soon as it contains `wanted`, or after SECONDS as it is."""
    firefox = Firefox(program, folder)
    try:
        firefox.ask("WebDriver:NewSession")
        firefox.ask("WebDriver:Navigate", url=address)
        until = time.monotonic() + SECONDS
        page = ""
        while wanted not in page and time.monotonic() < until:
            page = firefox.ask("WebDriver:GetPageSource")["value"]
        return page
    finally:
        firefox.lines.close()
        firefox.socket.close()
        firefox.process.terminate()
        firefox.process.wait(SECONDS)
