"""Tests networks and runs from Python against the command line, and the errors of wrong netlists."""

import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

import placedpar as pp

SOURCE = pathlib.Path(os.environ["PLACEDPAR_SOURCE"])
FIGURE_E2 = SOURCE / "examples" / "thesis" / "figure-e2" / "figure-e2.cfs"
CLOCK = """T800 (memory = 1M) t; process (interface (input in)) p; process (interface (output out)) q;
use "csp.producer" for q; use "csp.consumer" for p; q (count = 1000000000); p (count = 1000000000);
connect q.out to p.in; place p on t; place q on t;"""


def rows(table):
    """Returns the rows of a table as dictionaries, with pandas or without."""
    return table if isinstance(table, list) else table.to_dict("records")


class Networks(unittest.TestCase):
    def command(self, *arguments):
        """Returns the report that the command line gives."""
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.json")
            subprocess.run([os.environ["PLACEDPAR"], "run", FIGURE_E2, *arguments, "--json", report], check=True,
                           stdout=subprocess.DEVNULL)
            return json.loads(report.read_text(encoding="utf-8"))

    def test_a_run_is_that_of_the_command_line(self):
        run = pp.load(FIGURE_E2, slaves=2, linkspeed="10M").run(seed=7)
        typed = self.command("--set", "slaves=2", "--set", "linkspeed=10M", "--seed", "7")
        self.assertEqual(run.fingerprint, typed["fingerprint"])
        self.assertEqual(rows(run.measures), typed["measurements"])
        self.assertEqual((run.outcome, run.time * 1e12), ("completed", typed["time_ps"]))
        self.assertEqual(run.report["processors"], typed["processors"])
        self.assertNotEqual(pp.load(FIGURE_E2).run(seed=7).fingerprint, run.fingerprint)

    def test_the_log_has_every_generation_of_every_island(self):
        run = pp.load(FIGURE_E2, slaves=1).run()
        best = [row for row in rows(run.log) if row["quantity"] == "best" and row["process"] == "master[3]"]
        self.assertEqual([row["generation"] for row in best], list(range(1, 81)))
        last = next(row["value"] for row in rows(run.measures) if row["process"] == "master[3]"
                    and row["name"] == "best_fitness")
        self.assertAlmostEqual(best[-1]["value"], last)

    def test_the_timeline_covers_the_run(self):
        run = pp.load(FIGURE_E2, slaves=1).run()
        slices = [row for row in rows(run.timeline) if row["track"] == "t[0][0]"]
        self.assertEqual({row["activity"] for row in slices}, {"executes"})
        busy = sum(row["end"] - row["begin"] for row in slices)
        share = next(row["busy"] for row in rows(run.processors) if row["name"] == "t[0][0]")
        self.assertAlmostEqual(busy / run.time, share, 6)

    def test_pages_and_drawings_show_themselves_in_a_notebook(self):
        net = pp.load(FIGURE_E2, slaves=1)
        page = net.run().page(height=300)
        self.assertIn('height="300"', page._repr_html_())
        self.assertIn("srcdoc=\"&lt;!", page._repr_html_())
        self.assertIn("master[0]", page.text)
        self.assertTrue(net.svg()._repr_svg_().startswith("<svg"))
        with tempfile.TemporaryDirectory() as folder:
            page.save(pathlib.Path(folder, "page.html"))
            self.assertEqual(pathlib.Path(folder, "page.html").read_text(encoding="utf-8"), page.text)

    def test_a_wrong_netlist_is_an_exception_with_its_place(self):
        with self.assertRaises(pp.NetlistError) as caught:
            pp.load('T800 (memory = 1M) t;\nprocess p;\nuse "csp.producr" for p;\nplace p on t;')
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column), ("netlist", 3, 1))
        self.assertEqual(error.hint, 'did you mean "csp.producer"?')
        self.assertIn('netlist:3:1: error: ', str(error))
        with self.assertRaisesRegex(pp.NetlistError, "no/such.cfs"):
            pp.load("no/such.cfs")
        with self.assertRaisesRegex(pp.NetlistError, "slavs"):
            pp.load(FIGURE_E2, slavs=3)

    def test_a_run_stops_at_its_limit(self):
        run = pp.load(CLOCK).run(until="1ms")
        self.assertEqual((run.outcome, run.time), ("stopped at the time limit", 1e-3))
        self.assertEqual(pp.load(CLOCK).run(until=0.001).fingerprint, run.fingerprint)
        for wrong in ({"until": -1}, {"until": 1e9}, {"seed": -1}, {"seed": 2**64}):
            with self.assertRaisesRegex(pp.Error, "expected (0 to 9.2e6 s|a whole number)"):
                pp.load(CLOCK).run(**wrong)

    def test_a_deadlock_is_an_exception_with_the_cycle(self):
        with self.assertRaises(pp.Deadlock) as caught:
            pp.load(SOURCE / "examples" / "csp" / "deadlock" / "ring.cfs").run()
        self.assertIn("cycle", str(caught.exception))
        self.assertEqual(caught.exception.run.outcome, "deadlock")

    def test_other_threads_go_on_during_a_run(self):
        counted = []
        running = threading.Event()

        def count():
            while not running.is_set():
                counted.append(1)
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        pp.load(CLOCK).run(until="100ms")
        running.set()
        thread.join()
        self.assertGreater(len(counted), 5)

    def test_ctrl_c_ends_a_run(self):
        threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            pp.load(CLOCK).run()
        self.assertEqual(pp.load(CLOCK).run(until="1us").outcome, "stopped at the time limit")


