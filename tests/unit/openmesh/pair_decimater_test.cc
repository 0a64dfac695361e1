// PairDecimaterT's calls, whichever driver runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cmath>
#include <map>
#include <whittle/openmesh/mod_garland_heckbert.hh>

#include "meshes.hh"
#include "support/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::VertexHandle;

/// A mesh with a decimater and our cost module, ready to run.
template <class MeshT>
struct Set {
  explicit Set(const IndexedMesh& shape, Driver driver = Driver::automatic)
      : mesh(open_mesh<MeshT>(shape)), decimater(mesh) {
    decimater.add(cost);
    decimater.set_driver(driver);
    decimater.set_listener([this](const Contraction& made) { contractions.push_back(made); });
    EXPECT_TRUE(decimater.initialize());
  }
  ModGarlandHeckbertT<MeshT>& module() { return decimater.module(cost); }

  MeshT mesh;
  PairDecimaterT<MeshT> decimater;
  typename ModGarlandHeckbertT<MeshT>::Handle cost;
  std::vector<Contraction> contractions;
};

class PairDecimater : public testing::TestWithParam<Driver> {};
INSTANTIATE_TEST_SUITE_P(Drivers, PairDecimater, testing::Values(Driver::engine, Driver::mesh),
                         [](const auto& test) { return test.param == Driver::engine ? "Engine" : "Mesh"; });

// Calls ---------------------------------------------------------------------------------------------------------------

TEST_P(PairDecimater, StockCallsReachTheirTargets) {
  const IndexedMesh shape = blob(3, 1);  // 642 vertices, 1280 faces
  {
    Set<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate(100), 100U);
    EXPECT_EQ(set.decimater.result().n_vertices, 542U);
    EXPECT_EQ(set.decimater.result().stop, StopReason::target);
    EXPECT_EQ(set.decimater.last_driver(), GetParam());
  }
  {
    Set<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to(200), 442U);
    set.mesh.garbage_collection();
    EXPECT_EQ(set.mesh.n_vertices(), 200U);
  }
  {
    Set<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to_faces(0, 401), 440U);
    EXPECT_EQ(set.decimater.result().n_faces, 400U);
  }
  {
    Set<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to_faces(300, 400), 342U) << "the first bound reached ends the run";
  }
  {
    Set<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to(642), 0U);
    EXPECT_EQ(set.decimater.decimate_to_faces(0, 1280), 0U);
  }
  {
    Set<DoubleMesh> set(shape, GetParam());
    EXPECT_GT(set.decimater.decimate(), 600U) << "0 means as many as possible";
    EXPECT_EQ(set.decimater.result().stop, StopReason::exhausted);
    EXPECT_GT(set.decimater.result().rejections.link + set.decimater.result().rejections.flip, 0U);
  }
}

TEST_P(PairDecimater, TheResultSaysWhatWasDone) {
  const IndexedMesh shape = terrain(20, 3);
  Set<DoubleMesh> set(shape, GetParam());
  const DecimateResult result = set.decimater.decimate(to_faces(200));
  const IndexedMesh after = geometry_of(set.mesh);
  EXPECT_EQ(result.n_contractions, set.contractions.size());
  EXPECT_EQ(result.n_faces, after.faces.size());
  EXPECT_EQ(result.n_vertices, after.positions.size());
  EXPECT_LE(result.n_faces, 200U);
  EXPECT_GE(result.n_faces, 199U);
  const auto dearest = std::max_element(set.contractions.begin(), set.contractions.end(),
                                        [](const auto& a, const auto& b) { return a.cost < b.cost; });
  EXPECT_EQ(result.max_cost, dearest->cost);
  EXPECT_EQ(result.stop, StopReason::target);
}

TEST_P(PairDecimater, RespectsTheCostLimitOfTheModuleAndOfTheTarget) {
  const IndexedMesh shape = noisy_torus(40, 20, 1, 0.4, 0.02, 5);
  Set<DoubleMesh> all(shape, GetParam());
  all.decimater.decimate(to_faces(400));
  const double limit = all.decimater.result().max_cost / 10;
  const auto below = [limit](double cost) { return cost <= limit; };

  Set<DoubleMesh> by_target(shape, GetParam());
  const DecimateResult result = by_target.decimater.decimate(to_cost(limit));
  EXPECT_EQ(result.stop, StopReason::cost);
  EXPECT_GT(result.n_contractions, 50U);
  EXPECT_LE(result.max_cost, limit);

  Set<DoubleMesh> by_module(shape, GetParam());
  by_module.module().set_max_cost(limit);
  EXPECT_EQ(by_module.decimater.decimate(to_cost(limit * 5)).stop, StopReason::cost);
  expect_same_contractions(by_target.contractions, by_module.contractions, "the lower limit counts");
  for (const Contraction& made : by_module.contractions) EXPECT_PRED1(below, made.cost);
}

