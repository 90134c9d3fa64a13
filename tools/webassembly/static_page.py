#!/usr/bin/env python3
"""Writes the page of `placedpar serve` as files, which work from any web server: the jobs run in the browser.

Usage: static_page.py PLACEDPAR BUILD FOLDER. PLACEDPAR is the program, of the same version as the WebAssembly program in
the folder BUILD. Files in FOLDER are replaced.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.request

PAGE = pathlib.Path(__file__).parent / "page"


def served(placedpar: str) -> dict[str, str]:
    """Returns the page and its data by name, as a server on this computer answers."""
    server = subprocess.Popen([placedpar, "serve", "--port", "0"], stdout=subprocess.PIPE, text=True)
    try:
        address = re.search(r"http://\S+/", server.stdout.readline())
        if not address:
            sys.exit(f"{placedpar} serve has not started")
        names = {"index.html": "", "examples": "examples", "exercises": "exercises", "catalogue": "catalogue"}
        return {name: urllib.request.urlopen(address[0] + path).read().decode() for name, path in names.items()}
    finally:
        server.terminate()
        server.wait()


def write_page(placedpar: str, build: str, folder: str) -> None:
    texts = served(placedpar)
    texts["index.html"] = texts["index.html"].replace("<script>", '<script src="here.js"></script>\n<script>', 1)
    target = pathlib.Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (target / name).write_text(text)
    for file in (PAGE / "here.js", PAGE / "worker.js", pathlib.Path(build) / "job.js", pathlib.Path(build) / "job.wasm"):
        shutil.copy(file, target)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    write_page(*sys.argv[1:])