class Studies(unittest.TestCase):
    def test_a_sweep_goes_on_from_its_store(self):
        net = pp.load(FIGURE_E2)
        with tempfile.TemporaryDirectory() as folder:
            store = pathlib.Path(folder, "runs.sqlite")
            made = []
            pp.sweep(net, slaves=[1], seeds=2, measure="master.T_exe", store=store)
            found = rows(pp.sweep(net, slaves=range(1, 3), linkspeed="10M", measure=["time", "master[0].T_exe"]))
            both = rows(pp.sweep(net, slaves=[1, 2], seeds=2, measure="master.T_exe", store=store,
                                 progress=lambda ended, missing: made.append((ended, missing))))
            with self.assertRaisesRegex(pp.Error, "the number of seeds is 0, expected at least 1"):
                pp.sweep(net, slaves=[1], seeds=0)
            with self.assertRaisesRegex(pp.Error, "slaves has no values: give at least one"):
                pp.sweep(net, slaves=range(3, 1))
        self.assertEqual(made[-1], (2, 2))
        self.assertEqual([(row["slaves"], row["seed"]) for row in both], [(1, 1), (1, 2), (2, 1), (2, 2)])
        self.assertEqual([row["slaves"] for row in found], [1, 2])
        run = pp.load(FIGURE_E2, slaves=2, linkspeed="10M").run()
        self.assertAlmostEqual(found[1]["time"], run.time * 1e3)

    def test_a_sweep_refuses_a_measure_that_no_run_has(self):
        with self.assertRaisesRegex(pp.Error, "T_exe"):
            pp.sweep(pp.load(FIGURE_E2), slaves=[1], measure="master.T_ex")

    def test_an_explanation_says_what_would_be_faster(self):
        explanation = pp.explain(pp.load(FIGURE_E2, slaves=1))
        answers = rows(explanation.what_if)
        faster = next(row for row in answers if row["what"] == "all processors twice as fast")
        again = pp.load(FIGURE_E2, slaves=1, settings=faster["set"]).run()
        self.assertEqual(round(again.time * 1e12), faster["time_ps"])
        self.assertIn("all processors twice as fast: 49.8 % less time", str(explanation))


if __name__ == "__main__":
    unittest.main()
