"""Tests the page of a run: it shows the whole run, loads nothing from elsewhere, and works in a browser."""

import html
import html.parser
import json
import pathlib
import re
import resource
import tempfile
import unittest
import urllib.parse

import firefox
from chromium import CHROMIUM, Chromium
from cut_texts import check_nothing_is_cut
from page_reader import Page, data_of
from program import EXAMPLES, FIGURE_E2, fingerprint, placedpar

COMMSTIME = EXAMPLES / "csp/commstime" / "commstime.cfs"
PHILOSOPHERS = EXAMPLES / "csp/philosophers" / "philosophers.cfs"
ISLANDS = EXAMPLES / "machine/through-routing" / "islands.cfs"

# The visible part after loading and after each change of the width. The zoom must agree with it, or its next step goes
# wrong.
WIDTHS = """
const see = () => ({ moments: view.scale.domain(), zoomed: d3.zoomTransform(canvas).rescaleX(view.full).domain(),
                     width: view.width, room: scroller.clientWidth });
const all = [see()];
for (const width of ["1000px", "980px", "600px", "1200px", ""]) {
  document.body.style.width = width;
  window.dispatchEvent(new Event("resize"));
  all.push(see());
}
document.documentElement.dataset.seen = JSON.stringify(all);
"""
CLICK = """
const row = view.rowOf.get(trackNamed.get("NAME").number);
scroller.scrollTop = row * rowHeight - 60;
const box = canvas.getBoundingClientRect(), x = box.left + view.scale(now.moment), y = box.top + topOf(row) + rowHeight / 2;
for (const what of ["mousemove", "click"]) canvas.dispatchEvent(new MouseEvent(what, { clientX: x, clientY: y, view: window }));
"""

LONG = ("--set", "count=20000")  # 640,000 slices and messages in 190.8 ms
MIDDLE = (95 * 10**9, 95 * 10**9 + 10**8)
MOMENT = MIDDLE[0] + 5 * 10**7

# Looks at the middle of the run. When all of it is loaded, reports the drawn shapes and the process's state there.
LOOK = f"""
const drawn = {{ slices: [], messages: [], shares: 0 }};
window.drawSlice = (track, slice) => {{ drawn.slices.push([track.number, slice.begin, slice.end, slice.doing, slice.note]); }};
window.drawMessage = message => {{ drawn.messages.push([message.left, message.arrived, message.from, message.to, message.channel]); }};
window.drawShares = () => {{ drawn.shares += 1; }};
window.fitCanvas = () => {{}};
view.height = 1e4;
lookAt({MIDDLE[0]}, {MIDDLE[1]});
choose("consumer");
goTo({MOMENT});
const asked = setInterval(() => {{
  if (looked.unpacks) return;
  clearInterval(asked);
  Object.assign(drawn, {{ slices: [], messages: [], shares: 0 }});
  showMoment();
  document.documentElement.dataset.seen = JSON.stringify({{ ...drawn, state: stateOfProcess(trackNamed.get("consumer"), now.moment),
    unpacked: d3.sum(stretches, each => each.content ? each.entries : 0) }});
}}, 10);
"""


class Loads(html.parser.HTMLParser):
    """Collects what a page would load from elsewhere."""

    def __init__(self, text):
        super().__init__()
        self.found = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.found += [value for name, value in attrs if name in ("src", "href") and not value.startswith("data:")]


