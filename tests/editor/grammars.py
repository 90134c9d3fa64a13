"""Compares the words that VS Code's tokenizer finds with stored ones.

grammars.py TREE [--write]. The folder PLACEDPAR_NPM has node_modules with vscode-tmgrammar-test; without it the test is
skipped, with exit code 77.
"""

import os
import pathlib
import subprocess
import sys


def main(tree, *options):
    tokenizer = pathlib.Path(os.environ.get("PLACEDPAR_NPM", "")) / "node_modules/.bin/vscode-tmgrammar-snap"
    if "PLACEDPAR_NPM" not in os.environ or not tokenizer.exists():
        print("skipped: PLACEDPAR_NPM names no folder in which vscode-tmgrammar-test was installed with npm")
        return 77
    vscode = pathlib.Path(tree) / "editors/vscode"
    texts = sorted(str(each) for each in (pathlib.Path(tree) / "tests/editor/snapshots").iterdir() if each.suffix != ".snap")
    update = ["--updateSnapshot"] if "--write" in options else []
    return subprocess.run([tokenizer, "--config", vscode / "package.json", *update, *texts], check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
