"""Copies the source tree, and lets the tools make one piece of each sort there."""

import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests" / "tidy"), str(ROOT / "tools" / "skeleton")]
import tree  # noqa: E402

MADE = {"kind": "hour-glass", "device": "abacus", "problem": "steep-valley", "experiment": "one-way"}


def copy_tree(folder):
    """Copies tracked and new files to a new folder below this one; returns its path."""
    top = pathlib.Path(folder) / "placedpar"
    for name in tree.names(ROOT):
        (top / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, top / name)
    return top


def run_tool(top, what, *arguments):
    """Runs a tool from another folder. Returns the finished process: returncode, stdout, stderr."""
    return subprocess.run([top / "tools" / f"new-{what}", *arguments], cwd="/", capture_output=True, text=True, check=False)


def make_all(top):
    """Makes the four pieces; returns {path: text before, or None} of new and changed files."""
    before = contents(top)
    for what, name in MADE.items():
        done = run_tool(top, what, name)
        assert done.returncode == 0, done.stderr
    return {name: before.get(name) for name, content in contents(top).items() if before.get(name) != content}


def contents(top):
    return {name: (top / name).read_bytes() for name in tree.names(top)}
