// What PairDecimaterT keeps, with either driver: handles, properties, locked elements.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/decimation.hh"
#include "common/meshes.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::VertexHandle;

class PairDecimaterKeeps : public EachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, PairDecimaterKeeps, each_driver, driver_name);

// Mesh state ----------------------------------------------------------------------------------------------------------

TEST_P(PairDecimaterKeeps, SurvivorsKeepHandlesAndProperties) {
  const IndexedMesh shape = blob(3, 4);
  Decimation<DoubleMesh> set(shape, GetParam());
  OpenMesh::VProp<int> vertex_number(set.mesh);
  OpenMesh::FProp<int> face_number(set.mesh);
  for (const VertexHandle v : set.mesh.vertices()) vertex_number[v] = v.idx() * 3;
  for (const OpenMesh::FaceHandle f : set.mesh.faces()) face_number[f] = f.idx() * 5;
  set.decimater.decimate_to_faces(0, 300);
  EXPECT_EQ(set.mesh.n_vertices(), 642U) << "elements are marked, not removed";
  for (const VertexHandle v : set.mesh.vertices()) EXPECT_EQ(vertex_number[v], v.idx() * 3);
  for (const Contraction& made : set.contractions) {
    EXPECT_TRUE(set.mesh.status(VertexHandle(static_cast<int>(made.removed))).deleted());
  }

  std::map<int, Vec3> places;
  for (const VertexHandle v : set.mesh.vertices()) places[vertex_number[v]] = to_vec3(set.mesh.point(v));
  set.mesh.garbage_collection();
  EXPECT_EQ(set.mesh.n_faces(), 300U);
  EXPECT_EQ(set.mesh.n_vertices(), 152U);
  for (const VertexHandle v : set.mesh.vertices()) EXPECT_EQ(to_vec3(set.mesh.point(v)), places.at(vertex_number[v]));
  for (const OpenMesh::FaceHandle f : set.mesh.faces()) EXPECT_EQ(face_number[f] % 5, 0);
  expect_sound(set.mesh, "after garbage collection");

  // The module's own properties were compacted, too: the next run continues.
  set.decimater.set_driver(Driver::automatic);
  EXPECT_EQ(set.decimater.decimate_to(100), 52U);
  expect_sound(set.mesh, "after the second run");
}

TEST_P(PairDecimaterKeeps, UnderEndpointPlacementHandlesKeepTheirPoints) {
  for (const IndexedMesh& shape : {torus(24, 12), blob(3, 4), terrain(14, 2), bracket(3)}) {
    Decimation<DoubleMesh> set(shape, GetParam());
    QuadricOptions options;
    options.placement = Placement::endpoint;
    set.module().set_options(options);
    ASSERT_TRUE(set.decimater.initialize());
    const DoubleMesh before = set.mesh;
    set.decimater.decimate_to_faces(0, shape.faces.size() / 4);
    std::size_t n_lower = 0;  // number of survivors with the lower handle
    for (const Contraction& made : set.contractions) n_lower += made.survivor < made.removed;
    EXPECT_GT(n_lower, 0U);
    for (const VertexHandle v : set.mesh.vertices()) EXPECT_EQ(set.mesh.point(v), before.point(v)) << v.idx();
    for (const Contraction& made : set.contractions) {
      EXPECT_TRUE(set.mesh.status(VertexHandle(static_cast<int>(made.removed))).deleted());
    }
    expect_sound(set.mesh, "under endpoint placement");
  }
}

TEST_P(PairDecimaterKeeps, DeletedElementsBeforeTheRunDoNotCount) {
  const IndexedMesh shape = noisy_sphere(3, 0.04, 8);
  DoubleMesh holed = open_mesh<DoubleMesh>(shape);
  holed.request_vertex_status();
  holed.request_edge_status();
  holed.request_face_status();
  for (const int v : {3, 100, 500}) holed.delete_vertex(VertexHandle(v), false);
  const IndexedMesh rest = geometry_of(holed);

  PairDecimaterT<DoubleMesh> decimater(holed);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  decimater.add(cost);
  decimater.set_driver(GetParam());
  std::vector<Contraction> contractions;
  decimater.set_listener([&](const Contraction& made) { contractions.push_back(made); });
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate_to_faces(0, rest.faces.size()), 0U);
  EXPECT_EQ(decimater.decimate_to(600), 39U) << "639 of 642 vertices are there";
  expect_sound(holed, "after the run");

  // The same as on a mesh without deleted elements, except for the numbers.
  Decimation<DoubleMesh> clean(rest, GetParam());
  clean.decimater.decimate_to(600);
  ASSERT_EQ(clean.contractions.size(), contractions.size());
  for (std::size_t i = 0; i < contractions.size(); ++i) {
    EXPECT_EQ(contractions[i].survivor, rest.origins[clean.contractions[i].survivor]) << i;
    EXPECT_EQ(contractions[i].removed, rest.origins[clean.contractions[i].removed]) << i;
    EXPECT_EQ(contractions[i].position, clean.contractions[i].position) << i;
  }
}

