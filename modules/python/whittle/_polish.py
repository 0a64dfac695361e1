"""Fitting of meshes that others have simplified."""

from __future__ import annotations

import json
from collections.abc import Callable
from os import PathLike
from typing import Any, Literal, TypeVar, cast, overload

from numpy.typing import ArrayLike

from . import _core
from ._libraries import taken
from ._mesh import Mesh, warn
from ._progress import told

__all__ = ["Polished", "polish"]

_Given = TypeVar("_Given")
Fit = Literal["mean", "balanced", "max"]
Progress = Callable[[str, float], Any] | type | None


class Polished(Mesh):
    """A mesh that was fitted, and what is known of that."""

    @property
    def report(self) -> dict[str, Any]:
        """`passes`, `moved`, and the root mean square distances `rms_before` and `rms_after`, model units."""
        keys: dict[str, Any] = json.loads(cast("_core.Polished", self._core).report)
        return keys


@overload
def polish(
    reference: Any,
    mesh: Mesh | tuple[ArrayLike, ArrayLike] | str | PathLike[str],
    *,
    passes: int = 3,
    fit: Fit = "balanced",
    as_result: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> Polished: ...
@overload
def polish(
    reference: Any,
    mesh: _Given,
    *,
    passes: int = 3,
    fit: Fit = "balanced",
    as_result: Literal[False] = False,
    threads: int = 0,
    progress: Progress = None,
) -> _Given: ...
def polish(
    reference: Any,
    mesh: Any,
    *,
    passes: int = 3,
    fit: Fit = "balanced",
    as_result: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> Any:
    """Fits a simplified mesh, anyone's, to the mesh it was made from. Vertices move; faces stay.

    >>> import whittle
    >>> square = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 0.1]]
    >>> faces = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    >>> moved = whittle.Mesh([*square[:4], [1, 1, 0.2]], faces)
    >>> better = whittle.polish((square, faces), moved)
    >>> bool(0.05 < better.points[4, 2] < 0.15)
    True

    Parameters
    ----------
    reference, mesh
        Each a `Mesh`, a pair of points and faces, or what else `simplify` takes as one object.
    passes
        The largest number of passes; they end when one no longer lowers the error.
    fit
        What counts: "mean", the mean distance; "max", the largest one; or "balanced".
    as_result
        Whether to return a `Polished` for any mesh.
    threads, progress
        As for `simplify`.

    Returns
    -------
    A `Polished` for a `Mesh`, arrays and a path; else a mesh as it was given.
    """
    original, _ = taken(reference, threads)
    of, given_back = taken(mesh, threads)
    with told(progress) as callable_:
        core = _core.polish(original._core, of._core, passes, fit, threads, callable_)
    warn(core.warnings)
    result = Polished._of(core)
    return result if as_result else given_back(result)
