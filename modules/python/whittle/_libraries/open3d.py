"""Meshes of Open3D."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._mesh import Mesh
from .adapter import Adapter, as_before, named


class Open3D(Adapter):
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


class Open3DTensor(Adapter):
    """open3d.t.geometry.TriangleMesh."""

    def mesh(self, threads: int) -> Mesh:
        mesh = self.given.cpu()
        of_vertices = {name: mesh.vertex[name].numpy() for name in mesh.vertex}
        self._of_triangles = {name: mesh.triangle[name].numpy() for name in mesh.triangle}
        of_triangles = dict(self._of_triangles)
        # The normals of triangles follow from the faces.
        of_triangles.pop("normals", None)
        self._of_vertices = of_vertices
        attributes = dict(of_vertices)
        return Mesh(
            attributes.pop("positions"),
            of_triangles.pop("indices"),
            normals=attributes.pop("normals", None),
            colors=attributes.pop("colors", None),
            texcoords=of_triangles.pop("texture_uvs", None),
            attributes=attributes,
            face_attributes=of_triangles,
            threads=threads,
        )

    def given_back(self, result: Mesh) -> Any:
        # A vertex has one value of each attribute, and a corner its texture coordinates, as above.
        given = self.given
        mesh = type(given)(given.device)
        tensor = type(given.vertex["positions"])

        def add(attributes: Any, name: str, values: NDArray[Any], before: Mapping[str, NDArray[Any]]) -> None:
            attributes[name] = tensor(np.ascontiguousarray(as_before(values, before, name)), device=given.device)

        of_vertices, of_triangles = self._of_vertices, self._of_triangles
        add(mesh.vertex, "positions", result.points, of_vertices)
        add(mesh.triangle, "indices", result.faces, of_triangles)
        first = result.first_rows
        if result.normals is not None:
            add(mesh.vertex, "normals", result.normals[first], of_vertices)
        if result.colors is not None:
            share = 255 if of_vertices["colors"].dtype.kind == "u" else 1
            add(mesh.vertex, "colors", share * result.colors[first, : of_vertices["colors"].shape[1]], of_vertices)
        for name, values in named(result).items():
            add(mesh.vertex, name, values[first], of_vertices)
        if result.texcoords is not None:
            add(mesh.triangle, "texture_uvs", result.texcoords[result.corners], of_triangles)
        for name, values in result.face_attributes.items():
            add(mesh.triangle, name, values, of_triangles)
        if given.has_valid_material():
            mesh.material = given.material
        return mesh
