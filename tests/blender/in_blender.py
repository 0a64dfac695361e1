"""Runs inside Blender: blender --background --factory-startup --python-exit-code 1 --python in_blender.py -- ADDON."""

import importlib.util
import sys

import bpy
import numpy as np

try:
    import whittle  # noqa: F401
except ImportError as problem:
    print(f"skipped: Blender's Python {sys.version_info.major}.{sys.version_info.minor}: {problem}")
    sys.exit(77)

spec = importlib.util.spec_from_file_location("whittle_addon", sys.argv[sys.argv.index("--") + 1])
addon = importlib.util.module_from_spec(spec)
spec.loader.exec_module(addon)
addon.register()


def undo_step(name):
    bpy.ops.ed.undo_push(message=name)


def make_figure():
    """A sheet with two materials, two UV layers, colours, two vertex groups, shape keys, and an armature."""
    for other in list(bpy.data.objects):
        bpy.data.objects.remove(other)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=60, y_subdivisions=60, size=2)
    figure = bpy.context.object
    figure.name = "figure"
    mesh = figure.data
    for vertex in mesh.vertices:
        x, y, _ = vertex.co
        vertex.co.z = 0.2 * np.sin(3 * x) * np.cos(2 * y)
    for name in ("red", "green"):
        mesh.materials.append(bpy.data.materials.new(name))
    for polygon in mesh.polygons:
        polygon.material_index = int(polygon.center.x > 0)
        polygon.use_smooth = True
    second = mesh.uv_layers.new(name="second")
    for loop, uv in zip(mesh.loops, second.data, strict=True):
        x, y, _ = mesh.vertices[loop.vertex_index].co
        uv.uv = (y, x)
    colors = mesh.color_attributes.new("paint", "FLOAT_COLOR", "POINT")
    for vertex, color in zip(mesh.vertices, colors.data, strict=True):
        color.color = ((vertex.co.x + 1) / 2, 0, 1, 1)
    for name, sign in (("left", -1), ("right", 1)):
        group = figure.vertex_groups.new(name=name)
        for vertex in mesh.vertices:
            weight = 0.5 + 0.5 * sign * vertex.co.x
            if weight > 0:
                group.add([vertex.index], weight, "REPLACE")
    figure.shape_key_add(name="Basis")
    raised = figure.shape_key_add(name="raised")
    for vertex, point in zip(mesh.vertices, raised.data, strict=True):
        point.co.z = vertex.co.z + 0.5 * vertex.co.x
    raised.value = 0.25
    armature = bpy.data.objects.new("armature", bpy.data.armatures.new("armature"))
    bpy.context.collection.objects.link(armature)
    modifier = figure.modifiers.new("armature", "ARMATURE")
    modifier.object = armature
    bpy.ops.object.select_all(action="DESELECT")
    figure.select_set(True)
    bpy.context.view_layer.objects.active = figure
    return figure


def check_content(figure):
    mesh = figure.data
    assert [m.name.partition(".")[0] for m in mesh.materials] == ["red", "green"]
    assert {p.material_index for p in mesh.polygons} == {0, 1}
    for polygon in mesh.polygons:
        assert polygon.material_index == int(polygon.center.x > 0), polygon.center
        assert polygon.use_smooth
    assert [layer.name for layer in mesh.uv_layers] == ["UVMap", "second"]
    for loop, first, second in zip(mesh.loops, mesh.uv_layers[0].data, mesh.uv_layers[1].data, strict=True):
        x, y, _ = mesh.vertices[loop.vertex_index].co
        assert np.allclose(first.uv, ((x + 1) / 2, (y + 1) / 2), atol=0.02), (first.uv, x, y)
        assert np.allclose(second.uv, (y, x), atol=0.05), (second.uv, x, y)
    for vertex, color in zip(mesh.vertices, mesh.color_attributes["paint"].data, strict=True):
        assert np.allclose(color.color, ((vertex.co.x + 1) / 2, 0, 1, 1), atol=0.05)
    assert [group.name for group in figure.vertex_groups] == ["left", "right"]
    for vertex in mesh.vertices:
        weights = {element.group: element.weight for element in vertex.groups}
        assert np.allclose(weights.get(1, 0), 0.5 + 0.5 * vertex.co.x, atol=0.05)
    keys = mesh.shape_keys.key_blocks
    assert [key.name for key in keys] == ["Basis", "raised"]
    assert abs(keys["raised"].value - 0.25) < 1e-6
    for vertex, point in zip(mesh.vertices, keys["raised"].data, strict=True):
        assert abs(point.co.z - vertex.co.z - 0.5 * vertex.co.x) < 0.05
    assert figure.modifiers["armature"].object.name == "armature"


def test_share():
    figure = make_figure()
    n = 2 * len(figure.data.polygons)
    undo_step("before")
    assert bpy.ops.object.simplify_with_whittle(target="RATIO", ratio=0.1) == {"FINISHED"}
    figure = bpy.data.objects["figure"]
    assert 0.08 * n <= len(figure.data.polygons) <= 0.1 * n
    check_content(figure)
    undo_step("after")
    bpy.ops.ed.undo()
    assert 2 * len(bpy.data.objects["figure"].data.polygons) == n


def test_faces_and_uvs():
    figure = make_figure()
    assert bpy.ops.object.simplify_with_whittle(target="FACES", faces=500, keep_uvs=False) == {"FINISHED"}
    assert len(figure.data.polygons) <= 500
    assert not figure.data.uv_layers


def test_error():
    figure = make_figure()
    assert bpy.ops.object.simplify_with_whittle(target="ERROR", max_error=0.05, effort="fast") == {"FINISHED"}
    assert 10 < len(figure.data.polygons) < 3000


def test_selection():
    make_figure()
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=5, location=(4, 0, 0))
    sphere = bpy.context.object
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4, location=(8, 0, 0))
    other = bpy.context.object
    n_other = len(other.data.polygons)
    other.select_set(False)
    figure = bpy.data.objects["figure"]
    for chosen in (figure, sphere):
        chosen.select_set(True)
    assert bpy.ops.object.simplify_with_whittle(ratio=0.1) == {"FINISHED"}
    assert len(sphere.data.polygons) == 512
    assert len(figure.data.polygons) <= 720
    assert len(other.data.polygons) == n_other


def test_nothing_selected():
    make_figure()
    bpy.ops.object.select_all(action="DESELECT")
    assert not bpy.ops.object.simplify_with_whittle.poll()


tests = [value for name, value in sorted(globals().items()) if name.startswith("test_")]
for test in tests:
    test()
    print(f"passed: {test.__name__}")
print(f"all {len(tests)} tests passed")
