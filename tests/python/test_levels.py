"""Levels of detail, recordings and geomorphs."""

import subprocess
import sys

import numpy as np
import pytest
import whittle
from conftest import grid


def test_lod(mesh):
    levels = whittle.lod(mesh, faces=[100, 800, 320])
    for level, n in zip(levels, [800, 320, 100], strict=True):
        assert n - 1 <= len(level.faces) <= n
        assert level.error is None
    of = whittle.Mesh(*mesh)
    errors = [whittle.measure(of, level)["mean"] for level in levels]
    assert errors == sorted(errors)
    assert len(whittle.lod(of, faces=[9])[0].faces) <= 9
    assert len(of.faces) == len(mesh[1])
    for wrong in (
        {},
        {"faces": [len(mesh[1])]},
        {"faces": [100], "ratios": [0.5]},
        {"errors": [0]},
        {"errors": ["far"]},
        {"ratios": [1.5]},
        {"faces": [0]},
    ):
        with pytest.raises(ValueError):
            whittle.lod(mesh, **wrong)
    with pytest.raises(TypeError, match="max_error"):
        whittle.lod(mesh, faces=[100], max_error=0.1)


def test_lod_by_share_and_by_error(mesh):
    points, faces = mesh
    by_vertices = whittle.lod(mesh, ratios=[0.5, 0.1])
    assert [len(level.points) for level in by_vertices] == [len(points) // 2, len(points) // 10]
    by_faces = whittle.lod(mesh, face_ratios=[0.5, 0.1])
    for level, n in zip(by_faces, [len(faces) // 2, len(faces) // 10], strict=True):
        assert n - 1 <= len(level.faces) <= n
    within = whittle.lod(mesh, errors=["0.1%", "1%"])
    diagonal = np.linalg.norm(np.ptp(points, axis=0))
    assert len(within[1].faces) < len(within[0].faces) < len(faces)
    for level, share in zip(within, [0.001, 0.01], strict=True):
        assert whittle.certify(mesh, level)["proven"] <= level.error * 1.001 <= share * diagonal * 1.001


@pytest.mark.parametrize(
    ("options", "arguments"),
    [
        (["--faces", "800,100"], {"faces": [800, 100]}),
        (["--ratios", "50%,10%", "--effort", "best"], {"ratios": [0.5, 0.1], "effort": "best"}),
        (["--face-ratios", "10%", "--fit", "max"], {"face_ratios": [0.1], "fit": "max"}),
        (["--errors", "0.2%"], {"errors": ["0.2%"]}),
    ],
)
def test_lod_as_the_program(mesh, tmp_path, options, arguments):
    of = whittle.Mesh(*mesh)
    whittle.write(tmp_path / "mesh.ply", of)
    command = [sys.executable, "-m", "whittle", "lod", tmp_path / "mesh.ply", "-o", tmp_path / "level_{i}.ply"]
    subprocess.run([*command, "--quiet", *options], check=True)
    levels = whittle.lod(of, **arguments)
    assert len(levels) == len(list(tmp_path.glob("level_*.ply")))
    for i, level in enumerate(levels):
        whittle.write(tmp_path / "ours.ply", level)
        assert (tmp_path / "ours.ply").read_bytes() == (tmp_path / f"level_{i}.ply").read_bytes()


def test_lod_keeps_attributes(mesh, uv):
    for level in whittle.lod(whittle.Mesh(*mesh, texcoords=uv), faces=[1000, 200]):
        assert np.abs(level.texcoords - level.points[:, :2]).max() < 0.02


def test_recordings(mesh, tmp_path):
    points, faces = mesh
    recording = whittle.record(points, faces, faces_left=60)
    first, last = recording.level(0), recording.level(-1)
    assert np.array_equal(first.points, points)
    assert len(last.faces) <= 60
    direct = whittle.simplify(points, faces, faces_left=60)
    assert np.array_equal(last.points, direct.points)
    for n in (3000, 500, 61):
        assert n - 2 <= len(recording.level(faces=n).faces) <= n
    assert len(recording.level(vertices=200).points) <= 200
    recording.save(tmp_path / "run.rec")
    again = whittle.Recording(tmp_path / "run.rec")
    assert len(again) == len(recording)
    assert np.array_equal(again.level(faces=500).points, recording.level(faces=500).points)
    with pytest.raises(IndexError):
        recording.level(len(recording))
    with pytest.raises(ValueError, match="more"):
        recording.level(faces=2)
    with pytest.raises(ValueError):
        recording.level()
    with pytest.raises(whittle.RecordingError):
        whittle.Recording(b"nothing")


def test_recordings_of_large_meshes_have_attributes():
    points, faces = grid(110)
    recording = whittle.record(points, faces, texcoords=points[:, :2], face_ratio=0.05)
    level = recording.level(faces=5000)
    assert np.abs(level.texcoords - level.points[:, :2]).max() < 0.02


def test_geomorphs(mesh, tmp_path):
    recording = whittle.record(*mesh, faces_left=60)
    morph = whittle.geomorph(recording, fine=500, coarse=100)
    assert len(morph.at(0).faces) == len(recording.level(faces=500).faces)
    middle = (morph.at(0).points + morph.at(1).points) / 2
    assert np.allclose(morph.at(0.5).points, middle)
    morph.write(tmp_path / "morph.glb")
    assert len(whittle.read(tmp_path / "morph.glb").faces) == len(morph.at(0).faces)


def test_pages(mesh, tmp_path):
    result = whittle.simplify(*mesh, faces_left=100)
    try:
        page = whittle.report(mesh, result)
    except RuntimeError as problem:
        pytest.skip(str(problem))  # the program is built without pages
    page.save(tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert text.lstrip().lower().startswith("<!doctype html>")
    assert "original" in text
    assert page._repr_html_().startswith("<iframe")
    assert len(whittle.report(whittle.record(*mesh, faces_left=100)).text) > 1000
    with pytest.raises(RuntimeError):
        whittle.report(tmp_path / "none.ply")
