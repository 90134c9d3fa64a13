"""Reads the traces that a run writes, by what their formats say and not by what the program does.

The Trace Event Format is JSON: "Trace Event Format", by the authors of chrome://tracing. A value change dump is clause 18
of IEEE Std 1364-2005.
"""

import bisect
import collections
import decimal
import json
import re

Slice = collections.namedtuple("Slice", "begin end name category arguments open")
Arrow = collections.namedtuple("Arrow", "name source left target arrived")

PICOSECONDS = 1_000_000  # picoseconds in a microsecond


def picoseconds(microseconds):
    exact = decimal.Decimal(microseconds) * PICOSECONDS
    assert exact == int(exact), microseconds
    return int(exact)


class JsonTrace:
    """A trace's content: its tracks by name in drawing order, slices by track, arrows, the end."""

    REQUIRED = {"X": {"name", "cat", "ts", "dur"}, "B": {"name", "cat", "ts"}, "s": {"name", "cat", "id", "ts"},
                "f": {"name", "cat", "id", "ts", "bp"}, "i": {"name", "cat", "ts", "s"}, "M": {"name", "args"}}
    OPTIONAL = {"X": {"args", "cname"}, "B": {"args"}}

    def __init__(self, path, has_many_clocks=False):
        """has_many_clocks: the times are those of several ranks."""
        self.has_many_clocks = has_many_clocks
        document = json.loads(path.read_text(encoding="utf-8"), parse_float=decimal.Decimal)
        self.events = document["traceEvents"]
        by_phase = collections.defaultdict(list)
        for event in self.events:
            self.check_form(event)
            by_phase[event["ph"]].append(event)
        (last,) = by_phase["i"]
        self.end, self.why = picoseconds(last["ts"]), last["name"]
        self.read_names(by_phase["M"])
        self.slices = {track: [] for track in self.tracks}
        for event in by_phase["X"] + by_phase["B"]:
            self.add_slice(event)
        for name, slices in self.slices.items():
            self.check_track(name, slices)
        self.arrows = self.read_arrows(by_phase["s"], by_phase["f"])

    def check_form(self, event):
        phase = event["ph"]
        assert phase in self.REQUIRED, event
        keys = event.keys() - {"ph", "pid", "tid"}
        assert self.REQUIRED[phase] <= keys <= self.REQUIRED[phase] | self.OPTIONAL.get(phase, set()), event
        assert isinstance(event["pid"], int) and isinstance(event["tid"], int) and event["pid"] > 0 and event["tid"] > 0
        assert event["name"], event

    def read_names(self, metadata):
        said = collections.defaultdict(dict)
        for event in metadata:
            key = (event["pid"],) if event["name"].startswith("process_") else (event["pid"], event["tid"])
            assert event["name"] not in said[key], event
            said[key][event["name"]] = event["args"].get("name", event["args"].get("sort_index"))
        self.nodes = {key[0]: value["process_name"] for key, value in said.items() if len(key) == 1}
        order = {key[0]: value["process_sort_index"] for key, value in said.items() if len(key) == 1}
        keys = sorted((key for key in said if len(key) == 2), key=lambda k: (order[k[0]], said[k]["thread_sort_index"]))
        assert len({tid for _, tid in keys} | order.keys()) == len(keys) + len(order), "a number is used twice"
        self.name_of = {key: said[key]["thread_name"] for key in keys}
        self.node_of = {said[key]["thread_name"]: self.nodes[key[0]] for key in keys}
        self.tracks = list(self.name_of.values())
        assert len(set(self.tracks)) == len(self.tracks), "two tracks of one name"

    def add_slice(self, event):
        begin = picoseconds(event["ts"])
        end = begin + picoseconds(event["dur"]) if event["ph"] == "X" else self.end
        self.slices[self.name_of[event["pid"], event["tid"]]].append(
            Slice(begin, end, event["name"], event["cat"], event.get("args", {}), event["ph"] == "B"))

    def check_track(self, name, slices):
        """Checks that the slices are in order, do not overlap, and have a length."""
        for each in slices:
            assert each.begin < each.end or each.open, (name, each)
            assert each.end <= self.end, (name, each)
        for before, after in zip(slices, slices[1:]):
            assert not before.open and before.end <= after.begin, (name, before, after)

    def read_arrows(self, starts, ends):
        assert len({e["id"] for e in starts}) == len(starts) and len({e["id"] for e in ends}) == len(ends)
        end_of = {event["id"]: event for event in ends}
        assert end_of.keys() == {e["id"] for e in starts}
        arrows = []
        for start in starts:
            end = end_of[start["id"]]
            assert (start["name"], start["cat"], end["bp"]) == (end["name"], end["cat"], "e")
            arrow = Arrow(start["name"], self.name_of[start["pid"], start["tid"]], picoseconds(start["ts"]),
                          self.name_of[end["pid"], end["tid"]], picoseconds(end["ts"]))
            assert arrow.left <= arrow.arrived, arrow
            for track, at in ((arrow.source, arrow.left), (arrow.target, arrow.arrived)):
                # By the clocks of two ranks a message may arrive before it leaves: then it takes no time.
                assert self.lies_in_a_slice(track, at) or (self.has_many_clocks and arrow.left == arrow.arrived), (arrow, track)
            arrows.append(arrow)
        return arrows

    def lies_in_a_slice(self, track, at):
        slices = self.slices[track]
        last = bisect.bisect_right(slices, at, key=lambda each: each.begin) - 1
        return last >= 0 and (at < slices[last].end or slices[last].open)

    def of_category(self, track, category):
        return [each for each in self.slices[track] if each.category == category]

    def processes(self):
        """Returns the tracks of processes, without tracks of components."""
        return [t for t in self.tracks if "/" not in t and not t.startswith("processor ") and " -> " not in t]

    def components(self, process):
        return [t for t in self.tracks if t == process or t.startswith(process + "/")]

    def waiting(self, process):
        """Returns how long neither the process nor a component of its PARs computed or was ready."""
        lives = [s for t in self.components(process) for s in self.slices[t]]
        if not lives:
            return 0
        going_on = [(s.begin, s.end) for s in lives if s.category in ("compute", "ready")]
        return max(s.end for s in lives) - min(s.begin for s in lives) - measure(going_on)


