"""The page to look at meshes in a browser or a notebook."""

from __future__ import annotations

import html
import os
import subprocess
import tempfile
from pathlib import Path
from typing import Any

from ._levels import Recording
from ._libraries import as_mesh
from ._mesh import write

__all__ = ["Page", "report"]


class Page:
    """A page in one file, that needs no network. A notebook shows it inline."""

    def __init__(self, text: str) -> None:
        self.text = text

    def save(self, path: str | os.PathLike[str]) -> None:
        Path(path).write_text(self.text, encoding="utf-8")

    def _repr_html_(self) -> str:
        return f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="640" style="border: 0"></iframe>'


def report(*meshes: Any) -> Page:
    """The page of `whittle report`: the first mesh beside the others, with their error, or with a `Recording`.

    Parameters
    ----------
    meshes
        The original, and results of it: meshes of any kind that `simplify` takes, files, or a `Recording`.

    Raises
    ------
    RuntimeError
        The program has been built without its module for pages.
    """
    from .__main__ import program

    with tempfile.TemporaryDirectory() as folder:
        names = []
        for i, mesh in enumerate(meshes):
            name = str(Path(folder) / ("original" if i == 0 else f"result {i}"))
            if isinstance(mesh, Recording):
                names.append(f"{name}.rec")
                mesh.save(names[-1])
            elif isinstance(mesh, (str, os.PathLike)):
                names.append(os.fspath(mesh))
            else:
                names.append(f"{name}.ply")
                write(names[-1], as_mesh(mesh))
        page = Path(folder) / "page.html"
        command = [str(program()), "report", *names, "-o", str(page), "--quiet"]
        ran = subprocess.run(command, capture_output=True, text=True)
        if ran.returncode != 0:
            raise RuntimeError(ran.stderr.strip())
        return Page(page.read_text(encoding="utf-8"))
