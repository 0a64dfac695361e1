"""Levels of detail, and recordings of runs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

from . import _core
from ._libraries import taken
from ._mesh import Mesh, warn
from ._options import OPTIONS, given
from ._progress import told
from ._simplify import simplify

__all__ = ["Geomorph", "Level", "Recording", "geomorph", "lod", "record"]


class Level(Mesh):
    """A level of detail, and what is proven of it."""

    @property
    def error(self) -> float | None:
        """The proven distance from the input, and of the input from it, model units; None without `errors`."""
        return cast("_core.Level", self._core).error


def _checked(option: str) -> str:
    if option in OPTIONS and OPTIONS[option].group.startswith("Targets"):
        raise TypeError(f"lod() got an unexpected keyword argument '{option}': levels have targets of their own")
    return option


def lod(
    mesh: Any,
    *,
    ratios: Sequence[float] | None = None,
    face_ratios: Sequence[float] | None = None,
    faces: Sequence[int] | None = None,
    errors: Sequence[float | str] | None = None,
    threads: int = 0,
    progress: Any = None,
    **options: Any,
) -> list[Level]:
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
    ratios, face_ratios, faces, errors
        One of these: shares of the vertices, (0, 1); shares of the faces; numbers of faces; or distances that are
        proven, in model units or as "0.1%" of the diagonal. There are fewer levels if the run can't go on.
    options
        As for `simplify`, but for targets.

    Raises
    ------
    ValueError
        A value is out of range, none or two of the four are given, or the mesh hasn't more faces than a number.
    """
    of, _ = taken(mesh, threads)
    targets = _core.LevelTargets()
    targets.ratios = list(ratios or ())
    targets.face_ratios = list(face_ratios or ())
    targets.faces = list(faces or ())
    targets.set_errors([str(error) for error in errors or ()])
    wishes = _core.Wishes()
    wishes.options = given({_checked(name): value for name, value in options.items()})
    wishes.threads = threads
    with told(progress) as callable_:
        levels, texts = _core.levels(of._core, of is not mesh, targets, wishes, callable_)
    warn(texts)
    return [Level._of(level) for level in levels]


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
