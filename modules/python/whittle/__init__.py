"""Simplifies triangle meshes.

>>> import numpy as np, whittle
>>> i, j = np.meshgrid(np.arange(50), np.arange(50), indexing="ij")
>>> points = np.stack([i, j, np.sin(i / 8) * np.cos(j / 8)], axis=-1).reshape(-1, 3)
>>> corner = (i * 50 + j)[:-1, :-1].ravel()
>>> lower, upper = [corner, corner + 50, corner + 51], [corner, corner + 51, corner + 1]
>>> faces = np.concatenate([np.stack(lower, axis=-1), np.stack(upper, axis=-1)])
>>> small = whittle.simplify(points, faces, face_ratio=0.1)
>>> len(faces), len(small.faces)
(4802, 480)
>>> whittle.measure(whittle.Mesh(points, faces), small)["mean_rel"] < 2e-4
True
"""

from ._core import ReadError, RecordingError, UnsupportedMesh, WriteError, __version__
from ._levels import Geomorph, Level, Recording, geomorph, lod, record
from ._measure import Verification, certificate, certify, info, measure, verify
from ._mesh import Mesh, read, write
from ._options import OPTIONS
from ._polish import Polished, polish
from ._report import Page, report
from ._simplify import Result, simplify

__all__ = [
    "OPTIONS",
    "Geomorph",
    "Level",
    "Mesh",
    "Page",
    "Polished",
    "ReadError",
    "Recording",
    "RecordingError",
    "Result",
    "UnsupportedMesh",
    "Verification",
    "WriteError",
    "__version__",
    "certificate",
    "certify",
    "geomorph",
    "info",
    "lod",
    "measure",
    "polish",
    "read",
    "record",
    "report",
    "simplify",
    "verify",
    "write",
]
