"""Compares the answers of the program in WebAssembly with those of `placedpar serve --job`, for every example and task."""

import base64
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ["PLACEDPAR"]
BUILD = pathlib.Path(os.environ["PLACEDPAR_WEBASSEMBLY"])  # the folder with job.js
EXAMPLES = json.loads((BUILD / "page/examples").read_text())
SECONDS = 600
WRONG = {"a.occ": "PROC main (CHAN OF BYTE keyboard, screen, error)\n  screen ! 'a\n:\n", "b.cfs": "T800 (memory = 1M) a;\nplace p on a;\n"}


def native(job):
    return json.loads(subprocess.run([PROGRAM, "serve", "--job", "--seconds", "60"], input=json.dumps(job), text=True, stdout=subprocess.PIPE,
                                     timeout=SECONDS, check=True).stdout)


def in_webassembly(job):
    with tempfile.TemporaryFile("w+") as answer:  # Node.js may end before all of its output has gone through a pipe
        done = subprocess.run(["node", "--no-experimental-fetch", BUILD / "job.js"], input=json.dumps(job), text=True, stdout=answer,
                              stderr=subprocess.PIPE, timeout=SECONDS, check=False)
        answer.seek(0)
        text = answer.read()
    if not text:
        raise AssertionError(f"{job['main']}: {done.stderr[-2000:]}")
    return json.loads(text)


def unpacked(page):
    """Returns the page of a run with its data, which each program compresses in its own way.

    Real numbers keep 12 digits: the sines and logarithms of both programs' libraries differ in the last bit.
    """
    whole = re.sub(r'(?<=[">])e[AF][A-Za-z0-9+/]+={0,2}(?=["<])', lambda found: zlib.decompress(base64.b64decode(found[0])).hex(), page)
    return re.sub(r"-?\d\.\d+E-?\d+", lambda found: f"{float(found[0]):.12g}", whole)


def comparable(answer):
    return {**answer, "page": unpacked(answer["page"])} if "page" in answer else answer


class Answers(unittest.TestCase):
    maxDiff = 2000

    def compare(self, do, main, files=None, **more):
        job = {"do": do, "main": main, "files": files or EXAMPLES, **more}
        with self.subTest(main=main, do=do):
            answer = in_webassembly(job)
            self.assertEqual(comparable(answer), comparable(native(job)))
            return answer

    def test_every_example_runs_alike(self):
        for main in EXAMPLES:
            if not main.endswith(".inc"):
                self.compare("run", main, seed=2)

    def test_every_task(self):
        for main in ("occam/sieve/sieve.occ", "occam/network/table.cfs", "csp/commstime/commstime.cfs", "occam/sixteen/sixteen.pgm"):
            for do in ("check", "explain", "listing"):
                self.compare(do, main)
        for main in WRONG:
            self.assertTrue(self.compare("check", main, WRONG)["faults"])
            self.assertEqual(self.compare("run", main, WRONG)["ended"], "refused")
        hello = {"a.occ": EXAMPLES["occam/hello/hello.occ"]}
        self.assertEqual(self.compare("exercise", "a.occ", hello, exercise="1.1")["ended"], "not solved")


if __name__ == "__main__":
    unittest.main()
