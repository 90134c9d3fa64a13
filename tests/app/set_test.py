"""--set as its users meet it: what it reaches, what the report and the manifest say, and what is refused."""

import json
import pathlib
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, fingerprint, placedpar

RECORD = EXAMPLES / "records" / "boom-4deg.csv"
COMMSTIME = EXAMPLES / "01-commstime" / "commstime.cfs"


class Set(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def changed(self, netlist, old, new):
        """The netlist with one text in the place of another."""
        text = netlist.read_text(encoding="utf-8").replace("../", str(netlist.parent.parent) + "/")
        self.assertIn(old, text)
        path = self.folder / "changed.cfs"
        path.write_text(text.replace(old, new), encoding="utf-8")
        return path

    def check(self, *settings, netlist=CLUSTER):
        """The network's hash."""
        run = placedpar("check", netlist, *(word for each in settings for word in ("--set", each)))
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout.split("hash ")[1]

    def refused(self, *settings, command=("check",)):
        run = placedpar(*command, CLUSTER, *(word for each in settings for word in ("--set", each)))
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        return run.stderr

    def test_it_is_as_if_the_netlist_said_so(self):
        for setting, old, new in (("linkspeed=10M", "channelcall = library_call", "linkspeed = 10M, channelcall = library_call"),
                                  ("t.clock=25M", "channelcall = library_call", "clock = 25M, channelcall = library_call"),
                                  ("master.elite=2", "elite = elite", "elite = 2"),
                                  ("elite=2", "val elite 0", "val elite 2"),
                                  ("split=demand", 'val split "individuals"', 'val split "demand"'),
                                  ("master.split=demand", "split = split", 'split = "demand"')):
            given = self.changed(CLUSTER, old, new)
            if setting == "linkspeed=10M":  # of the workstation, too
                given.write_text(given.read_text(encoding="utf-8").replace("workstation sun", "workstation (linkspeed = 10M) sun"),
                                 encoding="utf-8")
            self.assertEqual(self.check(setting), self.check(netlist=given), setting)
            ours, theirs = placedpar("run", CLUSTER, "--set", setting), placedpar("run", given)
            self.assertEqual(fingerprint(ours.stdout), fingerprint(theirs.stdout), setting)

    def test_the_report_and_the_manifest_say_what_was_set(self):
        path = self.folder / "report.json"
        settings = ("slaves=1", "split=demand", "linkspeed=10M", "slave[0].cycles_per_error=2000")
        words = [word for each in settings for word in ("--set", each)]
        run = placedpar("run", CLUSTER, *words, "--json", path)
        self.assertEqual(run.returncode, 0, run.stderr)
        for line in ("set: slaves = 1\n", "set: split = demand\n", "set: linkspeed = 10M, for t[0], t[1], sun\n",
                     "set: slave[0].cycles_per_error = 2000, for slave[0]\n"):
            self.assertIn(line, run.stdout)
        manifest = json.loads(path.read_text(encoding="utf-8"))["manifest"]
        self.assertEqual({each["name"]: (each["value"], each["elements"]) for each in manifest["set"]},
                         {"slaves": ("1", []), "split": ("demand", []), "linkspeed": ("10M", ["t[0]", "t[1]", "sun"]),
                          "slave[0].cycles_per_error": ("2000", ["slave[0]"])})
        again = [word for name, value in manifest["overrides"].items() for word in ("--set", f"{name}={value}")]
        self.assertEqual(placedpar("run", CLUSTER, *again).stdout, run.stdout)

    def test_what_is_shown_has_it_and_loads_again(self):
        for setting in ("length=10", "linkspeed=10M", "master.priority=HIGH", "split=demand"):
            shown = placedpar("show", CLUSTER, "--set", setting)
            path = self.folder / "shown.cfs"
            path.write_text(shown.stdout, encoding="utf-8")
            self.assertEqual(self.check(setting), self.check(netlist=path), setting)
            self.assertNotEqual(self.check(setting), self.check(), setting)

    def test_ten_metres_of_wire_slow_a_link_down(self):
        slow, fast = (placedpar("run", COMMSTIME, *words) for words in (("--set", "length=10"), ()))
        time = [float(run.stdout.split("completed at ")[1].split()[0]) for run in (slow, fast)]
        self.assertGreater(time[0], time[1])
        self.assertIn("set: length = 10, for wire[0], wire[1], wire[2], wire[3]\n", slow.stdout)

    def test_what_is_wrong_is_shown_where_the_option_says_it(self):
        self.assertTrue(self.refused("master.elit=1").startswith(
            '--set:1:8: error: the process "master" has no parameter "elit"\n'
            "    master.elit=1\n"
            "           ^\n"
            'hint: did you mean "elite"?\n'))
        self.assertIn("--set:1:14: error: wrong type for the parameter", self.refused("master.elite=1.5"))
        self.assertIn("--set:1:11: error: illegal value of the attribute", self.refused("linkspeed=0", command=("run",)))
        self.assertIn("--set:1:7: error: the value is missing", self.refused("elite=", command=("show",)))
        twice = self.refused("linkspeed=10M", "sun.linkspeed=10M")
        self.assertIn('"linkspeed" of "sun" is set twice\n', twice)
        self.assertIn("linkspeed=10M: linkspeed is set twice", self.refused("linkspeed=5M", "linkspeed=10M"))

    def test_a_value_of_a_val_that_the_netlist_cannot_use_names_the_option_too(self):
        said = self.refused("split=demnd")
        self.assertIn('did you mean "demand"?', said)
        self.assertIn("--set:1:1: note: ", said)

    def test_what_exists_is_said_where_something_does_not(self):
        said = self.refused("linkspede=10M")
        self.assertIn('hint: did you mean "linkspeed"?\n', said)
        for what in ("note: vals: ", "note: processes and their parameters: ", "note: nodes and their attributes: "):
            self.assertIn(what, said)
        self.assertLess(len(said), 1500)

    def test_identify_takes_it_for_its_netlist(self):
        run = placedpar("identify", RECORD, "--on", CLUSTER, "--set", "slaves=1", "--set", "linkspeed=10M")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("set: linkspeed = 10M", run.stdout)
        fixed = self.changed(CLUSTER, "population = population", "population = 60")
        run = placedpar("identify", RECORD, "--on", fixed)  # as ever, the netlist's own value is not set aside unasked
        self.assertEqual(run.returncode, 1)
        self.assertIn("identify searches with 120", run.stderr)
        run = placedpar("identify", RECORD, "--on", fixed, "--set", "master.population=120")
        self.assertEqual(run.returncode, 0, run.stderr)


if __name__ == "__main__":
    unittest.main()
