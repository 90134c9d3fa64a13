"""Executes the notebooks of examples/python, where Debian's nbconvert and ipykernel are installed."""

import importlib.util
import os
import pathlib
import unittest

NOTEBOOKS = pathlib.Path(os.environ["PLACEDPAR_SOURCE"], "examples", "python")
MISSING = [name for name in ("nbconvert", "ipykernel", "pandas") if importlib.util.find_spec(name) is None]


@unittest.skipIf(MISSING, f"not installed: {', '.join(MISSING)}")
class Notebooks(unittest.TestCase):
    def execute(self, name):
        """Returns the texts that the cells of the notebook print or show."""
        import nbformat
        from nbconvert.preprocessors import ExecutePreprocessor
        notebook = nbformat.read(NOTEBOOKS / name, as_version=4)
        ExecutePreprocessor(timeout=300).preprocess(notebook, {"metadata": {"path": str(NOTEBOOKS)}})
        outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
        return "\n".join(output.get("text", "") or "\n".join(map(str, output.get("data", {}).values())) for output in outputs)

    def test_all_notebooks_are_executed(self):
        expected = {"first-steps-in-csp": "cycle: a -&gt; b -&gt; a|cycle: a -> b -> a",
                    "islands-against-one-population": "p against one population",
                    "which-machine-for-the-job": "what holds it back(.|\n)*<svg"}
        self.assertEqual({path.stem for path in NOTEBOOKS.glob("*.ipynb")}, set(expected))
        for name, shown in expected.items():
            with self.subTest(name):
                self.assertRegex(self.execute(f"{name}.ipynb"), shown)


if __name__ == "__main__":
    unittest.main()