def without_the_middle(page):
    """Returns the page as it would be without room for the stretches of the middle."""
    data, stretches = data_of(page), re.findall(r'<script class="stretch".*?</script>\n', page)
    run = data["timeline"]
    periods = list(zip(*[iter(run["stretches"])] * 3))
    lost = [i for i, (begin, end, _) in enumerate(periods) if 0.4 < begin / run["end"] and end / run["end"] < 0.6]
    assert len(lost) > 1
    run["lost"] = [periods[lost[0]][0], periods[lost[-1]][1]]
    run["left_out"] = sum(periods[i][2] for i in lost)
    run["stretches"] = [number for i, period in enumerate(periods) if i not in lost for number in period]
    for i in lost:
        page = page.replace(stretches[i], "", 1)
    return re.sub(r'(<script id="data" type="application/json">).*?(</script>)', lambda found: found[1] + json.dumps(data) + found[2], page, flags=re.S)


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if CHROMIUM:
            cls.chromium = Chromium()
            cls.addClassCleanup(cls.chromium.close)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def page(self, netlist, *options, exit_code=0):
        path = self.folder / "run.html"
        run = placedpar("run", netlist, "--page", path, *options)
        self.assertEqual(run.returncode, exit_code, run.stderr)
        return run, path.read_text(encoding="utf-8")

    def browse(self, address="", then=""):
        """Returns the page from the browser after its program, and then `then`, has run."""
        path = self.folder / "browsed.html"
        page = (self.folder / "run.html").read_text(encoding="utf-8")
        path.write_text(page.replace("</body>", f"<script>{then}</script></body>"), encoding="utf-8")
        page, said = self.chromium.visit(path.as_uri() + ("#" + urllib.parse.quote(address, safe="=&") if address else ""))
        self.assertEqual(said, [])
        self.assertIn('data-errors="0"', page[:5000])
        self.assertIn('data-loaded="yes"', page[:5000])
        return page

    def test_it_needs_nothing_from_elsewhere(self):
        _, page = self.page(FIGURE_E2)
        self.assertEqual(Loads(page).found, [])
        self.assertIn("Copyright 2010-2020 Mike Bostock", page)
        self.assertLess(len(page), 20e6)

    def test_it_has_every_slice_of_a_short_run_and_the_report(self):
        run, page = self.page(FIGURE_E2, "--trace", self.folder / "trace.json", "--json", self.folder / "report.json")
        data, report = data_of(page), json.loads((self.folder / "report.json").read_text(encoding="utf-8"))
        self.assertEqual(data["report"]["fingerprint"], fingerprint(run.stdout))
        self.assertEqual(fingerprint(run.stdout), fingerprint(placedpar("run", FIGURE_E2).stdout))
        self.assertEqual(data["timeline"]["left_out"], 0)
        self.assertEqual(data["report"]["measurements"], report["measurements"])
        events = json.loads((self.folder / "trace.json").read_text(encoding="utf-8"))["traceEvents"]
        known = Page(page)
        self.assertEqual(sum(map(len, known.slices.values())), sum(event["ph"] in "XB" for event in events))
        self.assertEqual(len(known.messages), sum(event["ph"] == "s" for event in events))
        waited = sum(end - begin for begin, end, doing, _, _ in known.slices_of("master[0]")
                     if doing not in ("computes", "ready"))
        self.assertGreater(waited, 0)
        self.assertEqual(len(data["searches"][0]["generations"]), 80)

    def test_it_says_where_processes_are_declared_and_for_whom_they_wait(self):
        _, page = self.page(PHILOSOPHERS, "--set", "butler=0", exit_code=2)
        data = data_of(page)
        fork = next(each for each in data["processes"] if each["name"] == "fork[1]")
        number = int(fork["place"].rpartition(":")[2])
        self.assertEqual(fork["line"], PHILOSOPHERS.read_text(encoding="utf-8").splitlines()[number - 1])
        begin, _, doing, is_open, note = Page(page).slices_of("philosopher[0]")[-1]
        self.assertEqual((doing, is_open, note.split("\t")[1]), ("outputs", True, "fork[1]"))
        self.assertLess(begin, data["timeline"]["end"])

    def part(self, *options):
        """Returns the page of only the middle of the long run, which is short enough to be loaded at once."""
        return self.page(COMMSTIME, *LONG, "--trace-from", f"{MIDDLE[0]}ps", "--trace-until", f"{MIDDLE[1]}ps", *options)[1]

    def test_a_long_run_has_every_slice_and_message(self):
        _, page = self.page(COMMSTIME, *LONG)
        known, part = Page(page), Page(self.part())
        run, (begin, end) = known.run, MIDDLE
        self.assertTrue(run["deflated"])
        self.assertFalse(part.run["deflated"])
        self.assertEqual(run["left_out"], 0)
        self.assertNotIn("lost", run)
        self.assertLess(len(page), 1e6)
        self.assertEqual([track["name"] for track in run["tracks"]], [track["name"] for track in part.run["tracks"]])
        for number, slices in part.slices.items():
            self.assertEqual([each for each in slices if begin < each.begin and each.end < end],
                             [each for each in known.slices[number] if begin < each.begin and each.end < end])
        self.assertEqual([each for each in part.messages if begin < each.left and each.arrived < end],
                         [each for each in known.messages if begin < each.left and each.arrived < end])
        self.assertGreater(len(part.messages), 30)
        busy = next(t for t in run["tracks"] if t["kind"] == "processor")
        self.assertGreater(len(busy["running"]), 4000)
        self.assertGreater(run["bin"] * len(busy["running"]), run["end"] - run["begin"])

    def test_the_same_run_is_the_same_page(self):
        self.assertEqual(*(self.page(COMMSTIME, *LONG)[1] for _ in range(2)))

    def test_a_part_of_a_run(self):
        _, page = self.page(COMMSTIME, "--trace-from", "1ms", "--trace-until", "2ms")
        run = data_of(page)["timeline"]
        self.assertEqual((run["begin"], run["end"]), (10**9, 2 * 10**9))

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_a_part_is_said_to_be_one(self):
        for options, said in ((("--trace-from", "1ms", "--trace-until", "2.5ms"), "from 1.000 ms to 2.500 ms, of 9.540 ms. They end there: end of the part that is traced."),
                              (("--trace-from", "1ms"), "from 1.000 ms to 9.540 ms, of 9.540 ms."),
                              (("--trace-until", "2.5ms"), "from 0 to 2.500 ms, of 9.540 ms."),
                              (("--trace-from", "1s"), "<b>Nothing of the run</b>"), ((), None), (("--until", "5ms"), None)):
            self.page(COMMSTIME, *options)
            hidden, text = re.search(r'<p id="part"( hidden="")?>(.*?)</p>', self.browse(""), re.S).groups()
            self.assertEqual((bool(hidden), bool(text)), (said is None, said is not None), options)
            self.assertIn(said or "", text)

    def test_a_part_after_the_run_is_empty_and_says_so(self):
        for begin, empty in (("1s", True), ("9.54ms", True), ("9.53ms", False), ("0s", False)):
            run, _ = self.page(COMMSTIME, "--trace-from", begin)
            said = f"{self.folder / 'run.html'}: the timelines of the page are empty: the run ended at 9.540000 ms, but the trace would begin at "
            self.assertEqual(run.stderr.startswith(said), empty)
            self.assertTrue(empty or not run.stderr)

    def test_what_is_refused(self):
        for options, message in [(("--page", self.folder / "nowhere" / "run.html"), "nowhere"),
                                 (("--page", self.folder / "run.html", "--seeds", "2"), "a page shows one run"),
                                 (("--page", COMMSTIME), str(COMMSTIME)),
                                 (("--page", self.folder / "run.html", "--trace-from", "2ms", "--trace-until", "1ms"),
                                  "choose a later end"),
                                 (("--trace-from", "1ms"), "--trace or --page")]:
            run = placedpar("run", COMMSTIME, *options)
            self.assertEqual(run.returncode, 1)
            self.assertIn(message, run.stderr)
            self.assertEqual(list(self.folder.iterdir()), [])

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_the_slider_moves_through_the_run(self):
        self.page(FIGURE_E2)
        seen = [self.browse(f"at={at}&from={at}&to={at + 0.001}&process=slave[0][0]") for at in (0.3, 0.8)]
        times, loads, texts = ([re.search(pattern, page, re.S).group(1) for page in seen] for pattern in
                               (r'<output id="now">(.*?)<', r'class="load"[^>]* width="([\d.]+)"',
                                r'<aside id="chosen">(.*?)</aside>'))
        self.assertTrue(times[0].startswith("201."), times)
        self.assertTrue(times[1].startswith("536."), times)
        self.assertNotEqual(texts[0], texts[1])
        self.assertIn("slave[clusters][slaves]", texts[0])
        self.assertNotEqual(*loads)
        self.assertEqual(seen[0].count('class="curve"'), 12)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_what_is_cut_off_is_not_said_to_last_for_ever(self):
        for options in (("--trace-from", "1ms", "--trace-until", "2ms"), ("--until", "2ms")):
            self.page(COMMSTIME, *options)
            pages = [self.browse(f"at=1&process={name}") for name in ("prefix", "delta", "successor", "consumer")]
            said = [re.search(rf'id="{part}">(.*?)</{kind}>', page, re.S).group(1)
                    for page in pages for part, kind in (("chosen", "aside"), ("measures", "section"))]
            self.assertFalse([text for text in said if "for ever" in text])
            self.assertTrue([text for text in said if "until 2.0" in text and "at least</li>" in text])
        self.assertTrue([text for text in said if re.search(r"\d %, the last wait since", text)])

    def said_of(self, address, expression):
        """Returns the value of an expression in the page, opened with the view in the address."""
        page = self.browse(address, f"document.documentElement.dataset.seen = JSON.stringify({expression});")
        return json.loads(html.unescape(re.search(r'data-seen="([^"]*)"', page).group(1)))

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_what_the_address_asks_for_and_is_not_there_is_said(self):
        self.page(FIGURE_E2)
        text = "document.getElementById('address').hidden ? '' : document.getElementById('address').textContent"
        for address, said in (("view=software&process=master[1]&at=0.5", ""), ("view=foo", 'no view "foo"'), ("process=nobody", '"nobody"'),
                              ("at=soon", '"soon" is not a part of the run'), ("zoom=3", '"zoom"')):
            with self.subTest(address=address):
                found = self.said_of(address, text)
                self.assertIn(said, found)
                self.assertEqual(bool(said), bool(found))
        path = self.folder / "run.html"
        path.write_text(re.sub(r'(id="software" hidden>).*?</svg>', r"\1", path.read_text(encoding="utf-8"), flags=re.S), encoding="utf-8")
        self.assertIn('no drawing for the view "software"', self.said_of("view=software", text))
        self.assertEqual(self.said_of("view=software", "[...document.querySelectorAll('#views button')].map(each => each.hidden)"), [False, True])

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_rows_are_found_and_folded(self):
        self.page(FIGURE_E2)
        place = "(() => { const y = topOf(view.rowOf.get(trackNamed.get('slave[3][2]').number)); return [y, view.height, scroller.scrollTop]; })()"
        y, height, scrolled = self.said_of("process=slave[3][2]", place)
        self.assertTrue(scrolled > 0 and 0 < y < height - 10, (y, height, scrolled))
        rows = "view.rows.filter(row => row.track && isOfProcess(row.track)).map(row => row.track.name)"
        folded = self.said_of("", rows)
        self.assertFalse([name for name in folded if "/" in name])
        unfolded = self.said_of("", f"(fold(trackNamed.get('slave[3][2]')), {rows})")
        self.assertEqual({name.split("/")[0] for name in set(unfolded) - set(folded)}, {"slave[3][2]"})
        search = "document.getElementById('search')"
        self.assertEqual(self.said_of("", f"({search}.value = 'MASTER', {search}.dispatchEvent(new Event('input')), {rows})"),
                         [name for name in folded if name.startswith("master")])

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_many_searches_are_bands(self):
        netlist = self.folder / "ring.cfs"
        netlist.write_text(placedpar("generate", "ring", "--size", "16", "--job", "islands", "--host", "node").stdout, encoding="utf-8")
        _, page = self.page(netlist)
        self.assertEqual(len(data_of(page)["searches"]), 16)
        count = "['.band', '.curve', '.chosen-curve[d]', '#curves a', '#jumps a'].map(each => document.querySelectorAll(each).length)"
        self.assertEqual(self.said_of("process=island[3]", count), [6, 3, 3, 0, 2])
        # Of the three searches, the second ends after the first generation, and the third reports every second
        # generation.
        made = "(data.searches = [[[1, 0, 1, 1, 1], [2, 0, 7, 7, 1], [3, 0, 9, 9, 1]], [[1, 0, 5, 5, 1]], [[1, 0, 2, 2, 1], [3, 0, 4, 4, 1]]]" \
               ".map(generations => ({ generations })), quantileCurves.clear(), [0, 0.5, 1].map(part => quantileCurve(part).map(row => row[2])))"
        self.assertEqual(self.said_of("", made), [[1, 2, 4], [2, 5, 5], [5, 7, 9]])

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_folded_components_are_drawn_together(self):
        self.page(FIGURE_E2)
        seen = "(() => { const drawn = []; window.drawShares = track => drawn.push(track.number === track.outermost || !isOfProcess(track)); showMoment(); " \
               "const sums = tracks.filter(isFoldable).map(track => ['running', 'ready'].map(what => [rowShare(track, what, run.begin, run.end), " \
               "d3.sum(componentsOf[track.number], each => shareOf(each[what], run.begin, run.end)), shareOf(track[what], run.begin, run.end)])); " \
               "return [drawn, d3.merge(sums)]; })()"
        drawn, shares = self.said_of("", seen)
        self.assertTrue(drawn and all(drawn))
        for row, together, alone in shares:
            self.assertAlmostEqual(row, min(1, together))
        self.assertTrue([row for row, together, alone in shares if row > alone + 0.01])

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_the_page_of_a_small_window_and_in_the_dark(self):
        """Checks that nothing is wider than 420 pixels, and that all texts contrast with their background."""
        self.page(FIGURE_E2)
        inner = (self.folder / "run.html").read_text(encoding="utf-8").replace("</body>", """<script>
            const light = colour => { const [r, g, b] = colour.match(/[\\d.]+/g).map(Number); return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255; };
            const behind = element => { const colour = getComputedStyle(element).backgroundColor; return /, 0\\)/.test(colour) ? behind(element.parentElement) : colour; };
            const turned = element => element && (getComputedStyle(element).filter !== "none" || turned(element.parentElement));
            const texts = [...document.querySelectorAll("h1, h2, p, a, td, th, button, output, label, text")];
            parent.document.documentElement.dataset.seen = JSON.stringify([innerWidth, document.documentElement.scrollWidth,
              light(behind(document.body)), d3.min(texts.filter(each => each.tagName !== "text"), each => Math.abs(light(getComputedStyle(each).color) - light(behind(each)))),
              d3.max(texts.filter(each => each.tagName === "text"), each => light(getComputedStyle(each).fill)),
              ["#canvas", ".picture > svg", ".charts > svg"].map(each => Boolean(turned(document.querySelector(each))))]);</script></body>""")
        (self.folder / "run.html").write_text("<html style='color-scheme: light dark'><body data-loaded='yes'><iframe style='width: 420px; height: 900px' srcdoc='"
                                              f"{html.escape(inner)}'></iframe></body></html>", encoding="utf-8")
        for dark in (False, True):
            page, _ = self.chromium.visit((self.folder / "run.html").as_uri(), dark)
            width, needed, paper, contrast, drawn, turned = json.loads(html.unescape(re.search(r'data-seen="([^"]*)"', page).group(1)))
            self.assertEqual(width, 420)
            self.assertLessEqual(needed, width)
            self.assertEqual(paper < 0.2, dark)
            self.assertGreater(contrast, 0.3)
            self.assertLess(drawn, 0.6)  # on white
            self.assertEqual(turned, [dark] * 3)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_no_text_is_cut_off(self):
        """In these drawings the last boxes end near the right edge, with their percentages to the right."""
        for netlist in (FIGURE_E2, COMMSTIME, ISLANDS, EXAMPLES / "explore/pipeline" / "pipeline.cfs", EXAMPLES / "csp/farm" / "farm.cfs"):
            self.page(netlist)
            for view, text in (("machine", "number of a link"), ("software", "of the sender's port")):
                check_nothing_is_cut(self, self.chromium, f"{(self.folder / 'run.html').as_uri()}#view={view}", text)

    def test_the_time_for_a_page_grows_with_the_machine(self):
        """A machine with four times the islands takes four to six times the time; comparing all pairs would take 16 times."""
        def seconds(size):
            netlist = self.folder / f"torus-{size}.cfs"
            netlist.write_text(placedpar("generate", "torus", "--size", f"{size}x{size}", "--host", "node").stdout, encoding="utf-8")
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            self.page(netlist, "--until", "1ms")
            return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        self.assertLess(min(seconds(32) for _ in range(2)), 9 * min(seconds(16) for _ in range(3)))

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_a_large_network_is_a_map_of_loads(self):
        netlist = self.folder / "torus.cfs"
        netlist.write_text(placedpar("generate", "torus", "--size", "15x14", "--host", "node").stdout, encoding="utf-8")
        self.page(netlist, "--until", "20ms")
        seen = "(() => { const text = () => getComputedStyle(document.querySelector('#machine .texts')).display, far = text(); " \
               "zoomPicture(pictures[0], d3.zoomIdentity.scale(1 / pictures[0].scale)); " \
               "return [pictures.map(each => each.large), far, text(), new Set(pictures[0].meters.map(each => each.frame.style('fill'))).size]; })()"
        large, far, near, colours = self.said_of("at=0.5", seen)
        self.assertEqual((large, far, near), ([True, True], "none", "inline"))
        self.assertGreater(colours, 1)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_a_moment_in_the_address_is_exact(self):
        run = data_of(self.page(COMMSTIME)[1])["timeline"]
        page = self.browse("at=0.500012345&from=0.5&to=0.5001")
        seen = re.search(r'<output id="now">([\d.]+) ms<', page).group(1)
        self.assertAlmostEqual(float(seen) * 1e9, run["begin"] + 0.500012345 * (run["end"] - run["begin"]), delta=1000)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_the_cycle_of_the_philosophers_shows(self):
        self.page(PHILOSOPHERS, "--set", "butler=0", exit_code=2)
        page = self.browse("process=philosopher[0]")
        self.assertEqual(page.count('class="arrow cycle"'), 10)
        self.assertIn("waiting for ever", page)
        self.assertRegex(page, r'id="deadlock">.*?philosopher\[0\].*?fork\[1\].*?philosopher\[1\]')
        self.assertEqual(self.browse("at=0.5").count('class="arrow cycle"'), 0)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_the_same_moments_stay_in_sight_when_the_width_changes(self):
        _, page = self.page(COMMSTIME)
        run = data_of(page)["timeline"]
        begin, length = run["begin"], run["end"] - run["begin"]
        for first, last in [(0, 1), (0.5, 0.6), (0.5, 0.500001)]:
            page = self.browse(f"from={first}&to={last}", WIDTHS)
            seen = json.loads(html.unescape(re.search(r'data-seen="([^"]*)"', page).group(1)))
            self.assertGreater(len({each["width"] for each in seen}), 3)
            for each in seen:
                self.assertEqual(each["width"], each["room"])
                for moments in (each["moments"], each["zoomed"]):
                    for moment, part in zip(moments, (first, last)):
                        self.assertAlmostEqual(moment, begin + part * length, delta=(last - first) * length / 1000)

    def look(self):
        """Returns the report of LOOK, and the texts about the chosen process and the run."""
        page = self.browse("", LOOK)
        return (json.loads(html.unescape(re.search(r'data-seen="([^"]*)"', page).group(1))),
                *(re.search(rf'id="{part}">(.*?)</{kind}>', page, re.S).group(1) for part, kind in (("chosen", "aside"), ("outcome", "p"))))

    def check_the_middle(self, look):
        """Opens the page in a browser; returns the report of LOOK, and the texts about the chosen process and the
        run."""
        seen = []
        for page in (self.page(COMMSTIME, *LONG)[1], self.part()):
            (self.folder / "run.html").write_text(page, encoding="utf-8")
            drawn, chosen = look()
            self.assertEqual(drawn["shares"], 0)
            seen.append([{tuple(each) for each in drawn[kind] if MIDDLE[0] < each[begin] and each[begin + 1] < MIDDLE[1]}
                         for kind, begin in (("slices", 1), ("messages", 0))] + [drawn["state"]])
            self.assertRegex(chosen, r"<li>inputs from .*delta.* on <i>delta.out\[1\] -&gt; consumer.in</i>, since")
            self.assertLess(drawn["unpacked"], 250000)
        part = Page(self.part())
        self.assertEqual(seen[0], seen[1])
        self.assertEqual(seen[0][1], {message for message in part.messages if MIDDLE[0] < message.left and message.arrived < MIDDLE[1]})
        self.assertGreater(len(seen[0][0]), 250)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_the_middle_of_a_long_run_is_there_where_it_is_looked_at(self):
        self.check_the_middle(lambda: self.look()[:2])

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_what_is_only_summarised_is_said(self):
        _, page = self.page(COMMSTIME, *LONG)
        for changed, said in [(without_the_middle(page), r"see its [\d,]+ slices and messages one by one. [\d,]+ more, of the middle, are summarised"),
                              (page.replace("<head>", "<head><script>delete window.DecompressionStream;</script>"),
                               "This browser cannot unpack its slices and messages")]:
            (self.folder / "run.html").write_text(changed, encoding="utf-8")
            drawn, chosen, outcome = self.look()
            self.assertRegex(outcome, said)
            self.assertGreater(drawn["shares"], 5)
            self.assertEqual((drawn["slices"], drawn["messages"], drawn["state"]), ([], [], "unknown"))
            self.assertIn("only summarised here", chosen)

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_a_click_says_what_a_router_waits_for(self):
        self.page(ISLANDS)
        link = "sun.link[0] -> t[0].link[3]"
        for name, wait in [("router sender t[0].link[3] -> sun.link[0]", "waits for packets to send"),
                           (f"router receiver {link}", f"inputs from router sender {link}")]:
            page = self.browse("at=0.5&from=0.45&to=0.55", CLICK.replace("NAME", name))
            under, chosen = (html.unescape(re.sub("<[^>]*>", " ", re.search(pattern, page, re.S).group(1)))
                             for pattern in (r'<p id="under">(.*?)</p>', r'<aside id="chosen">(.*?)</aside>'))
            self.assertTrue(under.startswith(f"{name}: {wait}; from "), under)
            self.assertRegex(" ".join(chosen.split()), f"^{re.escape(name)} .*{re.escape(wait)}")

    @unittest.skipUnless(firefox.FIREFOX, "no Firefox")
    def test_the_middle_of_a_long_run_in_firefox(self):
        def look():
            browser.visit((self.folder / "run.html").as_uri())
            browser.run(LOOK)
            while not browser.run("return document.documentElement.dataset.seen"):
                self.assertEqual(browser.run("return document.documentElement.dataset.errors"), "0")
            return (json.loads(browser.run("return document.documentElement.dataset.seen")),
                    browser.run("return document.getElementById('chosen').innerHTML"))
        with firefox.Firefox() as browser:
            self.check_the_middle(look)

    @unittest.skipUnless(firefox.FIREFOX, "no Firefox")
    def test_the_same_in_firefox(self):
        self.page(PHILOSOPHERS, "--set", "butler=0", exit_code=2)
        with firefox.Firefox() as browser:
            browser.visit((self.folder / "run.html").as_uri())
            self.assertEqual(browser.run("return [document.documentElement.dataset.errors, document.documentElement.dataset.loaded]"),
                             ["0", "yes"])
            self.assertEqual(browser.run("return document.querySelectorAll('.arrow.cycle').length"), 10)
            self.assertRegex(browser.run("return document.getElementById('deadlock').textContent"),
                             r"(?s)philosopher\[0\].*fork\[1\].*philosopher\[1\]")
            browser.run("slider.value = 5000; slider.dispatchEvent(new Event('input'))")
            self.assertEqual(browser.run("return document.querySelectorAll('.arrow.cycle').length"), 0)
            drawn = "return pen.getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, each) => sum + each, 0)"
            before, half = browser.run(drawn), browser.run("return document.getElementById('now').textContent")
            browser.run("slider.value = 2500; slider.dispatchEvent(new Event('input')); choose('philosopher[2]')")
            self.assertNotEqual(browser.run("return document.getElementById('now').textContent"), half)
            self.assertNotEqual(browser.run(drawn), before)
            self.assertIn("philosopher[2]", browser.run("return document.getElementById('chosen').textContent"))
            self.assertEqual(browser.run("return document.documentElement.dataset.errors"), "0")


if __name__ == "__main__":
    unittest.main()
