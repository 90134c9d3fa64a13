"""Drives Chromium by its own protocol over two pipes: a command is JSON with a zero byte behind it. One browser serves many
pages: a start takes two seconds, a page a tenth of one."""

import collections
import json
import os
import select
import shutil
import subprocess
import tempfile

CHROMIUM = shutil.which("chromium")

# A page's programs get this much virtual time after loading, and it passes at once.
VIRTUAL_MS = 3000
SECONDS = 100  # for an answer


class Chromium:
    def __init__(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        commands, self.commands = os.pipe()
        self.answers, answers = os.pipe()
        # The shell is not sh: Debian's redirects only file descriptors of one digit.
        self.process = subprocess.Popen(
            ["bash", "-c", f'exec "$@" 3<&{commands} 4>&{answers}', "bash", CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu",
             f"--user-data-dir={self.profile.name}", "--remote-debugging-pipe"],
            pass_fds=(commands, answers), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(commands)
        os.close(answers)
        self.unread, self.events, self.count = b"", collections.deque(), 0

    def close(self):
        self.command("Browser.close")
        self.process.wait(timeout=60)
        os.close(self.commands)
        os.close(self.answers)
        self.profile.cleanup()

    def message(self):
        while b"\0" not in self.unread:
            if not select.select([self.answers], [], [], SECONDS)[0]:
                raise TimeoutError(f"Chromium has said nothing for {SECONDS} s")
            part = os.read(self.answers, 1 << 20)
            if not part:
                raise RuntimeError("Chromium has ended")
            self.unread += part
        text, self.unread = self.unread.split(b"\0", 1)
        return json.loads(text)

    def command(self, method, session=None, **parameters):
        """Returns the command's result. Events that arrive before it are appended to `events`."""
        self.count += 1
        sent = {"id": self.count, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        os.write(self.commands, json.dumps(sent).encode() + b"\0")
        while (found := self.message()).get("id") != self.count:
            self.events.append(found)
        if "error" in found:
            raise RuntimeError(f"{method}: {found['error']}")
        return found["result"]

    def wait_for(self, method, session, said):
        """Waits for the event. What the page writes on the console meanwhile is added to `said`."""
        while True:
            event = self.events.popleft() if self.events else self.message()
            if event.get("sessionId") != session:
                continue
            if event.get("method") in ("Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded"):
                said.append(json.dumps(event["params"]))
            if event.get("method") == method:
                return

    def visit(self, address, dark=False):
        """Returns the page as HTML after its programs have run, and what they wrote on the console."""
        return self.value_in(address, "document.documentElement.outerHTML", dark)

    def value_in(self, address, expression, dark=False, width=1300):
        """Returns the value of a JavaScript expression in a page after its programs have run, and their console
        output."""
        target = self.command("Target.createTarget", url="about:blank")["targetId"]
        try:
            return self.value_in_target(target, address, expression, dark, width)
        finally:
            self.command("Target.closeTarget", targetId=target)

    def value_in_target(self, target, address, expression, dark, width):
        session = self.command("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        said = []
        for domain in ("Page", "Runtime", "Log"):
            self.command(f"{domain}.enable", session)
        self.command("Emulation.setEmulatedMedia", session,
                     features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.command("Emulation.setDeviceMetricsOverride", session, width=width, height=900, deviceScaleFactor=1, mobile=False)
        self.command("Page.navigate", session, url=address)
        self.wait_for("Page.loadEventFired", session, said)
        self.command("Emulation.setVirtualTimePolicy", session, policy="pauseIfNetworkFetchesPending", budget=VIRTUAL_MS)
        self.wait_for("Emulation.virtualTimeBudgetExpired", session, said)
        result = self.command("Runtime.evaluate", session, expression=expression, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"the page says {result['exceptionDetails']}")
        return result["result"]["value"], said