TEST(PairDecimaterErrors, NotInitializedThrows) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(sphere(1));
  PairDecimaterT<DoubleMesh> decimater(mesh);
  EXPECT_FALSE(decimater.initialize()) << "no module ranks";
  EXPECT_THROW(decimater.decimate(), std::logic_error);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  ASSERT_TRUE(decimater.add(cost));
  EXPECT_FALSE(decimater.add(cost)) << "the handle is taken";
  EXPECT_THROW(decimater.decimate(), std::logic_error);
  EXPECT_THROW(decimater.decimate_to(10), std::logic_error);
  EXPECT_THROW(decimater.decimate_to_faces(0, 10), std::logic_error);
  EXPECT_THROW(decimater.decimate(to_faces(10)), std::logic_error);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate(3), 3U);

  OpenMesh::Decimater::ModQuadricT<DoubleMesh>::Handle second;
  ASSERT_TRUE(decimater.add(second));
  EXPECT_THROW(decimater.decimate(), std::logic_error) << "a module was added";
  EXPECT_FALSE(decimater.initialize()) << "two modules rank";
  EXPECT_THROW(decimater.decimate(), std::logic_error);
  ASSERT_TRUE(decimater.remove(second));
  EXPECT_FALSE(decimater.remove(second));
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate(3), 3U);
}

TEST(PairDecimaterErrors, WrongTargetsThrow) {
  Set<DoubleMesh> set(sphere(1));
  EXPECT_THROW(set.decimater.decimate(to_cost(-1)), std::invalid_argument);
  EXPECT_THROW(set.decimater.decimate(to_cost(std::nan(""))), std::invalid_argument);
  DoubleMesh mesh = open_mesh<DoubleMesh>(sphere(1));
  PairDecimaterT<DoubleMesh> foreign(mesh);
  OpenMesh::Decimater::ModQuadricT<DoubleMesh>::Handle quadric;
  foreign.add(quadric);
  ASSERT_TRUE(foreign.initialize());
  EXPECT_THROW(foreign.decimate(to_cost(1)), std::invalid_argument);
}

TEST(PairDecimaterErrors, TheEngineSaysWhyItCannotRun) {
  const auto message = [](auto& decimater) {
    try {
      decimater.decimate();
    } catch (const std::logic_error& error) {
      return std::string(error.what());
    }
    return std::string("no exception");
  };
  DoubleMesh mesh = open_mesh<DoubleMesh>(sphere(2));
  PairDecimaterT<DoubleMesh> decimater(mesh);
  decimater.set_driver(Driver::engine);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  ModFlipGuardT<DoubleMesh>::Handle guard;
  ModRecorderT<DoubleMesh>::Handle recorder;
  decimater.add(cost);
  decimater.add(guard);
  EXPECT_THAT(decimater.engine_obstacle(), testing::HasSubstr("not initialized"));
  decimater.initialize();
  EXPECT_EQ(decimater.engine_obstacle(), "");

  decimater.add(recorder);
  decimater.initialize();
  EXPECT_THAT(message(decimater), testing::HasSubstr("module Recorder"));
  decimater.remove(recorder);

  mesh.status(VertexHandle(7)).set_feature(true);
  decimater.initialize();
  EXPECT_THAT(message(decimater), testing::HasSubstr("features"));
  mesh.status(VertexHandle(7)).set_feature(false);

  EXPECT_EQ(decimater.decimate(5), 5U);
  EXPECT_THAT(message(decimater), testing::HasSubstr("since initialize()"));
  decimater.initialize();
  EXPECT_EQ(decimater.decimate(5), 5U);

  decimater.module(cost).set_arithmetic(Arithmetic::stock);
  decimater.initialize();
  EXPECT_THAT(message(decimater), testing::HasSubstr("module GarlandHeckbert"));
}

TEST(PairDecimaterDrivers, AutomaticTakesTheEngineWhereItCan) {
  Set<DoubleMesh> set(sphere(3));
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::engine);
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::mesh) << "the second run goes on where the first ended";
  set.decimater.initialize();
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::engine);
  set.mesh.status(*set.mesh.vertices().begin()).set_feature(true);
  set.decimater.initialize();
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::mesh);
}

