"""An editor for tests: talks with placedpar language-server, and keeps the texts that it has open."""

import json
import os
import pathlib
import queue
import random
import subprocess
import tempfile
import threading
import time
import unittest

from program import PROGRAM

TIMEOUT = 60  # seconds for an answer, on a busy machine


def units(text):
    """Returns the length of a text in units of UTF-16."""
    return len(text.encode("utf-16-le")) // 2


def position(text, index):
    """Returns the position of a character of a text, as the protocol counts."""
    before = text[:index]
    return {"line": before.count("\n"), "character": units(before[before.rfind("\n") + 1:])}


def index_of(text, at):
    """Returns the index of a position's character."""
    start = 0
    for _ in range(at["line"]):
        start = text.index("\n", start) + 1
    index = start
    while units(text[start:index]) < at["character"]:
        index += 1
    return index


class LanguageClient:
    def __init__(self, initialize=True):
        self.process = subprocess.Popen([PROGRAM, "language-server"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.messages = queue.Queue()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()
        self.diagnostics, self.logged, self.texts, self.versions = {}, [], {}, {}
        self.last_id = 0
        if initialize:
            self.capabilities = self.request("initialize", {"capabilities": {}})["capabilities"]
            self.notify("initialized", {})

    def read(self):
        while header := self.process.stdout.readline():
            length = int(header.split(b":")[1])
            assert self.process.stdout.readline() == b"\r\n"
            self.messages.put(json.loads(self.process.stdout.read(length)))
        self.messages.put(None)

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def notify(self, method, params):
        self.send({"method": method, "params": params})

    def receive(self):
        """Returns the next message, after noting it if it is a notification; None at the end."""
        message = self.messages.get(timeout=TIMEOUT)
        if message and message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]
        elif message and message.get("method") == "window/logMessage":
            self.logged.append(message["params"]["message"])
        return message

    def answer(self, method, params):
        """Sends a request, and returns the whole answer."""
        self.last_id += 1
        self.send({"id": self.last_id, "method": method, "params": params})
        while True:
            message = self.receive()
            if message is None:
                raise AssertionError("the server has ended")
            if message.get("id") == self.last_id and "method" not in message:
                return message

    def request(self, method, params):
        answer = self.answer(method, params)
        assert "error" not in answer, answer
        return answer["result"]

    def open(self, path, text=None, language="placedpar-netlist"):
        """Opens a file, with another text if one is given. Returns its URI."""
        uri = pathlib.Path(path).absolute().as_uri()
        self.texts[uri] = pathlib.Path(path).read_text() if text is None else text
        self.versions[uri] = 1
        self.notify("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": language, "version": 1,
                                                              "text": self.texts[uri]}})
        return uri

    def edit(self, uri, *changes):
        """Replaces parts of a text: each change is (first index, last index, new text)."""
        sent, text = [], self.texts[uri]
        for first, last, new in changes:
            sent.append({"range": {"start": position(text, first), "end": position(text, last)}, "text": new})
            text = text[:first] + new + text[last:]
        self.texts[uri] = text
        self.versions[uri] += 1
        self.notify("textDocument/didChange", {"textDocument": {"uri": uri, "version": self.versions[uri]},
                                               "contentChanges": sent})

    def replace(self, uri, old, new):
        first = self.texts[uri].index(old)
        self.edit(uri, (first, first + len(old), new))

    def close(self, uri):
        self.notify("textDocument/didClose", {"textDocument": {"uri": uri}})

    def checked(self, uri):
        """Returns the diagnostics of a text as it is now."""
        while self.diagnostics.get(uri, {}).get("version") != self.versions[uri]:
            if self.receive() is None:
                raise AssertionError("the server has ended")
        return self.diagnostics[uri]["diagnostics"]

    def at(self, uri, words, behind=0):
        """Returns the parameters of a request about the first character of some words, or one further on."""
        return {"textDocument": {"uri": uri}, "position": position(self.texts[uri], self.texts[uri].index(words) + behind)}

    def underlined(self, uri, diagnostic):
        text, span = self.texts[uri], diagnostic["range"]
        return text[index_of(text, span["start"]):index_of(text, span["end"])]

    def applied(self, uri, edits):
        """Returns the text after the edits of an answer."""
        text = self.texts[uri]
        for each in sorted(edits, key=lambda e: (e["range"]["start"]["line"], e["range"]["start"]["character"]), reverse=True):
            text = text[:index_of(text, each["range"]["start"])] + each["newText"] + text[index_of(text, each["range"]["end"]):]
        return text

    def processor_seconds(self):
        """Returns the processor time that the server has taken; unlike the wall clock, it does not depend on other programs."""
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def end(self):
        """Shuts the server down, and returns its exit code."""
        if self.process.poll() is None:
            self.request("shutdown", None)
            self.notify("exit", None)
        code = self.process.wait(TIMEOUT)
        self.process.stdin.close()
        self.reader.join(TIMEOUT)
        self.process.stdout.close()
        return code

    def end_without_shutdown(self):
        self.notify("exit", None)
        code = self.process.wait(TIMEOUT)
        self.process.stdin.close()
        self.process.stdout.close()
        return code


class LanguageTest(unittest.TestCase):
    """Has an editor and a folder, and asks about the places of texts."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.client = LanguageClient()
        self.addCleanup(self.client.end)

    def open(self, name, text, language="placedpar-netlist"):
        path = self.folder / name
        path.write_text(text)
        return self.client.open(path, text, language)

    def underlined(self, uri):
        return [self.client.underlined(uri, each) for each in self.client.checked(uri)]

    def labels(self, uri, words, behind=0):
        answer = self.client.request("textDocument/completion", self.client.at(uri, words, behind))
        return [item["label"] for item in answer["items"]]

    def hover(self, uri, words, behind=0):
        answer = self.client.request("textDocument/hover", self.client.at(uri, words, behind))
        return answer["contents"]["value"] if answer else ""

    def definition(self, uri, words, behind=0):
        return self.client.request("textDocument/definition", self.client.at(uri, words, behind))

    def seconds_an_edit(self, uri, digit):
        """Returns the processor time of an edit of the last character of `digit`, which is a digit."""
        self.assertEqual(self.client.checked(uri), [])
        times, begun = [], self.client.processor_seconds()
        for number in range(10):
            sent = time.monotonic()
            where = self.client.texts[uri].index(digit) + len(digit) - 1
            self.client.edit(uri, (where, where + 1, str(number)))
            self.assertEqual(self.client.checked(uri), [])
            times.append(time.monotonic() - sent)
            digit = digit[:-1] + str(number)
        processor = (self.client.processor_seconds() - begun) / len(times)
        print(f"{uri.rsplit('/')[-1]}: an edit in {self.client.texts[uri].count(chr(10))} lines takes "
              f"{1000 * sorted(times)[5]:.0f} ms, {1000 * processor:.0f} ms of a processor", flush=True)
        return processor

    def survives(self, uri, text, seed):
        """Replaces the text by random parts of a text, and asks about random places of them."""
        rng = random.Random(seed)
        for _ in range(40):
            some = [line[:rng.randint(0, len(line))] if rng.random() < 0.1 else line
                    for line in text.split("\n") if rng.random() > 0.05]
            self.client.edit(uri, (0, len(self.client.texts[uri]), "\n".join(some)))
            for _ in range(5):
                now = self.client.texts[uri]
                place = {"textDocument": {"uri": uri}, "position": position(now, rng.randint(0, len(now)))}
                for method in ("hover", "completion", "definition"):
                    self.client.request("textDocument/" + method, place)
        self.client.checked(uri)
