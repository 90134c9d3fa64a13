"""Tests placedpar disassemble: a loader, packets, positions, and files that are refused."""

import os
import tempfile
import unittest

from program import EXAMPLES, placedpar

LOADER = bytes([0x24, 0xF2, 0x60, 0x0C]) # mint; j to the first byte
PACKETS = (bytes([0x71] * 60), bytes([0x72] * 60), bytes([0x22, 0xF0]))
FILE = b"".join(bytes([len(each)]) + each for each in (LOADER, *PACKETS)) + b"\0"


class Disassemble(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory() # pylint: disable=consider-using-with
        self.addCleanup(self.folder.cleanup)

    def disassembled(self, content, *options):
        path = os.path.join(self.folder.name, "code.btl")
        with open(path, "wb") as file:
            file.write(content)
        return placedpar("disassemble", "code.btl", *options, folder=self.folder.name)

    def test_the_loader_has_addresses_and_the_rest_positions(self):
        run = self.disassembled(FILE)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        head, about, text = run.stdout.split("\n", 2)
        self.assertEqual(head, "code.btl: 131 bytes, disassembled for a T800")
        self.assertTrue(about.startswith("+: position in the file. ?: these bytes may be data, because no path"))
        self.assertTrue(text.startswith("\nloader: bytes +00001 to +00004\n"
                                        "  #80000070  24 F2               mint                    6\n"
                                        "  #80000072  60 0C               j       #80000070\n"
                                        "\npackets: bytes +00006 to +00081, in packets of 60\n"), text)
        self.assertIn("\n  +00080     22 F0             ? ret\n", text)

    def test_the_processor_decides_where_memory_begins_and_what_is_an_instruction(self):
        dup = bytes([3, 0x25, 0xFA, 0x02]) # dup; j
        self.assertIn("  #80000070  25 FA               dup ", self.disassembled(dup).stdout)
        self.assertIn("  #80000048  25 FA                    %.\n", self.disassembled(dup, "--processor", "T414").stdout)

    def test_a_part_is_shown_from_a_position_as_printed_or_in_decimal(self):
        for words in (["--from", "+00080"], ["--from=128", "--until", "+82"], ["--from", "128"]):
            lines = self.disassembled(FILE, *words).stdout.splitlines()
            self.assertEqual(lines[4], "  +00080     22 F0             ? ret", words)

    def test_wrong_positions_and_files_are_refused(self):
        for words, message in ((["--from", "x"], "--from: \"x\" is not a position: write 1135, or +0046F as in the output"),
                               (["--until", "-3"], "\"-3\" is not a position"),
                               (["--from", "131"], "code.btl: the range from position 131 to 131, end excluded, has no byte: the file has 131 "
                                                   "bytes"),
                               (["--processor", "T212"], "T212 not in {T414,T425,T400,T800,T805}")):
            run = self.disassembled(FILE, *words)
            self.assertEqual((run.returncode, run.stdout), (1, ""))
            self.assertIn(message, run.stderr)
        run = placedpar("disassemble", EXAMPLES / "thesis/table-e1/cluster.cfs")
        self.assertEqual(run.returncode, 1)
        self.assertIn("this is text, not code for a transputer", run.stderr)

    def test_any_content_is_disassembled(self):
        for content in (b"\0", b"\1\2\3", bytes(range(256)) * 9, b"\xff" * 70000, bytes(200000) + b"\1", b"\x20" * 5000 + b"\xf5"):
            run = self.disassembled(content, "--until", "300000")
            self.assertIn((run.returncode, run.stderr != ""), ((0, False), (1, True)))
            self.assertTrue(run.returncode == 0 or "cut off" in run.stderr or "this is text" in run.stderr, run.stderr)


if __name__ == "__main__":
    unittest.main()
