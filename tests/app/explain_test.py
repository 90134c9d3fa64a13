"""placedpar explain: the critical path adds up to the run, and what changes would gain is what changed runs take."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["PLACEDPAR"]
EXAMPLES = os.environ["PLACEDPAR_EXAMPLES"]
FIGURE_E2 = os.path.join(EXAMPLES, "04-figure-e2", "figure-e2.cfs")


def explained(netlist, *options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "explained.json")
        run = subprocess.run([PROGRAM, "explain", netlist, "--json", path, *options], capture_output=True, text=True)
        return run, json.loads(pathlib.Path(path).read_text(encoding="utf-8"))


def time_of_run(netlist, *options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "run.json")
        subprocess.run([PROGRAM, "run", netlist, "--json", path, *options], capture_output=True, check=True)
        return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["time_ps"]


class Explain(unittest.TestCase):
    def test_the_path_leads_without_a_gap_from_the_end_to_the_beginning(self):
        for netlist in ("01-commstime/commstime.cfs", "02-deadlock/ring.cfs", "03-table-e1/cluster.cfs",
                        "04-figure-e2/figure-e2.cfs"):
            with self.subTest(netlist):
                run, document = explained(os.path.join(EXAMPLES, netlist), "--no-what-if")
                self.assertIn(run.returncode, (0, 2), run.stderr)
                moment = 0
                for part in document["critical_path"]:
                    self.assertEqual(part["begin_ps"], moment)
                    moment = part["end_ps"]
                self.assertEqual(moment, document["time_ps"])

    def test_a_what_if_is_a_run_with_what_it_sets(self):
        _, document = explained(FIGURE_E2)
        answers = {what["what"]: what for what in document["what_if"]}
        for what in ("all links twice as fast", "one more: slaves 4 instead of 3", "channelcall none",
                     "the processors of master twice as fast"):
            answer = answers[what]
            settings = [word for name, value in answer["set"].items() for word in ("--set", f"{name}={value}")]
            self.assertNotEqual(answer["time_ps"], document["time_ps"])
            self.assertEqual(answer["time_ps"], time_of_run(FIGURE_E2, *settings), what)


if __name__ == "__main__":
    unittest.main()