TEST(PairDecimaterDrivers, TwoRunsAreOne) {
  // The engine driver keeps the module's quadrics up to date, so that the next run goes on from them.
  for (const IndexedMesh& shape : {blob(3, 7), moved(terrain(18, 4), Vec3(500, -70, 90))}) {
    Set<DoubleMesh> at_once(shape, Driver::mesh);
    at_once.decimater.decimate(400);
    Set<DoubleMesh> in_parts(shape);
    in_parts.decimater.decimate(150);
    EXPECT_EQ(in_parts.decimater.last_driver(), Driver::engine);
    in_parts.decimater.decimate(100);
    EXPECT_EQ(in_parts.decimater.last_driver(), Driver::mesh);
    in_parts.decimater.decimate(150);
    expect_same_contractions(at_once.contractions, in_parts.contractions, "in parts");
  }
}

TEST_P(PairDecimater, InitializeTwiceStartsAnew) {
  const IndexedMesh shape = noisy_sphere(3, 0.05, 3);
  Set<DoubleMesh> once(shape, GetParam());
  once.decimater.decimate(200);
  Set<DoubleMesh> twice(shape, GetParam());
  ASSERT_TRUE(twice.decimater.initialize());
  twice.decimater.decimate(200);
  expect_same_contractions(once.contractions, twice.contractions, "initialized twice");

  // After a run: as if the mesh were new.
  ASSERT_TRUE(twice.decimater.initialize());
  twice.contractions.clear();
  twice.decimater.decimate(200);
  Set<DoubleMesh> again(geometry_of(once.mesh), GetParam());
  again.decimater.decimate(200);
  EXPECT_EQ(again.contractions.size(), twice.contractions.size());
  EXPECT_TRUE(geometry_of(again.mesh).positions == geometry_of(twice.mesh).positions);
}

// Mesh state ----------------------------------------------------------------------------------------------------------

TEST_P(PairDecimater, SurvivorsKeepHandlesAndProperties) {
  const IndexedMesh shape = blob(3, 4);
  Set<DoubleMesh> set(shape, GetParam());
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

  // The module's own properties moved along: the next run goes on.
  set.decimater.set_driver(Driver::automatic);
  EXPECT_EQ(set.decimater.decimate_to(100), 52U);
  expect_sound(set.mesh, "after the second run");
}

TEST_P(PairDecimater, DeletedElementsBeforeTheRunDoNotCount) {
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

  // The same as on a mesh that never had them, but for the numbers.
  Set<DoubleMesh> clean(rest, GetParam());
  clean.decimater.decimate_to(600);
  ASSERT_EQ(clean.contractions.size(), contractions.size());
  for (std::size_t i = 0; i < contractions.size(); ++i) {
    EXPECT_EQ(contractions[i].survivor, rest.origins[clean.contractions[i].survivor]) << i;
    EXPECT_EQ(contractions[i].removed, rest.origins[clean.contractions[i].removed]) << i;
    EXPECT_EQ(contractions[i].position, clean.contractions[i].position) << i;
  }
}

TEST_P(PairDecimater, EmptyAndTinyMeshesEndAtOnce) {
  for (const IndexedMesh& shape : {IndexedMesh{}, single_triangle(), tetrahedron(), csaszar_torus()}) {
    Set<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate(), 0U) << shape.faces.size() << " faces";
    EXPECT_EQ(set.decimater.result().n_faces, shape.faces.size());
    EXPECT_EQ(set.decimater.result().stop, StopReason::exhausted);
  }
}

TEST_P(PairDecimater, IsolatedVerticesAreLeftAlone) {
  const IndexedMesh shape = with_isolated_vertices(blob(2, 2), 9, 4);
  Set<DoubleMesh> set(shape, GetParam());
  EXPECT_EQ(set.decimater.decimate(to_vertices(100)).n_vertices, 100U);
  set.mesh.garbage_collection();
  EXPECT_EQ(set.mesh.n_vertices(), 109U);
}

