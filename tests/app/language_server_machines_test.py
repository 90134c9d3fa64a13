"""Tests placedpar language-server with configurations and studies: questions, wrong input, and long texts."""

import re
import unittest

from language_client import LanguageTest, position
from program import EXAMPLES, placedpar

CONFIGURATION = """-- \u00e9\U0001f600
VAL n IS 2:
NODE root.node:
[n]NODE worker:
NODE p:
ARC host.arc, inner:
EDGE screen:
NETWORK
  DO
    SET root.node (type, memsize := "T414", 65536)
    CONNECT root.node[link][0] TO HOST WITH host.arc
    CONNECT root.node[link][1] TO worker[0][link][0] WITH inner
    CONNECT root.node[link][2] TO screen
    DO i = 0 FOR n
      SET worker[i] (type, memsize := "T800", 1048576)
    CONNECT worker[0][link][1] TO worker[1][link][2]
:
#INCLUDE "hostio.inc"
#USE "master.occ"
#USE "slave.occ"
MAPPING
  MAP p ONTO worker[0] PRI HIGH
:
CONFIG
  CHAN OF SP fs, ts:
  CHAN OF INT up:
  PLACE fs, ts ON host.arc:
  PLACE up ON inner:
  PLACED PAR
    PROCESSOR root.node
      master (fs, ts, up)
    PROCESSOR p
      slave (up)
:
"""

MASTER = """#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC master (CHAN OF SP fs, ts, CHAN OF INT in)
  INT x:
  SEQ
    in ? x
    so.exit (fs, ts, sps.success)
:
"""

SLAVE = """PROC slave (CHAN OF INT out)
  out ! 3
:
"""

NETLIST = """val slaves 3;
T800 (memory = 1M) t[slaves];
rep i = 0 for slaves - 1
    connect t[i].link[0] to t[i + 1].link[1];
process (interface (output out)) sender;
process (interface (input in)) receiver;
use "csp.producer" for sender;
use "csp.consumer" for receiver;
sender (count = 5);
connect sender.out to receiver.in;
place sender on t[0];
place receiver on t[1];
"""


