"""Checks that the notebook's cells print the outputs stored in it. If Jupyter is installed
(`make python`), its kernel runs the notebook; otherwise the cells run one by one in this process.
"""

import contextlib
import io
import json
import os
import shutil
import unittest

import checks
import frob  # noqa: F401 -- it is to be there

ROOT = os.environ["FROB_ROOT"]
NAME = "wall_follower.ipynb"


def printed(cell):
    return "".join(
        "".join(o.get("text", "")) for o in cell["outputs"] if o["output_type"] == "stream"
    )


def by_hand(notebook):
    """Returns the output of each code cell."""
    names = {"__name__": "__main__"}
    told = []
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                exec(compile("".join(cell["source"]), NAME, "exec"), names)
            told.append(out.getvalue())
    return told


def by_jupyter(text):
    import nbclient
    import nbformat

    notebook = nbformat.reads(text, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300).execute()
    return [printed(cell) for cell in notebook["cells"] if cell["cell_type"] == "code"]


class Notebook(unittest.TestCase):
    def setUp(self):
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        for name in ("notebook", "wall_follow"):
            shutil.copytree(f"{ROOT}/examples/{name}", f"notes/{name}", dirs_exist_ok=True)
        os.chdir("notes/notebook")

    def test_prints_what_it_shows(self):
        with open(NAME, encoding="utf-8") as file:
            text = file.read()
        notebook = json.loads(text)
        shown = [printed(cell) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        self.assertTrue(any(shown))
        try:
            import nbclient  # noqa: F401
        except ImportError:
            told = by_hand(notebook)
        else:
            told = by_jupyter(text)
        self.assertEqual(told, shown)


if __name__ == "__main__":
    checks.main("the notebook")
