# Made by stubs/make_stub.py from the program's table of options.
from collections.abc import Callable, Mapping
from os import PathLike
from typing import Any, Literal, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._mesh import Mesh

_Given = TypeVar("_Given")

class Result(Mesh):
    _core: _core.Result
    @property
    def report(self) -> dict[str, Any]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def met(self) -> bool: ...
    @property
    def vertex_map(self) -> NDArray[np.int64]: ...
    @property
    def face_origins(self) -> NDArray[np.int64]: ...
    @property
    def certificate(self) -> bytes: ...
    @property
    def recording(self) -> bytes | None: ...

@overload
def simplify(
    mesh: ArrayLike,
    faces: ArrayLike,
    *,
    normals: ArrayLike | None = None,
    colors: ArrayLike | None = None,
    texcoords: ArrayLike | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    locked: ArrayLike | None = None,
    certificate: bool = False,
    record: bool = False,
    as_result: bool = False,
    progress: Callable[[str, float], Any] | type | None = None,
    threads: int = 0,
    faces_left: int | None = None,
    vertices_left: int | None = None,
    ratio: float | str | None = None,
    face_ratio: float | str | None = None,
    max_cost: float | str | None = None,
    max_error: float | str | None = None,
    max_error_borders: float | str | None = None,
    per_mesh: bool | None = None,
    certify: bool | None = None,
    tolerance_map: str | None = None,
    out_attributes: Literal["keep", "position-only"] | None = None,
    categories: str | list[str] | Mapping[str, float] | None = None,
    seams: Literal["weighted", "keep"] | None = None,
    regions: str | list[str] | Mapping[str, float] | None = None,
    out_normals: Literal["keep", "recompute", "drop"] | None = None,
    crease_angle: float | str | None = None,
    threshold: float | str | None = None,
    max_pairs: int | None = None,
    across_walls: bool | None = None,
    topology: Literal["keep", "free"] | None = None,
    prune: float | str | None = None,
    effort: Literal["fast", "normal", "best"] | None = None,
    cost: Literal["quadric", "memoryless", "lindstrom-turk", "midpoint"] | None = None,
    weights: Literal["area", "uniform", "area-angle"] | None = None,
    placement: Literal["optimal", "midpoint", "endpoint"] | None = None,
    valence: float | str | None = None,
    isotropic: float | str | None = None,
    order: Literal["exact", "approximate"] | None = None,
    attribute_weight: str | list[str] | Mapping[str, float] | None = None,
    polish: int | None = None,
    fit: Literal["mean", "balanced", "max"] | None = None,
    boundary: Literal["weighted", "locked", "free"] | None = None,
    boundary_weight: float | str | None = None,
    feature_angle: float | str | None = None,
    feature_tolerance: float | str | None = None,
    max_normal_flip: float | str | None = None,
    min_radius_ratio: float | str | None = None,
    self_intersections: Literal["allow", "count", "refuse"] | None = None,
) -> Result: ...
@overload
def simplify(
    mesh: Mesh | str | PathLike[str],
    faces: None = None,
    *,
    normals: ArrayLike | None = None,
    colors: ArrayLike | None = None,
    texcoords: ArrayLike | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    locked: ArrayLike | None = None,
    certificate: bool = False,
    record: bool = False,
    as_result: bool = False,
    progress: Callable[[str, float], Any] | type | None = None,
    threads: int = 0,
    faces_left: int | None = None,
    vertices_left: int | None = None,
    ratio: float | str | None = None,
    face_ratio: float | str | None = None,
    max_cost: float | str | None = None,
    max_error: float | str | None = None,
    max_error_borders: float | str | None = None,
    per_mesh: bool | None = None,
    certify: bool | None = None,
    tolerance_map: str | None = None,
    out_attributes: Literal["keep", "position-only"] | None = None,
    categories: str | list[str] | Mapping[str, float] | None = None,
    seams: Literal["weighted", "keep"] | None = None,
    regions: str | list[str] | Mapping[str, float] | None = None,
    out_normals: Literal["keep", "recompute", "drop"] | None = None,
    crease_angle: float | str | None = None,
    threshold: float | str | None = None,
    max_pairs: int | None = None,
    across_walls: bool | None = None,
    topology: Literal["keep", "free"] | None = None,
    prune: float | str | None = None,
    effort: Literal["fast", "normal", "best"] | None = None,
    cost: Literal["quadric", "memoryless", "lindstrom-turk", "midpoint"] | None = None,
    weights: Literal["area", "uniform", "area-angle"] | None = None,
    placement: Literal["optimal", "midpoint", "endpoint"] | None = None,
    valence: float | str | None = None,
    isotropic: float | str | None = None,
    order: Literal["exact", "approximate"] | None = None,
    attribute_weight: str | list[str] | Mapping[str, float] | None = None,
    polish: int | None = None,
    fit: Literal["mean", "balanced", "max"] | None = None,
    boundary: Literal["weighted", "locked", "free"] | None = None,
    boundary_weight: float | str | None = None,
    feature_angle: float | str | None = None,
    feature_tolerance: float | str | None = None,
    max_normal_flip: float | str | None = None,
    min_radius_ratio: float | str | None = None,
    self_intersections: Literal["allow", "count", "refuse"] | None = None,
) -> Result: ...
@overload
def simplify(
    mesh: _Given,
    faces: None = None,
    *,
    normals: ArrayLike | None = None,
    colors: ArrayLike | None = None,
    texcoords: ArrayLike | None = None,
    attributes: Mapping[str, ArrayLike] | None = None,
    locked: ArrayLike | None = None,
    certificate: bool = False,
    record: bool = False,
    as_result: bool = False,
    progress: Callable[[str, float], Any] | type | None = None,
    threads: int = 0,
    faces_left: int | None = None,
    vertices_left: int | None = None,
    ratio: float | str | None = None,
    face_ratio: float | str | None = None,
    max_cost: float | str | None = None,
    max_error: float | str | None = None,
    max_error_borders: float | str | None = None,
    per_mesh: bool | None = None,
    certify: bool | None = None,
    tolerance_map: str | None = None,
    out_attributes: Literal["keep", "position-only"] | None = None,
    categories: str | list[str] | Mapping[str, float] | None = None,
    seams: Literal["weighted", "keep"] | None = None,
    regions: str | list[str] | Mapping[str, float] | None = None,
    out_normals: Literal["keep", "recompute", "drop"] | None = None,
    crease_angle: float | str | None = None,
    threshold: float | str | None = None,
    max_pairs: int | None = None,
    across_walls: bool | None = None,
    topology: Literal["keep", "free"] | None = None,
    prune: float | str | None = None,
    effort: Literal["fast", "normal", "best"] | None = None,
    cost: Literal["quadric", "memoryless", "lindstrom-turk", "midpoint"] | None = None,
    weights: Literal["area", "uniform", "area-angle"] | None = None,
    placement: Literal["optimal", "midpoint", "endpoint"] | None = None,
    valence: float | str | None = None,
    isotropic: float | str | None = None,
    order: Literal["exact", "approximate"] | None = None,
    attribute_weight: str | list[str] | Mapping[str, float] | None = None,
    polish: int | None = None,
    fit: Literal["mean", "balanced", "max"] | None = None,
    boundary: Literal["weighted", "locked", "free"] | None = None,
    boundary_weight: float | str | None = None,
    feature_angle: float | str | None = None,
    feature_tolerance: float | str | None = None,
    max_normal_flip: float | str | None = None,
    min_radius_ratio: float | str | None = None,
    self_intersections: Literal["allow", "count", "refuse"] | None = None,
) -> _Given: ...
