"""Starts the service under test, named by the environment variable PLACEDPAR, and sends jobs to it."""

import http.client
import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["PLACEDPAR"]
EXAMPLES = pathlib.Path(os.environ["PLACEDPAR_EXAMPLES"])
SECONDS = 60  # longest wait for anything that should be immediate


class Service:
    """A running `placedpar serve` at any free port. Its folder is empty at first."""

    def __init__(self, folder, *arguments):
        self.process = subprocess.Popen([PROGRAM, "serve", "--port", "0", *map(str, arguments)], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True, cwd=folder)
        found = re.fullmatch(r"placedpar serve: page at (http://(.*):(\d+)/)\n", self.process.stdout.readline())
        if not found:
            raise AssertionError(self.process.communicate(timeout=SECONDS)[1])
        self.page, self.host, self.port = found[1], found[2].strip("[]"), int(found[3])

    def stop(self):
        """Returns the exit code and the text on standard error."""
        self.process.send_signal(signal.SIGTERM)
        _, said = self.process.communicate(timeout=SECONDS)
        return self.process.returncode, said

    def ask(self, method, path, body=None, **headers):
        """Returns the status, the headers and the text of an answer."""
        connection = http.client.HTTPConnection(self.host, self.port, timeout=SECONDS)
        try:
            connection.request(method, path, body, {name.replace("_", "-"): value for name, value in headers.items()})
            answer = connection.getresponse()
            return answer.status, answer.headers, answer.read().decode()
        finally:
            connection.close()

    def post(self, job, name="job"):
        return self.ask("POST", f"/job?{name}", json.dumps(job), Content_Type="application/json")

    def answer(self, do, main, files=None, **more):
        """Returns the answer to a job. Without files, `main` is an example."""
        status, _, text = self.post({"do": do, "main": main, "files": files or {main: (EXAMPLES / main).read_text()}, **more})
        if status != 200:
            raise AssertionError(f"{status}: {text}")
        return json.loads(text)

    def children(self):
        """Returns the processes of the jobs."""
        return pathlib.Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text().split()

    def memory_megabytes(self):
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+) kB", status)[1]) / 1024


class ServiceTest(unittest.TestCase):
    OPTIONS = ()

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.service = self.serve(*self.OPTIONS)

    def serve(self, *options):
        service = Service(self.folder, *options)
        self.addCleanup(lambda: service.process.poll() is None and service.stop())
        return service
