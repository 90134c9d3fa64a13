"""Runs the code of the guide."""

import contextlib
import io
import os
import pathlib
import re
import unittest

try:
    import pandas
except ImportError:
    pandas = None

SOURCE = pathlib.Path(os.environ["PLACEDPAR_SOURCE"])


class Guide(unittest.TestCase):
    @unittest.skipIf(pandas is None, "pandas is not installed: the guide identifies a DataFrame")
    def test_the_code_of_the_guide_runs(self):
        text = (SOURCE / "docs" / "guides" / "python.md").read_text(encoding="utf-8")
        code = "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(SOURCE)
        names = {}
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, "python.md", "exec"), names)
        self.assertRegex(printed.getvalue(), r"ends +total +6\n")
        self.assertIn("what holds it back", printed.getvalue())
        self.assertIn("philosopher 0 eats\n", printed.getvalue())
        self.assertEqual(list(names["dinners"]["outcome"]), ["completed"] * 4 + ["deadlock"])
        self.assertEqual(len(names["table"]), 3 * 2 * 2)
        self.assertEqual(names["found"].links["compliance"][0].round(4), 0.0083)


if __name__ == "__main__":
    unittest.main()
