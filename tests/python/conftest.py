"""Meshes for the tests of the Python package."""

import numpy as np
import pytest


def grid(n, height=0.1):
    """n by n squares, bent; 2 n² faces."""
    i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij")
    u, v = i / n, j / n
    points = np.stack([u, v, height * np.sin(5 * u) * np.cos(4 * v)], axis=-1).reshape(-1, 3)
    corner = (i * (n + 1) + j)[:-1, :-1].ravel()
    lower = np.stack([corner, corner + n + 1, corner + n + 2], axis=-1)
    upper = np.stack([corner, corner + n + 2, corner + 1], axis=-1)
    return points, np.concatenate([lower, upper]).astype(np.uint32)


@pytest.fixture
def mesh():
    return grid(40)


@pytest.fixture
def uv(mesh):
    points, _ = mesh
    return points[:, :2].copy()
