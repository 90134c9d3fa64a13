"""Makes the table of contents at the side: the folders of the documents are its chapters.

The pages themselves have links in their text, as on GitHub, and no list for Sphinx.
"""

import fnmatch
import posixpath

CHAPTERS = (
    ("Start", ["docs/start/first-netlist", "docs/start/commands"]),
    ("Learn", ["docs/learn/csp", "docs/learn/transputers", "docs/learn/genetic-algorithms",
               "docs/learn/one-generation", "docs/occam-course/README"]),
    ("Guides", ["docs/guides/*"]),
    ("Examples", ["examples/*/README"]),
    ("Reference", ["docs/reference/*", "interfaces/cpp/README"]),
    ("Source", ["CONTRIBUTING", "*/README"]),
)


def listing(entries, caption=None):
    """Returns a hidden list of pages for Sphinx, in MyST's notation."""
    lines = [":::{toctree}", ":hidden:", ":glob:"] + ([f":caption: {caption}"] if caption else [])
    return "\n".join([*lines, "", *entries, ":::"])


def pages_below(app, docname):
    """Returns the pattern of the pages that a README lists, or None if its folder has none."""
    folder = posixpath.dirname(docname)
    pattern = "*" if folder.startswith(("docs/", "interfaces")) else "*/README"
    others = fnmatch.filter(app.env.found_docs, f"{folder}/{pattern}")
    return pattern if set(others) - {docname} else None


def add_contents(app, docname, source):
    """Adds the chapters to the first page, and the pages of its folder to each other README."""
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
