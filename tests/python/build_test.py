"""Tests networks that are built in Python: against their netlists, their errors, and sweeps over them."""

import sys
import unittest

import placedpar as pp


class Numbers(pp.Process):
    out = pp.Output(int)
    count = 3

    def body(self):
        for number in range(self.count):
            yield self.out.output(number)


class Relay(pp.Process):
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
    inp = pp.Input(int)
    count = 3

    def body(self):
        total = 0
        for _ in range(self.count):
            total += yield self.inp.input()
        self.measure("total", total)


NETLIST = """T800 (clock = 25M) a, b;
connection (linkspeed = 10M) wire;
connect a.link[1] to b.link[0] by wire;
connect a.link[2] to b.link[3];
process q, r, s;
use "Numbers" for q; use "Relay" for r; use "Sum" for s;
place q on a; place r on b; place s on a;
r (cycles = 1000);
connect q.out to r.inp; place q.out on a.link[2];
connect r.out to s.inp;"""


def chain():
    net = pp.Network()
    a = net.processor("T800", "a", clock="25M")
    b = net.processor("T800", "b", clock=25000000)
    net.connect(a.link[1], b.link[0], linkspeed="10M")
    net.connect(a.link[2], b.link[3])
    q = net.process("q", Numbers, on=a)
    r = net.process("r", Relay, on=b, cycles=1000)
    s = net.process("s", Sum, on=a)
    net.connect(q.out, r.inp, link=a.link[2])
    net.connect(r.out, s.inp)
    return net


def rows(table):
    return table if isinstance(table, list) else table.to_dict("records")


class Built(unittest.TestCase):
    def test_a_built_network_runs_as_its_netlist(self):
        run = chain().run(seed=3)
        self.assertEqual(run.fingerprint, pp.load(NETLIST, kinds=[Numbers, Relay, Sum]).run(seed=3).fingerprint)
        self.assertEqual(rows(run.measures)[0]["value"], 6)
        carried = {(row["from"], row["bytes"]) for row in rows(run.links) if row["bytes"]}
        self.assertEqual(carried, {("a.link[2]", 12), ("b.link[0]", 12)})

    def test_kinds_in_cpp_meet_kinds_in_python(self):
        class Counter(pp.Process):
            inputs = pp.Input(pp.Packet)

            def body(self):
                for _ in range(5):
                    yield self.inputs.input()
                self.measure("time", pp.now(), "s")
        net = pp.Network()
        t = net.processor("T800")
        producer = net.process("producer", "csp.producer", on=t, priority="HIGH", count=5)
        counter = net.process("counter", Counter, on=t)
        net.connect(producer.out, counter.inputs)
        self.assertEqual(net.run().outcome, "completed")
        self.assertIn("priority = ", net.cfs)

    def test_a_network_grows_after_a_run(self):
        net = chain()
        first = net.run().fingerprint
        c = net.processor("T800")
        net.connect(net.processor("T800").link[0], c.link[0])
        self.assertEqual(len(rows(net.run().processors)), 4)
        self.assertEqual(chain().run().fingerprint, first)

    def test_an_error_has_the_line_of_the_program(self):
        net = pp.Network()
        a = net.processor("T800", clock="20M")
        net.process("p", "csp.producr", on=a)
        line = sys._getframe().f_lineno - 1
        with self.assertRaises(pp.NetlistError) as caught:
            net.run()
        self.assertEqual((caught.exception.file, caught.exception.line), (__file__, line))
        self.assertIn(f'{__file__}:{line}: error: ', str(caught.exception))
        self.assertIn('hint: did you mean "csp.producer"?', str(caught.exception))
        net = pp.Network()
        net.processor("T800", memry="1M")
        with self.assertRaisesRegex(pp.NetlistError, "build_test.py:.*memry"):
            net.svg()

    def test_a_warning_has_the_line_of_the_program(self):
        net = pp.Network()
        a, b = net.processor("T800", tolerance=1), net.processor("T800")
        line = sys._getframe().f_lineno - 1
        c = net.processor("T800")
        net.connect(a.link[0], b.link[0])
        net.connect(b.link[1], c.link[0])
        net.connect(net.process("q", Numbers, on=a).out, net.process("s", Sum, on=c).inp)
        with self.assertWarnsRegex(pp.NetlistWarning, f'build_test.py:{line}: warning: the attribute "tolerance"') as caught:
            net.run()
        self.assertEqual(caught.filename, __file__)

    def test_wrong_calls_are_errors_at_once(self):
        net = pp.Network()
        a, b = net.processor("T800"), net.processor("T800")
        p = net.process("p", Numbers, on=a)
        q = net.process("q", Sum, on=a)
        for message, wrong in (("'p' is used twice", lambda: net.process("p", Numbers, on=a)),
                               ("letters, digits", lambda: net.process("1p", Numbers, on=a)),
                               ("a link of the processor of p.out or of q.inp",
                                lambda: net.connect(p.out, q.inp, link=b.link[0])),
                               ("loaded takes no more statements", lambda: pp.load(NETLIST, [Numbers, Relay, Sum]).processor("T800"))):
            with self.assertRaisesRegex(pp.Error, message):
                wrong()
        with self.assertRaisesRegex(TypeError, "derived from placedpar.Process"):
            net.process("r", int, on=a)


class Sweeps(unittest.TestCase):
    def test_a_sweep_runs_processes_in_python(self):
        told = []
        found = rows(pp.sweep(chain(), {"r.cycles": [10, 1000]}, clock=["20M", "25M"], seeds=2, measure=["time", "s.total"],
                              progress=lambda made, of: told.append((made, of))))
        self.assertEqual(told, [(i + 1, 8) for i in range(8)])
        self.assertEqual([(row["r.cycles"], row["clock"], row["seed"]) for row in found[:3]],
                         [(10, "20M", 1), (10, "20M", 2), (10, "25M", 1)])
        self.assertEqual({row["s.total"] for row in found}, {6})
        self.assertAlmostEqual(found[-1]["time"], chain().run(seed=2).time * 1e3)
        self.assertEqual(found[-1]["outcome"], "completed")

    def test_a_sweep_reports_deadlocks_and_refused_settings(self):
        found = rows(pp.sweep(chain(), {"r.count": [2, 3, "x"]}, measure="s.total"))
        self.assertEqual([row["outcome"] for row in found], ["deadlock", "completed", "refused"])

    def test_a_sweep_says_what_it_cannot_do(self):
        with self.assertRaisesRegex(pp.Error, "a later sweep could not tell whether the program is still the same"):
            pp.sweep(chain(), clock="20M", store="runs.sqlite")
        with self.assertRaisesRegex(pp.Error, "s.totl"):
            pp.sweep(chain(), clock="20M", measure="s.totl")
        with self.assertRaisesRegex(pp.Error, "runs one at a time: compare the times of runs"):
            pp.explain(chain())


if __name__ == "__main__":
    unittest.main()
