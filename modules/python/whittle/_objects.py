"""Meshes of other libraries. None of them is imported: an object tells by itself what it is."""

from __future__ import annotations

import importlib
import os
from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._mesh import Mesh, read


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


def _named(mesh: Mesh) -> dict[str, NDArray[Any]]:
    """Attributes but for texture coordinates."""
    texture = mesh.texcoords
    return {name: values for name, values in mesh.attributes.items() if values is not texture and name != "texcoords"}


class _Trimesh(Adapter):
    def mesh(self, threads: int) -> Mesh:
        mesh = self.given
        visual = mesh.visual
        colors = visual.vertex_colors if visual.kind == "vertex" else None
        face_attributes = {f"face {name}": values for name, values in mesh.face_attributes.items()}
        if visual.kind == "face":
            face_attributes["face colors"] = visual.face_colors
        return Mesh(
            mesh.vertices.view(np.ndarray),
            mesh.faces.view(np.ndarray),
            colors=colors,
            texcoords=getattr(visual, "uv", None),
            attributes=dict(mesh.vertex_attributes),
            face_attributes=face_attributes,
            threads=threads,
        )

    def given_back(self, result: Mesh) -> Any:
        split = result.split_at_seams()
        mesh = type(self.given)(vertices=split.points, faces=split.faces, process=False, metadata=self.given.metadata)
        visual = self.given.visual
        if split.texcoords is not None:
            mesh.visual = type(visual)(uv=np.array(split.texcoords), material=visual.material)
        elif split.colors is not None:
            mesh.visual.vertex_colors = np.rint(255 * split.colors).astype(np.uint8)
        for name, values in _named(split).items():
            mesh.vertex_attributes[name] = np.array(values, dtype=self.given.vertex_attributes[name].dtype)
        for name, values in split.face_attributes.items():
            if name == "face colors":
                mesh.visual.face_colors = values.astype(np.uint8)
            else:
                mesh.face_attributes[name.removeprefix("face ")] = np.array(values)
        return mesh


class _PyVista(Adapter):
    """pyvista.PolyData."""

    def mesh(self, threads: int) -> Mesh:
        surface = self.given if self.given.is_all_triangles else self.given.triangulate()
        arrays = {name: surface.point_data[name] for name in surface.point_data}
        texture, normals = surface.point_data.active_texture_coordinates, surface.point_data.active_normals
        for name in (surface.point_data.active_texture_coordinates_name, surface.point_data.active_normals_name):
            arrays.pop(name, None)
        self._texture = surface.point_data.active_texture_coordinates_name
        cells = {name: surface.cell_data[name] for name in surface.cell_data}
        return Mesh(
            np.asarray(surface.points),
            surface.faces.reshape(-1, 4)[:, 1:],
            normals=normals,
            texcoords=texture,
            attributes=arrays,
            face_attributes=cells,
            threads=threads,
        )

    def given_back(self, result: Mesh) -> Any:
        split = result.split_at_seams()
        faces = np.empty((len(split.faces), 4), dtype=np.int64)
        faces[:, 0] = 3
        faces[:, 1:] = split.faces
        surface = type(self.given)(np.array(split.points), faces.ravel())
        for name, values in _named(split).items():
            surface.point_data[name] = _as_before(values, self.given.point_data, name)
        if split.texcoords is not None:
            surface.point_data[self._texture] = np.array(split.texcoords)
            surface.point_data.active_texture_coordinates_name = self._texture
        if split.normals is not None:
            surface.point_data.active_normals = np.array(split.normals)
        for name, values in split.face_attributes.items():
            surface.cell_data[name] = _as_before(values, self.given.cell_data, name)
        return surface


def _as_before(values: NDArray[Any], before: Any, name: str) -> NDArray[Any]:
    """An array of the type that it had."""
    if name not in before:
        return np.array(values)
    dtype = np.asarray(before[name]).dtype
    return (np.rint(values) if dtype.kind in "iu" else np.asarray(values)).astype(dtype)


def _vtk(module: str) -> Any:
    """A module of VTK, which is there, as the object is."""
    return importlib.import_module(f"vtkmodules.{module}")


class _Vtk(Adapter):
    """vtkPolyData, of which only points and triangles, and arrays of points, are taken."""

    def mesh(self, threads: int) -> Mesh:
        vtk_to_numpy = _vtk("util.numpy_support").vtk_to_numpy
        surface = self.given
        cells = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
        offsets = vtk_to_numpy(surface.GetPolys().GetOffsetsArray())
        if np.any(np.diff(offsets) != 3):
            raise ValueError("not all cells are triangles: vtkTriangleFilter makes them so")
        data = surface.GetPointData()
        arrays = {}
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            if array is not None:
                arrays[array.GetName() or f"array {i}"] = vtk_to_numpy(array)
        return Mesh(
            vtk_to_numpy(surface.GetPoints().GetData()), cells.reshape(-1, 3), attributes=arrays, threads=threads
        )

    def given_back(self, result: Mesh) -> Any:
        numpy_to_vtk = _vtk("util.numpy_support").numpy_to_vtk
        split = result.split_at_seams()
        points = _vtk("vtkCommonCore").vtkPoints()
        points.SetData(numpy_to_vtk(np.array(split.points), deep=True))
        cells = _vtk("vtkCommonDataModel").vtkCellArray()
        cells.SetData(
            3, _vtk("util.numpy_support").numpy_to_vtkIdTypeArray(split.faces.astype(np.int64).ravel(), deep=True)
        )
        surface = self.given.NewInstance()
        surface.SetPoints(points)
        surface.SetPolys(cells)
        for name, values in split.attributes.items():
            array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            array.SetName(name)
            surface.GetPointData().AddArray(array)
        return surface


