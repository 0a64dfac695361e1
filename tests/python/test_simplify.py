"""whittle.simplify, and what it returns, over NumPy arrays."""

import doctest
import inspect
import json
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import whittle
from conftest import grid
from whittle import _measure, _options, _simplify


@pytest.mark.parametrize("module", [whittle, _measure, _simplify])
def test_examples_in_docstrings(module):
    found = doctest.testmod(module)
    assert found.attempted > 0
    assert found.failed == 0


@pytest.mark.parametrize("float_type", [np.float32, np.float64])
@pytest.mark.parametrize("index_type", [np.int32, np.int64, np.uint32, np.uint64])
def test_types_of_arrays(mesh, float_type, index_type):
    points, faces = mesh
    result = whittle.simplify(points.astype(float_type), faces.astype(index_type), faces_left=200)
    assert result.points.dtype == float_type
    assert result.points.shape == (result.points.shape[0], 3)
    assert result.faces.dtype == np.uint32
    assert result.faces.max() < len(result.points)
    assert len(result.faces) <= 200
    assert result.met


def test_layouts_of_arrays(mesh):
    points, faces = mesh
    expected = whittle.simplify(points, faces, faces_left=200)
    padded = np.zeros((len(points), 5))
    padded[:, 1:4] = points
    for other_points, other_faces in [
        (np.asfortranarray(points), np.asfortranarray(faces)),
        (padded[:, 1:4], faces[:, :]),
        (points.tolist(), faces.tolist()),
        (points, faces[::-1][::-1]),
        (points.astype(">f8"), faces.astype(">i4")),
    ]:
        result = whittle.simplify(other_points, other_faces, faces_left=200)
        assert np.array_equal(result.points, expected.points)
        assert np.array_equal(result.faces, expected.faces)


def test_arrays_given_stay_as_they_are(mesh):
    points, faces = mesh
    before = points.copy(), faces.copy()
    whittle.simplify(points, faces, faces_left=100)
    assert np.array_equal(points, before[0])
    assert np.array_equal(faces, before[1])


def test_arrays_returned_outlive_the_result(mesh):
    result = whittle.simplify(*mesh, faces_left=100)
    points, faces, vertex_map = result.points, result.faces, result.vertex_map
    del result
    other = [whittle.simplify(*mesh, faces_left=90) for _ in range(3)]
    assert np.isfinite(points).all()
    assert faces.max() < len(points)
    assert vertex_map.max() == len(points) - 1
    points *= 2
    assert len(other) == 3


def test_vertex_map_and_origins(mesh):
    points, faces = mesh
    with_isolated = np.concatenate([[[9.0, 9, 9]], points])
    result = whittle.simplify(with_isolated, faces + 1, faces_left=300)
    assert result.vertex_map[0] == -1
    assert len(result.vertex_map) == len(points) + 1
    assert (result.vertex_map[1:] >= 0).all()
    for v, origin in enumerate(result.origins):
        assert result.vertex_map[origin] == v
    for face, origin in zip(result.faces, result.face_origins, strict=True):
        assert np.array_equal(result.vertex_map[1:][faces[origin]], face)


def test_locked_vertices_stay(mesh):
    points, faces = mesh
    locked = np.zeros(len(points), dtype=bool)
    locked[::97] = True
    result = whittle.simplify(points, faces, faces_left=200, locked=locked)
    assert np.array_equal(result.points[result.vertex_map[locked]], points[locked])
    with pytest.raises(ValueError, match="locked"):
        whittle.simplify(points, faces, faces_left=200, locked=locked[1:])


def test_tolerances_hold_near_their_vertices(mesh):
    points, faces = mesh
    tolerances = np.where(points[:, 0] < 0.5, 1e-5, 1.0)
    tight = whittle.Mesh(points, faces, tolerances=tolerances)
    result = whittle.simplify(tight, max_error=0.01)
    plain = whittle.simplify(points, faces, max_error=0.01)
    assert len(result.faces) > 2 * len(plain.faces)
    assert result.report["max_error"]["proven"] <= 0.01


def test_texture_coordinates_by_vertex(mesh, uv):
    result = whittle.simplify(*mesh, texcoords=uv, faces_left=200)
    assert result.texcoords.shape == (len(result.points), 2)
    assert not result.has_seams
    assert np.abs(result.texcoords - result.points[:, :2]).max() < 0.02


def test_texture_coordinates_by_corner(mesh, uv):
    points, faces = mesh
    by_corner = uv[faces].copy()
    middle = points[faces].mean(axis=1)[:, 0] > 0.5
    by_corner[middle] += 3
    for values in (by_corner, by_corner.reshape(-1, 2)):
        result = whittle.simplify(points, faces, texcoords=values, faces_left=300)
        assert result.has_seams
        assert len(result.texcoords) > len(result.points)
        of_corners = result.texcoords[result.corners]
        shift = np.round(of_corners - result.points[result.faces][:, :, :2])
        assert set(np.unique(shift)) == {0, 3}
        split = result.split_at_seams()
        assert len(split.points) == len(split.texcoords) == len(result.texcoords)
        assert np.array_equal(split.points[split.faces], result.points[result.faces])


