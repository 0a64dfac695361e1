// Many collapses at once give the same mesh as the same collapses one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>
#include <whittle/openmesh/detail/bulk_collapse.hh>
#include <whittle/openmesh/garbage_collection.hh>

#include "common/decimation.hh"
#include "common/link_condition.hh"
#include "common/meshes.hh"
#include "common/same_mesh.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Collapses one edge in the same way as PairDecimaterT's mesh driver.
void collapse_one(DoubleMesh& mesh, HalfedgeHandle h) {
  const OpenMesh::Decimater::CollapseInfoT<DoubleMesh> collapse(mesh, h);
  const auto carry = [&mesh](HalfedgeHandle from, HalfedgeHandle to) {
    if (!from.is_valid() || !mesh.status(mesh.edge_handle(from)).feature()) return;
    mesh.status(mesh.edge_handle(to)).set_feature(true);
  };
  carry(collapse.v0vl, collapse.vlv1);
  carry(collapse.vrv0, collapse.v1vr);
  mesh.collapse(h);
}

/// Collapses random edges in random directions, as long as the topology and `limit` allow.
std::vector<VertexMerge> collapse_at_random(DoubleMesh& mesh, std::size_t limit, std::uint64_t seed) {
  std::vector<VertexMerge> merges;
  Random random(seed);
  LinkConditionT<DoubleMesh> link_condition(mesh);
  for (std::size_t n_tries = 8 * mesh.n_halfedges(); n_tries > 0 && merges.size() < limit; --n_tries) {
    const HalfedgeHandle h(static_cast<int>(random.below(mesh.n_halfedges())));
    if (mesh.status(mesh.edge_handle(h)).deleted() || !link_condition(h)) continue;
    merges.push_back({mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)});
    collapse_one(mesh, h);
  }
  return merges;
}

void expect_as_one_by_one(const DoubleMesh& mesh, std::size_t limit, std::uint64_t seed, const std::string& name) {
  const std::string context = name + ", at most " + std::to_string(limit) + " collapses, seed " + std::to_string(seed);
  DoubleMesh one_by_one = mesh;
  const std::vector<VertexMerge> merges = collapse_at_random(one_by_one, limit, seed);
  DoubleMesh at_once = mesh;
  BulkCollapse(at_once, merges).run();
  expect_same_mesh(one_by_one, at_once, context);
  expect_sound(at_once, context);
  one_by_one.garbage_collection();
  collect_garbage(at_once);
  expect_same_mesh(one_by_one, at_once, context + ", collected");
  expect_sound(at_once, context + ", collected");
}

constexpr std::size_t all = ~std::size_t{0};

TEST(BulkCollapse, LeavesWhatCollapsesOneByOneLeave) {
  for (const auto& [name, shape] : holdable_meshes()) {
    const DoubleMesh mesh = mesh_with_status(shape);
    for (const std::size_t limit : {std::size_t{0}, std::size_t{1}, shape.positions.size() / 2, all}) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) expect_as_one_by_one(mesh, limit, seed, name);
    }
  }
}

TEST(BulkCollapse, OfSeveralPartsLeavesEach) {
  const IndexedMesh parts =
      joined(joined(moved(sphere(3), Vec3(9, 0, 0)), noisy_torus(20, 12, 1, 0.4, 0.02, 5)),
             joined(moved(open_cylinder(16, 6), Vec3(0, 9, 0)), moved(terrain(9, 3), Vec3(0, 0, 9))));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_as_one_by_one(mesh_with_status(parts), all, seed, "parts");
}

TEST(BulkCollapse, LeavesAloneWhatWasDeletedBefore) {
  DoubleMesh mesh = mesh_with_status(noisy_sphere(3, 0.04, 8));
  for (const int v : {3, 100, 101, 500}) mesh.delete_vertex(VertexHandle(v), false);
  for (const int f : {17, 300}) mesh.delete_face(FaceHandle(f), true);
  ASSERT_FALSE(mesh.status(VertexHandle(4)).deleted());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_as_one_by_one(mesh, all, seed, "holed sphere");
}

