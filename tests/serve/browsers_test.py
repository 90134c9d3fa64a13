"""Tests the page in Chromium and in Firefox, as a student uses it: by keyboard, from an error to the deadlock, and by a link."""

import json
import time
import unittest

import firefox
from chromium import CHROMIUM, Chromium
from serving import SECONDS, ServiceTest

RING = """val n 3;
T800 (memory = 1M) t[n];
process (interface (input in, output out)) buffer[n];
rep i = 0 for n {
connect t[i].link[1] to t[(i + 1) % n].link[0];
use "csp.identity" for buffer[i];
connect buffer[i].out to buffer[(i + 1) % n].in;
place bufer[i] on t[i];
}
"""
FOREVER = """PROC forever (CHAN OF BYTE keyboard, screen, error)
  WHILE TRUE
    SKIP
:
"""
PHILOSOPHERS = "csp/philosophers/philosophers.cfs"
EDITOR = "document.querySelector('#netlist .CodeMirror').CodeMirror"
MARKS = f"""JSON.stringify({EDITOR}.getAllMarks().filter(mark => /fault/.test(mark.className)).map(mark => mark.find())
  .map(({{from, to}}) => [from.line + 1, {EDITOR}.getRange(from, to)]))"""
# Where the underline is on the screen: below which letters, as the browser has laid them out.
SEEN = f"""(() => {{ const box = document.querySelector('#netlist .fault.error').getBoundingClientRect();
  const {{line, ch}} = {EDITOR}.coordsChar({{left: box.left + 1, top: (box.top + box.bottom) / 2}}, 'window'); return [line + 1, ch + 1]; }})()"""
STATUS = "document.getElementById('status').textContent"


