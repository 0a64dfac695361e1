# SPDX-License-Identifier: BSD-3-Clause
"""Object > Simplify with Whittle: an add-on for Blender 3.4 and later. It needs the Python package whittle."""

import importlib.util
from typing import Any

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

bl_info = {
    "name": "Simplify with Whittle",
    "author": "The Whittle authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Object > Simplify with Whittle",
    "description": "Fewer triangles, near to the original; keeps UVs, materials, vertex groups and shape keys",
    "category": "Mesh",
}

HOW_TO_INSTALL = "The Python package whittle is missing: install it into Blender's Python with pip"
GROUP = "vertex group "
KEY = "shape key "
LAYER = "UV layer "
COLORS = "colors "


def _of(collection: Any, name: str, n: int, columns: int, dtype: Any = np.float32) -> Any:
    """A property of all elements of a collection, (n, columns)."""
    values = np.empty(n * columns, dtype=dtype)
    collection.foreach_get(name, values)
    return values.reshape(n, columns) if columns > 1 else values


def _joined(uvs: Any, faces: Any) -> Any:
    """UVs of corners, (F, 3, 2): those of a vertex that Blender takes for one are equal."""
    limit = 1e-4  # STD_UV_CONNECT_LIMIT
    corners = faces.ravel()
    left = np.arange(len(corners))
    joined = uvs.reshape(-1, 2).copy()
    while len(left) > 0:  # each time one value of each vertex
        first = np.zeros(corners.max() + 1, dtype=np.int64)
        first[corners[left][::-1]] = left[::-1]
        at = first[corners[left]]
        is_same = np.abs(joined[left] - joined[at]).max(axis=1) < limit
        joined[left[is_same]] = joined[at[is_same]]
        left = left[~is_same]
    return joined.reshape(uvs.shape)


class Content:
    """What an object's mesh has, as arrays."""

    def __init__(self, given: Any) -> None:
        mesh = given.data
        mesh.calc_loop_triangles()
        n = len(mesh.vertices)
        n_triangles = len(mesh.loop_triangles)
        self.points = _of(mesh.vertices, "co", n, 3)
        self.faces = _of(mesh.loop_triangles, "vertices", n_triangles, 3, np.int32)
        loops = _of(mesh.loop_triangles, "loops", n_triangles, 3, np.int32)
        polygons = _of(mesh.loop_triangles, "polygon_index", n_triangles, 1, np.int32)
        n_polygons = len(mesh.polygons)
        self.materials = _of(mesh.polygons, "material_index", n_polygons, 1, np.int32)[polygons]
        self.is_smooth = _of(mesh.polygons, "use_smooth", n_polygons, 1, bool)[polygons]
        self.uvs = {u.name: _joined(_of(u.data, "uv", len(mesh.loops), 2)[loops], self.faces) for u in mesh.uv_layers}
        self.colors = {}
        for layer in mesh.color_attributes:
            is_by_vertex = layer.domain == "POINT"
            values = _of(layer.data, "color", n if is_by_vertex else len(mesh.loops), 4)
            self.colors[layer.name] = values if is_by_vertex else values[loops]
        self.groups = self._weights(given, n)
        keys = mesh.shape_keys.key_blocks[1:] if mesh.shape_keys else []
        self.keys = {key.name: _of(key.data, "co", n, 3) - self.points for key in keys}

    @staticmethod
    def _weights(given: Any, n: int) -> dict[str, Any]:
        weights = {group.name: np.zeros(n, dtype=np.float32) for group in given.vertex_groups}
        names = [group.name for group in given.vertex_groups]
        for vertex in given.data.vertices:
            for element in vertex.groups:
                weights[names[element.group]][vertex.index] = element.weight
        return weights


