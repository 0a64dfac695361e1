"""Meshes of trimesh, meshio and PyMeshLab."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._mesh import Mesh
from .adapter import Adapter, as_before, named


class Trimesh(Adapter):
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
        for name, values in named(split).items():
            mesh.vertex_attributes[name] = np.array(values, dtype=self.given.vertex_attributes[name].dtype)
        for name, values in split.face_attributes.items():
            if name == "face colors":
                mesh.visual.face_colors = values.astype(np.uint8)
            else:
                mesh.face_attributes[name.removeprefix("face ")] = np.array(values)
        return mesh


class Meshio(Adapter):
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
            point_data={n: as_before(v, self.given.point_data, n) for n, v in split.attributes.items()},
            cell_data={n: [np.array(v)] for n, v in split.face_attributes.items()},
        )


class PyMeshLab(Adapter):
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