class Configurations(LanguageTest):
    def setUp(self):
        super().setUp()
        (self.folder / "master.occ").write_text(MASTER)
        (self.folder / "slave.occ").write_text(SLAVE)
        self.uri = self.open("a.pgm", CONFIGURATION, "occam")

    def defined_at(self, words, behind=0):
        """Returns the position of the definition, in this file."""
        found = self.definition(self.uri, words, behind)
        self.assertEqual(found["uri"], self.uri)
        return found["range"]["start"]

    def declared(self, words, behind=0):
        return position(CONFIGURATION, CONFIGURATION.index(words) + behind)

    def test_hover_describes_nodes_arcs_edges_and_attributes(self):
        self.assertEqual(self.client.checked(self.uri), [])
        self.assertTrue(self.hover(self.uri, "root.node[link][0]").endswith(
            "T414 with 65536 bytes; link 0 to HOST, link 1 to worker[0] link 0, link 2 to screen\n"))
        worker = self.hover(self.uri, "worker[i]")
        self.assertIn("[2]NODE worker\n", worker)
        self.assertIn("worker[0]: T800 with 1048576 bytes; link 0 to root.node link 1, link 1 to worker[1] link 2\n", worker)
        self.assertIn("worker[1]: T800 with 1048576 bytes; link 2 to worker[0] link 1\n", worker)
        self.assertIn("mapped onto worker[0] at high priority\n", self.hover(self.uri, "p ONTO"))
        self.assertIn("from root.node link 0 to HOST; carries fs, ts\n", self.hover(self.uri, "host.arc:"))
        self.assertIn("joined to root.node link 2\n", self.hover(self.uri, "screen\n    DO"))
        self.assertIn("joined to root.node link 0\n", self.hover(self.uri, "HOST WITH"))
        self.assertIn("bytes", self.hover(self.uri, "memsize :="))
        self.assertIn("PROC slave (CHAN OF INT out)", self.hover(self.uri, "slave (up)"))
        self.assertEqual(self.hover(self.uri, "NETWORK"), "")

    def test_a_long_array_is_cut_short(self):
        self.client.replace(self.uri, "VAL n IS 2", "VAL n IS 20")
        worker = self.hover(self.uri, "worker[i]")
        self.assertIn("worker[7]: T800", worker)
        self.assertNotIn("worker[8]", worker)
        self.assertTrue(worker.endswith("and 12 more\n"))

    def test_completion(self):
        def names(words, behind=0):
            return sorted(set(self.labels(self.uri, words, behind)))
        self.assertEqual(names("root.node (type"), ["p", "root.node", "worker"])
        self.assertEqual(names("root.node[link][0]"), ["HOST", "p", "root.node", "screen", "worker"])
        self.assertEqual(names("host.arc\n"), ["host.arc", "inner"])
        self.assertEqual(names("worker[0] PRI"), ["host.arc", "inner", "p", "root.node", "worker"])
        self.assertEqual(names("type, memsize := \"T414\""), ["memsize", "romsize", "root", "type"])
        self.assertIn("T805", names("T414"))
        anywhere = names("slave (up)")
        for word in ("slave", "master", "up", "PROCESSOR", "ONTO", "link"):
            self.assertIn(word, anywhere)
        self.assertNotIn("i", anywhere)
        self.assertIn("i", names("worker[i]", len("worker[")))
        self.assertIn("hostio.lib", names("master.occ"))
        self.assertEqual(names("\u00e9"), [])

    def test_names_are_completed_while_the_configuration_has_errors(self):
        """A configuration without CONFIG is wrong, but its names are known."""
        begun = CONFIGURATION[:CONFIGURATION.index("#INCLUDE")]
        uri = self.open("b.pgm", begun, "occam")
        self.assertGreater(len(self.client.checked(uri)), 0)
        self.assertIn("worker", self.labels(uri, "worker[0][link][0]"))
        self.client.replace(uri, "TO worker[0][link][0]", "TO (")
        self.assertGreater(len(self.client.checked(uri)), 0)
        self.assertIn("worker", self.labels(uri, "TO (", 3))

    def test_definition(self):
        self.assertEqual(self.defined_at("worker[0][link][1]"), self.declared("worker:"))
        self.assertEqual(self.defined_at("host.arc\n"), self.declared("host.arc,"))
        self.assertEqual(self.defined_at("inner:\n  PLACED"), self.declared("inner:"))
        self.assertEqual(self.defined_at("screen\n    DO"), self.declared("screen:"))
        self.assertEqual(self.defined_at("p\n      slave"), self.declared("NODE p", 5))
        self.assertEqual(self.defined_at("i] (type"), self.declared("i = 0"))
        self.assertEqual(self.definition(self.uri, "slave (up)")["uri"], (self.folder / "slave.occ").as_uri())
        self.assertEqual(self.definition(self.uri, "slave.occ")["uri"], (self.folder / "slave.occ").as_uri())
        self.assertIsNone(self.definition(self.uri, "HOST WITH"))

    def test_outline(self):
        symbols = self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": self.uri}})
        self.assertEqual([s["name"] for s in symbols], ["n", "root.node", "worker", "p", "host.arc", "inner", "screen",
                                                        "NETWORK", "MAPPING", "CONFIG"])

    def test_ten_thousand_lines(self):
        """An edit is checked within 100 ms of a processor. A question takes less than a second."""
        vals = "".join(f"VAL v{i} IS {i}:\n" for i in range(9_000))
        nodes = "".join(f"    SET more[{i}] (type, memsize := \"T800\", 65536)\n" for i in range(500))
        wires = "".join(f"    CONNECT more[{i}][link][0] TO more[{i + 1}][link][1]\n" for i in range(499))
        text = vals + CONFIGURATION.replace("NODE p:", "NODE p:\n[500]NODE more:").replace("  DO\n", "  DO\n" + nodes + wires, 1)
        uri = self.open("long.pgm", text, "occam")
        self.assertLess(self.seconds_an_edit(uri, "VAL v5000 IS 5000"), 0.1)
        begun = self.client.processor_seconds()
        self.assertIn("and 492 more", self.hover(uri, "more[0][link]"))
        self.assertIn("v8999", self.labels(uri, "slave (up)"))
        self.assertLess(self.client.processor_seconds() - begun, 1)

    def test_wrong_input_is_survived(self):
        self.survives(self.uri, CONFIGURATION, 5)


