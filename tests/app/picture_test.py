"""Tests the drawing of placedpar show --format svg, read as XML and measured."""

import itertools
import json
import math
import pathlib
import re
import resource
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from made_up_networks import MADE_UP, SEVERAL_BLOCKS, STAR, TORUS, TREE, random_network
from program import EXAMPLES, placedpar

SVG = "{http://www.w3.org/2000/svg}"
LETTER = {"name": 13 * 0.66, "facts": 10 * 0.58, "process": 11 * 0.58, "kind": 9 * 0.58, "inside": 9 * 0.58,
          "link": 9 * 0.58, "count": 10 * 0.58, "key": 10 * 0.58, "title": 14 * 0.66}

LARGE = [f"{topology} --size {size} --host node" for topology, sizes in {
    "pipeline": ["220"], "ring": ["64", "300"], "tree": ["255"], "mesh": ["15x20"], "torus": ["8x8", "20x15"], "hypercube": ["16"],
    "cube-connected-cycles": ["384"], "star": ["5"], "chordal-ring": ["64", "250"], "figure-e2": ["60x4"]}.items() for size in sizes]


class Box:
    def __init__(self, left, top, right, bottom, what=""):
        self.left, self.top, self.right, self.bottom, self.what = left, top, right, bottom, what

    centre = property(lambda self: ((self.left + self.right) / 2, (self.top + self.bottom) / 2))

    def overlaps(self, other):
        return (self.left < other.right - 0.1 and other.left < self.right - 0.1 and self.top < other.bottom - 0.1 and
                other.top < self.bottom - 0.1)

    def holds(self, other, slack=0.0):
        return (self.left - slack <= other.left and other.right <= self.right + slack and self.top <= other.top and
                other.bottom <= self.bottom)

    def contains(self, x, y):
        return self.left + 0.5 < x < self.right - 0.5 and self.top + 0.5 < y < self.bottom - 0.5

    def __repr__(self):
        return f"{self.what} at {self.left} {self.top} {self.right} {self.bottom}"


def box_of(element):
    """Returns the box of a rectangle or an ellipse."""
    number = lambda name: float(element.get(name))  # noqa: E731
    if element.tag == SVG + "ellipse":
        return Box(number("cx") - number("rx"), number("cy") - number("ry"), number("cx") + number("rx"),
                   number("cy") + number("ry"))
    return Box(number("x"), number("y"), number("x") + number("width"), number("y") + number("height"))


def text_box(element, dx=0.0, dy=0.0):
    style = element.get("class").split()[0]
    height = LETTER[style] / 0.6
    width = len(element.text) * LETTER[style]
    x, y = float(element.get("x")) + dx, float(element.get("y")) + dy
    if style in ("name", "facts", "inside", "link"):
        x -= width / 2
    if style == "kind":
        x -= width
    return Box(x, y - 0.75 * height, x + width, y + 0.2 * height, element.text)


def points_of(data):
    """Returns points on a path a few pixels apart; for a curve, its corners."""
    corners = [tuple(map(float, pair)) for pair in re.findall(r"[MLQ ](-?[\d.]+) (-?[\d.]+)", data)]
    for (x, y), (to_x, to_y) in itertools.pairwise(corners) if hasattr(itertools, "pairwise") else zip(corners, corners[1:]):
        steps = int(max(abs(to_x - x), abs(to_y - y)) / 4) + 1
        for step in range(steps + 1):
            yield x + (to_x - x) * step / steps, y + (to_y - y) * step / steps


class Drawing:
    def __init__(self, text):
        self.root = ElementTree.fromstring(text)
        elements = list(self.root.iter())
        self.nodes = [(each.get("data-node"), each.get("class").split()[1], self.frame(each)) for each in elements
                      if each.get("data-node")]
        self.boxes = {name: box for name, _, box in self.nodes}
        self.wires = [(each.get("data-wire"), each.get("d")) for each in elements if each.get("data-wire")]
        self.processes = [each.get("data-process") for each in elements if each.get("data-process")]
        self.labels = [text_box(each) for each in self.root.findall(f"{SVG}text") if "link" in each.get("class")]
        self.counts = [box_of(each.find(f"{SVG}rect")) for each in self.root.findall(f"{SVG}g")
                       if each.get("class") == "channels"]
        self.channels = sum(int(each.text) for group in self.root.findall(f"{SVG}g") if group.get("class") == "channels"
                            for each in group.iter(f"{SVG}text"))

    @staticmethod
    def frame(group):
        return box_of(next(each for each in group if each.tag in (SVG + "rect", SVG + "ellipse")))

    def texts_inside(self):
        """Returns (box, texts) of each node."""
        groups = [each for each in self.root.findall(f"{SVG}g") if each.get("class") == "texts"]
        for (_, _, box), group in zip(self.nodes, groups):
            yield box, [text_box(each) for each in group.iter(f"{SVG}text")]

    def legend(self):
        found = []
        for group in self.root.findall(f"{SVG}g"):
            if group.get("class").startswith("legend"):
                dx, dy = map(float, re.findall(r"-?[\d.]+", group.get("transform")))
                found += [text_box(each, dx, dy) for each in group.iter(f"{SVG}text")]
        return found


