"""Compares the answers of the program in WebAssembly with those of `placedpar serve --job`: every example, and each task."""

import base64
import json
import os
import pathlib
import re
import subprocess
import unittest
import zlib

PROGRAM = os.environ["PLACEDPAR"]
BUILD = pathlib.Path(os.environ["PLACEDPAR_WEBASSEMBLY"])  # the folder with job.js
EXAMPLES = pathlib.Path(os.environ["PLACEDPAR_EXAMPLES"])
SECONDS = 600


def native(job):
    return json.loads(subprocess.run([PROGRAM, "serve", "--job", "--seconds", "60"], input=json.dumps(job), text=True, stdout=subprocess.PIPE,
                                     timeout=SECONDS, check=True).stdout)


def in_webassembly(job):
    done = subprocess.run(["node", "--no-experimental-fetch", BUILD / "job.js"], input=json.dumps(job), text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, timeout=SECONDS, check=False)
    if not done.stdout:
        raise AssertionError(f"{job['main']}: {done.stderr[-2000:]}")
    return json.loads(done.stdout)


def unpacked(page):
    """Returns the page of a run with its data, which each program compresses in its own way."""
    return re.sub(r'"(e[AF][A-Za-z0-9+/]+={0,2})"', lambda found: zlib.decompress(base64.b64decode(found[1])).hex(), page)


def comparable(answer):
    return {**answer, "page": unpacked(answer["page"])} if "page" in answer else answer


class Answers(unittest.TestCase):
    maxDiff = 2000

    def compare(self, job):
        with self.subTest(main=job["main"], do=job["do"]):
            self.assertEqual(comparable(in_webassembly(job)), comparable(native(job)))


if __name__ == "__main__":
    unittest.main()
