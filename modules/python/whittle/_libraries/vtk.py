"""Meshes of VTK and PyVista."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._mesh import Mesh
from .adapter import Adapter, as_before, named


class PyVista(Adapter):
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
        for name, values in named(split).items():
            surface.point_data[name] = as_before(values, self.given.point_data, name)
        if split.texcoords is not None:
            surface.point_data[self._texture] = np.array(split.texcoords)
            surface.point_data.active_texture_coordinates_name = self._texture
        if split.normals is not None:
            surface.point_data.active_normals = np.array(split.normals)
        for name, values in split.face_attributes.items():
            surface.cell_data[name] = as_before(values, self.given.cell_data, name)
        return surface


def _vtk(module: str) -> Any:
    """A module of VTK, which is there, as the object is."""
    return importlib.import_module(f"vtkmodules.{module}")


def _vtk_arrays(data: Any) -> dict[str, NDArray[Any]]:
    """The arrays of points or cells, by name."""
    to_numpy = _vtk("util.numpy_support").vtk_to_numpy
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {array.GetName() or f"array {i}": to_numpy(array) for i, array in enumerate(arrays) if array is not None}


def _add_vtk_array(data: Any, name: str, values: NDArray[Any], before: Mapping[str, NDArray[Any]]) -> None:
    array = _vtk("util.numpy_support").numpy_to_vtk(np.ascontiguousarray(as_before(values, before, name)), deep=True)
    array.SetName(name)
    data.AddArray(array)


class Vtk(Adapter):
    """vtkPolyData of triangles, with its arrays of points and cells."""

    def mesh(self, threads: int) -> Mesh:
        to_numpy = _vtk("util.numpy_support").vtk_to_numpy
        surface = self.given
        corners = to_numpy(surface.GetPolys().GetConnectivityArray())
        n_others = surface.GetNumberOfCells() - surface.GetNumberOfPolys()
        if n_others > 0 or np.any(np.diff(to_numpy(surface.GetPolys().GetOffsetsArray())) != 3):
            raise ValueError("not all cells are triangles: vtkTriangleFilter makes them so")
        data = surface.GetPointData()
        self._arrays, self._of_cells = _vtk_arrays(data), _vtk_arrays(surface.GetCellData())
        attributes = dict(self._arrays)
        self._normals, self._texcoords = (
            array.GetName() if array is not None else "" for array in (data.GetNormals(), data.GetTCoords())
        )
        return Mesh(
            to_numpy(surface.GetPoints().GetData()),
            corners.reshape(-1, 3),
            normals=attributes.pop(self._normals, None),
            texcoords=attributes.pop(self._texcoords, None),
            attributes=attributes,
            face_attributes=self._of_cells,
            threads=threads,
        )

    def given_back(self, result: Mesh) -> Any:
        support = _vtk("util.numpy_support")
        split = result.split_at_seams()
        points = _vtk("vtkCommonCore").vtkPoints()
        points.SetData(support.numpy_to_vtk(np.array(split.points), deep=True))
        cells = _vtk("vtkCommonDataModel").vtkCellArray()
        cells.SetData(3, support.numpy_to_vtkIdTypeArray(split.faces.astype(np.int64).ravel(), deep=True))
        surface = self.given.NewInstance()
        surface.SetPoints(points)
        surface.SetPolys(cells)
        data = surface.GetPointData()
        for name, values in named(split).items():
            _add_vtk_array(data, name, values, self._arrays)
        if split.normals is not None:
            _add_vtk_array(data, self._normals, split.normals, self._arrays)
            data.SetActiveNormals(self._normals)
        if split.texcoords is not None:
            _add_vtk_array(data, self._texcoords, split.texcoords, self._arrays)
            data.SetActiveTCoords(self._texcoords)
        for name, values in split.face_attributes.items():
            _add_vtk_array(surface.GetCellData(), name, values, self._of_cells)
        return surface