TEST_P(PairDecimater, FaceNormalsAreRightAtTheEnd) {
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

template <class MeshT>
bool unmoved(const MeshT& mesh, const IndexedMesh& before, VertexHandle v) {
  return !mesh.status(v).deleted() && to_vec3(mesh.point(v)) == before.positions[static_cast<std::size_t>(v.idx())];
}

TEST_P(PairDecimater, LockedVerticesKeepEveryBitAndOthersMergeIntoThem) {
  const IndexedMesh shape = moved(blob(3, 5), Vec3(0.1, 7, -3));
  Set<DoubleMesh> set(shape, GetParam());
  for (const VertexHandle v : set.mesh.vertices()) set.mesh.status(v).set_locked(v.idx() % 4 == 1);
  const DecimateResult result = set.decimater.decimate(DecimateTarget{});
  for (int v = 1; v < 642; v += 4) EXPECT_TRUE(unmoved(set.mesh, shape, VertexHandle(v))) << v;
  const auto into_locked = [](const Contraction& made) { return made.survivor % 4 == 1; };
  EXPECT_GT(std::count_if(set.contractions.begin(), set.contractions.end(), into_locked), 100);
  EXPECT_GT(result.n_contractions, 350U);
  EXPECT_GT(result.rejections.locked, 0U);
  expect_sound(set.mesh, "after the run");
}

TEST_P(PairDecimater, OnlySelectedVerticesMoveOrVanish) {
  const IndexedMesh shape = noisy_grid(20, 20, 0.2, 9);
  Set<DoubleMesh> set(shape, GetParam());
  for (const VertexHandle v : set.mesh.vertices()) set.mesh.status(v).set_selected(set.mesh.point(v)[0] < 8.5);
  EXPECT_GT(set.decimater.decimate(0, true), 100U);
  for (int v = 0; v < 441; ++v) {
    if (shape.positions[static_cast<std::size_t>(v)].x() > 8.5) {
      EXPECT_TRUE(unmoved(set.mesh, shape, VertexHandle(v))) << v;
    }
  }
  Set<DoubleMesh> none(shape, GetParam());
  EXPECT_EQ(none.decimater.decimate(0, true), 0U) << "nothing is selected";
  EXPECT_GT(none.decimater.decimate(10, false), 0U);
}

TEST(PairDecimaterFeatures, AFeatureLineKeepsToItsVerticesAndItsEdges) {
  // The rim of the cylinder's middle, and the vertices on it.
  const IndexedMesh shape = open_cylinder(24, 8);
  Set<DoubleMesh> set(shape);
  DoubleMesh& mesh = set.mesh;
  const auto on_ring = [&](VertexHandle v) { return std::abs(mesh.point(v)[2] - 1) < 1e-9; };
  for (const VertexHandle v : mesh.vertices()) mesh.status(v).set_feature(on_ring(v));
  for (const auto e : mesh.edges()) {
    const bool is_feature = on_ring(e.v0()) && on_ring(e.v1());
    mesh.status(e).set_feature(is_feature);
  }
  ASSERT_TRUE(set.decimater.initialize());
  set.decimater.decimate();
  EXPECT_EQ(set.decimater.last_driver(), Driver::mesh);
  int n_on_ring = 0;
  for (const VertexHandle v : mesh.vertices()) {
    if (!mesh.status(v).feature()) continue;
    ++n_on_ring;
    // Each feature vertex lies where one of them was, and the ring is still one closed line of feature edges.
    const Vec3 p = to_vec3(mesh.point(v));
    EXPECT_TRUE(std::count(shape.positions.begin(), shape.positions.end(), p)) << p.transpose();
    EXPECT_NEAR(p.z(), 1, 1e-9);
    const auto edges = mesh.ve_range(v);
    EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [&](auto e) { return mesh.status(e).feature(); }), 2);
  }
  EXPECT_LT(n_on_ring, 24) << "nothing was contracted along the line";
  EXPECT_GE(n_on_ring, 3);
  expect_sound(mesh, "after the run");
}

TEST(PairDecimaterFeatures, WithoutFeatureEdgesFeatureVerticesAreCorners) {
  const IndexedMesh shape = blob(3, 5);
  Set<DoubleMesh> set(shape);
  for (const VertexHandle v : set.mesh.vertices()) set.mesh.status(v).set_feature(v.idx() % 5 == 0);
  set.decimater.decimate();
  for (int v = 0; v < 642; v += 5) EXPECT_TRUE(unmoved(set.mesh, shape, VertexHandle(v))) << v;
  EXPECT_GT(set.decimater.result().n_contractions, 300U);
}

// Observer ------------------------------------------------------------------------------------------------------------