def simplified(given: Any, options: dict[str, Any], keeps_uvs: bool) -> Any:
    """The object's mesh, simplified, as a whittle.Result."""
    import whittle

    content = Content(given)
    attributes: dict[str, Any] = {}
    if keeps_uvs:
        attributes |= {LAYER + name: values for name, values in list(content.uvs.items())[1:]}
    attributes |= {COLORS + name: values for name, values in content.colors.items()}
    attributes |= {GROUP + name: values for name, values in content.groups.items()}
    attributes |= {KEY + name: values for name, values in content.keys.items()}
    mesh = whittle.Mesh(
        content.points,
        content.faces,
        texcoords=next(iter(content.uvs.values())) if keeps_uvs and content.uvs else None,
        attributes=attributes,
        face_groups=content.materials,
        face_attributes={"smooth": content.is_smooth.astype(np.uint8)},
        weld=False,
    )
    return whittle.simplify(mesh, categories=[], **options)


def _new_mesh(given: Any, result: Any, keeps_uvs: bool) -> Any:
    before = given.data
    mesh = bpy.data.meshes.new(before.name)
    mesh.from_pydata(result.points.tolist(), [], result.faces.tolist())
    for material in before.materials:
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", result.face_groups.astype(np.int32))
    mesh.polygons.foreach_set("use_smooth", result.face_attributes["smooth"] > 0.5)
    corners = result.corners.ravel()
    names = [layer.name for layer in before.uv_layers] if keeps_uvs else []
    for i, name in enumerate(names):
        values = result.texcoords if i == 0 else result.attributes[LAYER + name]
        layer = mesh.uv_layers.new(name=name)
        layer.data.foreach_set("uv", np.ascontiguousarray(values[corners], dtype=np.float32).ravel())
        layer.active_render = before.uv_layers[name].active_render
    first = result.first_rows
    for layer in before.color_attributes:
        values = result.attributes[COLORS + layer.name][first if layer.domain == "POINT" else corners]
        new = mesh.color_attributes.new(layer.name, layer.data_type, layer.domain)
        new.data.foreach_set("color", np.clip(values, 0, None).astype(np.float32).ravel())
    if hasattr(before, "use_auto_smooth"):  # before 4.1
        mesh.use_auto_smooth = before.use_auto_smooth
    mesh.update()
    return mesh


def _set_groups(given: Any, result: Any, first: Any, before: list[tuple[str, bool]]) -> None:
    for name, is_locked in before:
        group = given.vertex_groups.get(name) or given.vertex_groups.new(name=name)
        group.lock_weight = is_locked
        weights = result.attributes[GROUP + name][first]
        for v in np.flatnonzero(weights > 0):
            group.add([int(v)], float(min(weights[v], 1.0)), "REPLACE")


def _set_keys(given: Any, result: Any, first: Any, before: list[dict[str, Any]]) -> None:
    for i, settings in enumerate(before):
        key = given.shape_key_add(name=settings["name"], from_mix=False)
        if i > 0:
            moved = result.points + result.attributes[KEY + settings["name"]][first]
            key.data.foreach_set("co", np.ascontiguousarray(moved, dtype=np.float32).ravel())
    for key, settings in zip(given.data.shape_keys.key_blocks, before, strict=True):
        key.slider_min, key.slider_max = settings["range"]
        key.value, key.mute = settings["value"], settings["mute"]
        key.relative_key = given.data.shape_keys.key_blocks[settings["relative_key"]]


def _settings_of_keys(mesh: Any) -> list[dict[str, Any]]:
    if not mesh.shape_keys:
        return []
    return [
        {
            "name": key.name,
            "value": key.value,
            "mute": key.mute,
            "range": (key.slider_min, key.slider_max),
            "relative_key": key.relative_key.name,
        }
        for key in mesh.shape_keys.key_blocks
    ]


