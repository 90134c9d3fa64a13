"""Makes links to files and folders of the source tree work, by a page with the text of each linked file."""

import html
import pathlib
import posixpath

from docutils import nodes
from sphinx import addnodes

LANGUAGES = {".hpp": "cpp", ".cfs": "netlist", ".inc": "netlist", ".occ": "occam", ".pgm": "occam", ".svg": "xml", ".ipynb": "json"}
LONGEST = 200_000  # largest number of characters of a file that are shown


def link_to_page(app, page, path, content):
    """Returns a link from the page `page` to the page of the file `path`."""
    uri = app.builder.get_relative_uri(page, posixpath.join("files", path))
    return nodes.reference("", "", *content, refuri=uri, internal=True)


def take_links(app, doctree):
    """Replaces each link that would download a file by a link to the page of this file."""
    page = app.env.docname
    for link in list(doctree.findall(addnodes.download_reference)):
        path = posixpath.normpath(posixpath.join(posixpath.dirname(page), link["reftarget"]))
        app.env.linked_files[page] = app.env.linked_files.get(page, set()) | {path}
        link.replace_self(link_to_page(app, page, path, link.children))


def find_folder(app, env, node, content):
    """Returns a link for a folder: to its README, or, if it has none, to a page that lists its files."""
    page = node["refdoc"]
    path = posixpath.normpath(posixpath.join(posixpath.dirname(page), node["reftarget"]))
    if f"{path}/README" in env.found_docs:
        return nodes.reference("", "", content, internal=True,
                               refuri=app.builder.get_relative_uri(page, f"{path}/README"))
    if not (pathlib.Path(app.srcdir) / path).exists():
        return None
    env.linked_files[page] = env.linked_files.get(page, set()) | {path}
    return link_to_page(app, page, path, [content])


def body_of(app, path):
    """Returns the HTML of the page for a file or a folder of the tree."""
    file = pathlib.Path(app.srcdir) / path
    if file.is_dir():
        names = sorted(entry.name for entry in file.iterdir() if not entry.name.startswith((".", "__")))
        text = "\n".join(names)
        language = "text"
    else:
        text = file.read_text(errors="replace")[:LONGEST]
        language = LANGUAGES.get(file.suffix, file.suffix.lstrip(".") or "text")
    shown = app.builder.highlighter.highlight_block(text, language, force=True)
    return f"<h1>{html.escape(path)}</h1>\n{shown}"


def make_pages(app):
    """Yields a page for each linked file and folder."""
    for path in sorted(set().union(*app.env.linked_files.values())):
        yield posixpath.join("files", path), {"title": path, "body": body_of(app, path)}, "page.html"


def begin(app):
    if not hasattr(app.env, "linked_files"):
        app.env.linked_files = {}


def forget(app, env, docname):
    env.linked_files.pop(docname, None)


def merge(app, env, docnames, other):
    env.linked_files.update({name: paths for name, paths in other.linked_files.items() if name in docnames})


def setup(app):
    app.connect("builder-inited", begin)
    app.connect("env-purge-doc", forget)
    app.connect("env-merge-info", merge)
    app.connect("doctree-read", take_links, priority=100)
    app.connect("missing-reference", find_folder)
    app.connect("html-collect-pages", make_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
