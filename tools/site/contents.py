"""Makes the table of contents at the side, whose chapters are the folders of the documents.

The pages have links in their text, as on GitHub, but not the lists that Sphinx needs. This extension adds these lists.
"""

import fnmatch
import posixpath

CHAPTERS = (
    ("Start", ["docs/start/first-netlist", "docs/start/commands"]),
    ("Learn", ["docs/learn/csp", "docs/learn/transputers", "docs/learn/genetic-algorithms",
               "docs/learn/one-generation", "docs/occam-course/README"]),
    ("Guides", ["docs/guides/*"]),
    ("Examples", ["examples/*/README"]),
    ("Reference", ["docs/reference/*", "interfaces/cpp/README", "interfaces/python*"]),
    ("Source", ["CONTRIBUTING", "*/README"]),
)


def listing(entries, caption=None):
    """Returns a hidden list of pages for Sphinx, in MyST's notation."""
    lines = [":::{toctree}", ":hidden:", ":glob:"] + ([f":caption: {caption}"] if caption else [])
    return "\n".join([*lines, "", *entries, ":::"])


def pages_below(app, docname):
    """Returns the pattern of the pages below a README, or None if there are no such pages."""
    folder = posixpath.dirname(docname)
    pattern = "*" if folder.startswith(("docs/", "interfaces")) else "*/README"
    others = fnmatch.filter(app.env.found_docs, f"{folder}/{pattern}")
    return pattern if set(others) - {docname} else None


def add_contents(app, docname, source):
    """Adds the chapters to the first page, and to every other README the pages below it."""
    lists = []
    if docname == "README":
        lists = [listing(["/" + entry for entry in entries], caption) for caption, entries in CHAPTERS]
    elif posixpath.basename(docname) == "README":
        pattern = pages_below(app, docname)
        lists = [listing([pattern])] if pattern else []
    source[0] = "\n\n".join([source[0], *lists]) + "\n"


def setup(app):
    app.connect("source-read", add_contents)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
