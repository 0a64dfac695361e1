"""What the libraries have in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._mesh import Mesh


class Adapter(ABC):
    """A mesh of another library."""

    def __init__(self, given: Any) -> None:
        self.given = given

    @abstractmethod
    def mesh(self, threads: int) -> Mesh:
        """The same mesh as a `Mesh`."""

    @abstractmethod
    def given_back(self, result: Mesh) -> Any:
        """A mesh of the library, with a vertex for each value of its attributes."""


def named(mesh: Mesh) -> dict[str, NDArray[Any]]:
    """Attributes but for texture coordinates."""
    return {name: values for name, values in mesh.attributes.items() if name != "texcoords"}


def as_before(values: NDArray[Any], before: Mapping[str, Any], name: str) -> NDArray[Any]:
    """An array of the type, and with the shape of a row, that it had."""
    if name not in before:
        return np.array(values)
    old = np.asarray(before[name])
    numbers = np.rint(values) if old.dtype.kind in "iu" else np.asarray(values)
    return numbers.astype(old.dtype).reshape(len(values), *old.shape[1:])
