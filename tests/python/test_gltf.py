"""glTF documents: what they have beside geometry stays."""

import base64
import json
import struct
import subprocess
import sys
import warnings

import numpy as np
import pytest
import whittle
from conftest import grid

PIXEL = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8DwHwAFBQIAX8jx0gAAAABJRU5ErkJggg=="


def content(path):
    """The JSON of a .glb file."""
    data = path.read_bytes()
    return json.loads(data[20 : 20 + struct.unpack("<I", data[12:16])[0]])


def n_faces(document):
    """Of all meshes, each once."""
    primitives = [p for mesh in document["meshes"] for p in mesh["primitives"]]
    return sum(document["accessors"][p["indices"]]["count"] for p in primitives) // 3


@pytest.fixture
def scene(tmp_path):
    """A textured sheet that stands twice, once turned and larger, and an animation."""
    points, faces = grid(24)
    parts = [points.astype("<f4"), points[:, :2].astype("<f4"), faces.astype("<u4"), np.float32([0, 1])]
    parts.append(np.float32([[0, 0, 0], [0, 1, 0]]))
    views, data = [], b""
    for part in parts:
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": part.nbytes})
        data += part.tobytes()
    kinds = [(5126, "VEC3"), (5126, "VEC2"), (5125, "SCALAR"), (5126, "SCALAR"), (5126, "VEC3")]
    accessors = [
        {"bufferView": i, "componentType": number, "type": kind, "count": len(part) * (3 if number == 5125 else 1)}
        for i, (part, (number, kind)) in enumerate(zip(parts, kinds, strict=True))
    ]
    for i, part in ((0, parts[0]), (3, parts[3][:, None])):
        accessors[i] |= {"min": part.min(axis=0).tolist(), "max": part.max(axis=0).tolist()}
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"name": "here", "mesh": 0},
            {"name": "there", "mesh": 0, "translation": [3, 0, 0], "rotation": [0, 0.6, 0, 0.8], "scale": [2, 2, 2]},
        ],
        "meshes": [{"name": "sheet", "primitives": [primitive]}],
        "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"name": "pixel", "uri": f"data:image/png;base64,{PIXEL}"}],
        "animations": [
            {
                "name": "jump",
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                "samplers": [{"input": 3, "output": 4}],
            }
        ],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [
            {
                "byteLength": len(data),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
            }
        ],
    }
    path = tmp_path / "scene.gltf"
    path.write_text(json.dumps(document))
    return path


def check_document(written, n):
    assert [node["name"] for node in written["nodes"]] == ["here", "there"]
    assert [mesh["name"] for mesh in written["meshes"]] == ["sheet"]
    assert [material["name"] for material in written["materials"]] == ["paint"]
    assert written["animations"][0]["name"] == "jump"
    assert len(written["images"]) == 1
    assert n_faces(written) == n


def test_the_document_stays(scene, tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mesh = whittle.read(scene)
        small = whittle.simplify(mesh, face_ratio=0.2)
        whittle.write(tmp_path / "small.glb", small)
        levels = whittle.lod(scene, face_ratios=[0.5, 0.1])
        for i, level in enumerate(levels):
            whittle.write(tmp_path / f"{i}.glb", level)
        whittle.write(tmp_path / "better.glb", whittle.polish(mesh, small))
    assert len(mesh.faces) == 1152
    check_document(content(tmp_path / "small.glb"), 230)
    check_document(content(tmp_path / "better.glb"), 230)
    for i, level in enumerate(levels):
        check_document(content(tmp_path / f"{i}.glb"), len(level.faces))


def test_as_the_program(scene, tmp_path):
    command = [sys.executable, "-m", "whittle", "simplify", scene, "-o", tmp_path / "program.glb", "--quiet"]
    subprocess.run([*command, "--face-ratio", "20%"], check=True)
    whittle.write(tmp_path / "ours.glb", whittle.simplify(scene, face_ratio=0.2))
    assert (tmp_path / "ours.glb").read_bytes() == (tmp_path / "program.glb").read_bytes()


def test_what_the_scene_shows(scene, tmp_path):
    assert whittle.info(scene)["faces"] == 2304
    shown = whittle.read(scene, as_shown=True)
    assert len(shown.faces) == 2304
    assert np.ptp(shown.points, axis=0)[0] > 3
    whittle.write(tmp_path / "shown.ply", whittle.simplify(shown, faces_left=300))
    with pytest.warns(UserWarning, match="as_shown=False"):
        whittle.write(tmp_path / "shown.glb", shown)
    with pytest.warns(UserWarning, match="as_shown=True"):
        whittle.write(tmp_path / "once.ply", whittle.read(scene))
