"""Tests placedpar assemble: what it writes boots, short or long, and a fault is shown with its place."""

import os
import pathlib
import re
import tempfile
import unittest

from program import EXAMPLES, placedpar

HELLO = EXAMPLES / "transputer" / "hello" / "hello.tas"


class Assemble(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.source, self.out = self.folder / "x.tas", self.folder / "x.btl"

    def assemble(self, text, *options):
        self.source.write_text(text, encoding="utf-8")
        return placedpar("assemble", self.source, "-o", self.out, *options)

    def printed_by_the_program(self, *options):
        done = placedpar("run", self.out, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_short_program_is_one_boot_packet(self):
        done = self.assemble("ldc 1; ldc -1\n")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, f"{self.out}: 3 bytes for address #80000070, in one boot packet\n")
        self.assertEqual(self.out.read_bytes(), b"\x03\x41\x60\x4f")
        self.assertIn("#80000048", self.assemble("rev; rev", "--processor", "T414").stdout)

    def test_a_packet_of_one_byte_would_be_a_peek(self):
        self.assemble("stopp; stopp; stopp")
        self.assertEqual(self.assemble("rev").returncode, 0)
        self.assertEqual(self.out.read_bytes(), b"\x02\xf0\x00")

    def test_programs_of_every_length_around_a_packet_run_on_every_type(self):
        hello = HELLO.read_text(encoding="utf-8")
        for processor in ("T414", "T425", "T400", "T800", "T805"):
            for more in (177, 178, 179, 180, 181, 182, 183, 184, 400, 3000):
                with self.subTest(processor=processor, more=more):
                    filler = "\n".join([".byte 255"] * more)
                    self.assertEqual(self.assemble(f"{hello}\n{filler}\n", "--processor", processor).returncode, 0)
                    self.assertIn("Hello from a transputer!!\n", self.printed_by_the_program("--processor", processor))
                    program = 75 + more
                    loader = self.out.stat().st_size - program
                    self.assertEqual(loader == 1, program <= 255)

    def test_a_program_begins_alike_with_and_without_the_loader(self):
        # The program exits with 7, plus the distance from its end to Wptr, plus 1000 times the distance from link 0's
        # input channel to C.
        for more in (0, 300):
            done = self.assemble(f"""
                ajw 8; stl 1; stl 1; stl 1
                ldl 1; mint; ldnlp 4; diff; ldc 1000; prod
                ldlp -8; ldpi end; diff; sum; adc 7
                ldpi status; stnl 0
                ldpi request; ldl 1; ldnlp -4; ldc 8; out; stopp
                .align; .byte 0
                request: .half 6; .byte 35
                status: .word 0; .byte 0
                {".word 0;" * more}
                .align
                end:""")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("loader" in done.stdout, more > 0)
            self.assertIn("exited with status 7\n", placedpar("run", self.out).stdout)

    def test_the_listing_has_every_byte_of_the_program(self):
        listed = self.assemble(HELLO.read_text(encoding="utf-8"), "--listing").stdout
        found = re.findall(r"^(8[0-9A-F]{7})  ((?:[0-9A-F]{2} ?){1,8})", listed, re.MULTILINE)
        self.assertEqual(b"".join(bytes.fromhex(part) for _, part in found), self.out.read_bytes()[1:])
        self.assertEqual(found[0], ("80000070", "B8 "))

    def test_a_fault_is_shown_with_its_place_and_nothing_is_written(self):
        done = self.assemble("start: ldc 1\n       dup; frob 3 -- comment\n")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr, f"{self.source}:2:13: error: the instruction \"frob\" does not exist\n"
                                      "           dup; frob 3 -- comment\n                ^\n")
        done = self.assemble("dup", "--processor", "T414")
        self.assertIn(':1:1: error: the T414 has no instruction "dup"', done.stderr)
        self.assertIn("the program has no instruction", self.assemble("-- nothing").stderr)
        self.assertFalse(self.out.exists())

    def test_files_that_are_no_text_or_the_output_are_refused(self):
        self.source.write_bytes(b"ldc 1\0")
        done = placedpar("assemble", self.source, "-o", self.out)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        for source, out, reason in ((self.source, self.source, "the output file is also the input"),
                                    (HELLO, self.folder / "none" / "x.btl", "none"),
                                    (self.folder, self.out, "directory"), (self.folder / "none.tas", self.out, "does not exist")):
            done = placedpar("assemble", source, "-o", out)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertIn(reason, done.stderr)
        self.assertEqual(os.listdir(self.folder), ["x.tas"])


if __name__ == "__main__":
    unittest.main()