FARM = EXAMPLES / "genetic/farms" / "farm.cfs"


def xml(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


# Examples with kinds or problems that only their own programs have, and machines whose links lead to a bus or a switch.
OTHERS = {"own-process", "own-problem", "own-policy", "busy-bus", "figure-d1", "faults-of-a-machine", "crossbar-at-run-time",
          "transputer/hello", "peek-and-poke", "transputer/network", "mixed"} # the bootable files of these are made by their pages


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "network.cfs"

    def shown(self, path, form):
        done = placedpar("show", path, "--format", form)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def drawing_of(self, text):
        self.path.write_text(text, encoding="utf-8")
        return Drawing(self.shown(self.path, "svg"))

    def check(self, path):
        text = self.shown(path, "svg")
        self.assertEqual(text, self.shown(path, "svg"))
        drawing, network = Drawing(text), json.loads(self.shown(path, "json"))
        self.check_parts(drawing, network)
        self.check_boxes(drawing)
        self.check_wires(drawing)
        return drawing

    def check_parts(self, drawing, network):
        """Checks that each node, wire and process is drawn once, and that all channels over a wire are counted."""
        self.assertEqual([node[0] for node in drawing.nodes], [node["name"] for node in network["nodes"]])
        end = lambda each: each["node"] + (f".link[{each['link']}]" if "link" in each else "")  # noqa: E731
        self.assertEqual([wire for wire, _ in drawing.wires],
                         [f"{end(wire['a'])} - {end(wire['b'])}" for wire in network["connections"]])
        self.assertEqual(sorted(drawing.processes), sorted(each["name"] for each in network["processes"]))
        self.assertEqual(drawing.channels, sum(len(each["carrier"].get("route", [0])) for each in network["channels"]
                                                      if each["carrier"]["kind"] != "soft"))

    def check_boxes(self, drawing):
        everything = [*drawing.boxes.values(), *drawing.labels, *drawing.counts, *drawing.legend()]
        for one, other in itertools.combinations(everything, 2):
            self.assertFalse(one.overlaps(other), f"{one} and {other}")
        for box, texts in drawing.texts_inside():
            for text in texts:
                self.assertTrue(box.holds(text, 2), f"{text} is not in {box}")
            for one, other in itertools.combinations(texts, 2):
                self.assertFalse(one.overlaps(other), f"{one} and {other}")
        view = list(map(float, drawing.root.get("viewBox").split()))
        sheet = Box(view[0], view[1], view[0] + view[2], view[1] + view[3])
        for each in everything:
            self.assertTrue(sheet.holds(each), f"{each} is not on the sheet")

    def check_wires(self, drawing):
        """Checks that each wire connects its two ends and crosses no box but switches."""
        switches = {name for name, kind, _ in drawing.nodes if kind == "c004"}
        for wire, data in drawing.wires:
            ends = {end.split(".link")[0] for end in wire.split(" - ")}
            for x, y in points_of(data):
                hit = [name for name, box in drawing.boxes.items() if box.contains(x, y)]
                self.assertLessEqual(set(hit), switches, f"{wire} leads through {hit}")
            points = list(points_of(data))
            for end, (x, y) in zip(wire.split(" - "), (points[0], points[-1])):
                box = drawing.boxes[end.split(".link")[0]]
                self.assertTrue(Box(box.left - 1, box.top - 1, box.right + 1, box.bottom + 1).contains(x, y), wire)
            self.assertTrue(ends <= set(drawing.boxes))

    def test_the_examples(self):
        for path in sorted(EXAMPLES.glob("*/*/*.cfs")):
            if OTHERS.isdisjoint({path.parent.name, f"{path.parent.parent.name}/{path.parent.name}"}):
                with self.subTest(path=path.name):
                    self.check(path)

    def test_booted_transputers_name_their_file(self):
        (self.path.parent / "a-program.btl").write_bytes(b"\x02\x21\xf5")
        booted = """T800 (memory = 2M) root, worker, other; connect root.link[0] to host; connect root.link[1] to worker.link[0];
            connect root.link[2] to other.link[0]; use "a-program.btl" for root;\n"""
        process = """process (interface (output out)) a; process (interface (input in)) b; use "csp.producer" for a; use "csp.consumer" for b;
            connect a.out to b.in; place a on other; place b on other;\n"""
        texts = lambda drawing: {each.text for each in drawing.root.iter(f"{SVG}text")}  # noqa: E731
        for more, expected, absent in (
                ("", {"network.cfs: 3 processors, 3 wires, 1 bootable file", "wire that carries bytes of programs"},
                 {"transputer with its processes"}),
                (process, {"network.cfs: 3 processors, 3 wires, 1 bootable file, 2 processes, 1 channel", "transputer with its processes"},
                 set())):
            self.path.write_text(booted + more, encoding="utf-8")
            shown = texts(self.check(self.path))
            self.assertLessEqual(expected | {"boots a-program.btl", "boots over its links", "transputer that executes its own code"}, shown)
            self.assertFalse(shown & (absent | {"wire without a channel"}))

    def test_made_up_networks(self):
        for name, text in MADE_UP.items():
            with self.subTest(name=name):
                self.path.write_text(text, encoding="utf-8")
                self.check(self.path)

    def test_networks_wired_at_random(self):
        for seed in range(25):
            with self.subTest(seed=seed):
                self.path.write_text(random_network(seed), encoding="utf-8")
                self.check(self.path)

    def test_wires_of_large_machines_lead_through_no_box(self):
        """Checks every point of every wire against every box, for all topologies, on both sides of the size at which a
        machine counts as large."""
        for arguments in LARGE:
            with self.subTest(arguments=arguments):
                done = placedpar("generate", *arguments.split())
                self.assertEqual(done.returncode, 0, done.stderr)
                self.path.write_text(done.stdout, encoding="utf-8")
                for software in ([], ["--software"]):
                    shown = placedpar("show", self.path, "--format", "svg", *software)
                    self.assertEqual(shown.returncode, 0, shown.stderr)
                    self.check_large(Drawing(shown.stdout))

    def test_wires_between_blocks_of_large_machines_lead_through_no_box(self):
        for name, text in SEVERAL_BLOCKS.items():
            with self.subTest(name=name):
                self.check_large(self.drawing_of(text))

    def check_large(self, drawing):
        tiles = {}
        tiles_of = lambda box: itertools.product(  # noqa: E731
            range(int(box.left // 256), int(box.right // 256) + 1), range(int(box.top // 256), int(box.bottom // 256) + 1))
        for name, box in drawing.boxes.items():
            for tile in tiles_of(box):
                for other in tiles.setdefault(tile, []):
                    self.assertFalse(box.overlaps(drawing.boxes[other]), f"{name} and {other}")
                tiles[tile].append(name)
        self.assertNotIn("nan", "".join(data for _, data in drawing.wires))
        for wire, data in drawing.wires:
            ends, points = wire.split(" - "), list(points_of(data))
            for x, y in points:
                hit = {name for name in tiles.get((int(x // 256), int(y // 256)), []) if drawing.boxes[name].contains(x, y)}
                self.assertLessEqual(hit, set(), f"{wire} leads through {hit}")
            for end, (x, y) in zip(ends, (points[0], points[-1])):
                box = drawing.boxes[re.sub(r"\.(link|slot).*", "", end)]
                self.assertTrue(Box(box.left - 1, box.top - 1, box.right + 1, box.bottom + 1).contains(x, y), wire)

    def test_the_time_for_a_drawing_grows_with_the_machine(self):
        """A machine of four times the size takes at most about four times the time; quadratic time would be 16 times."""
        def seconds(size):
            self.path.write_text(f"val n {size};\n" + TORUS, encoding="utf-8")
            least = math.inf
            for form in ("svg", "json"):
                for _ in range(2):
                    before = resource.getrusage(resource.RUSAGE_CHILDREN)
                    placedpar("show", self.path, "--format", form)
                    after = resource.getrusage(resource.RUSAGE_CHILDREN)
                    least = min(least, after.ru_utime - before.ru_utime)
                if form == "svg":
                    drawn, least = least, math.inf
            return max(drawn - least, 0.02)
        self.assertLess(seconds(48), 9 * seconds(24))

    def test_a_large_ring_is_round_and_its_host_beside_it(self):
        self.path.write_text(placedpar("generate", "chordal-ring", "--size", "256", "--host", "node").stdout, encoding="utf-8")
        drawing = Drawing(self.shown(self.path, "svg"))
        ring = [box.centre for name, box in drawing.boxes.items() if "[" in name]
        x, y = (sum(each[i] for each in ring) / len(ring) for i in (0, 1))
        wide, high = (max(each[i] for each in ring) - middle for i, middle in ((0, x), (1, y)))
        for each in ring:
            self.assertAlmostEqual(math.hypot((each[0] - x) / wide, (each[1] - y) / high), 1, delta=0.05)
        for name, box in drawing.boxes.items():
            if "[" not in name:
                self.assertLess(box.right, x - wide)

    def test_the_hub_of_a_large_ring_stands_at_its_edge(self):
        for topology in ("ring", "chordal-ring"):
            self.path.write_text(placedpar("generate", topology, "--size", "250", "--host", "node").stdout, encoding="utf-8")
            drawing = Drawing(placedpar("show", self.path, "--format", "svg", "--software").stdout)
            self.assertLess(drawing.boxes["host"].right, min(box.left for name, box in drawing.boxes.items() if "[" in name))
            widths = {box.right - box.left for box in drawing.boxes.values()}
            self.assertLess(max(widths), 2 * min(widths))

    def test_a_torus_stands_in_a_grid(self):
        for n in (4, 8):
            boxes = self.drawing_of(MADE_UP[f"torus-{n}"]).boxes
            places = [[boxes[f"t[{i}][{j}]"].centre for j in range(n)] for i in range(n)]
            columns, rows = [x for x, _ in places[0]], [row[0][1] for row in places]
            self.assertEqual(places, [[(x, y) for x in columns] for y in rows])
            self.assertEqual(len({b - a for a, b in zip(columns, columns[1:])} | {0}), 2)
            self.assertEqual(len({b - a for a, b in zip(rows, rows[1:])} | {0}), 2)
            self.assertLess(columns[0], columns[1])
            self.assertLess(rows[0], rows[1])

    def test_wires_that_close_a_torus_are_curves_around_it(self):
        wires = dict(self.drawing_of(MADE_UP["torus-4"]).wires)
        for i in range(4):
            self.assertNotIn("Q", wires[f"t[{i}][0].link[1] - t[{i}][1].link[3]"])
            self.assertIn("Q", wires[f"t[{i}][3].link[1] - t[{i}][0].link[3]"])
            self.assertIn("Q", wires[f"t[3][{i}].link[2] - t[0][{i}].link[0]"])

    def test_a_ring_is_round(self):
        boxes = self.drawing_of(MADE_UP["ring-16"]).boxes
        x = sum(box.centre[0] for box in boxes.values()) / 16
        y = sum(box.centre[1] for box in boxes.values()) / 16
        wide = max(box.centre[0] for box in boxes.values()) - x
        high = max(box.centre[1] for box in boxes.values()) - y
        angles = []
        for i in range(16):
            dx, dy = (boxes[f"t[{i}]"].centre[0] - x) / wide, (boxes[f"t[{i}]"].centre[1] - y) / high
            self.assertAlmostEqual(math.hypot(dx, dy), 1, delta=0.12)
            angles.append(math.atan2(dy, dx))
        turns = [(b - a) % (2 * math.pi) for a, b in zip(angles, angles[1:] + angles[:1])]
        self.assertAlmostEqual(sum(turns), 2 * math.pi)
        self.assertLess(max(turns), 0.7)

    def test_a_chain_keeps_neighbours_together(self):
        drawing = self.drawing_of(MADE_UP["chain"])
        for wire, data in drawing.wires:
            points = list(points_of(data))
            self.assertTrue(len({x for x, _ in points}) == 1 or len({y for _, y in points}) == 1, wire)

    def test_the_hub_of_a_star_is_its_centre(self):
        boxes = self.drawing_of(STAR).boxes
        spokes = [boxes[f"spoke[{i}]"].centre for i in range(4)]
        self.assertEqual(boxes["hub"].centre, (sum(x for x, _ in spokes) / 4, sum(y for _, y in spokes) / 4))

    def test_children_of_a_tree_stand_below_it(self):
        boxes = self.drawing_of(TREE).boxes
        for i in range(7):
            left, right = boxes[f"t[{2 * i + 1}]"].centre, boxes[f"t[{2 * i + 2}]"].centre
            x, y = boxes[f"t[{i}]"].centre
            self.assertEqual(left[1], right[1])
            self.assertGreater(left[1], y)
            self.assertTrue(left[0] < x < right[0])

    def test_a_tree_stays_one_where_wires_are_doubled(self):
        boxes = self.drawing_of("T800 t[5];\nrep i = 0 for 2 rep w = 0 for 2 {\n"
                                "    connect t[0].link[2 * i + w] to t[i + 1].link[w];\n"
                                "    connect t[i + 1].link[2 + w] to t[i + 3].link[w]; }\n").boxes
        heights = [boxes[f"t[{i}]"].centre[1] for i in range(5)]
        self.assertTrue(heights[0] < heights[1] == heights[2] < heights[3] == heights[4], heights)

    def test_heads_of_rows_stand_beside_their_rows(self):
        boxes = self.drawing_of("T800 w[3], t[3][4];\n"
                                "rep i = 0 for 3 { connect w[i].link[0] to t[i][0].link[3];\n"
                                "rep j = 0 for 3 connect t[i][j].link[1] to t[i][j + 1].link[3]; }\n"
                                "rep i = 0 for 2 rep j = 0 for 4 connect t[i][j].link[2] to t[i + 1][j].link[0];\n").boxes
        for i in range(3):
            self.assertEqual(boxes[f"w[{i}]"].centre[1], boxes[f"t[{i}][0]"].centre[1])
            self.assertLess(boxes[f"w[{i}]"].right, boxes[f"t[{i}][0]"].left)

    def test_the_software_is_processes_and_channels(self):
        star = ["--set", "links=3"]
        netlists = [(FARM, star), (FARM, []), (FARM, ["--set", "slaves=15", "--set", "links=3", "--set", "branches=3"]),
                    (EXAMPLES / "thesis/figure-e2" / "figure-e2.cfs", [])]
        for path, settings in netlists:
            done = placedpar("show", path, "--format", "svg", "--software", *settings)
            self.assertEqual(done.returncode, 0, done.stderr)
            drawing = Drawing(done.stdout)
            network = json.loads(placedpar("show", path, "--format", "json", *settings).stdout)
            self.assertEqual([name for name, _, _ in drawing.nodes], [each["name"] for each in network["processes"]])
            self.check_boxes(drawing)
            for channel in network["channels"]:
                self.assertIn(xml(channel["name"]), done.stdout)

    def test_an_arrow_points_to_each_receiver(self):
        done = placedpar("show", FARM, "--format", "svg", "--software")
        root = ElementTree.fromstring(done.stdout)
        heads = [each for each in root.findall(f"{SVG}path") if each.get("class") == "head"]
        self.assertEqual(len(heads), 7)  # to each of three slaves and back, and from the host

    def test_the_software_is_a_drawing_only(self):
        done = placedpar("show", FARM, "--software")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, "placedpar: --software needs the output format svg: write --format svg --software\n")

    def test_graphviz_draws_its_own_form(self):
        done = subprocess.run(["dot", "-Tsvg"], input=self.shown(EXAMPLES / "thesis/figure-e2" / "figure-e2.cfs", "dot"),
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=True)
        self.assertEqual(done.stderr, "")
        titles = [each.text for each in ElementTree.fromstring(done.stdout).iter(f"{SVG}title")]
        self.assertEqual(sum("--" in title for title in titles), 20)

    def test_the_legend_says_what_occurs(self):
        text = self.shown(EXAMPLES / "thesis/figure-e2" / "figure-e2.cfs", "svg")
        for words in ("transputer with its processes", "workstation", "wire that carries channels"):
            self.assertIn(f">{words}<", text)
        self.assertNotIn("crossbar", text)
        self.path.write_text(MADE_UP["switch"], encoding="utf-8")
        switched = self.shown(self.path, "svg")
        self.assertIn(">crossbar switch<", switched)
        self.assertNotIn("carries channels", switched)

    def test_no_kind_of_device_is_drawn_in_a_style_of_texts(self):
        """Each kind has a CSS class of its own, whatever its name."""
        text = self.shown(EXAMPLES / "machine/figure-d1" / "figure-d1.cfs", "svg")
        groups = [each.get("class").split() for each in ElementTree.fromstring(text).findall(f"{SVG}g")]
        kinds = [words[1:] for words in groups if words[0] in ("node", "legend")]
        self.assertIn(["link-adapter"], kinds)
        for words in kinds:
            self.assertLessEqual(len(words), 1)
            self.assertTrue(set(words).isdisjoint(LETTER), words)


if __name__ == "__main__":
    unittest.main()
