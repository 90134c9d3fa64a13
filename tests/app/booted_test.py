"""Tests what the program does with booted transputers: listings, faults, and real boards."""

import pathlib
import re
import signal
import socket
import subprocess
import tempfile
import threading
import unittest

from program import EXAMPLES, PROGRAM, placedpar

HELLO = EXAMPLES / "transputer" / "hello" / "hello.tas"
NOTE = HELLO.with_name("note.tas")
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
        self.assertIn("\n32 instructions of a T800, ", done.stdout)  # with the last `in`, which has not ended
        self.assertRegex(done.stdout, r"#80000070 .* ajw .* 1 ")

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

    def offered(self, where, file, *options):
        """Returns a run that offers its link, and the name of the board."""
        run = subprocess.Popen([PROGRAM, "run", file, "--offer", where, *options], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.stdout.close)
        self.addCleanup(run.stderr.close)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        return run, re.fullmatch(r"placedpar: the host's link is offered at (\S+)\n", run.stderr.readline()).group(1)

    def test_an_emulated_board_is_booted_and_served_by_a_socket_and_a_pseudo_terminal(self):
        note = self.folder / "note.btl"
        self.assertEqual(placedpar("assemble", NOTE, "-o", note).returncode, 0)
        alone = placedpar("run", note, "--host-folder", self.folder, "--keys", "!", "--", "Hello")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        expected = (self.folder / "note.txt").read_bytes()
        for where in ("tcp:0", "tcp:127.0.0.1:0", "pty"):
            with self.subTest(where=where):
                (self.folder / "note.txt").unlink()
                run, board = self.offered(where, note)
                self.assertTrue(board.startswith("/dev/" if where == "pty" else "tcp:127.0.0.1:"))
                done = placedpar("send", note, "--to", board, "--host-folder", self.folder, "--keys", "!", "--", "Hello")
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual((self.folder / "note.txt").read_bytes(), expected)
                lines = done.stdout.splitlines()
                self.assertEqual(lines[0], f"{note} on {board}: the program exited with success")
                self.assertRegex(lines[1], r"^ +measured +simulated$")
                boot, ran = (re.fullmatch(r"(?:boot|run) +([0-9.]+) s +([0-9.]+) s   .*", line).groups() for line in lines[2:4])
                self.assertIn("5 requests", lines[3])
                self.assertNotIn("departs", done.stdout)
                # The simulated times are those of a run without a board.
                whole = float(re.search(r"completed at ([0-9.]+) us", alone.stdout).group(1)) * 1e-6
                self.assertAlmostEqual(float(boot[1]) + float(ran[1]), whole, delta=2e-6)
                out, errors = run.communicate(timeout=60)
                self.assertEqual((run.returncode, errors), (0, ""), out)
                counts = [int(re.search(r"root +(\d+)", text).group(1)) for text in (alone.stdout, out)]
                self.assertIn(counts[1] - counts[0], range(10))  # the board goes on until the other program leaves
                self.assertRegex(out, r"root +\d+ +0  was served by another program")

    def test_a_simulated_run_that_departs_from_the_board_is_reported(self):
        run, board = self.offered("tcp:0", self.file)
        with socket.create_server(("127.0.0.1", 0)) as server:
            def changed_board():  # passes bytes on, and changes a letter of the program's text
                host, _ = server.accept()
                with host, socket.create_connection(("127.0.0.1", int(board.rsplit(":", 1)[1]))) as machine:
                    machine.sendall(host.recv(1000))
                    for _ in range(2):
                        request = machine.recv(1000)
                        host.sendall(request.replace(b"Hello", b"Hallo"))
                        machine.sendall(host.recv(1000))
            thread = threading.Thread(target=changed_board)
            thread.start()
            done = placedpar("send", self.file, "--to", f"tcp:127.0.0.1:{server.getsockname()[1]}", "--keys", "")
            thread.join(30)
        self.assertIn("Hallo from", done.stdout)
        self.assertIn("the simulated program differs: request 1 differs from the board's request\n", done.stdout)
        run.wait(60)

    def test_an_offer_ends_when_the_other_program_leaves_or_the_user_interrupts(self):
        run, board = self.offered("tcp:0", self.file)
        socket.create_connection(("127.0.0.1", int(board.rsplit(":", 1)[1]))).close()
        out, _ = run.communicate(timeout=60)
        self.assertEqual(run.returncode, 0)
        self.assertRegex(out, r"\nroot +0 +0  was never booted\n")
        run, _ = self.offered("tcp:0", self.file)
        run.send_signal(signal.SIGINT)
        self.assertEqual(run.wait(60), 130)

    def test_an_offer_that_cannot_be_made_is_refused(self):
        def refusal(*arguments):
            done = placedpar("run", *arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            return done.stderr
        self.assertEqual(refusal(self.file, "--offer", "5000"),
                         'placedpar: 5000: a link is offered at "pty", "tcp:PORT" or "tcp:ADDRESS:PORT"\n')
        self.assertIn("tcp:192.0.2.1:0: Cannot assign requested address", refusal(self.file, "--offer", "tcp:192.0.2.1:0"))
        self.assertIn("so it has no link to a host", refusal(EXAMPLES / "csp/commstime/commstime.cfs", "--offer", "pty"))
        self.assertIn("--offer: another program can be the host of one run only, but --seeds asks for 3 runs",
                      refusal(self.file, "--offer", "pty", "--seeds", "3"))

    def netlist(self, text):
        path = self.folder / "net.cfs"
        path.write_text(text, encoding="utf-8")
        return path

    def test_a_program_reads_the_size_of_its_memory(self):
        source = f"""{BEGIN}
            ldpi getenv; ldc 16; call ask
            ldlp reply + 1; adc 2; ldpi text; ldc 8; move
            ldpi write; ldc 18; call ask
            ldc 0; ldpi status; sb
            ldpi exit; ldc 8; call ask; stopp
    {{ASK}}
    getenv: .half 14
            .byte 32
            .half 10
            .byte "IBOARDSIZE", 0
    write:  .half 16
            .byte 15
            .word 1
            .half 8
    text:   .byte "        ", 0
    """
        (self.folder / "x.tas").write_text(source.replace("{ASK}", ASK), encoding="utf-8")
        self.assertEqual(placedpar("assemble", self.folder / "x.tas", "-o", self.folder / "x.btl").returncode, 0)
        self.assertTrue(placedpar("run", self.folder / "x.btl", "--memory", "4M").stdout.startswith("#400000"))
        done = placedpar("run", self.folder / "x.btl", "--memory", "4M", "--env", "IBOARDSIZE=#100000")
        self.assertTrue(done.stdout.startswith("#100000"))

    def test_the_reply_to_exit_reaches_a_program_while_others_run(self):
        programs = {"a": """
            ajw 8; stl 1; stl 1; stl 1; ldl 1; ldnlp -4; stl 2
            ldpi exit; ldl 2; ldc 8; out
            ldc 255; stl 3; ldc 255; stl 4; ldlp 3; ldl 1; ldc 8; in
            ldlp 3; adc 2; lb; ldlp 3; lb; adc 7; add; mint; ldnlp 2; rev; outbyte; stopp    -- the result, the length, 7
    exit:   .byte 6, 0, 35; .word 999999999; .byte 0
            """, "b": """
            ajw 8; stl 1; stl 1; stl 1; ldl 1; ldnlp -4; stl 2
            ldpi status; mint; ldnlp 6; ldc 1; in
            ldpi exit; ldl 2; ldc 8; out; stopp
    exit:   .byte 6, 0, 35
    status: .byte 0, 0, 0, 0, 0
            """}
        for name, source in programs.items():
            (self.folder / "x.tas").write_text(source, encoding="utf-8")
            done = placedpar("assemble", self.folder / "x.tas", "-o", self.folder / f"{name}.btl")
            self.assertEqual(done.returncode, 0, done.stderr)
        done = placedpar("run", self.netlist("""
            edge host2; T800 (memory = 1M) a, b;
            connect a.link[0] to host; connect b.link[0] to host2; connect a.link[2] to b.link[2];
            use "a.btl" for a; use "b.btl" for b;
            """))
        self.assertRegex(done.stdout, r"\na .* exited with success\nb .* exited with status 13\n")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_worker_boots_through_a_switch_that_another_program_sets(self):
        """The visitor leads link 0 of the switch to link 1 for as long as its messages to the echo take."""
        source = """
            ajw 8; stl 1; stl 1; stl 1; ldl 1; ldnlp -4; stl 2
            ldc 0; sttimer; ldtimer; adc 4; tin
            ldpi worker; mint; ldnlp 2; ldc end - worker; out
            ldc 0; stl 4; ldlp 4; mint; ldnlp 6; ldc 1; in
            ldl 4; ldpi status; sb
            ldpi exit; ldl 2; ldc 8; out; stopp
    exit:   .half 6
            .byte 35
    status: .word 0
            .byte 0
    worker: .byte end - code
    code:   .byte #B8, #24, #F2, #22, #4A, #FE, #21, #F5    -- ajw 8; mint; ldc 42; outbyte; stopp
    end:
    """
        netlist = self.netlist("""
            T800 (memory = 1M) root, worker, a;
            C004 sw;
            connect root.link[0] to host;
            connect a.link[3] to sw.config;
            connect root.link[2] to sw.link[0];
            connect worker.link[0] to sw.link[1];
            connect sw.link[0] to sw.link[1];
            use "x.btl" for root;
            process (interface (input commands, output answers)) logic;
            process (interface (output commands, input answers, output out[1], input in[1])) visitor;
            process (interface (input in, output out)) echo;
            use "csp.switch_logic" for logic; use "csp.switching_producer" for visitor; use "csp.identity" for echo;
            visitor (count = 1, bytes = 10000); echo (count = 1);
            connect visitor.commands to logic.commands;
            connect logic.answers to visitor.answers;
            connect visitor.out[0] to echo.in; connect echo.out to visitor.in[0];
            place visitor on a; place echo on a; place logic on sw;
            """)
        for waits, expected in (("adc 4", "exited with status 42"), ("adc 400", "waits")):
            with self.subTest(waits=waits):
                (self.folder / "x.tas").write_text(source.replace("adc 4;", waits + ";"), encoding="utf-8")
                self.assertEqual(placedpar("assemble", self.folder / "x.tas", "-o", self.folder / "x.btl").returncode, 0)
                done = placedpar("run", netlist)
                self.assertRegex(done.stdout, rf"\nroot .* {expected}\n")
                self.assertEqual("root.link[2] -> worker.link[0]: lost 1 byte" in done.stdout, expected == "waits")
                self.assertEqual(done.returncode, 2 if expected == "waits" else 0)

    def test_a_transputer_beside_a_bus_boots_and_a_bus_master_does_not(self):
        text = """
            VME vme;
            BBKV2 m[2];
            T800 (memory = 1M) root;
            rep i = 0 for 2 { connect m[i].bus[0] to vme.slot[i + 1]; }
            connect root.link[0] to host;
            connect root.link[1] to m[0].link[0];
            process (interface (output out)) source;
            process (interface (input in)) sink;
            use "csp.producer" for source; use "csp.consumer" for sink;
            source (count = 5, bytes = 8); sink (count = 5);
            connect source.out to sink.in;
            place source on m[0]; place sink on m[1];
            use "hello.btl" for root;
            """
        done = placedpar("run", self.netlist(text))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\nroot +\d+ +2  exited with success\n")
        self.assertIn("\nbus vme, busy ", done.stdout)
        done = placedpar("run", self.netlist(text.replace('use "hello.btl" for root', 'use "hello.btl" for m[0]')))
        self.assertEqual(done.returncode, 1)
        self.assertIn('"m[0]" is a bus master: only a processor can be booted', done.stderr)

    def test_studies_vary_booted_transputers(self):
        netlist = self.netlist('T800 (memory = 2M) root; connect root.link[0] to host; use "hello.btl" for root;\n')
        settings = ["root.clock=20M,30M", "root.linkspeed=10M,20M", "root.memorycycles=3,9"]
        self.assertEqual(placedpar("sweep", netlist, *settings, "--results", self.folder / "s.sqlite").returncode, 0)
        rows = placedpar("report", self.folder / "s.sqlite", "--csv", "-").stdout
        times = {}
        for clock in ("20M", "30M"):
            for speed in ("10M", "20M"):
                for cycles in ("3", "9"):
                    run = placedpar("run", netlist, "--set", f"root.clock={clock}", "--set", f"root.linkspeed={speed}",
                                    "--set", f"root.memorycycles={cycles}")
                    times[clock, speed, cycles] = float(re.search(r"completed at ([0-9.]+) us", run.stdout).group(1)) / 1000
                    row = next(row for row in rows.splitlines() if row.startswith(f"{clock},{speed},{cycles},"))
                    self.assertIn(f"{times[clock, speed, cycles]:.5g}"[:6], row)
        self.assertLess(times["20M", "20M", "3"], times["20M", "10M", "3"])
        self.assertLess(times["30M", "20M", "3"], times["20M", "20M", "3"])
        self.assertLess(times["20M", "20M", "3"], times["20M", "20M", "9"])
        study = self.folder / "search.toml"
        study.write_text("""netlist = "net.cfs"
[search]
minimise = "time"
population = 8
generations = 3
[set]
"root.clock" = ["20M", "25M", "30M"]
"root.linkspeed" = ["5M", "10M", "20M"]
"root.memorycycles" = [3, 6, 9]
""", encoding="utf-8")
        done = placedpar("optimise", study, folder=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\nthe best: placedpar run \S*net.cfs --set root.clock=30M --set root.linkspeed=20M ")

    def test_wrong_options_of_booted_programs_are_refused_with_what_would_be_right(self):
        size = ": a processor that executes code needs 2K to just below 4096M of memory, in steps of 256 bytes\n"
        for options, message in (
                (["--env", "FOO"], "placedpar: --env FOO: expected NAME=VALUE, such as --env ISEARCH=libs/\n"),
                (["--env", "A=1", "--env", "A=2"], "placedpar: --env A=2: A is set twice\n"),
                (["--memory", "4096M"], "--memory: 4096M" + size), (["--memory", "1K"], "--memory: 1K" + size),
                (["--memory", "2100"], "--memory: 2100" + size),
                (["--memory", "9" * 30 + "M"], f'--memory: "{"9" * 30}M" is not a size such as 32K or 2M\n'),
                (["--memory", "17592186044416M"], "--memory: 17592186044416M" + size),
                (["--memory", "4G"], '--memory: "4G" is not a size such as 32K or 2M\n'),
                (["--memorycycles", "1001"], "--memorycycles: 1001: expected 1 to 1000 cycles\n"),
                (["--keys", "a\\q"], "placedpar: --keys: \\ must be followed by r (the return key), n, t, e (the escape key) or \\\n"),
                (["--host-folder", "none"], 'placedpar: cannot use "none" as the host\'s folder: No such file or directory\n'),
                (["--", "x" * 508], "placedpar: the program's command line has 508 bytes; a reply of the host's server can hold at most 507\n")):
            with self.subTest(options=options):
                done = placedpar("run", self.file, *options)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertTrue(done.stderr.startswith(message), done.stderr)
        for limit in ("99999999999999", "18446744073709551615"):
            self.assertEqual(placedpar("run", self.file, "--host-limit", limit).returncode, 0)

    def test_files_of_the_wrong_kind_are_refused_with_what_they_are(self):
        empty, folder = self.folder / "empty.btl", self.folder / "folder"
        empty.write_bytes(b"")
        folder.mkdir()
        for file, why in ((empty, "placedpar: {}: the file is empty\n"), (PROGRAM, "placedpar: {}: this is a program for the host"),
                          (folder, "{}: error: this is a directory, not a file\n"),
                          (HELLO, "{}: error: this is a program in transputer instructions, not a netlist: placedpar assemble")):
            for command in ("run", "send", "disassemble"):
                with self.subTest(file=file, command=command):
                    done = placedpar(command, file, *(["--to", "tcp:127.0.0.1:1"] if command == "send" else []))
                    self.assertEqual((done.returncode, done.stdout), (1, ""))
                    expected = why if command == "run" else why.replace("{}: error", "placedpar: {}")
                    if file != HELLO or command == "run":
                        self.assertTrue(done.stderr.startswith(expected.format(file)), done.stderr)
        for command in (["check"], ["show"], ["explain"], ["sweep", "root.clock=20M,30M"]):
            done = placedpar(command[0], self.file, *command[1:])
            self.assertEqual(done.returncode, 1)
            self.assertIn('hint: this file boots a transputer: placedpar run executes it; in a netlist, write use "FILE" for root;',
                          done.stderr)

    def test_a_program_comes_from_a_pipe(self):
        netlist = self.netlist('T800 (memory = 2M) root; connect root.link[0] to host; use "/dev/stdin" for root;\n')
        done = subprocess.run([PROGRAM, "run", netlist], input=self.file.read_bytes(), capture_output=True, timeout=60, check=False)
        self.assertTrue(done.stdout.startswith(b"Hello from a transputer!!\n"), done.stderr)

    def test_a_changed_program_is_another_network_and_resumes_no_results(self):
        netlist = self.folder / "net.cfs"
        netlist.write_text('T800 (memory = 2M) root; connect root.link[0] to host; use "hello.btl" for root;\n', encoding="utf-8")
        def hash_of_network():
            return re.search("hash (.*)", placedpar("check", netlist).stdout).group(1)
        sweep = ["sweep", netlist, "root.clock=20M,30M", "--results", self.folder / "r.sqlite"]
        before = hash_of_network()
        self.assertEqual(placedpar(*sweep).returncode, 0)
        self.assertEqual(placedpar(*sweep).returncode, 0)
        (self.folder / "moved.btl").write_bytes(self.file.read_bytes())
        text = netlist.read_text(encoding="utf-8")
        netlist.write_text(text.replace("hello", "moved"), encoding="utf-8")
        self.assertEqual(hash_of_network(), before)
        netlist.write_text(text, encoding="utf-8")
        self.file.write_bytes(self.file.read_bytes().replace(b"Hello", b"Hallo"))
        self.assertNotEqual(hash_of_network(), before)
        done = placedpar(*sweep)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"the file's runs were made with other contents of {self.file}; name another file", done.stderr)

    def test_no_output_takes_the_place_of_a_program(self):
        netlist = self.folder / "net.cfs"
        netlist.write_text('T800 (memory = 2M) root; connect root.link[0] to host; use "hello.btl" for root;\n', encoding="utf-8")
        before = self.file.read_bytes()
        for command in (["run", netlist, "--json"], ["explain", netlist, "--json"], ["show", netlist, "-o"], ["run", self.file, "--json"]):
            with self.subTest(command=command[0]):
                done = placedpar(*command, self.file)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertEqual(self.file.read_bytes(), before)


# A program's end: sends a request of A bytes at address B to the host, and inputs the reply.
ASK = """
ask:    ldl 2; ldl 4 + to_host; ldl 1; out
        ldc 0; stl 4 + size; ldlp 4 + size; ldl 4 + from_host; ldc 2; in
        ldlp 4 + reply; adc 3; ldl 4 + from_host; ldl 4 + size; in; ret
exit:   .half 6
        .byte 35
status: .word -999999999
        .byte 0
"""
BEGIN = """
from_host = 0
to_host = 1
size = 2
count = 4
reply = 8
        ajw 8; stl from_host; stl from_host; stl from_host
        ldl from_host; ldnlp -4; stl to_host
"""


class Hostile(unittest.TestCase):
    """Programs that try what they should not."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.inside = self.folder / "in"
        self.inside.mkdir()
        self.file = self.folder / "x.btl"

    def run_source(self, source, *options):
        text = self.folder / "x.tas"
        text.write_text(source, encoding="utf-8")
        done = placedpar("assemble", text, "-o", self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return placedpar("run", self.file, *options)

    def opens(self, name, times=1):
        """Returns a program that opens a file for writing, so many times. It exits with the number of successes, plus 2."""
        return f"""{BEGIN}
            ldc 2; stl 5
            ldc {times}; stl count
    again:  ldpi open; ldc open_end - open; call ask
            ldlp reply; adc 3; lb; eqc 0; ldl 5; add; stl 5
            ldl count; adc -1; stl count; ldl count; eqc 0; cj again
            ldl 5; ldpi status; sb; ldl 5; ldc 8; shr; ldpi status; adc 1; sb
            ldc 0; ldpi status; adc 2; sb; ldc 0; ldpi status; adc 3; sb
            ldpi exit; ldc 8; call ask
            stopp
    {ASK}
    open:   .half open_end - open - 2
            .byte 10
            .half {len(name)}
            .byte "{name}"
            .byte 1, 2{", 0" if len(name) % 2 == 0 else ""}
    open_end:
    """

    def test_a_loop_of_four_milliards_of_turns_ends_at_the_time_limit(self):
        done = self.run_source("ldc 0; stl 2; again: ldlp 1; ldc end - again; lend; end: stopp", "--until", "200ms")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("stopped at the time limit at 200.000000 ms", done.stdout)
        turns = int(re.search(r"root +(\d+) +0  runs", done.stdout).group(1)) / 3  # ldlp, ldc, lend with a prefix
        self.assertAlmostEqual(turns, 200e-3 * 20e6 / 13, delta=0.01 * turns)

    def test_a_hundred_thousand_opens_take_the_streams_that_there_are(self):
        done = self.run_source(self.opens("file", 100_000), "--host-folder", self.inside)
        self.assertIn("exited with status 255", done.stdout)  # 2 and 253 files
        self.assertEqual([each.name for each in self.inside.iterdir()], ["file"])

    def test_no_file_outside_of_the_folder_is_opened(self):
        (self.folder / "secret").write_text("unseen", encoding="utf-8")
        (self.inside / "out").symlink_to(self.folder)
        (self.inside / "link").symlink_to(self.folder / "secret")
        for name in ("../secret", "out/secret", "link", f"{self.folder}/secret", "out/new", "C:secret", ""):
            with self.subTest(name=name):
                done = self.run_source(self.opens(name), "--host-folder", self.inside)
                self.assertIn("exited with status 2\n", done.stdout)
        self.assertEqual((self.folder / "secret").read_text(encoding="utf-8"), "unseen")
        self.assertEqual(sorted(each.name for each in self.folder.iterdir()), ["in", "secret", "x.btl", "x.tas"])
        self.assertIn("exited with status 3\n", self.run_source(self.opens("file"), "--host-folder", self.inside).stdout)

    def test_gigabytes_of_output_end_at_the_limit(self):
        writes = f"""{BEGIN}
            ldpi open; ldc open_end - open; call ask
            ldl reply + 1; ldpi write; adc 3; stnl 0
    again:  ldpi write; ldc 512; call ask
            ldlp reply + 1; lb; cj full; j again
    full:   ldpi exit; ldc 8; call ask
            stopp
    {ASK}
    open:   .half open_end - open - 2
            .byte 10
            .half 3
            .byte "big", 1, 2
    open_end:
            .align
            .byte 0             -- so that the number of the stream is a word
    write:  .half 510
            .byte 13
            .word 0
            .half 503
    """
        done = self.run_source(writes + ".byte 120\n" * 503, "--host-folder", self.inside, "--host-limit", "1")
        self.assertIn("exited with failure; it reached the limit of --host-limit", done.stdout)
        self.assertLessEqual((self.inside / "big").stat().st_size, 1 << 20)
        self.assertGreater((self.inside / "big").stat().st_size, 1_000_000)


if __name__ == "__main__":
    unittest.main()
