"""Meshes: arrays of points and faces, and what belongs to them."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

if TYPE_CHECKING:
    from typing_extensions import Self


def _in_order(array: NDArray[Any]) -> NDArray[Any]:
    """In C order, and in the byte order of the machine. The same array if it is so."""
    return np.ascontiguousarray(array.astype(array.dtype.newbyteorder("="), copy=False))


def _rows(values: ArrayLike, faces: NDArray[Any]) -> NDArray[Any]:
    """In C order, with one row for each vertex, or for each corner of a face."""
    array = np.asarray(values)
    if array.ndim == 3 and array.shape[:2] == (len(faces), 3):
        array = array.reshape(-1, array.shape[2])
    if array.dtype.kind not in "fiub":
        raise TypeError(f"an array of {array.dtype} has no numbers")
    if array.dtype.kind == "f" and array.dtype.itemsize not in (4, 8):
        array = array.astype(np.float64)
    return _in_order(array)


def _points(points: ArrayLike) -> NDArray[Any]:
    array = np.asarray(points)
    return _in_order(array if array.dtype == np.float32 else array.astype(np.float64, copy=False))


def _faces(faces: ArrayLike) -> NDArray[Any]:
    array = np.asarray(faces)
    if array.size == 0:
        array = array.reshape(-1, 3).astype(np.uint32)
    return _in_order(array)


def warn(texts: Sequence[str]) -> None:
    """Warns whoever has called the function that calls this one."""
    for text in texts:
        warnings.warn(text, stacklevel=3)


def _length(value: float | str | bool) -> str:
    """True: exact duplicates; False: nothing is welded; else a length."""
    if isinstance(value, bool):
        return "0" if value else "off"
    return str(value)


class Mesh:
    """A triangle mesh: any set of triangles, open or closed, with attributes.

    Exact duplicates of points on open borders are welded, duplicate faces and faces without three corners are dropped,
    and so are points without a face, as the program does with a file.

    Parameters
    ----------
    points
        (V, 3), real and finite. Single precision stays single precision.
    faces
        (F, 3), integers below V.
    normals, colors, texcoords
        (V, 3), (V, 3 or 4) and (V, 2 or 3); or one for each corner of a face: (F, 3, 3) and so on. Colours of unsigned
        integers go to 255 or 65535, real ones to 1.
    attributes
        Further numbers by name: (V,) or (V, k), or for each corner.
    face_attributes, face_groups, group_names
        Numbers of faces by name: (F,) or (F, k); the material or group of each face: (F,), numbers into `group_names`.
    tolerances
        (V,): with `max_error`, smaller limits near vertices, model units.
    weld
        False, or how near points on open borders may lie to be welded, besides exact duplicates: a length in model
        units, a share of the diagonal such as "0.1%", or "auto".
    threads
        0: all cores. No result depends on it.

    Raises
    ------
    ValueError
        An array has another shape, a number isn't finite, a face has a vertex that isn't there, or no face is left.
    """

    def __init__(
        self,
        points: ArrayLike,
        faces: ArrayLike,
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        texcoords: ArrayLike | None = None,
        attributes: Mapping[str, ArrayLike] | None = None,
        face_attributes: Mapping[str, ArrayLike] | None = None,
        face_groups: ArrayLike | None = None,
        group_names: Sequence[str] = (),
        tolerances: ArrayLike | None = None,
        weld: float | str | bool = True,
        threads: int = 0,
    ) -> None:
        corners = _faces(faces)
        arrays: list[tuple[str, str, NDArray[Any]]] = []
        for name, kind, values in (
            ("normals", "normal", normals),
            ("colors", "color", colors),
            ("texcoords", "texcoord", texcoords),
        ):
            if values is not None:
                arrays.append((name, kind, _rows(values, corners)))
        arrays += [(name, "number", _rows(values, corners)) for name, values in (attributes or {}).items()]
        of_faces = _core.FaceArrays(
            [(name, _rows(values, corners)) for name, values in (face_attributes or {}).items()],
            None if face_groups is None else _rows(face_groups, corners),
            list(group_names),
        )
        self._core: _core.Mesh = _core.Mesh.from_arrays(
            _points(points),
            corners,
            arrays,
            of_faces,
            None if tolerances is None else _rows(tolerances, corners),
            _length(weld),
            threads,
        )

    @classmethod
    def _of(cls, core: _core.Mesh) -> Self:
        mesh = cls.__new__(cls)
        mesh._core = core
        return mesh

    @property
    def points(self) -> NDArray[Any]:
        """(V, 3), float64; float32 if the points were given so."""
        return self._core.points

    @property
    def faces(self) -> NDArray[np.uint32]:
        """(F, 3), counter-clockwise from outside."""
        return self._core.faces

    @property
    def corners(self) -> NDArray[np.uint32]:
        """(F, 3): of each corner the row in normals, colours and attributes. `faces` unless there are seams."""
        wedges = self._core.wedges
        return self._core.faces if wedges is None else wedges

    @property
    def first_rows(self) -> NDArray[np.int64]:
        """(V,): for each point one of its rows in normals, colours and attributes, that of its first face."""
        rows = np.zeros(len(self.points), dtype=np.int64)
        rows[self.faces.ravel()[::-1]] = self.corners.ravel()[::-1]
        return rows

    @property
    def has_seams(self) -> bool:
        """Whether a vertex has several values of an attribute, as at the seams of a texture."""
        return self._core.wedges is not None

    @property
    def normals(self) -> NDArray[np.float32] | None:
        """(W, 3), by `corners`; or None."""
        return self._core.normals

    @property
    def colors(self) -> NDArray[np.float32] | None:
        """(W, 4): red, green, blue and opacity, each to 1, by `corners`; or None."""
        return self._core.colors

    @property
    def texcoords(self) -> NDArray[np.float64] | None:
        """(W, 2 or 3), by `corners`: the first texture coordinates; or None."""
        return next((values for _, is_texture, values in self._core.attributes if is_texture), None)

    @property
    def attributes(self) -> dict[str, NDArray[np.float64]]:
        """Further numbers by name, and all texture coordinates: (W,) or (W, k), by `corners`."""
        return {name: values for name, _, values in self._core.attributes}

    @property
    def face_attributes(self) -> dict[str, NDArray[np.float64]]:
        """Numbers of faces by name: (F,) or (F, k)."""
        return {name: values for name, _, values in self._core.face_attributes}

    @property
    def face_groups(self) -> NDArray[np.uint32] | None:
        """(F,): the material or group of each face, a number into `group_names`; or None."""
        return self._core.face_groups

    @property
    def group_names(self) -> list[str]:
        return self._core.group_names

    @property
    def origins(self) -> NDArray[np.int64]:
        """(V,): the number of each point among those that were given."""
        return self._core.origins

    @property
    def repairs(self) -> dict[str, int]:
        """How much was repaired, by kind."""
        return self._core.repairs

    @property
    def warnings(self) -> list[str]:
        return self._core.warnings

    def split_at_seams(self) -> Mesh:
        """The same surface with a point for each value of its attributes: `corners` are `faces` then."""
        return Mesh._of(self._core.split_at_seams())

    def __repr__(self) -> str:
        return f"<whittle.{type(self).__name__} of {len(self.points)} points and {len(self.faces)} faces>"


def read(
    path: str | os.PathLike[str], *, weld: float | str | bool = True, as_shown: bool = False, threads: int = 0
) -> Mesh:
    """Reads a mesh from an OBJ, PLY, STL, OFF or glTF file.

    Parameters
    ----------
    path
        Of the file. Its extension tells the format; gzip is unpacked.
    weld, threads
        As for `Mesh`.
    as_shown
        Of a glTF file. False: each mesh once; `write` writes the document again, with its nodes, materials, images and
        animations. True: all that its scene shows, each mesh as often as it stands there, for measures and other
        formats.

    Raises
    ------
    whittle.ReadError
        The file isn't a complete and valid mesh file.
    """
    return Mesh._of(_core.Mesh.read(os.fspath(path), _length(weld), as_shown, threads))


def write(
    path: str | os.PathLike[str],
    mesh: Mesh,
    *,
    ascii: bool = False,
    compress: bool = False,
    quantize: bool = False,
    merge_meshes: bool = False,
) -> None:
    """Writes a mesh, or the result of `simplify`, in the format that the extension of the path tells.

    `compress`, `quantize` and `merge_meshes` are for glTF, as the program's options of these names.

    Raises
    ------
    whittle.WriteError
        The file can't be written.
    """
    warn(mesh._core.write(os.fspath(path), ascii, compress, quantize, merge_meshes))
