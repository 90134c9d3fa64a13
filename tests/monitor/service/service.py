"""Starts the service under test, named by the environment variable PLACEDPAR, and talks to it."""

import json
import os
import pathlib
import re
import resource
import signal
import socket
import subprocess
import tempfile
import threading
import unittest

PROGRAM = os.environ["PLACEDPAR"]
SECONDS = 60  # longest wait for anything that should be immediate


class Service:
    """A running `placedpar monitor`; it uses any free port."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([PROGRAM, "monitor", *map(str, arguments)], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.log = []
        self.reader = threading.Thread(target=lambda: self.log.extend(self.process.stderr))  # drains the pipe, which would fill up
        self.reader.start()
        self.address = self.page = None
        for _ in range(("--port" in arguments or "--unix" not in arguments) + ("--unix" in arguments) +
                       ("--http" in arguments)):
            self.note(self.process.stdout.readline())

    def note(self, line):
        """Returns the address on which the service listens."""
        port = re.fullmatch(r"placedpar monitor: listening on (\S+) port (\d+)\n", line)
        path = re.fullmatch(r"placedpar monitor: listening on (/\S+)\n", line)
        page = re.fullmatch(r"placedpar monitor: page at (http://\S+/)\n", line)
        if not (port or path or page):
            self.process.wait(SECONDS)
            raise AssertionError(f"{line!r}; {self.said()}")
        if port:
            self.address = port[1], int(port[2])
        elif page:
            self.page = page[1]
        else:
            self.path = path[1]

    def stop(self, number=signal.SIGTERM):
        """Returns the exit code and the text on standard error."""
        if self.process.poll() is None:
            self.process.send_signal(number)
        self.process.wait(SECONDS)
        return self.process.returncode, self.said()

    def said(self):
        """Returns the text on standard error so far."""
        if self.process.poll() is not None:
            self.reader.join(SECONDS)
        return "".join(self.log)

    def fill_disk(self, file_bytes):
        """Limits the length of all files that the service writes from now on, like a full disk."""
        resource.prlimit(self.process.pid, resource.RLIMIT_FSIZE, (file_bytes, resource.RLIM_INFINITY))

    def free_disk(self):
        self.fill_disk(resource.RLIM_INFINITY)

    def memory_kilobytes(self):
        """Returns the memory that the service occupies now."""
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text(encoding="ascii")
        return int(re.search(r"VmRSS:\s+(\d+) kB", status)[1])


class Client:
    """A connection to the service that carries one JSON object a line in each direction."""

    def __init__(self, service, machine=None, source="", path=None, **hello):
        if path:
            self.socket = socket.socket(socket.AF_UNIX)
            self.socket.settimeout(SECONDS)
            self.socket.connect(path)
        else:
            self.socket = socket.create_connection(service.address, SECONDS, (source, 0) if source else None)
        self.lines = self.socket.makefile("rb")
        if machine is not None:
            self.welcome = self.ask(type="hello", version=1, machine=machine, **hello)

    def send(self, **message):
        self.send_bytes(json.dumps(message).encode() + b"\n")

    def send_bytes(self, data):
        self.socket.sendall(data)

    def receive(self):
        """Returns the next message; None if the service has closed the connection."""
        line = self.lines.readline()
        return json.loads(line) if line.endswith(b"\n") else None

    def receive_type(self, wanted):
        """Returns the next message of this type, skipping others."""
        while True:
            message = self.receive()
            if message is None or message["type"] == wanted:
                return message

    def ask(self, **message):
        self.send(**message)
        return self.receive()

    def close(self):
        self.lines.close()
        self.socket.close()


# The excavator's constants that the service takes by default.
ORIFICE, PUMP, TANK = 99.83, 175.08, 16.2
PISTON_IN3_PER_DEG = 32 * 22.4 * 3.141592653589793 / 180
PERIOD_S = 0.020


def boom(index, start_s=0.0, compliance=0.0086):
    """Returns a sample of a boom of this compliance with rising pressure: 40 in^3/s flow in, the rest to the tank."""
    t = index * PERIOD_S
    psi = 1500 + 1800 * t - 300 * t * t
    piston_in3 = 40 * t - compliance * (psi - 1500)
    pump_psi = psi + (40 / (ORIFICE * 0.1)) ** 2
    bypass_in2 = (PUMP - 40) / (ORIFICE * (pump_psi - TANK) ** 0.5)
    return {"type": "sample", "time_s": round(start_s + t, 6),
            "links": {"BO": {"inlet_psi": psi, "angle_deg": piston_in3 / PISTON_IN3_PER_DEG, "inlet_in2": 0.1,
                             "bypass_in2": bypass_in2}}}


CONFIGURATION = {"type": "configuration", "configuration": "a", "active": ["BO"]}


def move_softly(client, start_s=0.0):
    """Sends three movements of a boom twice as soft as its kind; returns all messages until they are judged."""
    client.send(type="baseline", links={"BO": 0.0043})
    client.receive_type("status")
    for movement in range(3):
        for i in range(40):
            client.send(**boom(i, start_s=start_s + 10 * movement))
    client.send(type="ping")
    said = []
    while (message := client.receive())["type"] != "pong":
        said.append(message)
    return said


class ServiceTest(unittest.TestCase):
    """A test case with services, clients and its own folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def service(self, *arguments):
        service = Service(*arguments)
        self.addCleanup(service.process.stderr.close)
        self.addCleanup(service.reader.join)
        self.addCleanup(service.process.stdout.close)
        self.addCleanup(service.process.wait)
        self.addCleanup(service.process.kill)
        return service

    def client(self, service, machine=None, **hello):
        client = Client(service, machine, **hello)
        self.addCleanup(client.close)
        return client

    def refusal(self, *arguments):
        """Returns the messages of a service that refuses to start."""
        done = subprocess.run([PROGRAM, "monitor", *map(str, arguments)], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=SECONDS, check=False)
        self.assertEqual(done.returncode, 1, done.stdout)
        return done.stderr