def measure(intervals):
    """Returns the total time covered by the intervals."""
    covered, until = 0, None
    for begin, end in sorted(intervals):
        if until is None or begin > until:
            covered += end - begin
            until = end
        elif end > until:
            covered += end - until
            until = end
    return covered


class VcdTrace:
    """Returns the wires of a value change dump, by path: (time, value) at each change."""

    IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_$]*\Z")
    CODE = re.compile(r"[!-~]+\Z")

    def __init__(self, path):
        self.tokens = iter(path.read_text(encoding="ascii").split())
        self.wires, self.codes, self.scopes = {}, {}, []
        self.names_in_scope = collections.defaultdict(set)
        self.comment = ""
        self.read_declarations()
        self.read_changes()

    def until_end(self):
        words = []
        for token in self.tokens:
            if token == "$end":
                return words
            words.append(token)
        raise AssertionError("$end is missing")

    def read_declarations(self):
        seen = []
        for token in self.tokens:
            words = self.until_end()
            seen.append(token)
            if token == "$scope":
                kind, name = words
                assert kind == "module"
                self.declare_name(name)
                self.scopes.append(name)
            elif token == "$upscope":
                assert not words
                self.scopes.pop()
            elif token == "$var":
                kind, size, code, name = words
                assert (kind, size) == ("wire", "1") and self.CODE.match(code) and code not in self.codes
                self.declare_name(name)
                self.codes[code] = ".".join(self.scopes + [name])
            elif token == "$timescale":
                assert words in (["1", "ps"], ["1ps"])
            elif token == "$comment":
                self.comment = " ".join(words)
            elif token == "$enddefinitions":
                break
            else:
                assert token == "$version", token
        assert not self.scopes and seen.count("$timescale") == 1 and seen[-1] == "$enddefinitions"

    def declare_name(self, name):
        assert self.IDENTIFIER.match(name), name
        scope = ".".join(self.scopes)
        assert name not in self.names_in_scope[scope], (scope, name)
        self.names_in_scope[scope].add(name)

    def read_changes(self):
        self.wires = {path: [] for path in self.codes.values()}
        time, dumping, changed = None, False, set()
        for token in self.tokens:
            if token.startswith("#"):
                assert time is None or int(token[1:]) > time, token
                if time is None:
                    self.begin = int(token[1:])
                time, changed = int(token[1:]), set()
            elif token == "$dumpvars":
                assert time == self.begin and not dumping
                dumping = True
            elif token == "$end":
                assert dumping and changed == self.codes.keys()
                dumping, changed = False, set()
            else:
                value, code = token[0], token[1:]
                assert value in "01" and code in self.codes and code not in changed, token
                changed.add(code)
                wire = self.wires[self.codes[code]]
                assert not wire or wire[-1][1] != int(value), "no change"
                wire.append((time, int(value)))
        self.end = time

    def on(self, path):
        """Returns the intervals in which a wire is 1."""
        wire = self.wires[path] + [(self.end, 0)]
        return [(a[0], b[0]) for a, b in zip(wire, wire[1:]) if a[1] == 1]