class _Open3D(Adapter):
    """open3d.geometry.TriangleMesh."""

    def mesh(self, threads: int) -> Mesh:
        mesh = self.given
        return Mesh(
            np.asarray(mesh.vertices),
            np.asarray(mesh.triangles),
            normals=np.asarray(mesh.vertex_normals) if mesh.has_vertex_normals() else None,
            colors=np.asarray(mesh.vertex_colors) if mesh.has_vertex_colors() else None,
            texcoords=np.asarray(mesh.triangle_uvs) if mesh.has_triangle_uvs() else None,
            face_groups=np.asarray(mesh.triangle_material_ids) if mesh.has_triangle_material_ids() else None,
            threads=threads,
        )

    def given_back(self, result: Mesh) -> Any:
        # Its vertices have one normal and one colour each, and each corner of a triangle its texture coordinates.
        mesh = type(self.given)()
        mesh.vertices = type(self.given.vertices)(np.asarray(result.points, dtype=np.float64))
        mesh.triangles = type(self.given.triangles)(result.faces.astype(np.int32))
        first = result.first_rows
        if result.normals is not None:
            mesh.vertex_normals = type(self.given.vertex_normals)(result.normals[first].astype(np.float64))
        if result.colors is not None:
            mesh.vertex_colors = type(self.given.vertex_colors)(result.colors[first, :3].astype(np.float64))
        if result.texcoords is not None:
            mesh.triangle_uvs = type(self.given.triangle_uvs)(result.texcoords[result.corners.ravel(), :2])
            mesh.textures = self.given.textures
        if result.face_groups is not None:
            mesh.triangle_material_ids = type(self.given.triangle_material_ids)(result.face_groups.astype(np.int32))
        return mesh


class _Meshio(Adapter):
    """meshio.Mesh, all cells of which are triangles."""

    def mesh(self, threads: int) -> Mesh:
        mesh = self.given
        other = sorted({block.type for block in mesh.cells} - {"triangle"})
        if other:
            raise ValueError(f"not all cells are triangles: there are cells of the type {other[0]}")
        faces = np.concatenate([block.data for block in mesh.cells]) if mesh.cells else np.zeros((0, 3), np.uint32)
        points = mesh.points
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points))])
        cells = {name: np.concatenate(parts) for name, parts in mesh.cell_data.items()}
        return Mesh(points, faces, attributes=dict(mesh.point_data), face_attributes=cells, threads=threads)

    def given_back(self, result: Mesh) -> Any:
        split = result.split_at_seams()
        return type(self.given)(
            np.array(split.points),
            [("triangle", split.faces.astype(np.int64))],
            point_data={n: _as_before(v, self.given.point_data, n) for n, v in split.attributes.items()},
            cell_data={n: [np.array(v)] for n, v in split.face_attributes.items()},
        )


class _PyMeshLab(Adapter):
    """pymeshlab.Mesh."""

    def mesh(self, threads: int) -> Mesh:
        mesh = self.given
        return Mesh(
            mesh.vertex_matrix(),
            mesh.face_matrix(),
            colors=mesh.vertex_color_matrix() if mesh.has_vertex_color() else None,
            texcoords=mesh.wedge_tex_coord_matrix() if mesh.has_wedge_tex_coord() else None,
            attributes={"quality": mesh.vertex_scalar_array()} if mesh.has_vertex_scalar() else None,
            threads=threads,
        )

    def given_back(self, result: Mesh) -> Any:
        more: dict[str, Any] = {}
        first = result.first_rows
        if result.colors is not None:
            more["v_color_matrix"] = result.colors[first].astype(np.float64)
        if "quality" in result.attributes:
            more["v_scalar_array"] = result.attributes["quality"][first]
        if result.texcoords is not None:
            more["w_tex_coords_matrix"] = result.texcoords[result.corners.ravel(), :2].astype(np.float64)
        return type(self.given)(
            vertex_matrix=np.asarray(result.points, dtype=np.float64), face_matrix=result.faces.astype(np.int32), **more
        )


#: What an object has that is a mesh of a library.
_ADAPTERS: list[tuple[type[Adapter], tuple[str, ...]]] = [
    (_Trimesh, ("vertices", "faces", "visual", "face_attributes")),
    (_PyVista, ("point_data", "cell_data", "is_all_triangles")),
    (_Vtk, ("GetPolys", "GetPoints", "GetPointData")),
    (_Open3D, ("triangles", "vertices", "has_triangle_uvs")),
    (_Meshio, ("cells", "points", "point_data", "cell_data")),
    (_PyMeshLab, ("vertex_matrix", "face_matrix")),
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


def as_mesh(given: Any) -> Mesh:
    """A mesh of any of these, or the file at a path."""
    if isinstance(given, Mesh):
        return given
    if isinstance(given, (str, os.PathLike)):
        return read(given)
    if isinstance(given, tuple) and len(given) == 2:
        return Mesh(*given)
    return adapter_of(given).mesh(0)
