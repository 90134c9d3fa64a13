"""Tests placedpar language-server as an editor uses it: texts that are edited, questions, and wrong messages."""

import json
import random
import re
import unittest

from language_client import LanguageClient, LanguageTest, position
from program import EXAMPLES, placedpar

NETLIST = """/* \u00e9\U0001f600 */ val n 3; /* number */
T800 (memory = 1M) t[n];
process (interface (input in, output out)) ring[n];
use "csp.identity" for ring;
rep i = 0 for n {
    connect t[i].link[0] to t[(i + 1) % n].link[1];
    connect ring[i].out to ring[(i + 1) % n].in;
    place ring[i] on t[i];
}
"""

PROGRAM_TEXT = """#INCLUDE "hostio.inc"
#USE "hostio.lib"
PROC square (CHAN OF INT from, to)
  INT x:
  SEQ -- \u00e9\U0001f600
    from ? x
    to ! x * x
:
PROC main (CHAN OF SP fs, ts)
  CHAN OF INT a, b:
  PAR
    square (a, b)
    INT result:
    SEQ
      a ! 7
      b ? result
      so.write.string.nl (fs, ts, "done")
      so.exit (fs, ts, 0)
:
"""


class LanguageServer(LanguageTest):
    # Diagnostics

    def test_an_error_is_underlined_as_one_types_and_goes(self):
        uri = self.open("a.cfs", NETLIST)
        self.assertEqual(self.client.checked(uri), [])
        self.client.replace(uri, "csp.identity", "csp.identify")
        (wrong,) = self.client.checked(uri)
        self.assertEqual(self.client.underlined(uri, wrong), "use")
        self.assertIn('did you mean "csp.identity"?', wrong["message"])
        self.client.replace(uri, "csp.identify", "csp.identity")
        self.assertEqual(self.client.checked(uri), [])
        self.client.replace(uri, "3;", "\U0001f600 3;")
        self.assertEqual(self.underlined(uri)[0], "\U0001f600")

    def test_errors_are_those_of_check(self):
        text = NETLIST.replace("val n 3", "val n 3 val").replace("ring[i].out", "rind[i].out") + "T800 t;\n"
        uri = self.open("a.cfs", text)
        said = json.loads(placedpar("check", self.folder / "a.cfs", "--format", "json").stdout)["diagnostics"]
        self.assertGreater(len(said), 0)
        lines = text.encode().split(b"\n")
        for mine, theirs in zip(self.client.checked(uri), said, strict=True):
            line = lines[theirs["line"] - 1]
            self.assertEqual(self.client.underlined(uri, mine), line[theirs["column"] - 1:theirs["end_column"] - 1].decode())
            self.assertEqual(mine["message"].split("\nhint: ")[0], theirs["message"])
            self.assertEqual(len(mine["relatedInformation"]), len(theirs["also"]))

    def test_many_edits_are_as_opening_the_text(self):
        rng = random.Random(3)
        uri = self.open("a.cfs", NETLIST)
        pieces = ["\n", " ", "}", "{", ";", "val m 2;", "\U0001f600", "\u00e9", "/* \u00e9", "*/", "ring", "\r\n", '"', "3"]
        for _ in range(60):
            for _ in range(rng.randint(1, 3)):
                text = self.client.texts[uri]
                first = rng.randint(0, len(text))
                last = min(len(text), first + rng.choice((0, 0, 1, 5)))
                if text[max(0, first - 1):first + 1] == "\r\n" or text[max(0, last - 1):last + 1] == "\r\n":
                    continue
                self.client.edit(uri, (first, last, rng.choice(pieces)))
            edited = self.client.checked(uri)
            self.client.close(uri)
            self.assertEqual(self.client.open(self.folder / "a.cfs", self.client.texts[uri]), uri)
            self.client.diagnostics.pop(uri)
            self.assertEqual(self.client.checked(uri), edited)
            if rng.random() < 0.2:
                self.client.close(uri)
                self.client.open(self.folder / "a.cfs", NETLIST)

    def test_an_included_file_is_read_as_it_is_open(self):
        (self.folder / "part.inc").write_text("val m 3;\n")
        uri = self.open("main.cfs", '#include "part.inc"\n' + NETLIST.replace("val n 3", "val n m"))
        self.assertEqual(self.client.checked(uri), [])
        part = self.client.open(self.folder / "part.inc")
        self.client.replace(part, "m 3", "mm 3")
        while not self.client.diagnostics[uri]["diagnostics"]:
            self.client.receive()
        self.assertEqual(self.underlined(uri)[0], "m")
        self.client.replace(part, "mm 3", "m = 3")
        while not self.client.diagnostics.get(part, {"diagnostics": []})["diagnostics"]:
            self.client.receive()
        self.assertEqual(self.underlined(part), ["="])
        self.client.close(part)
        while self.client.diagnostics[uri]["diagnostics"]:
            self.client.receive()

    def wait_for(self, uri, words):
        """Waits until the messages about a text are those that have these words: one each."""
        def have_come():
            found = [each["message"] for each in self.client.diagnostics[uri]["diagnostics"]]
            return len(found) == len(words) and all(word in message for word, message in zip(words, found, strict=True))
        while not have_come():
            self.assertIsNotNone(self.client.receive())

    def test_files_that_appear_or_change_later_are_read(self):
        uri = self.open("main.cfs", '#include "part.inc"\n' + NETLIST.replace("val n 3", "val n m"))
        self.assertIn("this file does not exist", self.client.checked(uri)[0]["message"])
        part = self.client.open(self.folder / "part.inc", "val m 3;\n")
        self.wait_for(uri, [])
        self.client.close(part)
        self.wait_for(uri, ["this file does not exist"])
        (self.folder / "part.inc").write_text("val m 3;\n")
        self.client.notify("textDocument/didSave", {"textDocument": {"uri": uri}})
        self.wait_for(uri, [])
        (self.folder / "part.inc").write_text("val k 3;\n")
        self.client.notify("textDocument/didSave", {"textDocument": {"uri": uri}})
        self.wait_for(uri, ['the name "m" is undefined'])

    def test_a_change_without_a_version_is_checked(self):
        uri = self.open("a.cfs", NETLIST)
        self.assertEqual(self.client.checked(uri), [])
        self.client.notify("textDocument/didChange", {"textDocument": {"uri": uri, "version": None},
                                                      "contentChanges": [{"text": NETLIST.replace("val n 3", "val n m")}]})
        self.wait_for(uri, ['the name "m" is undefined'])
        self.assertNotIn("version", self.client.diagnostics[uri])

    def test_a_file_that_is_to_be_included_is_read_alone(self):
        netlist = self.client.open(self.folder / "part.inc", "process p;\nplace p on ;\n")
        self.assertEqual(self.underlined(netlist), [";"])
        self.client.replace(netlist, "on ;", "on somewhere;")
        self.assertEqual(self.client.checked(netlist), [])
        occam = self.client.open(self.folder / "occam.inc", "VAL INT n IS 3:\nPROTOCOL P IS INT\n", "plaintext")
        self.assertEqual(len(self.client.checked(occam)), 1)

    def test_occam_studies_and_configurations_are_checked(self):
        occam = self.open("a.occ", PROGRAM_TEXT, "occam")
        self.assertEqual(self.client.checked(occam), [])
        self.client.replace(occam, "to ! x * x", "to ! x * yy.y")
        self.assertEqual(self.underlined(occam), ["yy.y"])
        (self.folder / "ring.cfs").write_text(NETLIST)
        study = self.open("a.toml", 'netlist = "ring.cfs"\n# \U0001f600\nsedes = 3\n', "toml")
        self.assertEqual(self.underlined(study), ["sedes"])
        self.client.replace(study, "sedes", "seeds")
        self.assertEqual(self.client.checked(study), [])
        self.client.replace(study, "seeds = 3", "[set]\nm = [1, 2]")
        self.assertIn('"m"', self.client.checked(study)[0]["message"])
        self.client.replace(study, "ring.cfs", "missing.cfs")
        self.assertIn("missing.cfs: this file does not exist", self.client.checked(study)[0]["message"])
        self.assertNotIn((self.folder / "missing.cfs").as_uri(), self.client.diagnostics)
        other = self.open("Cargo.toml", '[package]\nname = "other"\n', "toml")
        self.assertEqual(self.client.checked(other), [])
        configuration = self.open("a.pgm", 'NODE n:\nNETWORK\n  SET m (type, memsize := "T800", 1024)\n:\n', "occam")
        self.assertEqual(self.underlined(configuration), ["", "m"]) # the first is about the file as a whole

    # Questions

    def test_hover_in_a_netlist(self):
        uri = self.open("a.cfs", NETLIST.replace("use ", "connection (length = 2) c;\nuse "))
        self.assertEqual(self.hover(uri, "csp.identity"), placedpar("kinds", "csp.identity").stdout)
        self.assertEqual(self.hover(uri, "T800"), placedpar("kinds", "T800").stdout)
        self.assertIn("bytes", self.hover(uri, "memory"))
        self.assertIn("0 .. 1000", self.hover(uri, "length"))
        self.assertIn("output out", self.hover(uri, "ring[i].out", len("ring[i].o")))
        self.assertIn("link[0] to link[3]", self.hover(uri, "link[0]"))
        self.assertIn("val n 3; /* number */", self.hover(uri, "t[n]", 2))
        self.assertEqual(self.hover(uri, "number"), "")

    def test_hover_in_occam_has_the_cycles_of_a_line(self):
        uri = self.open("a.occ", PROGRAM_TEXT, "occam")
        self.assertRegex(self.hover(uri, "to ! x * x", 3), r"\d+ instructions, \d+ (or more|to \d+) cycles on a T800\n")
        self.assertIn("INT x:", self.hover(uri, "x * x"))
        self.assertIn("PROC square (CHAN OF INT from, to)", self.hover(uri, "square (a"))
        simple = self.open("b.occ", "PROC p ()\n  INT x:\n  SEQ\n    x := 1\n    x := 2\n:\n", "occam")
        self.assertEqual(self.hover(simple, "x := 1", 3), "2 instructions, 2 cycles on a T800\n") # ldc 1; stl x

    def test_completion_in_a_netlist(self):
        extended = NETLIST + "ring (count = 1);\nprocess q;\nuse \"\" for q;\nconnect ring.\nT800 (\n"
        uri = self.open("a.cfs", extended)
        self.assertIn("csp.identity", self.labels(uri, '""', 1))
        self.assertEqual(sorted(self.labels(uri, "ring.\n", 5)), ["in", "out"])
        self.assertIn("count", self.labels(uri, "count"))
        self.assertIn("memory", self.labels(uri, "memory"))
        for word in ("connect", "T800", "ring", "fault"):
            self.assertIn(word, self.labels(uri, "connect t"))
        self.assertEqual(self.labels(uri, "t[i];"), ["t"])
        self.assertEqual(self.labels(uri, "number"), [])
        self.assertIn("n", self.labels(uri, "n {"))
        self.assertEqual(sorted(self.labels(uri, "link[0]")), ["link[0]", "link[1]", "link[2]", "link[3]"])

    def test_completion_in_occam(self):
        uri = self.open("a.occ", PROGRAM_TEXT, "occam")
        labels = self.labels(uri, "so.exit")
        for word in ("so.write.string.nl", "square", "result", "SEQ", "RETYPES"):
            self.assertIn(word, labels)
        self.assertNotIn("x", labels)
        self.assertIn("x", self.labels(uri, "to ! x"))
        self.client.replace(uri, "so.exit (fs", "so.")
        self.assertIn("so.exit", self.labels(uri, "so., ts", 3))
        self.assertIn("hostio.lib", self.labels(uri, "hostio.lib"))

    def test_definitions(self):
        (self.folder / "part.inc").write_text("val m 3;\n")
        uri = self.open("main.cfs", '#include "part.inc"\n' + NETLIST.replace("val n 3", "val n m"))
        part = (self.folder / "part.inc").as_uri()
        found = self.definition(uri, "m;")
        self.assertEqual((found["uri"], found["range"]), (part, {"start": {"line": 0, "character": 4}, "end": {"line": 0, "character": 5}}))
        self.assertEqual(self.definition(uri, "part.inc")["uri"], part)
        self.assertEqual(self.definition(uri, "ring[i].out")["range"]["start"], position(self.client.texts[uri], NETLIST.index("ring[n]") + 20))
        self.assertIsNone(self.definition(uri, "memory"))
        (self.folder / "part.occ").write_text("PROC part ()\n  SKIP\n:\n")
        occam = self.open("a.occ", '#INCLUDE "part.occ"\nPROC p ()\n  INT value:\n  SEQ\n    value := 1\n    part ()\n:\n', "occam")
        self.assertEqual(self.definition(occam, "value :=")["range"]["start"], {"line": 2, "character": 6})
        self.assertEqual(self.definition(occam, "part ()")["uri"], (self.folder / "part.occ").as_uri())
        self.assertEqual(self.definition(occam, "part.occ")["uri"], (self.folder / "part.occ").as_uri())

    def test_rename(self):
        uri = self.open("a.cfs", NETLIST)
        before = placedpar("show", self.folder / "a.cfs").stdout
        edits = self.client.request("textDocument/rename", {**self.client.at(uri, "ring[i].out"), "newName": "circle"})
        text = self.client.applied(uri, edits["changes"][uri])
        self.assertEqual(text, NETLIST.replace("ring", "circle"))
        (self.folder / "a.cfs").write_text(text)
        self.assertEqual(placedpar("show", self.folder / "a.cfs").stdout, before.replace("ring", "circle"))
        part = self.open("part.inc", "process (interface (input in, output out)) ring;\nconnect ring.out to ring.in;\n")
        edits = self.client.request("textDocument/rename", {**self.client.at(part, "ring"), "newName": "circle"})
        self.assertEqual(self.client.applied(part, edits["changes"][part]),
                         "process (interface (input in, output out)) circle;\nconnect circle.out to circle.in;\n")
        shadow = self.open("b.cfs", "val i 2;\nrep i = 0 for i {\n    T800 t;\n}\nT800 u[i];\n")
        edits = self.client.request("textDocument/rename", {**self.client.at(shadow, "i 2"), "newName": "j"})
        self.assertEqual(self.client.applied(shadow, edits["changes"][shadow]),
                         "val j 2;\nrep i = 0 for j {\n    T800 t;\n}\nT800 u[j];\n")

    def test_a_rename_is_refused_where_it_would_be_incomplete(self):
        (self.folder / "part.inc").write_text("val m n;\n")
        uri = self.open("main.cfs", NETLIST + '#include "part.inc"\n')

        def refused(words, name):
            return self.client.answer("textDocument/rename", {**self.client.at(uri, words), "newName": name})["error"]["message"]
        self.assertIn(f'"n" is also used in {self.folder}/part.inc, line 1', refused("n 3", "nn"))
        self.assertIn("is declared already", refused("ring[n]", "t"))
        for name in ("host", "T425"):
            self.assertIn(f'"{name}" is predefined', refused("ring[n]", name))
        self.assertIn("cannot be a name", refused("ring[n]", "connect"))
        self.assertIn("cannot be renamed", refused("memory", "store"))
        part = self.client.open(self.folder / "part.inc")
        self.client.checked(uri)
        answer = self.client.answer("textDocument/rename", {**self.client.at(part, "m"), "newName": "mm"})
        self.assertIn("includes this file", answer["error"]["message"])

    def test_outline(self):
        uri = self.open("a.cfs", NETLIST)
        symbols = self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": uri}})
        self.assertEqual([s["name"] for s in symbols], ["n", "t", "ring"])
        occam = self.open("a.occ", PROGRAM_TEXT, "occam")
        symbols = self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": occam}})
        self.assertEqual([s["name"] for s in symbols], ["square", "main"])

    # Layout

    def laid_out(self, uri):
        edits = self.client.request("textDocument/formatting", {"textDocument": {"uri": uri}, "options": {"tabSize": 4, "insertSpaces": True}})
        return self.client.texts[uri] if edits is None else self.client.applied(uri, edits)

    def test_layout_of_every_example(self):
        """The words and comments stay, a second time changes nothing, and most examples have this layout."""
        same = 0
        files = sorted(EXAMPLES.rglob("*.cfs"))
        for file in files:
            with self.subTest(file.name):
                text = file.read_text()
                uri = self.open(file.name, text)
                once = self.laid_out(uri)
                self.assertEqual(re.sub(r"\s+", "", once), re.sub(r"\s+", "", text))
                flat = re.sub(r"(?m)^[ \t]+(?![^/]*\*/)", "", text) if "/*" not in text else text
                mangled = self.client.open(self.folder / "mangled.cfs", re.sub(r"(?m)[ \t]*$", "  ", flat))
                self.assertEqual(self.laid_out(mangled).split(), text.split())
                again = self.client.open(self.folder / ("again-" + file.name), once)
                self.assertEqual(self.laid_out(again), once)
                same += once == text
                self.client.close(uri)
                self.client.close(again)
        self.assertGreater(same, len(files) * 3 // 4)

    def test_layout_of_a_netlist_and_of_occam(self):
        uri = self.open("a.cfs", "val a -1 ;val b a+ -2*( 3 );\n\n\n   if a==b{\nT800 (memory=1M,\nroutecost = 3) t [2];\n"
                                 "rep i=0 for 2\nconnect t[ i ].link[0],edge;   /* why */\n  } else\nT800 u;  \n/* end\n     of it */")
        self.assertEqual(self.laid_out(uri), """val a -1; val b a + -2 * (3);

if a == b {
    T800 (memory = 1M,
          routecost = 3) t[2];
    rep i = 0 for 2
        connect t[i].link[0], edge;   /* why */
} else
    T800 u;
/* end
     of it */
""")
        minus = self.open("minus.cfs", "val a 1;\nval b\n- -a;\nval c a - -1;\n")
        self.assertEqual(self.laid_out(minus), "val a 1;\nval b\n    - -a;\nval c a - -1;\n")
        wrong = self.open("b.cfs", "val a  ;;")
        self.assertEqual(self.laid_out(wrong), "val a  ;;")
        occam = self.open("a.occ", "PROC p ()  \n\tSKIP  -- \t x \n:", "occam")
        self.assertEqual(self.laid_out(occam), "PROC p ()\n        SKIP  -- \t x\n:\n")

    # Messages

    def test_wrong_messages_are_answered_and_do_no_harm(self):
        client, uri = self.client, self.open("a.cfs", NETLIST)

        def error(data):
            client.send_bytes(data)
            while True:
                message = client.receive()
                if "error" in message:
                    return message["error"]["code"]

        def framed(body):
            return b"Content-Length: %d\r\n\r\n" % len(body) + body
        self.assertEqual(error(framed(b"{nonsense")), -32700)
        self.assertEqual(error(framed(b"[1, 2]")), -32600)
        self.assertEqual(error(framed(b'{"jsonrpc": "2.0", "id": 7}')), -32600)
        self.assertEqual(error(framed(b"[" * 100_000)), -32700)
        self.assertEqual(error(framed(b'\xff\xfe{"id": 1}')), -32700)
        self.assertEqual(error(b"Content-Length: many\r\n\r\n"), -32700)
        self.assertEqual(error(b"Content-Length: 99999999999\r\n\r\n"), -32700)
        self.assertEqual(error(b"Content-Length: -5\r\n\r\n"), -32700)
        self.assertEqual(error(b"Content-Type: text\r\n\r\n"), -32700)
        good = framed(b'{"jsonrpc": "2.0", "id": 8, "method": "no/such", "params": {}}')
        self.assertEqual(error(good.replace(b": 62", b": 40")), -32700) # what follows is found again
        self.assertEqual(error(good), -32601)
        self.assertEqual(error(b"x" * 20_000 + good), -32601)

        def code(method, params):
            return client.answer(method, params)["error"]["code"]
        place = {"textDocument": {"uri": uri}, "position": {"line": 99, "character": 0}}
        self.assertEqual(code("textDocument/hover", place), -32602)
        self.assertEqual(code("textDocument/hover", {**place, "position": {"line": -1, "character": 0}}), -32602)
        self.assertEqual(code("textDocument/hover", {**place, "position": None}), -32602)
        self.assertEqual(code("textDocument/hover", {**place, "textDocument": {"uri": "file:///nowhere"}}), -32602)
        self.assertEqual(code("textDocument/hover", [1]), -32602)
        far = {**place, "position": {"line": 0, "character": 10 ** 9}}
        self.assertIsNone(client.request("textDocument/hover", far)) # the end of the line
        client.notify("textDocument/didChange", {"textDocument": {"uri": uri, "version": 2}, "contentChanges": [
            {"range": {"start": {"line": 0, "character": 0}, "end": {"line": 98, "character": 0}}, "text": ""}]})
        client.notify("no/such", {})
        client.notify("$/cancelRequest", {"id": 1})
        self.assertIn("csp.identity", self.hover(uri, "csp.identity"))
        self.assertEqual(len(client.logged), 2, client.logged)
        self.assertIn("line 98 does not exist: the number of lines is", client.logged[0])

    def test_the_course_of_a_session(self):
        client = LanguageClient(initialize=False)
        self.assertEqual(client.answer("textDocument/hover", {})["error"]["code"], -32002)
        self.assertEqual(client.request("initialize", {"capabilities": {}})["capabilities"]["positionEncoding"], "utf-16")
        self.assertEqual(client.request("shutdown", None), None)
        self.assertEqual(client.answer("textDocument/hover", {})["error"]["code"], -32600)
        self.assertEqual(client.end_without_shutdown(), 0)
        rude = LanguageClient()
        self.assertEqual(rude.end_without_shutdown(), 1)
        gone = LanguageClient()
        gone.process.stdin.close()
        self.assertEqual(gone.process.wait(60), 1)
        gone.process.stdout.close()

    def test_ten_thousand_lines(self):
        """An edit in a text of 10,000 lines is checked within 100 ms of a processor."""
        statements = "".join(f"val v{i} {i}; /* \u00e9 */\n" for i in range(9_000))
        processors = "".join(f"T800 (memory = 1M) t{i};\n" for i in range(500))
        wires = "".join(f"connect t{i}.link[0] to t{i + 1}.link[1];\n" for i in range(499))
        netlist = self.open("a.cfs", statements + processors + wires + "val last 1;\n")
        lines = "".join(f"    x := (x + {i}) /\\ 255\n" for i in range(10_000))
        occam = self.open("a.occ", "PROC p ()\n  INT x:\n  SEQ\n    x := 0\n" + lines + ":\n", "occam")
        for uri, digit in ((netlist, "val last 1"), (occam, "x + 5000")):
            self.assertLess(self.seconds_an_edit(uri, digit), 0.1)

    def test_questions_about_ten_thousand_lines(self):
        """Each takes less than a second of a processor, with thousands of names, places or changes."""
        uses = "".join(f"val u{i} n;\n" for i in range(5_000))
        netlist = self.open("a.cfs", "val n 1;\n" + uses + "".join(f"val v{i} {i};\n" for i in range(5_000)) + "T800 t;\n")
        lines = "".join(f"    x := (x + {i}) /\\ 255\n" for i in range(10_000))
        occam = self.open("a.occ", "PROC p ()\n  INT x:\n  SEQ\n    x := 0\n" + lines + ":\n", "occam")
        self.assertEqual(self.client.checked(netlist) + self.client.checked(occam), [])

        def renamed():
            place = {**self.client.at(netlist, "n 1"), "newName": "m"}
            return len(self.client.request("textDocument/rename", place)["changes"][netlist])

        def changed():
            self.client.edit(netlist, *[(0, 0, " ")] * 3_000)
            return len(self.client.checked(netlist))
        questions = ((lambda: len(self.client.request("textDocument/documentSymbol", {"textDocument": {"uri": netlist}})), 10_002),
                     (renamed, 5_001), (changed, 0), (lambda: self.labels(occam, "x + 9999").count("x"), 1))
        for ask, answer in questions:
            begun = self.client.processor_seconds()
            self.assertEqual(ask(), answer)
            self.assertLess(self.client.processor_seconds() - begun, 1)


if __name__ == "__main__":
    unittest.main()
