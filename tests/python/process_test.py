"""Tests process kinds in Python: their operations, their times, kinds in C++ beside them, and their errors."""

import os
import signal
import subprocess
import sys
import threading
import unittest

import placedpar as pp


class Numbers(pp.Process):
    """Outputs the numbers 0 ... count - 1."""
    out = pp.Output(int)
    count = pp.Parameter(3, unit="numbers", least=1, about="how many")

    def body(self):
        for number in range(self.count):
            yield self.out.output(number)


class Relay(pp.Process):
    """Adds 1 to each number, after so many cycles."""
    inp = pp.Input(int)
    out = pp.Output(int)
    cycles = 100
    count = 3

    def body(self):
        for _ in range(self.count):
            x = yield self.inp.input()
            yield pp.compute(self.cycles)
            yield self.out.output(x + 1)


class Sum(pp.Process):
    """Adds up what it inputs, and reports the sum and the time."""
    inp = pp.Input(int)
    count = 3

    def body(self):
        total = 0
        for _ in range(self.count):
            total += yield self.inp.input()
        self.measure("total", total, "units")
        self.measure("said", self.name)
        self.measure("now", pp.now(), "s")


MACHINE = "T800 (memory = 1M, clock = 20M) a, b; connect a.link[1] to b.link[0];\n"
CHAIN = MACHINE + """process (interface (output out)) q; process (interface (input inp, output out)) r;
process (interface (input inp)) s; use "Numbers" for q; use "Relay" for r; use "Sum" for s;
connect q.out to r.inp; connect r.out to s.inp; place q on a; place r on b; place s on b;"""


def measured(run):
    table = run.measures if isinstance(run.measures, list) else run.measures.to_dict("records")
    return {(row["process"], row["name"]): row["value"] for row in table}


def alone(kind, **settings):
    """Runs one process of the kind on a T800 at 20 MHz, and returns what it measured."""
    text = f'T800 (memory = 1M, clock = 20M) t; process p; use "{kind.kind}" for p; place p on t;'
    run = pp.load(text, kinds=[kind], settings=settings).run()
    return {name: value for (_, name), value in measured(run).items()}


def pair(sender, receiver, out="", inp=""):
    """Returns a network of two processes and a channel on one processor."""
    return pp.load('T800 (memory = 1M, clock = 20M) t; process q, r;\n'
                   f'use "{getattr(sender, "kind", sender)}" for q; use "{getattr(receiver, "kind", receiver)}" for r;\n'
                   f'connect q.out{out} to r.{inp or "inp"}; place q on t; place r on t;',
                   kinds=[kind for kind in (sender, receiver) if not isinstance(kind, str)])