def test_attributes_by_name(mesh):
    points, faces = mesh
    result = whittle.simplify(
        points, faces, faces_left=300, normals=np.tile([0.0, 0, 2], (len(points), 1)),
        colors=np.full((len(points), 3), 51, dtype=np.uint8),
        attributes={"height": points[:, 2], "flow": points[:, :2], "label": (points[:, 0] > 0.5).astype(np.int32)},
    )  # fmt: skip
    assert set(result.attributes) == {"height", "flow", "label"}
    assert result.attributes["height"].shape == (len(result.points),)
    assert result.attributes["flow"].shape == (len(result.points), 2)
    assert np.abs(result.attributes["height"] - result.points[:, 2]).max() < 0.02
    assert set(np.unique(result.attributes["label"])) == {0, 1}
    assert np.allclose(result.colors[:, :3], 0.2)
    assert np.allclose(np.linalg.norm(result.normals, axis=1), 1)


def test_groups_of_faces(mesh):
    points, faces = mesh
    groups = (points[faces].mean(axis=1)[:, 0] > 0.5).astype(np.int64)
    of_mesh = whittle.Mesh(points, faces, face_groups=groups, group_names=["left", "right"])
    result = whittle.simplify(of_mesh, faces_left=200)
    assert result.group_names == ["left", "right"]
    right = result.points[result.faces].mean(axis=1)[:, 0] > 0.5
    assert np.array_equal(result.face_groups, right.astype(np.uint32))


def test_same_result_as_the_program(mesh, tmp_path):
    points, faces = mesh
    whittle.write(tmp_path / "in.ply", whittle.Mesh(points, faces))
    for options in (
        {"faces_left": 300},
        {"ratio": 0.1, "effort": "best"},
        {"max_error": "0.5%"},
        {"face_ratio": "10%", "valence": 0.5, "boundary": "locked"},
        {"vertices_left": 200, "cost": "lindstrom-turk"},
    ):
        result = whittle.simplify(points, faces, **options)
        whittle.write(tmp_path / "python.ply", result)
        arguments = [word for option, value in _options.given(options) for word in (option, value)]
        command = [sys.executable, "-m", "whittle", "simplify", str(tmp_path / "in.ply"), "-o"]
        subprocess.run([*command, str(tmp_path / "program.ply"), *arguments, "--quiet", "--force"], check=True)
        assert (tmp_path / "python.ply").read_bytes() == (tmp_path / "program.ply").read_bytes()


def test_no_result_depends_on_threads():
    points, faces = grid(110)
    results = [whittle.simplify(points, faces, face_ratio=0.1, threads=n) for n in (1, 2, 5)]
    for other in results[1:]:
        assert np.array_equal(results[0].points, other.points)
        assert np.array_equal(results[0].faces, other.faces)


def test_a_mesh_may_be_simplified_again(mesh):
    of = whittle.Mesh(*mesh)
    first = whittle.simplify(of, faces_left=400)
    second = whittle.simplify(of, faces_left=400)
    assert np.array_equal(first.points, second.points)
    again = whittle.simplify(first, faces_left=100)
    assert len(again.faces) <= 100
    assert len(first.faces) > 300


def test_report_and_warnings(mesh):
    result = whittle.simplify(*mesh, faces_left=200)
    report = result.report
    assert report["input"]["faces"] == len(mesh[1])
    assert report["output"]["faces"] == len(result.faces)
    assert report["options"]["effort"] == "normal"
    assert report["target"] == {"faces": 200, "met": True}
    assert json.loads(json.dumps(report)) == report
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    with pytest.warns(UserWarning, match="target not met"):
        missed = whittle.simplify(points, faces, faces_left=1)
    assert not missed.met
    assert len(missed.faces) == 4
    with pytest.warns(UserWarning, match="does nothing"):
        whittle.simplify(*mesh, faces_left=200, max_pairs=3)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "no target"),
        ({"ratio": 2}, "--ratio"),
        ({"ratio": 0}, "--ratio"),
        ({"faces_left": -1}, "--faces"),
        ({"faces_left": 1.5}, "--faces"),
        ({"faces_left": 9, "effort": "slow"}, "fast|normal|best"),
        ({"faces_left": 9, "threshold": "1%", "isotropic": 0.5}, "doesn't go with"),
        ({"faces_left": 9, "certify": "yes"}, "True or False"),
        ({"max_error": 0}, "--max-error"),
    ],
)
def test_options_that_are_wrong(mesh, options, message):
    with pytest.raises(ValueError) as raised:
        whittle.simplify(*mesh, **options)
    assert message in str(raised.value)


def test_unknown_options(mesh):
    with pytest.raises(TypeError, match="face_count"):
        whittle.simplify(*mesh, face_count=3)


@pytest.mark.parametrize(
    ("points", "faces", "message"),
    [
        ([[0, 0, 0], [1, 0, 0], [0, 1, np.nan]], [[0, 1, 2]], "point 2 is not finite"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 3]], "vertex 3"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, -1]], "vertex -1"),
        ([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]], r"\(3, 2\)"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1]], r"\(1, 2\)"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [], "no faces"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 1]], "no face is left"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0.0, 1, 2]], "no integers"),
        ([[0, 0, 0], [1, 0, 0], [0, 1e200, 0]], [[0, 1, 2]], "too large"),
    ],
)
def test_arrays_that_are_no_mesh(points, faces, message):
    with pytest.raises(ValueError, match=message):
        whittle.simplify(points, faces, faces_left=1)