TEST_P(PairDecimater, TheObserverIsToldCountsAndMayAbort) {
  const IndexedMesh shape = noisy_torus(40, 20, 1, 0.4, 0.02, 5);
  Set<DoubleMesh> whole(shape, GetParam());
  whole.decimater.decimate(300);

  Set<DoubleMesh> set(shape, GetParam());
  StoppingObserver observer(120, 10);
  set.decimater.set_observer(&observer);
  EXPECT_EQ(set.decimater.decimate(300), 120U);
  EXPECT_EQ(set.decimater.result().stop, StopReason::cancelled);
  EXPECT_THAT(observer.steps, testing::ElementsAre(10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120));
  EXPECT_EQ(set.contractions.size(), 120U);
  EXPECT_EQ(set.decimater.result().n_vertices, 680U);
  EXPECT_EQ(set.decimater.result().n_faces, geometry_of(set.mesh).faces.size());
  expect_sound(set.mesh, "after the abort");
  expect_same_topology(shape, geometry_of(set.mesh), "after the abort");

  // And goes on from there when asked to.
  set.decimater.set_observer(nullptr);
  set.decimater.set_driver(Driver::automatic);
  EXPECT_EQ(set.decimater.decimate(180), 180U);
  expect_same_contractions(whole.contractions, set.contractions, "aborted and resumed");
}

// What the traps are about --------------------------------------------------------------------------------------------

/// Watches how far the faces around each contraction turn.
template <class MeshT>
class ModFlipWatchT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModFlipWatchT, MeshT, FlipWatch);
  explicit ModFlipWatchT(MeshT& mesh) : Base(mesh, true) {}
  void preprocess_collapse(const CollapseInfo& collapse) override {
    before_.clear();
    for (const VertexHandle v : {collapse.v0, collapse.v1}) {
      for (const OpenMesh::FaceHandle f : this->mesh().vf_range(v)) before_[f.idx()] = this->mesh().calc_face_normal(f);
    }
  }
  void postprocess_collapse(const CollapseInfo& collapse) override {
    for (const OpenMesh::FaceHandle f : this->mesh().vf_range(collapse.v1)) {
      ++n_faces;
      n_flipped += (this->mesh().calc_face_normal(f) | before_.at(f.idx())) < 0;
    }
  }

  int n_faces = 0;
  int n_flipped = 0;

 private:
  std::map<int, typename MeshT::Normal> before_;
};

TEST(PairDecimaterTraps, NoContractionFlipsAFace) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_torus(60, 30, 1, 0.4, 0.06, 2));
  PairDecimaterT<DoubleMesh> decimater(mesh);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  ModFlipGuardT<DoubleMesh>::Handle guard;
  ModFlipWatchT<DoubleMesh>::Handle watch;
  decimater.add(cost);
  decimater.add(guard);
  decimater.add(watch);
  decimater.module(guard).set_max_normal_flip_deg(89.9);
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate_to(90);
  EXPECT_GT(decimater.module(watch).n_faces, 8000);
  EXPECT_EQ(decimater.module(watch).n_flipped, 0);
  EXPECT_GT(decimater.result().rejections.flip, 0U) << "nothing to guard against";
}

TEST_P(PairDecimater, UnitAndPlaceChangeNoContraction) {
  const IndexedMesh shape = noisy_sphere(3, 0.05, 12);
  const auto pairs = [](const IndexedMesh& s) {
    Set<DoubleMesh> set(s, GetParam());
    set.decimater.decimate(500);
    std::vector<std::pair<Index, Index>> result;
    for (const Contraction& made : set.contractions) result.emplace_back(made.survivor, made.removed);
    return result;
  };
  const auto expected = pairs(shape);
  EXPECT_EQ(expected.size(), 500U);
  EXPECT_EQ(pairs(scaled(shape, 0x1p-60)), expected) << "costs of 1e-70 are no ties";
  EXPECT_EQ(pairs(scaled(shape, 0x1p60)), expected);
  EXPECT_EQ(pairs(scaled(shape, 1000)), expected);
}

TEST_P(PairDecimater, FloatMeshesAreRoundedOnWriteBackOnly) {
  // The same contractions as on a mesh of doubles with the same, rounded, input.
  IndexedMesh shape = noisy_torus(40, 20, 1, 0.4, 0.02, 5);
  for (Vec3& p : shape.positions) p = p.cast<float>().cast<double>();
  Set<FloatMesh> single(shape, GetParam());
  Set<DoubleMesh> twice(shape, GetParam());
  single.decimater.decimate(600);
  twice.decimater.decimate(600);
  expect_same_contractions(twice.contractions, single.contractions, "float");
  for (const VertexHandle v : single.mesh.vertices()) {
    EXPECT_EQ(to_vec3(single.mesh.point(v)), to_vec3(twice.mesh.point(v)).cast<float>().cast<double>());
  }
}

}  // namespace
}  // namespace whittle::test
