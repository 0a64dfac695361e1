"""The notebooks run from the first cell to the last."""

import os
from pathlib import Path

import pytest

folder = Path(os.environ["WHITTLE_SOURCE_DIR"]) / "docs" / "notebooks"


@pytest.mark.parametrize("path", sorted(folder.glob("*.ipynb")), ids=lambda path: path.stem)
def test_notebook(path):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    pytest.importorskip("plotly")
    notebook = nbformat.read(path, as_version=4)
    assert all(not cell.get("outputs") for cell in notebook.cells), "it is kept without its outputs"
    nbclient.NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(folder)}}).execute()
    drawn = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("application/vnd.plotly.v1+json" in output.get("data", {}) for output in drawn)