def test_attributes_that_are_wrong(mesh):
    points, faces = mesh
    for name, values in {"texcoords": points[:9, :2], "colors": points[:, :2], "normals": points[:, :1]}.items():
        with pytest.raises(ValueError, match=name):
            whittle.simplify(points, faces, faces_left=9, **{name: values})
    with pytest.raises(TypeError):
        whittle.simplify(points, faces, faces_left=9, attributes={"name": np.full(len(points), "a")})


def test_proofs(mesh):
    points, faces = mesh
    result = whittle.simplify(points, faces, max_error=0.002, certificate=True)
    assert result.report["max_error"]["proven"] <= 0.002
    of = whittle.Mesh(points, faces)
    found = whittle.verify(of, result, result.certificate)
    assert found
    assert found.max_error <= 0.002
    assert not whittle.verify(of, whittle.simplify(points, faces, faces_left=8), result.certificate)
    assert not whittle.verify(of, result, b"no certificate")
    largest = whittle.certify(of, result)
    assert largest["proven"] <= 0.002 * (1 + 1e-3)
    assert whittle.measure(of, result)["max"] <= largest["proven"]
    steps = whittle.certificate(of, result, 0.002)
    assert steps
    assert whittle.verify(of, result, steps)
    assert whittle.certificate(of, result, 1e-9) is None


def test_progress_is_told():
    points, faces = grid(200)
    told = []
    whittle.simplify(points, faces, face_ratio=0.1, progress=lambda stage, fraction: told.append((stage, fraction)))
    assert all(isinstance(stage, str) and 0 <= fraction <= 1 for stage, fraction in told)
    assert {stage for stage, _ in told} <= {"decimating", "polishing"}


def test_an_exception_of_progress_ends_the_call():
    points, faces = grid(200)

    def progress(stage, fraction):
        raise LookupError(stage)

    with pytest.raises(LookupError, match="decimating"):
        whittle.simplify(points, faces, face_ratio=0.01, cost="lindstrom-turk", progress=progress)


def test_progress_bars(mesh):
    tqdm = pytest.importorskip("tqdm")
    points, faces = grid(200)
    with open(os.devnull, "w") as nowhere:

        class Bar(tqdm.tqdm):
            def __init__(self, **more):
                super().__init__(file=nowhere, **more)

        whittle.simplify(points, faces, face_ratio=0.1, progress=Bar)


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_interruption():
    points, faces = grid(400)
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100):
            whittle.simplify(points, faces, face_ratio=0.01, cost="lindstrom-turk")
    timer.join()


def test_other_threads_of_python_go_on():
    points, faces = grid(200)
    counts = [0]
    done = threading.Event()

    def count():
        while not done.is_set():
            counts[0] += 1
            time.sleep(0)

    other = threading.Thread(target=count)
    other.start()
    before = counts[0]
    whittle.simplify(points, faces, face_ratio=0.01, cost="lindstrom-turk", threads=1)
    assert counts[0] > before + 10
    done.set()
    other.join()


def test_signature_and_docstring_have_all_options():
    names = inspect.signature(whittle.simplify).parameters
    for name, option in whittle.OPTIONS.items():
        assert name in names
        assert f"{name}: " in whittle.simplify.__doc__
        assert option.help
    assert "options" not in names


def test_files(mesh, tmp_path):
    points, faces = mesh
    of = whittle.Mesh(points, faces, texcoords=points[:, :2])
    for name in ("mesh.ply", "mesh.obj", "mesh.glb", "mesh.stl", "mesh.off", "mesh.ply.gz"):
        whittle.write(tmp_path / name, of)
        again = whittle.read(tmp_path / name)
        assert len(again.faces) == len(faces), name
        result = whittle.simplify(tmp_path / name, faces_left=100)
        assert len(result.faces) <= 100
        whittle.write(tmp_path / f"small {name}", result)
        assert len(whittle.read(tmp_path / f"small {name}").faces) == len(result.faces)
    with pytest.raises(whittle.ReadError, match=r"[Nn]o such"):
        whittle.read(tmp_path / "none.ply")
    with pytest.raises(OSError):
        whittle.write(tmp_path / "none" / "mesh.ply", of)
    with pytest.raises(ValueError):
        whittle.write(tmp_path / "mesh.xyz", of)


def test_info(mesh):
    info = whittle.info(whittle.Mesh(*mesh))
    assert info["vertices"] == len(mesh[0])
    assert info["boundary_loops"] == 1
    assert info["self_intersections"] == 0


def test_the_program_of_the_package(tmp_path):
    ran = subprocess.run([sys.executable, "-m", "whittle", "--version"], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == f"whittle {whittle.__version__}"
    assert subprocess.run([sys.executable, "-m", "whittle", "nothing"], capture_output=True).returncode == 2
