"""Prints the table of docs/user/python.md: whittle beside what else simplifies meshes from Python.

python tests/bench/python_peers.py MESH… [--ratio 0.1] [--repetitions 5]

Each library gets arrays in memory in its own form, and the same number of faces to reach. Times are medians of
interleaved calls. Errors are those of whittle.measure: the mean distance both ways, over the diagonal.
"""

from __future__ import annotations

import argparse
import importlib.util
import statistics
import time
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import whittle

Arrays = tuple[Any, Any]
Peer = tuple[str, Callable[[], Any], Callable[[Any], Arrays]]


def is_there(module: str) -> bool:
    return importlib.util.find_spec(module) is not None


def peers(points: Any, faces: Any, n_faces: int) -> list[Peer]:
    """A name, a call, and what makes arrays of its result."""
    ratio = n_faces / len(faces)
    found: list[Peer] = []

    def of_result(result: Any) -> Arrays:
        return result.points, result.faces

    for effort in ("fast", "normal", "best"):
        found.append(
            (
                f"whittle, {effort}",
                lambda effort=effort: whittle.simplify(points, faces, faces_left=n_faces, effort=effort),
                of_result,
            )
        )
    if is_there("fast_simplification"):
        import fast_simplification

        found.append(
            (
                "fast-simplification",
                lambda: fast_simplification.simplify(points, faces, target_count=n_faces),
                lambda result: result,
            )
        )
    if is_there("pyfqmr"):
        import pyfqmr

        def fqmr() -> Any:
            simplifier = pyfqmr.Simplify()
            simplifier.setMesh(points, faces)
            simplifier.simplify_mesh(target_count=n_faces, verbose=False)
            return simplifier

        found.append(("pyfqmr", fqmr, lambda result: result.getMesh()[:2]))
    if is_there("pymeshlab"):
        import pymeshlab

        def meshlab() -> Any:
            meshes = pymeshlab.MeshSet()
            meshes.add_mesh(pymeshlab.Mesh(points, faces))
            meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=n_faces)
            return meshes  # its meshes don't outlive it

        def of_meshes(result: Any) -> Arrays:
            return result.current_mesh().vertex_matrix(), result.current_mesh().face_matrix()

        found.append(("PyMeshLab", meshlab, of_meshes))
    if is_there("open3d"):
        import open3d

        mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points), open3d.utility.Vector3iVector(faces))
        found.append(
            (
                "Open3D",
                lambda: mesh.simplify_quadric_decimation(n_faces),
                lambda result: (np.asarray(result.vertices), np.asarray(result.triangles)),
            )
        )
    if is_there("pyvista"):
        import pyvista

        surface = pyvista.PolyData.from_regular_faces(points, faces)
        for name, call in (
            ("PyVista, decimate", lambda: surface.decimate(1 - ratio)),
            ("PyVista, decimate_pro", lambda: surface.decimate_pro(1 - ratio, preserve_topology=True)),
        ):
            found.append((name, call, lambda result: (np.asarray(result.points), result.regular_faces)))
    return found


def table(path: Path, ratio: float, repetitions: int) -> list[str]:
    mesh = whittle.read(path)
    points, faces = np.array(mesh.points, dtype=np.float64), np.array(mesh.faces, dtype=np.int32)
    all_peers = peers(points, faces, round(ratio * len(faces)))
    times: dict[str, list[float]] = {name: [] for name, _, _ in all_peers}
    results: dict[str, Any] = {}
    for _ in range(repetitions):
        for name, call, _ in all_peers:
            begin = time.perf_counter()
            results[name] = call()
            times[name].append(time.perf_counter() - begin)
    lines = [f"|{path.name}, {len(faces)} faces|faces|mean error, %|time, s|", "|-|-|-|-|"]
    for name, _, arrays in all_peers:
        left = whittle.Mesh(*arrays(results[name]), weld=False)
        error = 100 * whittle.measure(mesh, left)["mean_rel"]
        lines.append(f"|{name}|{len(left.faces)}|{error:.5f}|{statistics.median(times[name]):.3f}|")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", type=Path, nargs="+")
    parser.add_argument("--ratio", type=float, default=0.1)
    parser.add_argument("--repetitions", type=int, default=5)
    given = parser.parse_args()
    warnings.simplefilter("ignore", UserWarning)
    for path in given.meshes:
        print("\n".join(table(path, given.ratio, given.repetitions)), end="\n\n")


if __name__ == "__main__":
    main()
