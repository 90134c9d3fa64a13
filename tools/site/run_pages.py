"""Adds the page of a run to the page of its example, if build.py has written the page of the run."""

import os
import pathlib
import shutil

RUNS = pathlib.Path(os.environ["PLACEDPAR_RUNS"])


def add_run(app, docname, source):
    """Adds a frame with the run's page to the page of an example."""
    run = docname.removeprefix("examples/").removesuffix("/README") + ".html"
    if not docname.startswith("examples/") or not (RUNS / run).exists():
        return
    address = "../" * docname.count("/") + "runs/" + run
    source[0] += (f'\n\n## The run\n\n<iframe class="run" loading="lazy" title="the page of the run" src="{address}">'
                  f'</iframe>\n<p><a href="{address}">Open the run in a separate page</a></p>\n')


def copy_runs(app, exception):
    if not exception:
        shutil.copytree(RUNS, pathlib.Path(app.outdir) / "runs", dirs_exist_ok=True)


def setup(app):
    app.connect("source-read", add_run)
    app.connect("build-finished", copy_runs)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
