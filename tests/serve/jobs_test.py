"""Tests what the service answers to jobs: as the command line, and nothing from a file outside of the job."""

import json
import os
import signal
import socket
import subprocess
import tempfile
import time
import unittest

from program import placedpar
from serving import EXAMPLES, PROGRAM, SECONDS, ServiceTest

RING = "csp/deadlock/ring.cfs"
COMMSTIME = "csp/commstime/commstime.cfs"
HELLO = "occam/hello/hello.occ"
COURSE = EXAMPLES.parent / "docs/occam-course"
FOREVER = """PROC forever (CHAN OF BYTE keyboard, screen, error)
  WHILE TRUE
    SKIP
:
"""
CHATTER = FOREVER.replace("SKIP", "screen ! 'x'")


class Jobs(ServiceTest):
    OPTIONS = ("--jobs", 1, "--seconds", 2)

    def test_a_check_names_the_place_of_an_error(self):
        text = (EXAMPLES / COMMSTIME).read_text().replace("place delta on b;", "place delta on bb;")
        [fault] = self.service.answer("check", "my.cfs", {"my.cfs": text})["faults"]
        line = text.splitlines()[fault["line"] - 1]
        self.assertEqual((fault["severity"], fault["file"], line[fault["column"] - 1:]), ("error", "my.cfs", "bb;"))
        self.assertIn('"bb"', fault["message"])
        [fault] = self.service.answer("check", "my.occ", {"my.occ": FOREVER.replace("TRUE", "TRU")})["faults"]
        self.assertEqual((fault["line"], fault["column"]), (2, 9))
        self.assertEqual(self.service.answer("check", COMMSTIME)["faults"], [])

    def test_a_run_is_that_of_the_command_line(self):
        for main in (COMMSTIME, RING, "occam/network/table.cfs"):
            answer, printed = self.service.answer("run", main), placedpar("run", main, folder=EXAMPLES)
            self.assertEqual(answer["output"] + answer["report"], printed.stdout, main)
            self.assertIn("</html>", answer["page"])
        answer = self.service.answer("run", RING)
        self.assertEqual(answer["ended"], "deadlock")
        self.assertRegex(answer["page"], r"buffer\[0\]")
        self.assertTrue(self.service.answer("run", HELLO)["output"].startswith("Hello from occam\n"))

    def test_the_seed_and_the_keys_are_those_of_the_job(self):
        main = "thesis/figure-e2/figure-e2.cfs"
        printed = placedpar("run", main, "--seed", 3, folder=EXAMPLES).stdout
        self.assertEqual(self.service.answer("run", main, seed=3)["report"], printed)
        echo = FOREVER.replace("WHILE TRUE\n    SKIP", "BYTE c:\n  SEQ\n    keyboard ? c\n    screen ! c")
        self.assertEqual(self.service.answer("run", "e.occ", {"e.occ": echo}, keys="q")["output"], "q")

    def test_explanation_and_listing_are_those_of_the_command_line(self):
        printed = placedpar("explain", COMMSTIME, folder=EXAMPLES).stdout
        self.assertEqual(self.service.answer("explain", COMMSTIME)["explanation"], printed)
        self.assertIn("What if", printed.replace("what if", "What if"))
        waits = "BYTE c:\n  INT n:\n  SEQ\n    keyboard ? c\n    n := 0\n    SEQ i = 0 FOR 20000\n      n := n + i\n    screen ! c"
        waits = FOREVER.replace("WHILE TRUE\n    SKIP", waits)
        explanation = self.serve().answer("explain", "e.occ", {"e.occ": waits}, keys="q")["explanation"]
        self.assertIn("what if", explanation)  # each changed run gets the key too, or it would never end
        printed = placedpar("run", HELLO, "--listing", folder=EXAMPLES).stdout
        self.assertIn(self.service.answer("listing", HELLO)["listing"].split("\n", 1)[1], printed)

    def test_exercises_are_checked(self):
        for folder, ended in (("answers", "solved"), ("exercises", "not solved")):
            answer = self.service.answer("exercise", "s.occ", {"s.occ": (COURSE / folder / "1-1.occ").read_text()}, exercise="1.1")
            self.assertEqual(answer["ended"], ended)
            self.assertTrue(answer["verdict"].startswith(ended), answer["verdict"])
        answer = self.service.answer("exercise", "s.occ", {"s.occ": FOREVER}, exercise="99")
        self.assertIn('there is no exercise "99"', answer["refused"])

    def test_files_are_those_of_the_job_and_the_examples(self):
        own = {"a/x.cfs": '#include "../b/y.inc"\nT800 (memory = 1M) t[n];\nconnect t[0].link[0] to t[1].link[1];', "b/y.inc": "val n 2;"}
        self.assertEqual(self.service.answer("check", "a/x.cfs", own)["faults"], [])
        including = (EXAMPLES / "machine/through-routing/farm.cfs").read_text()
        self.assertIn('#include "machine.inc"', including)
        self.assertEqual(self.service.answer("check", "machine/through-routing/my.cfs", {"machine/through-routing/my.cfs": including})["faults"], [])
        with tempfile.NamedTemporaryFile("w", suffix=".inc") as secret:
            secret.write("val password 42;")
            secret.flush()
            for main, text in (("x.cfs", f'#include "{secret.name}"\nval password 1;'), ("x.occ", f'#INCLUDE "{secret.name}"\n' + FOREVER)):
                [fault] = self.service.answer("check", main, {main: text})["faults"][:1]
                self.assertRegex(fault["message"], "this file does not exist|is missing")
            boots = f'T800 (memory = 1M) t;\nconnect t.link[0] to host;\nuse "{PROGRAM}" for t;'
            self.assertIn("this file does not exist", self.service.answer("run", "x.cfs", {"x.cfs": boots})["refused"])

    def test_a_run_that_takes_too_long_or_prints_too_much_is_ended(self):
        begun = time.monotonic()
        self.assertEqual(self.service.answer("run", "f.occ", {"f.occ": FOREVER})["ended"], "interrupted")
        self.assertLess(time.monotonic() - begun, 10)
        answer = self.service.answer("run", "c.occ", {"c.occ": CHATTER})
        self.assertEqual((answer["ended"], set(answer["output"])), ("interrupted", {"x"}))
        self.assertLessEqual(len(answer["output"]), 1 << 18)

    def test_a_run_that_needs_too_much_memory_is_ended(self):
        many = "T800 (memory = 1000M) t[8];\nconnect t[0].link[0] to host;\n" + \
            'process p[8];\nuse "big.occ" for p;\nrep i = 0 for 8 { place p[i] on t[i]; }'
        big = "PROC big ()\n  [200000000]INT a:\n  SEQ i = 0 FOR SIZE a\n    a[i] := i\n:\n"
        service = self.serve("--seconds", 30, "--memory", 256)
        answer = service.answer("run", "m.cfs", {"m.cfs": many, "big.occ": big})
        self.assertIn(answer["ended"], ("refused", "killed"))
        self.assertIn("memory", answer["refused"])
        self.assertEqual(service.answer("run", COMMSTIME)["ended"], "completed")

    def test_a_run_that_crashes_is_reported_and_harms_no_other(self):
        service = self.serve("--seconds", 60)
        page = self.begin("page", service)
        self.wait_until(service.children)
        [process] = service.children()
        os.kill(int(process), signal.SIGSEGV)
        answer = page.makefile("rb").read(1 << 16)
        self.assertIn(b'"ended":"failed"', answer)
        self.assertIn(b"the run has crashed: either it needed more memory", answer)
        self.assertEqual(service.answer("run", COMMSTIME)["ended"], "completed")

    def test_at_most_a_hundred_jobs_of_one_address_wait(self):
        service = self.serve("--jobs", 1, "--seconds", 60)
        pages = [self.begin("first", service)]
        self.wait_until(service.children)
        pages += [self.begin(f"job{number}", service) for number in range(100)]
        self.wait_until(lambda: self.place_of("job99", service) == 100)
        status, _, said = service.post({"do": "run", "main": "f.occ", "files": {"f.occ": FOREVER}})
        self.assertEqual((status, said), (503, "too many jobs are waiting: try again later\n"))
        pages.pop().close()
        self.wait_until(lambda: self.place_of("job99", service) is None)
        pages.append(self.begin("later", service))
        self.wait_until(lambda: self.place_of("later", service) == 100)

    def begin(self, name, service=None):
        """Begins a run that lasts until it is interrupted; returns the connection."""
        service = service or self.service
        body = json.dumps({"do": "run", "main": "f.occ", "files": {"f.occ": FOREVER}}).encode()
        connection = self.enterContext(socket.create_connection((service.host, service.port), SECONDS))
        connection.sendall(f"POST /job?{name} HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
                           f"Content-Length: {len(body)}\r\n\r\n".encode() + body)
        return connection

    def place_of(self, name, service=None):
        return json.loads((service or self.service).ask("GET", f"/place?{name}")[2]).get("place")

    def wait_until(self, holds):
        end = time.monotonic() + SECONDS
        while not holds():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def test_jobs_wait_in_a_queue_and_end_when_the_page_goes(self):
        first = self.begin("first")
        self.wait_until(lambda: self.place_of("first") == 0)
        second, third = self.begin("second"), self.begin("third")
        self.wait_until(lambda: (self.place_of("second"), self.place_of("third")) == (1, 2))
        [process] = self.service.children()
        second.close()
        self.wait_until(lambda: self.place_of("third") == 1)
        self.assertIsNone(self.place_of("second"))
        first.close()
        self.wait_until(lambda: self.place_of("third") == 0)
        self.assertNotIn(process, self.service.children())
        third.close()
        self.wait_until(lambda: not self.service.children())

    def test_a_page_that_has_sent_more_bytes_still_ends_its_job(self):
        page = self.begin("page")
        self.wait_until(lambda: self.place_of("page") == 0)
        page.sendall(b"x")
        page.close()
        begun = time.monotonic()
        self.wait_until(lambda: not self.service.children())
        self.assertLess(time.monotonic() - begun, 1)  # the run itself takes 2 s

    def test_output_that_ends_within_a_character_becomes_a_text(self):
        prints = FOREVER.replace("SKIP", "SEQ\n      screen ! BYTE 226\n      screen ! BYTE 130\n      screen ! BYTE 172")
        answer = self.serve("--seconds", 30).answer("run", "p.occ", {"p.occ": prints})
        self.assertEqual((answer["ended"], answer["output"][:-1]), ("interrupted", "€" * ((1 << 18) // 3)))

    def test_only_what_is_to_be_kept_is_written(self):
        self.service.answer("run", RING)
        self.assertEqual(list(self.folder.iterdir()), [])
        service = self.serve("--keep", self.folder)
        service.answer("check", RING)
        service.answer("run", RING, seed=7)
        [kept] = self.folder.iterdir()
        stored = json.loads(kept.read_text())
        self.assertEqual((stored["job"]["seed"], stored["answer"]["ended"]), (7, "deadlock"))
        self.assertEqual(stored["job"]["files"], {RING: (EXAMPLES / RING).read_text()})

    def test_what_is_refused_at_the_start(self):
        for options, message in ((("--address", "0.0.0.0"), "add --token-file FILE"), (("--keep", "nowhere"), "this folder does not exist"),
                                 (("--seconds", 0), "--seconds")):
            run = subprocess.run([PROGRAM, "serve", *map(str, options)], capture_output=True, text=True, timeout=SECONDS, check=False)
            self.assertEqual(run.returncode, 1)
            self.assertIn(message, run.stderr)


if __name__ == "__main__":
    unittest.main()
