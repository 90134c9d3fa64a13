"""Tests what the program does with booted transputers: listings, steps, faults, and real boards."""

import pathlib
import socket
import subprocess
import tempfile
import threading
import unittest

from program import EXAMPLES, PROGRAM, placedpar

HELLO = EXAMPLES / "transputer" / "hello" / "hello.tas"
SUCCESS = bytes([6, 0, 35]) + (999_999_999).to_bytes(4, "little") + bytes(1)  # the request `exit`


class Booted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "hello.btl"
        self.assertEqual(placedpar("assemble", HELLO, "-o", self.file).returncode, 0)

    def test_a_listing_counts_what_the_report_counts(self):
        done = placedpar("run", self.file, "--listing")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"root +32 +2  exited with success")
        self.assertIn("\n31 instructions of a T800, ", done.stdout)  # the last `in` has not ended
        self.assertRegex(done.stdout, r"#80000070 .* ajw .* 1 ")

    def test_a_stepped_run_ends_as_an_unwatched_one(self):
        stepped = subprocess.run([PROGRAM, "run", self.file, "--step"], input="s 2\nr\nc\n", capture_output=True, text=True,
                                 timeout=60, check=False)
        self.assertEqual(stepped.returncode, 0, stepped.stderr)
        self.assertIn("Iptr #", stepped.stdout)
        self.assertIn("\nHello from a transputer!!\n", stepped.stdout)
        self.assertIn(placedpar("run", self.file).stdout.split("Hello from a transputer!!\n")[1], stepped.stdout)

    def test_a_fault_halts_a_transputer_that_runs_its_own_code(self):
        netlist = self.folder / "net.cfs"
        netlist.write_text('T800 (memory = 2M) root; connect root.link[0] to host; use "hello.btl" for root;\n',
                           encoding="utf-8")
        done = placedpar("run", netlist, "--fault", "root halts (from = 50us)")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("stopped the code of root", done.stdout)
        self.assertIn("halted by a fault", done.stdout)

    def test_a_board_is_booted_and_served(self):
        got = bytearray()
        wanted = self.file.stat().st_size
        with socket.create_server(("127.0.0.1", 0)) as server:
            def board():
                link, _ = server.accept()
                with link:
                    while len(got) < wanted:
                        got.extend(link.recv(wanted - len(got)))
                    link.sendall(SUCCESS)
                    link.recv(100)
            thread = threading.Thread(target=board)
            thread.start()
            done = placedpar("send", self.file, "--to", f"tcp:127.0.0.1:{server.getsockname()[1]}", "--keys", "")
            thread.join(30)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(bytes(got), self.file.read_bytes())
        self.assertIn("the program exited with success\n", done.stdout)
        self.assertIn(f"{wanted} bytes", done.stdout)


if __name__ == "__main__":
    unittest.main()
