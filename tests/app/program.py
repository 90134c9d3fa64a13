"""Runs the program under test, named by the environment variable PLACEDPAR."""

import os
import pathlib
import subprocess

PROGRAM = os.environ["PLACEDPAR"]
EXAMPLES = pathlib.Path(os.environ["PLACEDPAR_EXAMPLES"])
CLUSTER = EXAMPLES / "thesis/table-e1" / "cluster.cfs"
FIGURE_E2 = EXAMPLES / "thesis/figure-e2" / "figure-e2.cfs"


def placedpar(*arguments, environment=None, folder=None, typed=None):
    """Returns the finished process, which reads the text `typed` as standard input: returncode, stdout, stderr."""
    return subprocess.run([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env={**os.environ, **(environment or {})}, timeout=120, check=False, cwd=folder, input=typed)


def fingerprint(output):
    """Returns the fingerprint that a run printed."""
    for line in output.splitlines():
        if line.startswith("fingerprint: "):
            return line.split()[1]
    raise AssertionError("no fingerprint in\n" + output)
