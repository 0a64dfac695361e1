"""whittle.simplify takes the meshes of other libraries, and gives them back."""

import numpy as np
import pytest
import whittle

target = {"faces_left": 300}


def expected_of(mesh):
    return whittle.simplify(*mesh, **target)


def test_trimesh(mesh):
    trimesh = pytest.importorskip("trimesh")
    points, faces = mesh
    given = trimesh.Trimesh(points, faces, process=False, metadata={"name": "sheet"})
    result = whittle.simplify(given, **target)
    assert type(result) is trimesh.Trimesh
    expected = expected_of(mesh)
    assert np.array_equal(result.vertices, expected.points)
    assert np.array_equal(result.faces, expected.faces)
    assert result.metadata["name"] == "sheet"
    assert isinstance(whittle.simplify(given, as_result=True, **target), whittle.Result)
    assert whittle.measure(given, result)["mean_rel"] < 1e-3


def test_trimesh_with_a_texture(mesh, uv):
    trimesh = pytest.importorskip("trimesh")
    material = trimesh.visual.material.SimpleMaterial(diffuse=[255, 0, 0, 255])
    visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    result = whittle.simplify(trimesh.Trimesh(*mesh, visual=visual, process=False), **target)
    assert result.visual.material is material
    assert np.abs(result.visual.uv - result.vertices[:, :2]).max() < 0.02


def test_trimesh_with_colors_and_attributes(mesh):
    trimesh = pytest.importorskip("trimesh")
    points, faces = mesh
    red = np.tile([200, 0, 0, 255], (len(points), 1)).astype(np.uint8)
    given = trimesh.Trimesh(points, faces, vertex_colors=red, process=False)
    given.vertex_attributes["height"] = points[:, 2].astype(np.float32)
    given.face_attributes["part"] = (points[faces].mean(axis=1)[:, 0] > 0.5).astype(int)
    result = whittle.simplify(given, **target)
    assert np.array_equal(np.unique(result.visual.vertex_colors, axis=0), [[200, 0, 0, 255]])
    assert result.vertex_attributes["height"].dtype == np.float32
    assert np.abs(result.vertex_attributes["height"] - result.vertices[:, 2]).max() < 0.02
    assert set(result.face_attributes["part"]) == {0, 1}
    given.visual = trimesh.visual.ColorVisuals(given, face_colors=red[: len(faces)] if len(red) > len(faces) else None)
    given.visual.face_colors = np.tile([0, 90, 0, 255], (len(faces), 1)).astype(np.uint8)
    result = whittle.simplify(given, **target)
    assert np.array_equal(np.unique(result.visual.face_colors, axis=0), [[0, 90, 0, 255]])


def test_pyvista(mesh, uv):
    pyvista = pytest.importorskip("pyvista")
    points, faces = mesh
    given = pyvista.PolyData.from_regular_faces(points, faces)
    given.point_data["height"] = points[:, 2].astype(np.float32)
    given.point_data["label"] = (points[:, 0] > 0.5).astype(np.int32)
    given.cell_data["part"] = (points[faces].mean(axis=1)[:, 0] > 0.5).astype(np.uint8)
    given.point_data["uv"] = uv
    given.point_data.active_texture_coordinates_name = "uv"
    result = whittle.simplify(given, **target)
    assert isinstance(result, pyvista.PolyData)
    assert result.n_cells <= 300
    assert result.is_all_triangles
    assert result.point_data["height"].dtype == np.float32
    assert np.abs(result.point_data["height"] - result.points[:, 2]).max() < 0.02
    assert result.point_data["label"].dtype == np.int32
    assert result.cell_data["part"].dtype == np.uint8
    assert np.abs(result.active_texture_coordinates - result.points[:, :2]).max() < 0.03
    assert given.n_cells == len(faces)


def test_pyvista_with_polygons(mesh):
    pyvista = pytest.importorskip("pyvista")
    plane = pyvista.Plane(i_resolution=20, j_resolution=20)  # squares
    result = whittle.simplify(plane, faces_left=2)
    assert result.n_cells == 2
    assert len(mesh) == 2