class InChromium:
    def __init__(self, address):
        self.browser = Chromium()
        self.open(address)

    def open(self, address):
        """Opens the address in a new tab."""
        target = self.browser.command("Target.createTarget", url="about:blank")["targetId"]
        self.tab = self.browser.command("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.browser.command("Target.setAutoAttach", self.tab, autoAttach=True, waitForDebuggerOnStart=False, flatten=True)
        for domain in ("Page", "Runtime", "Log"):
            self.browser.command(f"{domain}.enable", self.tab)
        self.browser.command("Emulation.setFocusEmulationEnabled", self.tab, enabled=True)
        self.browser.command("Page.navigate", self.tab, url=address)
        self.browser.wait_for("Page.loadEventFired", self.tab, [])

    def value(self, expression, session=None):
        result = self.browser.command("Runtime.evaluate", session or self.tab, expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise AssertionError(result["exceptionDetails"])
        return result["result"].get("value")

    def in_frame(self, expression):
        """Evaluates an expression in the frame of the run's page, which is a process of its own when it is there."""
        frames = [each["params"]["sessionId"] for each in self.browser.events
                  if each.get("method") == "Target.attachedToTarget" and each["params"]["targetInfo"]["type"] == "iframe"]
        return self.value(expression, frames[-1] if frames else self.tab)

    def type(self, text):
        self.browser.command("Input.insertText", self.tab, text=text)

    def run_by_key(self):
        for kind in ("rawKeyDown", "keyUp"):
            self.browser.command("Input.dispatchKeyEvent", self.tab, type=kind, modifiers=2, key="Enter", code="Enter", windowsVirtualKeyCode=13)

    def resize(self, width):
        self.browser.command("Emulation.setDeviceMetricsOverride", self.tab, width=width, height=900, deviceScaleFactor=1, mobile=False)

    def close(self):
        self.browser.close()


class InFirefox:
    def __init__(self, address):
        self.browser = firefox.Firefox().__enter__()
        self.browser.visit(address)

    def open(self, address):
        tab = self.browser.command("WebDriver:NewWindow", {"type": "tab"})["handle"]
        self.browser.command("WebDriver:SwitchToWindow", {"handle": tab})
        self.browser.visit(address)

    def value(self, expression):
        self.browser.command("WebDriver:SwitchToFrame", {"id": None})
        return self.run(expression)

    def run(self, expression):
        return self.browser.command("WebDriver:ExecuteScript", {"script": f"return {expression}", "args": []})["value"]

    def in_frame(self, expression):
        self.browser.command("WebDriver:SwitchToFrame", {"id": None})
        frame = self.browser.command("WebDriver:FindElement", {"using": "css selector", "value": "iframe"})["value"]
        self.browser.command("WebDriver:SwitchToFrame", {"element": next(iter(frame.values()))})
        return self.run(expression)

    def type(self, text):
        element = self.browser.command("WebDriver:GetActiveElement", {})["value"]
        self.browser.command("WebDriver:ElementSendKeys", {"id": next(iter(element.values())), "text": text})

    def run_by_key(self):
        self.type("\ue009\ue007")  # Control, Enter

    def resize(self, width):
        self.browser.command("WebDriver:SetWindowRect", {"width": width, "height": 900})

    def close(self):
        self.browser.__exit__()


class InBrowsers(ServiceTest):
    def wait_for(self, tab, expression, ask=None):
        """Returns the value of the expression when it is true."""
        end = time.monotonic() + SECONDS
        while not (value := (ask or tab.value)(expression)):
            self.assertLess(time.monotonic(), end, f"{expression}; status: {tab.value(STATUS)}")
            time.sleep(0.05)
        return value

    def ready(self, tab):
        self.wait_for(tab, f"document.getElementById('examples').length > 20 && {EDITOR}.getValue() !== ''")

    def write_and_mend(self, tab):
        """Types a program with an error, sees it underlined, and mends it."""
        tab.value("document.getElementById('new').click()")
        tab.type(RING)
        self.wait_for(tab, "document.querySelector('#netlist .fault.error') !== null")
        self.assertEqual(json.loads(tab.value(MARKS)), [[8, "bufer"]])
        self.assertEqual(tab.value(SEEN), [8, 7])
        self.assertIn('"bufer"', tab.value("document.getElementById('faults').textContent"))
        tab.value("document.querySelector('#faults button').click()")  # goes to the error
        tab.value(EDITOR + ".setSelection({line: 7, ch: 6}, {line: 7, ch: 11})")
        tab.type("buffer")
        self.wait_for(tab, "document.querySelector('.fault') === null && document.getElementById('faults').children.length === 0")
        self.assertEqual(tab.value(f"{EDITOR}.getValue()").strip(), RING.replace("bufer", "buffer").strip())

    def see_the_deadlock(self, tab):
        """Runs the program by keyboard, and moves through the run's page."""
        tab.run_by_key()
        self.assertEqual(self.wait_for(tab, f"/deadlock/.test({STATUS}) && {STATUS}"), "The run has ended: deadlock.")
        self.assertIn("deadlock", tab.value("document.querySelector('#panels pre').textContent"))
        tab.value("document.getElementById('tab-page').click()")
        self.wait_for(tab, "document.querySelector('iframe') !== null")
        self.wait_for(tab, "document.documentElement?.dataset.loaded === 'yes'", tab.in_frame)  # a new frame is empty
        self.assertRegex(tab.in_frame("document.getElementById('deadlock').textContent"), r"buffer\[0\] → buffer\[2\] → buffer\[1\] → buffer\[0\]")
        self.assertEqual(tab.in_frame("document.querySelectorAll('.arrow.cycle').length"), 3)
        slider = "document.getElementById('slider')"
        tab.in_frame(f"({slider}.value = 0, {slider}.dispatchEvent(new Event('input')))")
        self.assertEqual(tab.in_frame("document.getElementById('now').textContent")[:2], "0 ")
        self.assertEqual(tab.in_frame("document.documentElement.dataset.errors"), "0")

    def follow_the_link(self, tab):
        program = tab.value(f"{EDITOR}.getValue()")
        tab.value("document.getElementById('link').click()")
        address = self.wait_for(tab, "location.hash.length > 50 && location.href")
        tab.open(address)
        self.ready(tab)
        self.assertEqual(tab.value(f"{EDITOR}.getValue()"), program)

    def run_again_and_stop(self, tab):
        """Runs a program that never ends, runs it again, stops it, and leaves it for another program."""
        stop, examples = "document.getElementById('stop')", "document.getElementById('examples')"
        tab.value("document.getElementById('new').click()")
        tab.value(f"{EDITOR.replace('netlist', 'occam')}.setValue({json.dumps(FOREVER)})")
        for _ in range(2):
            tab.value("document.getElementById('run').click()")
            time.sleep(1)
        self.assertEqual((tab.value(STATUS), tab.value(stop + ".hidden")), ("Running.", False))
        tab.value(stop + ".click()")
        self.wait_for(tab, f"{STATUS} === 'Stopped.' && {stop}.hidden")
        tab.value("document.getElementById('run').click()")
        tab.value(f"({examples}.value = {json.dumps(PHILOSOPHERS)}, {examples}.dispatchEvent(new Event('change')))")
        time.sleep(1)
        self.assertEqual((tab.value(STATUS), tab.value(stop + ".hidden")), ("", True))
        self.wait_for_no_job()

    def wait_for_no_job(self):
        end = time.monotonic() + SECONDS
        while self.service.children():
            self.assertLess(time.monotonic(), end, "a job is still being done")
            time.sleep(0.05)

    def follow_damaged_links(self, tab):
        damaged = f"{STATUS} === 'The link is damaged: its program cannot be read.'"
        program = tab.value(f"{EDITOR}.getValue()")
        tab.value("void (location.hash = 'damaged')")
        self.wait_for(tab, damaged)
        self.assertEqual(tab.value(f"{EDITOR}.getValue()"), program)
        tab.open(self.service.page + "#damaged")
        self.ready(tab)
        self.wait_for(tab, damaged)

    def complete_and_solve(self, tab):
        """Completes the name of a kind, and checks the solution of an exercise."""
        tab.value("document.getElementById('new').click()")
        tab.type('use "csp.ident')
        self.wait_for(tab, EDITOR + ".getValue() === 'use \"csp.ident'")
        tab.value(EDITOR + ".showHint({hint: window.completeAt})")
        self.wait_for(tab, EDITOR + ".getValue() === 'use \"csp.identity'")
        choice = "document.getElementById('exercises')"
        tab.value(f"({choice}.value = '1.1', {choice}.dispatchEvent(new Event('change')))")
        tab.value("document.getElementById('check').click()")
        self.wait_for(tab, "/^not solved/.test(document.getElementById('panel-verdict')?.textContent)")

    def check_page(self, tab):
        try:
            self.ready(tab)
            self.write_and_mend(tab)
            self.see_the_deadlock(tab)
            self.follow_the_link(tab)
            self.run_again_and_stop(tab)
            self.follow_damaged_links(tab)
            self.complete_and_solve(tab)
            tab.resize(420)
            self.wait_for(tab, "innerWidth <= 500 && document.documentElement.scrollWidth <= innerWidth")
        finally:
            tab.close()

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_in_chromium(self):
        self.check_page(InChromium(self.service.page))

    @unittest.skipUnless(firefox.FIREFOX, "no Firefox")
    def test_in_firefox(self):
        self.check_page(InFirefox(self.service.page))

    @unittest.skipUnless(CHROMIUM, "no browser")
    def test_everything_has_a_label(self):
        tab = InChromium(self.service.page)
        try:
            self.ready(tab)
            tree = tab.browser.command("Accessibility.getFullAXTree", tab.tab)["nodes"]
            roles = {"button", "combobox", "textbox", "spinbutton", "tab", "listbox"}
            for node in tree:
                if not node["ignored"] and node["role"]["value"] in roles:
                    self.assertTrue(node["name"]["value"], node)
            named = {node["name"]["value"] for node in tree if not node["ignored"] and node["role"]["value"] in roles}
            self.assertLessEqual({"Netlist", "Program in occam", "Run", "Explain", "Listing", "Seed", "Keys", "Example", "Exercise"}, named)
        finally:
            tab.close()


if __name__ == "__main__":
    unittest.main()