TEST(BulkCollapse, TwiceIsTheSameAsOnce) {
  const DoubleMesh mesh = mesh_with_status(terrain(20, 3));
  DoubleMesh one_by_one = mesh;
  const std::vector<VertexMerge> merges = collapse_at_random(one_by_one, all, 1);
  const auto half = static_cast<std::ptrdiff_t>(merges.size() / 2);
  DoubleMesh twice = mesh;
  BulkCollapse(twice, std::vector(merges.begin(), merges.begin() + half)).run();
  BulkCollapse(twice, std::vector(merges.begin() + half, merges.end())).run();
  expect_same_mesh(one_by_one, twice, "in two halves");
}

TEST(BulkCollapse, VerticesOfWholeStarsKeepTheirOutgoingHalfedge) {
  const DoubleMesh mesh = mesh_with_status(noisy_grid(20, 20, 0.2, 9));
  DoubleMesh after = mesh;
  const HalfedgeHandle h = mesh.find_halfedge(VertexHandle(210), VertexHandle(211));
  ASSERT_TRUE(h.is_valid());
  const std::vector<VertexMerge> merges{{VertexHandle(210), VertexHandle(211)}};
  BulkCollapse(after, merges).run();
  int n_changed = 0;
  for (const VertexHandle v : after.vertices()) n_changed += after.halfedge_handle(v) != mesh.halfedge_handle(v);
  EXPECT_LE(n_changed, 4) << "the merged vertex, the two opposite the edge";
}

// In the decimater ----------------------------------------------------------------------------------------------------

struct Outcome {
  explicit Outcome(const IndexedMesh& shape, Driver driver) : mesh(mesh_with_status(shape)) {
    mesh.request_face_normals();
    for (const FaceHandle f : mesh.faces()) mesh.set_normal(f, {7, 7, 7});
    PairDecimaterT<DoubleMesh> decimater(mesh);
    ModGarlandHeckbertT<DoubleMesh>::Handle cost;
    decimater.add(cost);
    decimater.set_driver(driver);
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate_to(shape.positions.size() / 2);
    EXPECT_EQ(decimater.last_driver(), driver);
  }
  DoubleMesh mesh;
};

TEST(PairDecimaterWriteBack, BothDriversLeaveTheSameHandlesBitsPointsAndFaceNormals) {
  for (const auto& [name, shape] : holdable_meshes()) {
    const DoubleMesh by_mesh = Outcome(shape, Driver::mesh).mesh;
    const DoubleMesh by_engine = Outcome(shape, Driver::engine).mesh;
    expect_same_mesh(by_mesh, by_engine, name);
    for (const VertexHandle v : by_mesh.vertices()) ASSERT_EQ(by_engine.point(v), by_mesh.point(v)) << name;
    for (const FaceHandle f : by_mesh.faces()) {
      ASSERT_EQ(by_engine.normal(f), by_mesh.normal(f)) << name << ": of faces without a merged vertex they stay";
    }
  }
}

TEST(PairDecimaterWriteBack, TheModulesQuadricsGoAlongWithGarbageCollection) {
  Decimation<DoubleMesh> run(with_isolated_vertices(blob(3, 4), 9, 4), Driver::engine);
  DoubleMesh& mesh = run.mesh;
  run.decimater.decimate_to(200);
  OpenMesh::VProp<Vec3> position(mesh);
  OpenMesh::VProp<double> cost(mesh);  // per vertex, the cost of the edge of its outgoing halfedge
  const auto cost_at = [&](VertexHandle v) {
    const VertexHandle w = mesh.to_vertex_handle(mesh.halfedge_handle(v));
    return run.module().evaluate(v, w, PairConstraint::none).cost;
  };
  int n_isolated = 0;
  for (const VertexHandle v : mesh.vertices()) {
    position[v] = run.module().position(v);
    EXPECT_EQ(run.module().frame().to_model(position[v]), to_vec3(mesh.point(v)));
    n_isolated += mesh.is_isolated(v);
    if (!mesh.is_isolated(v)) cost[v] = cost_at(v);
  }
  EXPECT_EQ(n_isolated, 9);
  mesh.garbage_collection();
  EXPECT_EQ(mesh.n_vertices(), 209U);
  for (const VertexHandle v : mesh.vertices()) {
    EXPECT_EQ(run.module().position(v), position[v]);
    if (!mesh.is_isolated(v)) {
      EXPECT_EQ(cost_at(v), cost[v]);
    }
  }
}

}  // namespace
}  // namespace whittle::test