def test_vtk():
    pytest.importorskip("vtkmodules")
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

    source = vtkSphereSource()
    source.SetThetaResolution(60)
    source.SetPhiResolution(40)
    source.Update()
    given = source.GetOutput()
    plain = vtkPolyData()
    plain.ShallowCopy(given)
    points = vtk_to_numpy(plain.GetPoints().GetData())
    for data, name, values in (
        (plain.GetPointData(), "height", points[:, 2].copy()),
        (plain.GetPointData(), "uv", points[:, :2].copy()),
        (plain.GetCellData(), "part", np.arange(plain.GetNumberOfCells()) // 1200),
    ):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.AddArray(array)
    plain.GetPointData().SetActiveTCoords("uv")
    result = whittle.simplify(plain, faces_left=200)
    assert type(result) is type(plain)
    assert 190 <= result.GetNumberOfCells() <= 200
    data = result.GetPointData()
    points = vtk_to_numpy(result.GetPoints().GetData())
    normals = vtk_to_numpy(data.GetNormals())
    assert (np.sum(normals * points, axis=1) / np.linalg.norm(points, axis=1)).min() > 0.95
    assert np.abs(vtk_to_numpy(data.GetArray("height")) - points[:, 2]).max() < 0.02
    assert np.abs(vtk_to_numpy(data.GetTCoords()) - points[:, :2]).max() < 0.02
    part = vtk_to_numpy(result.GetCellData().GetArray("part"))
    assert part.dtype.kind == "i"
    assert set(part) == set(range(plain.GetNumberOfCells() // 1200 + 1))
    source = vtkCubeSource()  # of squares
    source.Update()
    with pytest.raises(ValueError, match="vtkTriangleFilter"):
        whittle.simplify(source.GetOutput(), faces_left=4)


def test_open3d(mesh, uv):
    open3d = pytest.importorskip("open3d")
    points, faces = mesh
    given = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(points), open3d.utility.Vector3iVector(faces.astype(np.int32))
    )
    result = whittle.simplify(given, **target)
    assert isinstance(result, open3d.geometry.TriangleMesh)
    assert np.array_equal(np.asarray(result.vertices), expected_of(mesh).points)
    given.vertex_colors = open3d.utility.Vector3dVector(np.tile([0.2, 0, 1], (len(points), 1)))
    given.triangle_uvs = open3d.utility.Vector2dVector(uv[faces].reshape(-1, 2))
    given.compute_vertex_normals()
    result = whittle.simplify(given, **target)
    corners = np.asarray(result.vertices)[np.asarray(result.triangles)].reshape(-1, 3)
    assert np.abs(np.asarray(result.triangle_uvs) - corners[:, :2]).max() < 0.02
    assert np.allclose(np.asarray(result.vertex_colors), [0.2, 0, 1], atol=1e-6)
    assert result.has_vertex_normals()


def test_open3d_tensors(mesh, uv):
    open3d = pytest.importorskip("open3d")
    points, faces = mesh
    tensor = open3d.core.Tensor
    given = open3d.t.geometry.TriangleMesh(tensor(points), tensor(faces.astype(np.int64)))
    result = whittle.simplify(given, **target)
    assert isinstance(result, open3d.t.geometry.TriangleMesh)
    assert np.array_equal(result.vertex.positions.numpy(), expected_of(mesh).points)
    given.vertex["height"] = tensor(points[:, 2:].astype(np.float32))
    given.vertex.colors = tensor(np.tile(np.array([51, 0, 255], dtype=np.uint8), (len(points), 1)))
    given.triangle.texture_uvs = tensor(uv[faces].astype(np.float32))
    given.triangle["part"] = tensor((points[faces].mean(axis=1)[:, 0] > 0.5).astype(np.int32))
    given.compute_vertex_normals()
    result = whittle.simplify(given, **target)
    positions, indices = result.vertex.positions.numpy(), result.triangle.indices.numpy()
    assert np.abs(result.triangle.texture_uvs.numpy() - positions[indices][:, :, :2]).max() < 0.02
    assert np.array_equal(result.vertex.colors.numpy(), np.tile([51, 0, 255], (len(positions), 1)))
    assert np.abs(result.vertex["height"].numpy()[:, 0] - positions[:, 2]).max() < 0.02
    assert result.triangle["part"].dtype == open3d.core.int32
    assert len(result.vertex.normals) == len(positions)
    assert "normals" in result.vertex and "positions" in result.vertex


def test_meshio(mesh):
    meshio = pytest.importorskip("meshio")
    points, faces = mesh
    given = meshio.Mesh(
        points, [("triangle", faces)], point_data={"height": points[:, 2]},
        cell_data={"part": [(points[faces].mean(axis=1)[:, 0] > 0.5).astype(int)]},
    )  # fmt: skip
    result = whittle.simplify(given, **target)
    assert isinstance(result, meshio.Mesh)
    assert len(result.cells_dict["triangle"]) <= 300
    assert np.abs(result.point_data["height"] - result.points[:, 2]).max() < 0.02
    assert set(np.unique(result.cell_data["part"][0])) == {0, 1}
    with pytest.raises(ValueError, match="quad"):
        whittle.simplify(meshio.Mesh(points, [("quad", [[0, 1, 2, 3]])]), **target)


def test_pymeshlab(mesh):
    pymeshlab = pytest.importorskip("pymeshlab")
    points, faces = mesh
    given = pymeshlab.Mesh(points, faces.astype(np.int32), v_scalar_array=points[:, 2].copy())
    result = whittle.simplify(given, **target)
    assert isinstance(result, pymeshlab.Mesh)
    assert result.face_number() <= 300
    assert np.abs(result.vertex_scalar_array() - result.vertex_matrix()[:, 2]).max() < 0.02


def test_polish_gives_back_what_it_was_given(mesh):
    trimesh = pytest.importorskip("trimesh")
    points, faces = mesh
    small = whittle.simplify(points, faces, polish=0, **target)
    given = trimesh.Trimesh(small.points, small.faces, process=False)
    result = whittle.polish((points, faces), given)
    assert isinstance(result, trimesh.Trimesh)
    assert np.array_equal(result.faces, small.faces)
    assert not np.array_equal(result.vertices, small.points)


def test_what_is_no_mesh():
    for given in (3, "no file", [[0, 0, 0]], {"points": 3}):
        with pytest.raises((TypeError, ValueError)):
            whittle.simplify(given, faces_left=3)
