"""Fitting of meshes that others have simplified."""

import subprocess
import sys

import numpy as np
import pytest
import whittle
from conftest import grid


@pytest.fixture
def reference(mesh):
    return whittle.Mesh(*mesh)


@pytest.fixture
def simplified(mesh):
    """Without a fit."""
    return whittle.Mesh(*_arrays(whittle.simplify(*mesh, faces_left=300, polish=0)))


def _arrays(mesh):
    return mesh.points, mesh.faces


def test_polish(reference, simplified):
    before = simplified.points.copy()
    result = whittle.polish(reference, simplified)
    assert isinstance(result, whittle.Polished)
    assert np.array_equal(result.faces, simplified.faces)
    assert np.array_equal(simplified.points, before)  # which stays as it was
    report = result.report
    assert 0 < report["rms_after"] < report["rms_before"]
    assert report["moved"] == np.any(result.points != before, axis=1).sum() > 0
    assert 1 <= report["passes"] <= 3
    errors = [whittle.measure(reference, mesh)["rms"] for mesh in (simplified, result)]
    assert errors[1] < errors[0]
    assert np.array_equal(whittle.polish(reference, simplified, threads=1).points, result.points)


def test_without_passes_nothing_moves(reference, simplified):
    result = whittle.polish(reference, simplified, passes=0)
    assert np.array_equal(result.points, simplified.points)
    assert result.report["moved"] == 0


def test_fits_differ(reference, simplified):
    by_fit = {fit: whittle.polish(reference, simplified, fit=fit).points for fit in ("mean", "balanced", "max")}
    assert not np.array_equal(by_fit["mean"], by_fit["max"])
    assert np.array_equal(by_fit["balanced"], whittle.polish(reference, simplified).points)
    with pytest.raises(ValueError, match="balanced"):
        whittle.polish(reference, simplified, fit="least")


def test_as_the_program(tmp_path, reference, simplified):
    whittle.write(tmp_path / "in.ply", reference)
    whittle.write(tmp_path / "small.ply", simplified)
    command = [sys.executable, "-m", "whittle", "polish", tmp_path / "in.ply", tmp_path / "small.ply", "--quiet"]
    subprocess.run([*command, "-o", tmp_path / "program.ply", "--passes", "2"], check=True)
    whittle.write(tmp_path / "ours.ply", whittle.polish(reference, tmp_path / "small.ply", passes=2))
    assert (tmp_path / "ours.ply").read_bytes() == (tmp_path / "program.ply").read_bytes()


def test_attributes_stay(reference, simplified):
    points, faces = _arrays(simplified)
    with_texture = whittle.Mesh(points, faces, texcoords=points[:, :2], colors=np.ones((len(points), 3)))
    result = whittle.polish(reference, with_texture)
    assert np.array_equal(result.texcoords, points[:, :2])
    assert np.array_equal(result.colors, with_texture.colors)


def test_progress_and_the_end_of_a_call(reference, simplified):
    told = []
    whittle.polish(reference, simplified, progress=lambda stage, fraction: told.append((stage, fraction)))
    assert all(0 <= fraction <= 1 for _, fraction in told)

    def ends(stage, fraction):
        raise KeyboardInterrupt

    big = whittle.Mesh(*grid(300))
    small = whittle.simplify(big, face_ratio=0.3, effort="fast")
    with pytest.raises(KeyboardInterrupt):
        whittle.polish(big, small, passes=50, progress=ends)
