"""Simplification."""

from __future__ import annotations

import json
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._libraries import taken
from ._mesh import Mesh, warn
from ._options import given, with_options
from ._progress import told


class Result(Mesh):
    """A simplified mesh, and what is known of it."""

    @property
    def _run(self) -> _core.Result:
        return cast("_core.Result", self._core)

    @property
    def report(self) -> dict[str, Any]:
        """What the program writes with `--json`: docs/user/simplify.md has the keys."""
        return json.loads(self._run.report)

    @property
    def warnings(self) -> list[str]:
        return self._run.warnings

    @property
    def met(self) -> bool:
        """Whether the number of faces or vertices that was asked for is reached."""
        return self._run.met

    @property
    def vertex_map(self) -> NDArray[np.int64]:
        """For each point that was given, its point here; -1 if no face had it."""
        return self._run.vertex_map

    @property
    def face_origins(self) -> NDArray[np.int64]:
        """For each face, the face that it was, among those after repairs."""
        return self._run.face_origins

    @property
    def certificate(self) -> bytes:
        """The steps of the proof, if they were asked for: `verify` checks them."""
        return self._run.certificate

    @property
    def recording(self) -> bytes | None:
        """The steps of the run, if they were asked for: `Recording` has its levels."""
        return self._run.recording


def _wishes(
    locked: ArrayLike | None, certificate: bool, record: bool, threads: int, options: dict[str, Any]
) -> _core.Wishes:
    wishes = _core.Wishes()
    wishes.options = given(options)
    if locked is not None:
        wishes.locked = np.ascontiguousarray(locked, dtype=np.uint8)
    wishes.certificate = certificate
    wishes.recording = record
    wishes.threads = threads
    return wishes


@with_options
def simplify(
    mesh: Any,
    faces: ArrayLike | None = None,
    *,
    normals: ArrayLike | None = None,
    colors: ArrayLike | None = None,
    texcoords: ArrayLike | None = None,
    attributes: dict[str, ArrayLike] | None = None,
    locked: ArrayLike | None = None,
    certificate: bool = False,
    record: bool = False,
    as_result: bool = False,
    progress: Any = None,
    threads: int = 0,
    **options: Any,
) -> Any:
    """Simplifies a mesh to a number or share of its faces or vertices, or within a distance.

    >>> import whittle
    >>> points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0]]
    >>> faces = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    >>> small = whittle.simplify(points, faces, faces_left=2)
    >>> len(small.faces), small.report["target"]["met"]
    (2, True)

    Parameters
    ----------
    mesh
        Points (V, 3), with `faces`; a pair of both; a `Mesh`; the path of a file; or a mesh of trimesh, PyVista, VTK,
        Open3D, meshio or PyMeshLab.
    faces
        (F, 3), if `mesh` has points alone.
    normals, colors, texcoords, attributes
        As for `Mesh`, if `mesh` has points alone.
    locked
        (V,): vertices with a number other than 0 stay where they are.
    certificate
        Whether to make the steps of the proof (`Result.certificate`).
    record
        Whether to keep the steps of the run (`Result.recording`).
    as_result
        Whether to return a `Result` for any mesh.
    progress
        A callable that gets the stage, and the fraction of it that is done; or a class such as `tqdm.tqdm`.
    threads
        0: all cores. No result depends on it.

    Returns
    -------
    A `Result` for arrays, a `Mesh` and a path; else a mesh as it was given.

    Raises
    ------
    ValueError
        A value is out of range, options don't go together, or the arrays are no mesh. The message is the program's.
    KeyboardInterrupt
        Ctrl-C ends the call.

    Options are those of the program; `faces_left`, `vertices_left`, `out_normals` and `out_attributes` are its
    `--faces`, `--vertices`, `--normals` and `--attributes`.
    """
    if faces is None:
        of, given_back = taken(mesh, threads)
    else:
        of, given_back = taken(
            Mesh(
                mesh, faces, normals=normals, colors=colors, texcoords=texcoords, attributes=attributes, threads=threads
            )
        )
    with told(progress) as callable_:
        core = _core.simplify(
            of._core, of is not mesh, _wishes(locked, certificate, record, threads, options), callable_
        )
    result = Result._of(core)
    warn(result.warnings)
    return result if as_result else given_back(result)
