#!/usr/bin/env python3
"""Builds the web site of the documents from the files of a build: build.py PROGRAM HEADERS FOLDER [--python PACKAGES].

A browser can open FOLDER/html/index.html from the file system. The other folders in FOLDER are intermediate: source/
has links to the pages and rooms, xml/ has Doxygen's output for the headers, and runs/ has the pages of the examples'
runs.
"""

import argparse
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from public_headers import write_interface_pages

HERE = pathlib.Path(__file__).parent
TREE = HERE.parent.parent


def link_pages(source):
    """Makes the source folder, with links to all top folders and files except the build folder."""
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for entry in TREE.iterdir():
        if entry.name != "build" and not entry.name.startswith("."):
            (source / entry.name).symlink_to(entry)


def first_run(page):
    """Returns the arguments of the page's first command that simulates a file of the tree; None if there is no such command."""
    for line in page.read_text().splitlines():
        if line.startswith("$ placedpar run examples/"):
            command = re.split("[;|>]", line.removeprefix("$ placedpar run "))[0]
            arguments = shlex.split(command, comments=True)
            if (TREE / arguments[0]).exists() and not {"--native", "--predict"} & set(arguments):
                return arguments
    return None


def without_pictures(arguments):
    """Returns the arguments without the options for traces, since another file would be written."""
    kept = []
    rest = iter(arguments)
    for argument in rest:
        if argument.startswith("--trace"):
            next(rest, None)
        else:
            kept.append(argument)
    return kept


def draw_runs(program, folder):
    """Writes FOLDER/NAME/OF/EXAMPLE.html for each example: the page of the first run that the example shows."""
    for page in sorted((TREE / "examples").glob("**/README.md")):
        arguments = first_run(page)
        drawn = folder / page.parent.relative_to(TREE / "examples").with_suffix(".html")
        if arguments is None:
            continue
        drawn.parent.mkdir(parents=True, exist_ok=True)
        run = subprocess.run([program, "run", *without_pictures(arguments), "--page", drawn], cwd=TREE,
                             stdin=subprocess.DEVNULL, capture_output=True, text=True)
        done = "drawn" if drawn.exists() else "not drawn, because it needs a file that another command makes"
        print(f"{done}: the run of {page.relative_to(TREE)}", flush=True)


def read_headers(headers, xml):
    """Lets Doxygen read the public headers: all headers except those in detail/."""
    xml.mkdir(parents=True, exist_ok=True)
    settings = f"""
        INPUT = {headers}
        RECURSIVE = YES
        EXCLUDE = {headers}/detail
        GENERATE_HTML = NO
        GENERATE_LATEX = NO
        GENERATE_XML = YES
        XML_OUTPUT = {xml}
        XML_PROGRAMLISTING = NO
        EXTRACT_ALL = YES
        EXTRACT_PRIVATE = NO
        QUIET = YES
        WARNINGS = NO
        INPUT_FILTER = "sed 's/= \\[\\] {{}}/= {{}}/'" # Sphinx cannot read a lambda as a default
        MACRO_EXPANSION = YES
        STRIP_FROM_PATH = {headers.parent}
    """
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)


PYTHON_PAGE = """# Interfaces in Python

[The guide](../docs/guides/python.md) shows how to use these classes and functions.

```{eval-rst}
.. automodule:: placedpar
   :members:
   :imported-members:
   :exclude-members: NetlistWarning
```
"""


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("program", type=pathlib.Path)
    options.add_argument("headers", type=pathlib.Path, help="the build's folder placedpar with the public headers")
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("--python", type=pathlib.Path, help="the folder that contains the Python package placedpar")
    given = options.parse_args()
    folder = given.folder.absolute()
    link_pages(folder / "source")
    read_headers(given.headers.absolute(), folder / "xml")
    write_interface_pages(folder / "xml", folder / "source" / "interfaces" / "cpp")
    if given.python:
        (folder / "source" / "interfaces" / "python.md").write_text(PYTHON_PAGE)
    shutil.rmtree(folder / "runs", ignore_errors=True)
    draw_runs(given.program.absolute(), folder / "runs")
    environment = os.environ | {"PLACEDPAR_API_XML": str(folder / "xml"), "PLACEDPAR_RUNS": str(folder / "runs")}
    if given.python:
        environment["PYTHONPATH"] = str(given.python.absolute())
    (folder / "html").mkdir(exist_ok=True)
    (folder / "html" / "index.html").write_text('<meta http-equiv="refresh" content="0; url=README.html">\n')
    return subprocess.run(["sphinx-build", "-q", "-E", "-W", "--keep-going", "-j", "auto", "-c", HERE, "-d", folder / "doctrees",
                           folder / "source", folder / "html"], env=environment).returncode


if __name__ == "__main__":
    sys.exit(main())
