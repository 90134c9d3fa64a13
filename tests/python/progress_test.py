"""Tests the line of progress: on a terminal, in a notebook, and nowhere else."""

import io
import os
import pathlib
import sys
import types
import unittest
import unittest.mock

import placedpar as pp
from placedpar.progress import progress_of

FIGURE_E2 = pathlib.Path(os.environ["PLACEDPAR_SOURCE"], "examples", "thesis", "figure-e2", "figure-e2.cfs")


class Terminal(io.StringIO):
    def isatty(self):
        return True


class Progress(unittest.TestCase):
    def told(self, stream, option=None):
        """Returns what is written about work that is told of twice, the second time after a second."""
        with unittest.mock.patch.object(sys, "stderr", stream), unittest.mock.patch("time.monotonic") as clock:
            clock.return_value = 100.0
            with progress_of(option, "{} of {} runs") as tell:
                if tell:
                    tell(1, 40)
                    clock.return_value = 101.0
                    tell(7, 40)
        return stream.getvalue()

    def test_a_line_is_shown_on_a_terminal_only(self):
        self.assertEqual(self.told(Terminal()), "\r7 of 40 runs\x1b[K\r\x1b[K")
        self.assertEqual(self.told(io.StringIO()), "")
        self.assertEqual(self.told(Terminal(), False), "")

    def test_a_function_is_told_in_place_of_the_line(self):
        told = []
        self.assertEqual(self.told(Terminal(), lambda *made: told.append(made)), "")
        self.assertEqual(told, [(1, 40), (7, 40)])

    def test_a_notebook_shows_a_line(self):
        shown = []

        class Handle:
            def update(self, data, raw):
                shown.append(data["text/plain"])

        def display(data, raw, display_id):
            shown.append(data["text/plain"])
            return Handle()
        notebook = types.SimpleNamespace(get_ipython=lambda: types.SimpleNamespace(kernel=True))
        with unittest.mock.patch.dict(sys.modules, {"IPython": notebook,
                                                    "IPython.display": types.SimpleNamespace(display=display)}):
            self.assertEqual(self.told(Terminal()), "")
        self.assertEqual(shown, ["7 of 40 runs", ""])

    def test_sweeps_and_runs_show_nothing_where_there_is_no_terminal(self):
        net = pp.load(FIGURE_E2, slaves=1)
        with unittest.mock.patch.object(sys, "stderr", io.StringIO()) as stream:
            pp.sweep(net, slaves=[1, 2])
            net.run()
            pp.explain(net)
        self.assertEqual(stream.getvalue(), "")


if __name__ == "__main__":
    unittest.main()
