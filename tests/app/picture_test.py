"""What placedpar show --format svg draws, read back as XML and measured."""

import itertools
import json
import math
import pathlib
import random
import re
import resource
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from program import EXAMPLES, placedpar

SVG = "{http://www.w3.org/2000/svg}"
LETTER = {"name": 13 * 0.66, "facts": 10 * 0.58, "process": 11 * 0.58, "kind": 9 * 0.58, "inside": 9 * 0.58,
          "link": 9 * 0.58, "count": 10 * 0.58, "key": 10 * 0.58, "title": 14 * 0.66}

RING = """T800 t[n];
process (interface (output out, input in)) p[n];
rep i = 0 for n {
    connect t[i].link[1] to t[(i + 1) % n].link[0];
    use "csp.identity" for p[i];
    connect p[i].out to p[(i + 1) % n].in;
    place p[i] on t[i];
}
"""
TORUS = """T805 (memory = 1M) t[n][n];
process (interface (output out, input in)) p[n][n];
rep i = 0 for n rep j = 0 for n {
    connect t[i][j].link[1] to t[i][(j + 1) % n].link[3];
    connect t[i][j].link[2] to t[(i + 1) % n][j].link[0];
    use "csp.prefix" for p[i][j];
    connect p[i][j].out to p[i][(j + 1) % n].in;
    place p[i][j] on t[i][j];
}
"""
CUBE = """val n 1 << k;
T800 t[n];
rep i = 0 for n rep b = 0 for k
    if (i >> b) % 2 == 0 connect t[i].link[b] to t[i + (1 << b)].link[b];
"""
STAR = """T800 hub, spoke[4];
process (interface (output out)) p[4];
process (interface (input in)) q[4];
rep i = 0 for 4 {
    connect hub.link[i] to spoke[i].link[0];
    use "csp.producer" for p[i];
    use "csp.consumer" for q[i];
    place p[i] on spoke[i];
    place q[i] on hub;
    connect p[i].out to q[i].in;
}
"""
CHAIN = """T800 t[n];
rep i = 0 for n - 1 connect t[i].link[1] to t[i + 1].link[0];
connect t[0].link[0] to host;
"""
SWITCH = """T800 t[n];
C004 sw;
rep i = 0 for n {
    connect t[i].link[0] to sw.link[2 * i];
    connect t[i].link[1] to sw.link[2 * i + 1];
    connect sw.link[2 * i + 1] to sw.link[(2 * (i + 1)) % (2 * n)];
}
"""
SINGLE = """T800 root;
process (interface (output out)) p[6];
process (priority = HIGH, interface (input in)) q[6];
rep i = 0 for 6 {
    use "csp.producer" for p[i];
    use "csp.consumer" for q[i];
    place p[i] on root;
    place q[i] on root;
    connect p[i].out to q[i].in;
}
"""
TREE = """T800 t[15];
rep i = 0 for 7 {
    connect t[i].link[1] to t[2 * i + 1].link[0];
    connect t[i].link[2] to t[2 * i + 2].link[0];
}
connect t[0].link[0] to host;
"""
MADE_UP = {
    "torus-4": "val n 4;\n" + TORUS, "torus-8": "val n 8;\n" + TORUS, "ring-16": "val n 16;\n" + RING,
    "ring-3": "val n 3;\n" + RING, "cube": "val k 3;\n" + CUBE, "hypercube": "val k 4;\n" + CUBE, "star": STAR,
    "chain": "val n 12;\n" + CHAIN, "switch": "val n 16;\n" + SWITCH, "single": SINGLE, "tree": TREE,
    "alone": "T800 a;\n",
    "unconnected": "T800 a, b; C004 sw; edge out;\nconnect a.link[0] to b.link[0];\nconnect a.link[3] to b.link[3];\n"
                   "connect b.link[1] to a.link[1];\n",
    "three dimensions": "T800 t[2][3][4];\nrep i = 0 for 2 rep j = 0 for 3 rep k = 0 for 3\n"
                        "    connect t[i][j][k].link[1] to t[i][j][k + 1].link[3];\n"
                        "rep j = 0 for 3 rep k = 0 for 4 connect t[0][j][k].link[0] to t[1][j][k].link[2];\n",
    "names": 'T800 a;\nprocess a_process_with_a_very_long_name_indeed_it_is;\n'
             'use "a<b>&\'c\'.lku" for a_process_with_a_very_long_name_indeed_it_is;\n'
             'place a_process_with_a_very_long_name_indeed_it_is on a;\n',
}


def random_network(seed):
    """Transputers whose links are wired at random; single ones and arrays."""
    stream = random.Random(seed)
    names = [f"s{i}" for i in range(stream.randrange(1, 7))] + [f"t[{i}]" for i in range(stream.randrange(2, 12))]
    ends = [f"{name}.link[{link}]" for name in names for link in range(3)]
    stream.shuffle(ends)
    singles = [name for name in names if name[0] == "s"]
    text = f"T800 {', '.join(singles)}, t[{len(names) - len(singles)}];\n"
    text += "".join(f"connect {a}.link[3] to {b}.link[3];\n" for a, b in zip(names[::2], names[1::2]))
    if len(names) % 2:
        text += f"connect {names[-1]}.link[3] to host;\n"
    return text + "".join(f"connect {a} to {b};\n" for a, b in zip(ends[::2], ends[1::2])
                          if a.split(".")[0] != b.split(".")[0] and stream.random() < 0.6)


LARGE = [f"{topology} --size {size} --host node" for topology, sizes in {
    "pipeline": ["220"], "ring": ["64", "300"], "tree": ["255"], "mesh": ["15x20"], "torus": ["8x8", "20x15"], "hypercube": ["16"],
    "cube-connected-cycles": ["384"], "star": ["5"], "chordal-ring": ["64", "250"], "figure-e2": ["60x4"]}.items() for size in sizes]