def replace_mesh(given: Any, result: Any, keeps_uvs: bool = True) -> None:
    """Gives an object the result of `simplified`. Its materials, vertex groups, shape keys and modifiers stay."""
    keys = _settings_of_keys(given.data)
    groups = [(group.name, group.lock_weight) for group in given.vertex_groups]
    given.data = _new_mesh(given, result, keeps_uvs)
    first = result.first_rows
    _set_groups(given, result, first, groups)
    if keys:
        _set_keys(given, result, first, keys)


class OBJECT_OT_simplify_with_whittle(bpy.types.Operator):
    """Fewer triangles for the selected meshes, near to the original"""

    bl_idname = "object.simplify_with_whittle"
    bl_label = "Simplify with Whittle"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012

    target: EnumProperty(  # type: ignore[valid-type]
        name="Target",
        items=[
            ("RATIO", "Share", "A share of the faces"),
            ("FACES", "Faces", "A number of faces of each object"),
            ("ERROR", "Largest Error", "As few faces as are found within a distance, proven"),
        ],
    )
    ratio: FloatProperty(name="Share", default=0.1, min=0.001, max=0.999, subtype="FACTOR")  # type: ignore[valid-type]
    faces: IntProperty(name="Faces", default=1000, min=1)  # type: ignore[valid-type]
    max_error: FloatProperty(  # type: ignore[valid-type]
        name="Largest Error", default=0.01, min=1e-6, precision=4, subtype="DISTANCE", unit="LENGTH"
    )
    effort: EnumProperty(  # type: ignore[valid-type]
        name="Effort",
        items=[
            ("fast", "Fast", "No fit to the original in the end"),
            ("normal", "Normal", "Fits the result to the original"),
            ("best", "Best", "Fits on the way, too"),
        ],
        default="normal",
    )
    keep_uvs: BoolProperty(name="Keep UVs", default=True)  # type: ignore[valid-type]

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.mode == "OBJECT" and any(o.type == "MESH" for o in context.selected_objects)

    def draw(self, context: Any) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "target")
        layout.prop(self, {"RATIO": "ratio", "FACES": "faces", "ERROR": "max_error"}[self.target])
        layout.prop(self, "effort")
        layout.prop(self, "keep_uvs")

    def asked(self) -> dict[str, Any]:
        name = {"RATIO": "face_ratio", "FACES": "faces_left", "ERROR": "max_error"}[self.target]
        value = {"RATIO": self.ratio, "FACES": self.faces, "ERROR": self.max_error}[self.target]
        return {name: value, "effort": self.effort}

    def execute(self, context: Any) -> set[str]:
        if importlib.util.find_spec("whittle") is None:
            self.report({"ERROR"}, HOW_TO_INSTALL)
            return {"CANCELLED"}
        objects = [o for o in context.selected_objects if o.type == "MESH" and o.data.polygons]
        results = []
        for given in objects:  # all of them, before any is changed
            try:
                results.append(simplified(given, self.asked(), self.keep_uvs))
            except (ValueError, RuntimeError) as problem:
                self.report({"ERROR"}, f"{given.name}: {problem}")
                return {"CANCELLED"}
        n_before = sum(len(polygon.vertices) - 2 for given in objects for polygon in given.data.polygons)
        for given, result in zip(objects, results, strict=True):
            replace_mesh(given, result, self.keep_uvs)
            for text in result.warnings:
                self.report({"WARNING"}, f"{given.name}: {text}")
        self.report({"INFO"}, f"{n_before} -> {sum(len(result.faces) for result in results)} triangles")
        return {"FINISHED"}


def _menu(self: Any, context: Any) -> None:
    self.layout.operator(OBJECT_OT_simplify_with_whittle.bl_idname)


def register() -> None:
    bpy.utils.register_class(OBJECT_OT_simplify_with_whittle)
    bpy.types.VIEW3D_MT_object.append(_menu)


def unregister() -> None:
    bpy.types.VIEW3D_MT_object.remove(_menu)
    bpy.utils.unregister_class(OBJECT_OT_simplify_with_whittle)


if __name__ == "__main__":
    register()