STUDY = """# \u00e9\U0001f600
netlist = "ring.cfs"
seeds = 2
measure = ["time", "max(t.busy)"]
where = "slaves > 1"

[set]
slaves = [2, 3]
sender.count = 10
"t.memory" = ["1M", "2M"]

[[also]]
set = {slaves = 2, receiver.priority = "LOW"}

[[table]]
name = "first"
columns = [
    {name = "two", set = {slaves = 2}},
    {name = "three", set = {slaves = 3}},
]
rows = [
    {name = "time", figure = "time", known = [1, 2], judge = "own"},
]
judged = true

[[table]]
name = "second"
like = "first"
"""


class Studies(LanguageTest):
    def setUp(self):
        super().setUp()
        (self.folder / "ring.cfs").write_text(NETLIST)
        self.uri = self.open("a.toml", STUDY, "toml")

    def test_keys_are_completed_by_their_table(self):
        keys = self.labels(self.uri, "seeds")
        for word in ("netlist", "seeds", "measure", "set", "also", "table", "search", "until", "price"):
            self.assertIn(word, keys)
        self.assertNotIn("known", keys)
        rows = self.labels(self.uri, "judge =")
        for word in ("figure", "known", "tolerance", "origin", "at_least", "interval"):
            self.assertIn(word, rows)
        self.assertNotIn("seeds", rows)
        self.assertEqual(sorted(self.labels(self.uri, 'name = "three"')), ["name", "set"])
        self.assertEqual(sorted(self.labels(self.uri, "set = {slaves = 2, r")), ["set", "where"])
        self.assertIn("columns", self.labels(self.uri, "judged"))
        self.assertEqual(sorted(self.labels(self.uri, "also")), ["also", "price", "relative_to", "search", "set", "table", "use"])
        self.client.edit(self.uri, (0, 0, "[search]\n\n"))
        self.assertEqual(self.labels(self.uri, "\n#", 0), ["minimise", "population", "generations", "seed"])

    def test_settings_are_those_of_the_netlist(self):
        for words in ("slaves = [", "slaves = 2, r", "slaves = 3}"):
            names = self.labels(self.uri, words)
            for name in ("slaves", "sender.count", "count", "t.memory", "memory"):
                self.assertIn(name, names)
            self.assertNotIn("seeds", names)
        self.assertIn("count", self.labels(self.uri, "sender.count", 7))
        self.assertNotIn("memory", self.labels(self.uri, "sender.count", 7))
        self.assertIn("memory", self.labels(self.uri, "t.memory", 2))

    def test_values(self):
        measures = ["links", "price", "processors", *(f"receiver.{each}" for each in ("last_number", "rate", "time", "time_per_packet")),
                    "t.busy", "time"]
        self.assertEqual(self.labels(self.uri, '"max(t'), [f'"{each}"' for each in measures])
        self.assertEqual(self.labels(self.uri, "time", 2), measures)
        self.assertEqual(self.labels(self.uri, "t.busy", 2), ["busy"])
        self.assertIn("slaves", self.labels(self.uri, "slaves > 1", 2))
        self.assertEqual(self.labels(self.uri, '"own"', 1), ["thesis", "published", "own"])
        self.assertEqual(self.labels(self.uri, "true"), ["true", "false"])
        self.assertEqual(self.labels(self.uri, '"first"\n'), [])
        self.client.replace(self.uri, 'like = "first"', "like = ")
        self.assertEqual(self.labels(self.uri, "like = ", 7), ['"first"', '"second"'])
        self.assertEqual(self.labels(self.uri, "\u00e9"), [])

    def test_a_text_that_is_not_yet_a_study_is_completed(self):
        begun = 'netlist = "ring.cfs"\nmeasure = ["time", "\nseeds = 3\nset = {sl\n[search]\nmini\n'
        uri = self.open("b.toml", begun, "toml")
        self.assertGreater(len(self.client.checked(uri)), 0)
        self.assertIn("t.busy", self.labels(uri, '"\nseeds', 1))
        self.assertIn("sender.count", self.labels(uri, "sl\n", 2))
        self.assertIn("minimise", self.labels(uri, "mini", 4))

    def test_hover(self):
        self.assertEqual(self.hover(self.uri, "seeds"),
                         "seeds: a whole number, 1 or more\nnumber of seeds with which each combination is run\n")
        self.assertIn("true or false", self.hover(self.uri, "judged"))
        self.assertIn("a list of {name, set}", self.hover(self.uri, "columns"))
        self.assertIn("val slaves 3;", self.hover(self.uri, "slaves = [2"))
        count = self.hover(self.uri, "sender.count", 8)
        self.assertIn("count", count)
        self.assertIn(count.strip().split("\n")[0].strip(), placedpar("kinds", "csp.producer").stdout)
        self.assertIn("memory", self.hover(self.uri, "t.memory", 3))
        self.assertIn("length of the run in ms", self.hover(self.uri, "time"))
        self.assertIn("load of the processor in %", self.hover(self.uri, "t.busy"))
        self.assertIn("val slaves 3;", self.hover(self.uri, "slaves > 1"))
        self.assertEqual(self.hover(self.uri, "max("), "")

    def test_definition(self):
        netlist = (self.folder / "ring.cfs").as_uri()

        def place(words, behind=0):
            found = self.definition(self.uri, words, behind)
            self.assertEqual(found["uri"], netlist)
            return found["range"]["start"]

        def declared(words, behind=0):
            return position(NETLIST, NETLIST.index(words) + behind)
        self.assertEqual(place("ring.cfs"), declared("val"))
        self.assertEqual(place("slaves = [2"), declared("slaves 3"))
        self.assertEqual(place("slaves > 1"), declared("slaves 3"))
        self.assertEqual(place("sender.count", 8), declared("count = 5"))
        self.assertEqual(place("t.memory", 3), declared("t[slaves]"))
        self.assertEqual(place("t.busy"), declared("t[slaves]"))
        self.assertEqual(self.definition(self.uri, 'like = "first"', 8)["range"]["start"],
                         position(STUDY, STUDY.index('first"')))
        self.assertIsNone(self.definition(self.uri, "seeds"))

    def test_a_change_of_the_netlist_is_seen(self):
        netlist = self.client.open(self.folder / "ring.cfs")
        self.client.checked(self.uri)
        self.assertIn("slaves", self.labels(self.uri, "slaves = ["))
        self.client.replace(netlist, "val slaves 3", "val extra 1; val slaves 3")
        self.assertIn("extra", self.labels(self.uri, "slaves = ["))

    def test_a_study_of_a_configuration(self):
        (self.folder / "master.occ").write_text(MASTER)
        (self.folder / "slave.occ").write_text(SLAVE)
        (self.folder / "a.pgm").write_text(CONFIGURATION)
        uri = self.open("c.toml", 'netlist = "a.pgm"\n[set]\n\n', "toml")
        self.assertIn("memory", self.labels(uri, "\n\n", 1))

    def test_ten_thousand_lines(self):
        """An edit is checked within 100 ms of a processor. A question takes less than a second."""
        also = "".join(f"[[also]]\n[also.set]\nslaves = 2\ncount = {i}\n" for i in range(2_500))
        uri = self.open("long.toml", STUDY + also, "toml")
        self.assertLess(self.seconds_an_edit(uri, "count = 2000"), 0.1)
        begun = self.client.processor_seconds()
        self.assertIn("val slaves", self.hover(uri, "slaves = 2\ncount = 2499"))
        self.assertIn("sender.count", self.labels(uri, "count = 2498"))
        self.assertLess(self.client.processor_seconds() - begun, 1)

    def test_wrong_input_is_survived(self):
        self.survives(self.uri, STUDY, 7)

    def test_keys_of_all_examples_are_known(self):
        """The keys of all studies of the examples have explanations."""
        for file in sorted(EXAMPLES.rglob("*.toml")):
            text = file.read_text()
            if "netlist =" not in text:
                continue
            uri = self.client.open(file, text, "toml")
            for found in re.finditer(r"(?m)^(\w+) = ", text.split("\n[")[0]):
                with self.subTest(file=file.name, key=found[1]):
                    place = {"textDocument": {"uri": uri}, "position": position(text, found.start())}
                    self.assertIn(found[1], self.client.request("textDocument/hover", place)["contents"]["value"])
            self.client.close(uri)


if __name__ == "__main__":
    unittest.main()