TREE_OF = "rep i = 0 for {1} {{ connect {0}[i].link[1] to {0}[2 * i + 1].link[0]; connect {0}[i].link[2] to {0}[2 * i + 2].link[0]; }}\n"
RING_OF = "rep i = 0 for {1} connect {0}[i].link[1] to {0}[(i + 1) % {1}].link[0];\n"
SEVERAL_BLOCKS = {
    "two trees and a ring": "T800 a[255], b[63], c[24], d;\n" + TREE_OF.format("a", 127) + TREE_OF.format("b", 31) + RING_OF.format("c", 24) + """
        connect a[0].link[0] to b[0].link[0];
        connect a[254].link[1] to c[3].link[2];
        connect a[100].link[3] to c[9].link[2];
        connect c[11].link[2] to b[62].link[1];
        connect b[40].link[3] to a[130].link[3];
        connect d.link[0] to a[200].link[3];
        connect d.link[1] to host;
        """,
    "two rings": "T800 a[300], c[24];\n" + RING_OF.format("a", 300) + RING_OF.format("c", 24) + """
        rep i = 0 for 12 connect c[2 * i].link[2] to a[25 * i].link[2];
        connect a[7].link[3] to host;
        """,
    "a torus, a tree and a ring": "T800 a[16][16], b[15], c[9];\n" + TREE_OF.format("b", 7) + RING_OF.format("c", 9) + """
        rep i = 0 for 16 rep j = 0 for 16 {
            connect a[i][j].link[1] to a[i][(j + 1) % 16].link[3];
            if i * j connect a[i][j].link[2] to a[(i + 1) % 16][j].link[0];
        }
        connect b[0].link[0] to a[0][0].link[0];
        connect c[4].link[2] to a[0][5].link[2];
        connect c[7].link[2] to b[14].link[1];
        connect b[8].link[1] to host;
        """,
    "a torus, cubes and singles": "T800 a[15][15], b[8], c[24], d, e, f;\n" + """
        rep i = 0 for 15 rep j = 0 for 14 connect a[i][j].link[1] to a[i][j + 1].link[3];
        rep i = 0 for 8 rep k = 0 for 3 if (i >> k) % 2 == 0 connect b[i].link[k] to b[i + (1 << k)].link[k];
        rep i = 0 for 8 rep k = 0 for 3 {
            connect c[3 * i + k].link[0] to c[3 * i + (k + 1) % 3].link[1];
            if (i >> k) % 2 == 0 connect c[3 * i + k].link[2] to c[3 * (i + (1 << k)) + k].link[2];
        }
        rep k = 0 for 8 connect b[k].link[3] to a[k][k].link[0];
        rep k = 0 for 8 connect c[3 * k].link[3] to a[k][2 * k % 15].link[2];
        connect d.link[0] to a[9][0].link[0]; connect d.link[1] to e.link[0]; connect e.link[1] to f.link[0];
        connect f.link[1] to a[3][14].link[0]; connect f.link[2] to d.link[2]; connect d.link[3] to host;
        """}


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
    """Of a rectangle or an ellipse."""
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
    """Points on a path, a few pixels apart; curves by their corners."""
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
        """(box, texts) of each node."""
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


FARM = EXAMPLES / "36-farms" / "farm.cfs"


def xml(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


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
        """Each node, wire and process is there once; every channel over a wire is counted."""
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
        """A wire leads from its ends to each other and through no other box but switches."""
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
        for path in sorted(EXAMPLES.glob("*/*.cfs")):
            if not path.parent.name.startswith("4"): # whose kind or problem only its own program has
                with self.subTest(path=path.name):
                    self.check(path)

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
        """Every point of every wire against every box, of all topologies, where they are drawn as large ones and below."""
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
        """Four times the machine takes at most about four times as long, which the square of it would exceed by far."""
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
                    (EXAMPLES / "04-figure-e2" / "figure-e2.cfs", [])]
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
        self.assertEqual(done.stderr, "placedpar: --software is for the drawing: --format svg --software\n")

    def test_graphviz_draws_its_own_form(self):
        done = subprocess.run(["dot", "-Tsvg"], input=self.shown(EXAMPLES / "04-figure-e2" / "figure-e2.cfs", "dot"),
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=True)
        self.assertEqual(done.stderr, "")
        titles = [each.text for each in ElementTree.fromstring(done.stdout).iter(f"{SVG}title")]
        self.assertEqual(sum("--" in title for title in titles), 20)

    def test_the_legend_says_what_occurs(self):
        text = self.shown(EXAMPLES / "04-figure-e2" / "figure-e2.cfs", "svg")
        for words in ("transputer with its processes", "workstation", "wire that carries channels"):
            self.assertIn(f">{words}<", text)
        self.assertNotIn("crossbar", text)
        self.path.write_text(MADE_UP["switch"], encoding="utf-8")
        switched = self.shown(self.path, "svg")
        self.assertIn(">crossbar switch<", switched)
        self.assertNotIn("carries channels", switched)

    def test_no_kind_of_device_is_drawn_in_a_style_of_texts(self):
        """Its name is a class of its own, whatever words it is made of."""
        text = self.shown(EXAMPLES / "42-figure-d1" / "figure-d1.cfs", "svg")
        groups = [each.get("class").split() for each in ElementTree.fromstring(text).findall(f"{SVG}g")]
        kinds = [words[1:] for words in groups if words[0] in ("node", "legend")]
        self.assertIn(["link-adapter"], kinds)
        for words in kinds:
            self.assertLessEqual(len(words), 1)
            self.assertTrue(set(words).isdisjoint(LETTER), words)


if __name__ == "__main__":
    unittest.main()
