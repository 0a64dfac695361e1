"""Meshes of other libraries. None of them is imported: an object tells by itself what it is."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from .._mesh import Mesh, read
from .adapter import Adapter
from .open3d import Open3D, Open3DTensor
from .others import Meshio, PyMeshLab, Trimesh
from .vtk import PyVista, Vtk

__all__ = ["adapter_of", "as_mesh", "taken"]

#: What an object has that is a mesh of a library.
_ADAPTERS: list[tuple[type[Adapter], tuple[str, ...]]] = [
    (Trimesh, ("vertices", "faces", "visual", "face_attributes")),
    (PyVista, ("point_data", "cell_data", "is_all_triangles")),
    (Vtk, ("GetPolys", "GetPoints", "GetPointData")),
    (Open3D, ("triangles", "vertices", "has_triangle_uvs")),
    (Open3DTensor, ("triangle", "vertex", "to_legacy")),
    (Meshio, ("cells", "points", "point_data", "cell_data")),
    (PyMeshLab, ("vertex_matrix", "face_matrix")),
]


def adapter_of(given: Any) -> Adapter:
    """Raises TypeError for an object that is no mesh."""
    for adapter, names in _ADAPTERS:
        if all(hasattr(given, name) for name in names):
            return adapter(given)
    raise TypeError(
        f"a {type(given).__name__} is no mesh: give points and faces, a whittle.Mesh, a path, or a mesh of trimesh, "
        "PyVista, VTK, Open3D, meshio or PyMeshLab"
    )


def _as_it_is(result: Mesh) -> Mesh:
    return result


def taken(given: Any, threads: int = 0, as_shown: bool = False) -> tuple[Mesh, Callable[[Mesh], Any]]:
    """What is given as a `Mesh`, and the function that gives back a result of it as the library's.

    That is a `Mesh`, a mesh of a library, the path of a file, or a pair of points and faces.
    """
    if isinstance(given, Mesh):
        return given, _as_it_is
    if isinstance(given, (str, os.PathLike)):
        return read(given, as_shown=as_shown, threads=threads), _as_it_is
    if isinstance(given, tuple) and len(given) == 2:
        return Mesh(*given, threads=threads), _as_it_is
    adapter = adapter_of(given)
    return adapter.mesh(threads), adapter.given_back


def as_mesh(given: Any) -> Mesh:
    """As a `Mesh`, to be looked at: of a file what its scene shows."""
    return taken(given, as_shown=True)[0]
