"""What is measured and proven of meshes."""

from __future__ import annotations

import json
from typing import Any

from . import _core
from ._core import Verification
from ._libraries import as_mesh
from ._mesh import Mesh
from ._progress import told

__all__ = ["Mesh", "Verification", "certificate", "certify", "info", "measure", "verify"]


def _read(report: str) -> dict[str, Any]:
    keys: dict[str, Any] = json.loads(report)
    return keys


def info(mesh: Any, *, threads: int = 0, progress: Any = None) -> dict[str, Any]:
    """Facts about a mesh: counts, borders, holes, the quality of its triangles, and self-intersections.

    >>> import whittle
    >>> whittle.info(whittle.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))["closed"]
    False
    """
    with told(progress) as callable_:
        return _read(_core.info(as_mesh(mesh)._core, threads, callable_))


def measure(
    reference: Any, test: Any, *, samples: int = 500_000, seed: int = 1, threads: int = 0, progress: Any = None
) -> dict[str, Any]:
    """The distance between two surfaces, both ways, and the quality of the second one's triangles.

    Distances are in model units, and as `…_rel` over the diagonal of the reference's bounding box. `samples` points are
    taken of each surface, and all of its vertices; for each the closest point on the other surface is exact.
    """
    with told(progress) as callable_:
        return _read(_core.measure(as_mesh(reference)._core, as_mesh(test)._core, samples, seed, threads, callable_))


def certify(
    reference: Any, test: Any, *, accuracy: float = 1e-3, threads: int = 0, progress: Any = None
) -> dict[str, Any]:
    """The largest distance between two surfaces, proven for all their points, both ways.

    >>> import whittle
    >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> flat = whittle.Mesh(square, [[0, 1, 2], [0, 2, 3]])
    >>> bent = whittle.Mesh([[0, 0, 0.125], *square[1:]], [[0, 1, 2], [0, 2, 3]])
    >>> round(whittle.certify(flat, bent)["proven"], 3)
    0.125

    `accuracy` is a share of each distance, [1e-6, 1].
    """
    with told(progress) as callable_:
        return _read(_core.certify(as_mesh(reference)._core, as_mesh(test)._core, accuracy, threads, callable_))


def certificate(reference: Any, test: Any, max_error: float, *, threads: int = 0, progress: Any = None) -> bytes | None:
    """The steps of a proof that two surfaces are within a distance of each other; None if they aren't, or it fails.

    `max_error` is in model units, above 0.
    """
    with told(progress) as callable_:
        return _core.certificate(as_mesh(reference)._core, as_mesh(test)._core, max_error, threads, callable_)


def verify(reference: Any, test: Any, certificate: bytes, *, threads: int = 0) -> Verification:
    """Checks a certificate by following each step of the proof. Its result is true if the proof holds."""
    return _core.verify(as_mesh(reference)._core, as_mesh(test)._core, certificate, threads)
