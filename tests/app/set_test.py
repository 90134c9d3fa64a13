"""Tests --set: the elements it reaches, the report, the manifest, and refusals."""

import json
import pathlib
import tempfile
import unittest

from program import CLUSTER, EXAMPLES, fingerprint, placedpar

RECORD = EXAMPLES / "hydraulics" / "records" / "boom-4deg.csv"
COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"


class Set(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def changed(self, netlist, old, new):
        """Returns the netlist with one text replaced."""
        text = netlist.read_text(encoding="utf-8").replace("../", str(netlist.parent.parent) + "/")
        self.assertIn(old, text)
        path = self.folder / "changed.cfs"
        path.write_text(text.replace(old, new), encoding="utf-8")
        return path

    def check(self, *settings, netlist=CLUSTER):
        """Returns the network's hash."""
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
            if setting == "linkspeed=10M":  # the workstation has this attribute too
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
        twice = self.refused("sun.linkspeed=10M", "sun . linkspeed=20M")
        self.assertIn('"linkspeed" of "sun" is set twice\n', twice)
        self.assertIn("linkspeed=10M: linkspeed is set twice", self.refused("linkspeed=5M", "linkspeed=10M"))

    def test_a_value_of_a_val_that_the_netlist_cannot_use_names_the_option_too(self):
        said = self.refused("split=demnd")
        self.assertIn('did you mean "demand"?', said)
        self.assertIn("--set:1:1: note: ", said)

    def test_what_is_said_of_one_goes_before_what_is_said_of_all(self):
        settings = ("slaves=2", "clock=10M", "t.clock=15M", "t[1].clock=25M")
        words = [word for each in settings for word in ("--set", each)]
        shown = json.loads(placedpar("show", CLUSTER, "--format", "json", *words).stdout)
        self.assertEqual({node["name"]: node["clock_hz"] for node in shown["nodes"]},
                         {"t[0]": 15_000_000, "t[1]": 25_000_000, "t[2]": 15_000_000, "sun": 10_000_000})
        run = placedpar("run", CLUSTER, *words).stdout
        for line in ("set: clock = 10M, for sun\n", "set: t.clock = 15M, for t[0], t[2]\n", "set: t[1].clock = 25M, for t[1]\n"):
            self.assertIn(line, run)

    def test_a_wire_without_a_name_goes_by_the_name_in_the_report(self):
        run = placedpar("run", COMMSTIME, "--set", "wire[0].length=10")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("set: wire[0].length = 10, for wire[0]\n", run.stdout)
        all_wires = placedpar("run", COMMSTIME, "--set", "wire.length=10").stdout
        self.assertEqual(fingerprint(all_wires), fingerprint(placedpar("run", COMMSTIME, "--set", "length=10").stdout))
        self.assertIn("hint: the names are wire[0] to wire[3]\n",
                      placedpar("run", COMMSTIME, "--set", "wire[4].length=10").stderr)

    def test_a_long_list_says_where_all_of_it_is(self):
        for said in (self.refused("master.elit_=1"), self.refused("nothing_like_it=1")):
            self.assertRegex(said, r" and \d+ more, see placedpar kinds ga\.master")

    def test_the_seed_is_an_option_of_its_own(self):
        for name in ("seed", "master.seed"):
            self.assertIn("hint: set the seed of a run with the option --seed N\n", self.refused(f"{name}=3"))

    def test_what_exists_is_said_where_something_does_not(self):
        said = self.refused("linkspede=10M")
        self.assertIn('hint: did you mean "linkspeed"?\n', said)
        for what in ("note: vals: ", "note: processes and their parameters: ", "note: nodes and their attributes: "):
            self.assertIn(what, said)
        self.assertLess(len(said), 1500)

    def test_identify_takes_it_for_its_netlist(self):
        run = placedpar("identify", RECORD, "--way", "thesis", "--on", CLUSTER, "--set", "slaves=1", "--set", "linkspeed=10M")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("set: linkspeed = 10M", run.stdout)
        fixed = self.changed(CLUSTER, "population = population", "population = 60")
        run = placedpar("identify", RECORD, "--way", "thesis", "--on", fixed)  # without a question, the netlist's own value is kept
        self.assertEqual(run.returncode, 1)
        self.assertIn("the identification has 120", run.stderr)
        run = placedpar("identify", RECORD, "--way", "thesis", "--on", fixed, "--set", "master.population=120")
        self.assertEqual(run.returncode, 0, run.stderr)


if __name__ == "__main__":
    unittest.main()
