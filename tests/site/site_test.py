"""The site of the documents: all links lead somewhere, and pages and search work from the file system in two browsers."""

import html.parser
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.parse

import chromium
import firefox

TREE = pathlib.Path(__file__).parent.parent.parent
FOUND = "document.querySelectorAll('#search-results li a').length"
FIRST = "document.querySelector('#search-results li a').getAttribute('href')"


class Links(html.parser.HTMLParser):
    """The addresses that a page refers to, and the names that links can lead to."""

    def __init__(self, file):
        super().__init__()
        self.addresses, self.names = [], set()
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.addresses += [given[name] for name in ("href", "src") if given.get(name)]
        self.names |= {given[name] for name in ("id", "name") if given.get(name)}


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.html = pathlib.Path(cls.folder.name) / "html"
        subprocess.run([sys.executable, TREE / "tools/site/build.py", os.environ["PLACEDPAR"], os.environ["PLACEDPAR_HEADERS"],
                        cls.folder.name, "--python", os.environ["PLACEDPAR_PYTHON"]], check=True)
        cls.pages = {file: Links(file) for file in cls.html.glob("**/*.html") if "runs" not in file.relative_to(cls.html).parts}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_link_leads_somewhere(self):
        broken = []
        for page, links in self.pages.items():
            for address in links.addresses:
                parts = urllib.parse.urlsplit(address)
                if parts.scheme or parts.netloc:
                    continue
                target = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
                known = self.pages.get(target)
                if not target.is_file() or (parts.fragment and known and parts.fragment not in known.names):
                    broken.append(f"{page.relative_to(self.html)}: {address}")
        self.assertEqual(broken, [])
        self.assertGreater(len(self.pages), 200)

    def test_every_document_has_its_page(self):
        documents = [TREE / "README.md", TREE / "CONTRIBUTING.md", *TREE.glob("docs/*/*.md"), *TREE.glob("examples/**/README.md")]
        for document in documents:
            self.assertTrue((self.html / document.relative_to(TREE)).with_suffix(".html").exists(), document)

    def test_examples_show_a_run(self):
        page = self.html / "examples/csp/philosophers/README.html"
        frame = next(address for address in self.pages[page].addresses if "runs/" in address)
        self.assertIn("philosopher[0]", (page.parent / frame).read_text())

    def test_the_public_headers_are_printed(self):
        page = (self.html / "interfaces/cpp/runtime.html").read_text()
        self.assertIn("Waits until a guard is ready and returns its index.", page)
        self.assertNotIn("detail::", page)

    def test_the_interfaces_in_python_are_printed(self):
        page = (self.html / "interfaces/python.html").read_text()
        self.assertIn('id="placedpar.load"', page)
        self.assertIn("A deadlock", page)

    def search(self, words):
        return (self.html / "search.html").as_uri() + "?q=" + urllib.parse.quote(words)

    @unittest.skipUnless(chromium.CHROMIUM, "Chromium is not installed")
    def test_search_works_from_the_file_system_in_chromium(self):
        browser = chromium.Chromium()
        self.addCleanup(browser.close)
        self.assertGreater(browser.value_in(self.search("acknowledge"), FOUND)[0], 3)
        self.assertEqual(browser.value_in(self.search("xyzzyplugh"), FOUND)[0], 0)
        self.assertIn("philosophers", browser.value_in(self.search("dining philosophers"), FIRST)[0])

    @unittest.skipUnless(firefox.FIREFOX, "Firefox is not installed")
    def test_search_works_from_the_file_system_in_firefox(self):
        with firefox.Firefox() as browser:
            browser.visit(self.search("acknowledge"))
            deadline = time.monotonic() + 60
            while (found := browser.run(f"return {FOUND}")) <= 3 and time.monotonic() < deadline:
                time.sleep(0.2)
            self.assertGreater(found, 3)


if __name__ == "__main__":
    unittest.main()