TEST_P(PairDecimaterKeeps, EmptyAndTinyMeshesEndAtOnce) {
  for (const IndexedMesh& shape : {IndexedMesh{}, single_triangle(), tetrahedron(), csaszar_torus()}) {
    Decimation<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate(), 0U) << shape.faces.size() << " faces";
    EXPECT_EQ(set.decimater.result().n_faces, shape.faces.size());
    EXPECT_EQ(set.decimater.result().stop, StopReason::exhausted);
  }
}

TEST_P(PairDecimaterKeeps, IsolatedVerticesAreLeftAlone) {
  const IndexedMesh shape = with_isolated_vertices(blob(2, 2), 9, 4);
  Decimation<DoubleMesh> set(shape, GetParam());
  EXPECT_EQ(set.decimater.decimate(to_vertices(100)).n_vertices, 100U);
  set.mesh.garbage_collection();
  EXPECT_EQ(set.mesh.n_vertices(), 109U);
}

TEST_P(PairDecimaterKeeps, FaceNormalsAreRightAtTheEnd) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(3, 0.1, 6));
  mesh.request_face_normals();
  mesh.update_face_normals();
  PairDecimaterT<DoubleMesh> decimater(mesh);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  decimater.add(cost);
  decimater.set_driver(GetParam());
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate(500);
  for (const OpenMesh::FaceHandle f : mesh.faces()) EXPECT_EQ(mesh.normal(f), mesh.calc_face_normal(f));
}

// Status bits and selection -------------------------------------------------------------------------------------------

TEST_P(PairDecimaterKeeps, LockedVerticesKeepEveryBitAndOthersMergeIntoThem) {
  const IndexedMesh shape = moved(blob(3, 5), Vec3(0.1, 7, -3));
  Decimation<DoubleMesh> set(shape, GetParam());
  for (const VertexHandle v : set.mesh.vertices()) set.mesh.status(v).set_locked(v.idx() % 4 == 1);
  const DecimateResult result = set.decimater.decimate(DecimateTarget::as_far_as_possible());
  for (int v = 1; v < 642; v += 4) EXPECT_TRUE(unmoved(set.mesh, shape, VertexHandle(v))) << v;
  const auto into_locked = [](const Contraction& made) { return made.survivor % 4 == 1; };
  EXPECT_GT(std::count_if(set.contractions.begin(), set.contractions.end(), into_locked), 100);
  EXPECT_GT(result.n_contractions, 350U);
  EXPECT_GT(result.refusals[Refusal::locked], 0U);
  expect_sound(set.mesh, "after the run");
}

TEST_P(PairDecimaterKeeps, OnlySelectedVerticesMoveOrVanish) {
  const IndexedMesh shape = noisy_grid(20, 20, 0.2, 9);
  Decimation<DoubleMesh> set(shape, GetParam());
  for (const VertexHandle v : set.mesh.vertices()) set.mesh.status(v).set_selected(set.mesh.point(v)[0] < 8.5);
  EXPECT_GT(set.decimater.decimate(0, true), 100U);
  for (int v = 0; v < 441; ++v) {
    if (shape.positions[static_cast<std::size_t>(v)].x() > 8.5) {
      EXPECT_TRUE(unmoved(set.mesh, shape, VertexHandle(v))) << v;
    }
  }
  Decimation<DoubleMesh> none(shape, GetParam());
  EXPECT_EQ(none.decimater.decimate(0, true), 0U) << "nothing is selected";
  EXPECT_GT(none.decimater.decimate(10, false), 0U);
}

}  // namespace
}  // namespace whittle::test
