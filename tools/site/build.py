#!/usr/bin/env python3
"""Builds the site of the documents: build.py PROGRAM HEADERS FOLDER, with the public headers of a build.

FOLDER/html/index.html opens from the file system. The other folders there are steps: source/ has the pages, with links
to the rooms; xml/ what Doxygen read in the headers; runs/ the pages of runs that the examples show.
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
    """Makes the source folder: links to all top folders and pages, without the folders of builds."""
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for entry in TREE.iterdir():
        if entry.name != "build" and not entry.name.startswith("."):
            (source / entry.name).symlink_to(entry)


def first_run(page):
    """Returns the arguments of the first command of a page that runs a file of the tree by simulation, or None."""
    for line in page.read_text().splitlines():
        if line.startswith("$ placedpar run examples/"):
            command = re.split("[;|>]", line.removeprefix("$ placedpar run "))[0]
            arguments = shlex.split(command, comments=True)
            if (TREE / arguments[0]).exists() and not {"--native", "--predict"} & set(arguments):
                return arguments
    return None


def without_pictures(arguments):
    """Returns the arguments without options that write a picture or choose a part of one."""
    kept = []
    rest = iter(arguments)
    for argument in rest:
        if argument.startswith("--trace"):
            next(rest, None)
        else:
            kept.append(argument)
    return kept


def draw_runs(program, folder):
    """Writes the page of the run that each example shows first, as FOLDER/NAME/OF/EXAMPLE.html."""
    for page in sorted((TREE / "examples").glob("**/README.md")):
        arguments = first_run(page)
        drawn = folder / page.parent.relative_to(TREE / "examples").with_suffix(".html")
        if arguments is None:
            continue
        drawn.parent.mkdir(parents=True, exist_ok=True)
        run = subprocess.run([program, "run", *without_pictures(arguments), "--page", drawn], cwd=TREE,
                             stdin=subprocess.DEVNULL, capture_output=True, text=True)
        done = "drawn" if drawn.exists() else "not drawn, for it needs a file that is made first"
        print(f"{done}: the run of {page.relative_to(TREE)}", flush=True)


def read_headers(headers, xml):
    """Lets Doxygen read the public headers, which are all but those in detail/."""
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


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("program", type=pathlib.Path)
    options.add_argument("headers", type=pathlib.Path, help="the folder placedpar of the staged headers")
    options.add_argument("folder", type=pathlib.Path)
    given = options.parse_args()
    folder = given.folder.absolute()
    link_pages(folder / "source")
    read_headers(given.headers.absolute(), folder / "xml")
    write_interface_pages(folder / "xml", folder / "source" / "interfaces" / "cpp")
    shutil.rmtree(folder / "runs", ignore_errors=True)
    draw_runs(given.program.absolute(), folder / "runs")
    environment = os.environ | {"PLACEDPAR_API_XML": str(folder / "xml"), "PLACEDPAR_RUNS": str(folder / "runs")}
    (folder / "html").mkdir(exist_ok=True)
    (folder / "html" / "index.html").write_text('<meta http-equiv="refresh" content="0; url=README.html">\n')
    return subprocess.run(["sphinx-build", "-q", "-E", "-W", "--keep-going", "-j", "auto", "-c", HERE, "-d", folder / "doctrees",
                           folder / "source", folder / "html"], env=environment).returncode


if __name__ == "__main__":
    sys.exit(main())
