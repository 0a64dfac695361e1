"""Levels of detail, and recordings of runs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import _core
from ._mesh import Mesh
from ._objects import as_mesh
from ._options import given
from ._progress import told
from ._simplify import simplify

__all__ = ["Geomorph", "Recording", "geomorph", "lod", "record"]


def lod(
    mesh: Any,
    *,
    faces: Sequence[int] | None = None,
    face_ratios: Sequence[float] | None = None,
    threads: int = 0,
    progress: Any = None,
    **options: Any,
) -> list[Mesh]:
    """Levels of detail out of one run, the finest first: each is polished, and the run goes on from there.

    >>> import whittle
    >>> square = whittle.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0.1]],
    ...                       [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
    >>> [len(level.faces) for level in whittle.lod(square, faces=[2])]
    [2]

    Parameters
    ----------
    mesh
        A `Mesh`, or what `simplify` takes as one object; or a pair of points and faces.
    faces, face_ratios
        Numbers of faces, or shares of them, (0, 1).
    options
        As for `simplify`, but for targets.
    """
    of = as_mesh(mesh)
    n = len(of.faces)
    counts = {*(faces or ()), *(max(1, round(ratio * n)) for ratio in face_ratios or ())}
    if not counts:
        raise ValueError("no target: give faces or face_ratios")
    if max(counts) >= n or min(counts) < 1:
        raise ValueError(f"levels have from 1 to {n - 1} faces here")
    wishes = _core.Wishes()
    wishes.options = given(options)
    wishes.threads = threads
    with told(progress) as callable_:
        levels = _core.levels(of._core, of is not mesh, sorted(counts, reverse=True), wishes, callable_)
    return [Mesh._of(level) for level in levels]


class Geomorph:
    """A continuous way between two levels of a recording."""

    def __init__(self, core: _core.Geomorph) -> None:
        self._core = core

    def at(self, share: float) -> Mesh:
        """The surface in between: 0 is the finer level, 1 the coarser one."""
        return Mesh._of(self._core.at(share))

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes a glTF file (.glb) with a morph target, and an animation that goes there and back."""
        Path(path).write_bytes(self._core.glb())


class Recording:
    """A recorded run: any level of detail, without running again.

    `len` is the number of levels: level 0 is the input, the last one the result.
    """

    def __init__(self, source: bytes | str | os.PathLike[str]) -> None:
        """Of the bytes of a recording, or of a file that `simplify --record` or `save` has written."""
        self._core = _core.Recording(source if isinstance(source, bytes) else Path(source).read_bytes())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it, for `whittle replay`, `geomorph` and `report`."""
        Path(path).write_bytes(self._core.bytes)

    def __len__(self) -> int:
        return self._core.n_levels

    def step_of(self, *, faces: int | None = None, vertices: int | None = None) -> int:
        """The number of the level with at most so many faces or vertices."""
        if (faces is None) == (vertices is None):
            raise ValueError("give faces or vertices")
        return self._core.level_of(faces, vertices)

    def level(self, step: int | None = None, *, faces: int | None = None, vertices: int | None = None) -> Mesh:
        """A level by its number, or with at most so many faces or vertices."""
        if step is None:
            step = self.step_of(faces=faces, vertices=vertices)
        if not -len(self) <= step < len(self):
            raise IndexError(f"the recording has the levels 0 to {len(self) - 1}")
        return Mesh._of(self._core.level(step % len(self)))


def record(mesh: Any, faces: Any = None, **options: Any) -> Recording:
    """Simplifies as `simplify` does, and keeps all steps.

    >>> import whittle
    >>> points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0.1]]
    >>> recording = whittle.record(points, [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], faces_left=2)
    >>> len(recording.level(0).faces), len(recording.level(-1).faces)
    (4, 2)
    """
    result = simplify(mesh, faces, record=True, as_result=True, **options)
    assert result.recording is not None  # as it was asked for
    return Recording(result.recording)


def geomorph(recording: Recording, *, fine: int, coarse: int) -> Geomorph:
    """The way between the levels with at most `fine` and `coarse` faces."""
    steps = recording.step_of(faces=fine), recording.step_of(faces=coarse)
    return Geomorph(recording._core.geomorph(*steps))
