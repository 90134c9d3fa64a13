"""Tests the page without a server in both browsers, as tests/serve/browsers_test.py tests the page of the service."""

import functools
import http.server
import os
import pathlib
import threading
import types
import unittest

import browsers_test

PAGE = pathlib.Path(os.environ["PLACEDPAR_WEBASSEMBLY"]) / "page"


class Files(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class WithoutServer(browsers_test.InBrowsers):
    def setUp(self):
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Files, directory=PAGE))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        self.service = types.SimpleNamespace(page=f"http://127.0.0.1:{server.server_port}/")

    def wait_for_no_job(self):
        """Does nothing: a job that is stopped ends with its worker, which the page cannot see."""


if __name__ == "__main__":
    unittest.main()