class Operations(unittest.TestCase):
    def test_a_chain_passes_numbers(self):
        run = pp.load(CHAIN, kinds=[Numbers, Relay, Sum]).run()
        found = measured(run)
        self.assertEqual((found["s", "total"], found["s", "said"]), (1 + 2 + 3, "s"))
        self.assertEqual(pp.load(CHAIN, kinds=[Numbers, Relay, Sum]).run().fingerprint, run.fingerprint)

    def test_parameters_come_from_the_netlist_and_are_checked(self):
        more = {"q.count": 5, "r.count": 5, "s.count": 5, "r.cycles": 1000}
        net = pp.load(CHAIN, kinds=[Numbers, Relay, Sum], settings=more)
        self.assertEqual(measured(net.run())["s", "total"], 15)
        slower = net.run().time - pp.load(CHAIN, kinds=[Numbers, Relay, Sum], settings={**more, "r.cycles": 0}).run().time
        self.assertAlmostEqual(slower, 5 * 1000 / 20e6, 6)
        with self.assertRaisesRegex(pp.NetlistError, "at least 1 number"):
            pp.load(CHAIN, kinds=[Numbers, Relay, Sum], settings={"q.count": 0})

    def test_time_passes_as_stated(self):
        class Clock(pp.Process):
            def body(self):
                yield pp.compute(20_000)
                self.measure("computed", pp.now(), "s")
                yield pp.wait("5ms")
                self.measure("waited", pp.now(), "s")
                yield pp.until(0.01)
                self.measure("until", pp.now(), "s")
                ticks = pp.clock()
                yield pp.after(ticks + 10)
                self.measure("ticks", pp.clock() - ticks, "ticks")
        found = alone(Clock)
        self.assertAlmostEqual(found["computed"], 0.001, 5)
        self.assertAlmostEqual(found["waited"], 0.006, 5)
        self.assertAlmostEqual(found["until"], 0.010, 5)
        self.assertGreater(found["ticks"], 10)

    def test_alt_takes_the_first_ready_guard_or_its_timeout(self):
        class Late(pp.Process):
            out = pp.Output(float)

            def body(self):
                yield pp.wait("2ms")
                yield self.out.output(2.5)

        class Chooser(pp.Process):
            inp = pp.Input(float)

            def body(self):
                chosen = yield pp.alt(self.inp, pp.wait("1ms"))
                self.measure("first", str(chosen))
                chosen = yield pp.alt(pp.when(False, pp.skip()), self.inp)
                self.measure("second", str(chosen))
                chosen = yield pp.alt(pp.skip())
                self.measure("third", str(chosen))
        found = measured(pair(Late, Chooser).run())
        self.assertEqual([found["r", name] for name in ("first", "second", "third")],
                         ["(1, None)", "(1, 2.5)", "(0, None)"])

    def test_par_runs_generators_and_operations(self):
        class Both(pp.Process):
            def body(self):
                def half(cycles):
                    yield pp.wait("1ms")
                    yield pp.compute(cycles)
                    return cycles
                results = yield pp.par(half(1), pp.wait("3ms"), half(2))
                self.measure("results", str(results))
                self.measure("now", pp.now(), "s")
        found = alone(Both)
        self.assertEqual(found["results"], "[1, None, 2]")
        self.assertAlmostEqual(found["now"], 0.003, 5)

    def test_arrays_of_ports_are_lists(self):
        class Fan(pp.Process):
            out = pp.Outputs(list[int])

            def body(self):
                yield pp.par(*(end.output([i, 10 * i]) for i, end in enumerate(self.out)))

        class Merge(pp.Process):
            inp = pp.Inputs(list[int])

            def body(self):
                messages = []
                for _ in self.inp:
                    messages.append((yield pp.alt(*self.inp)))
                self.measure("messages", str(sorted(messages)))
        net = pp.load('T800 (memory = 1M) t; process q, r; use "Fan" for q; use "Merge" for r;\n'
                      'rep i = 0 for 3 connect q.out[i] to r.inp[i]; place q on t; place r on t;', kinds=[Fan, Merge])
        self.assertEqual(measured(net.run())["r", "messages"], "[(0, [0, 0]), (1, [1, 10]), (2, [2, 20])]")

    def test_kinds_in_python_meet_kinds_in_cpp(self):
        class Packets(pp.Process):
            out = pp.Output(pp.Packet)

            def body(self):
                for number in range(1000):
                    yield self.out.output(pp.Packet(number, bytes=8))
        python = pair(Packets, "csp.consumer", inp="in").run()
        cpp = pp.load('T800 (memory = 1M, clock = 20M) t; process q, r; use "csp.producer" for q; '
                      'use "csp.consumer" for r; q (bytes = 8);\n'
                      'connect q.out to r.in; place q on t; place r on t;').run()
        self.assertEqual(python.fingerprint, cpp.fingerprint)
        self.assertEqual(measured(python)["r", "last_number"], 999)

    def test_messages_are_of_many_types(self):
        for kind, message in ((bool, True), (float, 0.5), (bytes, b"ab"), (list[float], [1.5, 2.0]), (pp.INT64, 2**40),
                              (pp.BYTE, 255), (object, {"any": ["thing"]})):
            class Sender(pp.Process):
                out = pp.Output(kind)

                def body(self):
                    yield self.out.output(message)

            class Receiver(pp.Process):
                inp = pp.Input(kind)

                def body(self):
                    got = yield self.inp.input()
                    self.measure("same", str(got == message))
            self.assertEqual(measured(pair(Sender, Receiver).run())["r", "same"], "True", kind)

    def test_random_numbers_are_those_of_the_seed_and_the_name(self):
        class Dice(pp.Process):
            def body(self):
                random = self.random()
                self.measure("thrown", str([random.below(6) for _ in range(9)]))
                return
                yield
        stream = pp.RandomStream(1, "p")
        self.assertEqual(alone(Dice)["thrown"], str([stream.below(6) for _ in range(9)]))

    def test_a_body_may_need_a_deep_stack(self):
        class Deep(pp.Process):
            def body(self):
                self.measure("value", eval("(" * 150 + "7" + ")" * 150))  # Python's parser needs more than 256 KB
                yield pp.compute(1)
        self.assertEqual(alone(Deep)["value"], 7)

    def test_ends_and_measure_outlast_their_process(self):
        kept = []

        class Keeper(Numbers):
            def body(self):
                kept.append(self)
                yield from Numbers.body(self)
        pair(Keeper, Sum).run()
        for use in (lambda: kept[0].out.channel, lambda: kept[0].out.output(1)):
            with self.assertRaisesRegex(pp.Error, "the end out was used after its process had ended"):
                use()
        with self.assertRaisesRegex(pp.Error, "after its process had ended"):
            kept[0].measure("late", 1)

    def test_a_long_timeout_of_alt_is_never_over(self):
        class Patient(pp.Process):
            def body(self):
                yield pp.wait("1s")
                self.measure("chosen", (yield pp.alt(pp.wait(9.2e6), pp.wait("1ms")))[0])
        self.assertEqual(alone(Patient)["chosen"], 1)


class Errors(unittest.TestCase):
    def failing(self, body, message):
        class Failing(pp.Process):
            out = pp.Output(int)
        Failing.body = body
        with self.assertRaisesRegex(pp.ProcessError, message) as caught:
            pair(Failing, Sum).run()
        return caught.exception

    def test_an_exception_names_process_kind_and_time(self):
        def body(self):
            yield pp.wait("1ms")
            raise ValueError("worn out")
        error = self.failing(body, r"netlist:1:\d+: process q \(Failing\) at 1\.\d+ ms: ValueError: worn out")
        self.assertIsInstance(error.__cause__, ValueError)
        self.assertEqual(error.__cause__.__traceback__.tb_frame.f_code.co_name, "body")

    def test_a_wrong_message_is_a_type_error_at_its_yield(self):
        def body(self):
            yield self.out.output("three")
        self.assertIsInstance(self.failing(body, "channel q.out -> r.inp carries INT32, not 'three'").__cause__, TypeError)

        def handles(self):
            try:
                yield self.out.output(2**40)
            except TypeError:
                for _ in range(3):
                    yield self.out.output(7)

        class Handling(Numbers):
            body = handles
        self.assertEqual(measured(pair(Handling, Sum).run())["r", "total"], 21)

    def test_what_is_no_operation_is_refused(self):
        def body(self):
            yield 3
        self.failing(body, "a body yields operations, such as self.inp.input\\(\\) or pp.compute\\(100\\), not 3")

        def returns(self):
            return 3
        self.failing(returns, "body\\(\\) must be a generator")

        def guards(self):
            yield pp.alt(pp.compute(3))
        self.failing(guards, "a computation is not a guard")

        def inputs(self):
            yield self.out.input()
        self.failing(inputs, r"out is an output end: use out.output\(message\)")

    def test_what_describes_no_kind_is_refused(self):
        for wrong, message in ((lambda: pp.Parameter(True), "an int, a float or a str, not True"),
                               (lambda: pp.load(MACHINE, kinds=[int]), "derived from placedpar.Process"),
                               (lambda: pp.wait(1e30), "expected 0 to 9.2e6 s")):
            with self.assertRaisesRegex((pp.Error, TypeError), message):
                wrong()
        for name, value, message in (("great", 2**70, "Wrong.great: a parameter of"), ("seed", 3, "Wrong.seed")):
            kind = type("Wrong", (pp.Process,), {name: value, "body": lambda self: None})
            with self.assertRaisesRegex(pp.Error, message):
                pp.load(MACHINE, kinds=[kind])

    def test_a_deadlock_has_the_cycle_and_the_lines(self):
        class Ring(pp.Process):
            inp = pp.Input(int)
            out = pp.Output(int)

            def body(self):
                x = yield self.inp.input()  # both wait here
                yield self.out.output(x)
        net = pp.load('T800 (memory = 1M) t; process a, b; use "Ring" for a; use "Ring" for b;\n'
                      'connect a.out to b.inp; connect b.out to a.inp; place a on t; place b on t;', kinds=[Ring])
        with self.assertRaises(pp.Deadlock) as caught:
            net.run()
        line = Ring.body.__code__.co_firstlineno + 1
        self.assertIn("cycle: a -> b -> a", str(caught.exception))
        self.assertEqual(str(caught.exception).count(f"process_test.py:{line}"), 2)

    def test_a_deadlock_in_a_par_has_the_lines_of_the_components(self):
        class Waiting(pp.Process):
            inp = pp.Input(int)
            out = pp.Output(int)

            def body(self):
                def half():
                    yield self.inp.input()  # waits here
                yield pp.par(half(), pp.wait("1ms"))
                yield self.out.output(1)
        net = pp.load('T800 (memory = 1M) t; process a, b; use "Waiting" for a; use "Waiting" for b;\n'
                      'connect a.out to b.inp; connect b.out to a.inp; place a on t; place b on t;', kinds=[Waiting])
        with self.assertRaisesRegex(pp.Deadlock, f"process_test.py:{Waiting.body.__code__.co_firstlineno + 2}"):
            net.run()

    def test_generators_are_closed_at_the_end(self):
        closed = []

        class Endless(Numbers):
            def body(self):
                try:
                    while True:
                        yield self.out.output(1)
                finally:
                    closed.append(self.name)
        with self.assertRaises(pp.Deadlock):
            pair(Endless, Sum).run()
        self.assertEqual(closed, ["q"])

    def test_ctrl_c_ends_loops_with_and_without_operations(self):
        def computes(self):
            while True:
                yield pp.compute(1)

        def hangs(self):
            while True:
                pass
            yield
        for body in (computes, hangs):
            with self.subTest(body.__name__):
                threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
                with self.assertRaises(KeyboardInterrupt):
                    alone(type("Loop", (pp.Process,), {"body": body}))

    def test_python_ends_while_a_thread_runs_a_network(self):
        program = ("import threading, time, placedpar as pp\n"
                   "class Loop(pp.Process):\n"
                   "    def body(self):\n"
                   "        while True: yield pp.compute(10)\n"
                   "net = pp.load('T800 (memory = 1M) t; process p; use \"Loop\" for p; place p on t;', kinds=[Loop])\n"
                   "threading.Thread(target=net.run, daemon=True).start()\n"
                   "time.sleep(0.2)\n")
        ended = subprocess.run([sys.executable, "-c", program], stderr=subprocess.PIPE, text=True)
        self.assertEqual(ended.returncode, 0, ended.stderr)

    def test_a_wrong_argument_is_named(self):
        random = pp.RandomStream(1, "name")
        for message, wrong in (("cycles is 1.5, expected a whole number from -9223372036854775808",
                                lambda: pp.compute(1.5)),
                               ("words_outside is 'x'", lambda: pp.compute(1, "x")), ("ticks is None", lambda: pp.after(None)),
                               ("bytes is -1, expected a whole number from 0 to 4294967295", lambda: pp.Packet(1, -1)),
                               ("n is 2.5", lambda: random.below(2.5)), ("probability is 'x'", lambda: random.chance("x")),
                               ("seed is -1", lambda: pp.RandomStream(-1, "name"))):
            with self.assertRaisesRegex(TypeError, message):
                wrong()

        def measures(self):
            self.measure(5, 1)
        with self.assertRaisesRegex(pp.ProcessError, "name is 5, expected a text"):
            alone(type("Measures", (pp.Process,), {"body": measures}))

    def test_progress_is_told_from_another_thread(self):
        told = []

        def computes(self):
            for _ in range(60000):
                yield pp.compute(1000)
        net = pp.load('T800 (memory = 1M) t; process p; use "Long" for p; place p on t;',
                      kinds=[type("Long", (pp.Process,), {"body": computes})])
        run = net.run(until="3600s", progress=lambda time, end: told.append((time, end, threading.current_thread())))
        times = [time for time, _, _ in told]
        self.assertEqual(times, sorted(times))
        self.assertEqual((times[-1], told[-1][1]), (run.time, 3600))


if __name__ == "__main__":
    unittest.main()
