// PairDecimaterT's interface, with either driver.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cmath>
#include <map>

#include "common/decimation.hh"
#include "common/meshes.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::VertexHandle;

class PairDecimater : public EachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, PairDecimater, each_driver, driver_name);

// Calls ---------------------------------------------------------------------------------------------------------------

TEST_P(PairDecimater, StockCallsReachTheirTargets) {
  const IndexedMesh shape = blob(3, 1);  // 642 vertices, 1280 faces
  {
    Decimation<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate(100), 100U) << "contractions, as in the stock";
    EXPECT_EQ(set.decimater.result().n_vertices, 542U);
    EXPECT_EQ(set.decimater.result().stop, StopReason::target);
    EXPECT_EQ(set.decimater.last_driver(), GetParam());
  }
  {
    Decimation<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to(200), 442U);
    set.mesh.garbage_collection();
    EXPECT_EQ(set.mesh.n_vertices(), 200U);
  }
  {
    Decimation<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to_faces(0, 401), 440U);
    EXPECT_EQ(set.decimater.result().n_faces, 400U);
  }
  {
    Decimation<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to_faces(300, 400), 342U) << "the first bound reached ends the run";
  }
  {
    Decimation<DoubleMesh> set(shape, GetParam());
    EXPECT_EQ(set.decimater.decimate_to(642), 0U);
    EXPECT_EQ(set.decimater.decimate_to_faces(0, 1280), 0U);
  }
  {
    Decimation<DoubleMesh> set(shape, GetParam());
    EXPECT_GT(set.decimater.decimate(), 600U) << "0 means as many as possible";
    EXPECT_EQ(set.decimater.result().stop, StopReason::exhausted);
    EXPECT_GT(set.decimater.result().refusals[Refusal::link] + set.decimater.result().refusals[Refusal::flip], 0U);
  }
}

TEST_P(PairDecimater, TheResultSaysWhatWasDone) {
  const IndexedMesh shape = terrain(20, 3);
  Decimation<DoubleMesh> set(shape, GetParam());
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
  Decimation<DoubleMesh> all(shape, GetParam());
  all.decimater.decimate(to_faces(400));
  const double limit = all.decimater.result().max_cost / 10;
  const auto below = [limit](double cost) { return cost <= limit; };

  Decimation<DoubleMesh> by_target(shape, GetParam());
  const DecimateResult result = by_target.decimater.decimate(to_cost(limit));
  EXPECT_EQ(result.stop, StopReason::cost);
  EXPECT_GT(result.n_contractions, 50U);
  EXPECT_LE(result.max_cost, limit);

  Decimation<DoubleMesh> by_module(shape, GetParam());
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
  Decimation<DoubleMesh> set(sphere(1));
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
  ModCollapsesT<DoubleMesh>::Handle recorder;
  decimater.add(cost);
  decimater.add(guard);
  EXPECT_THAT(decimater.engine_obstacle(), testing::HasSubstr("not initialized"));
  decimater.initialize();
  EXPECT_EQ(decimater.engine_obstacle(), "");

  decimater.add(recorder);
  decimater.initialize();
  EXPECT_THAT(message(decimater), testing::HasSubstr("module Collapses"));
  decimater.remove(recorder);

  decimater.initialize();
  EXPECT_EQ(decimater.decimate(5), 5U);
  EXPECT_EQ(decimater.engine_obstacle(), "") << "the next run goes on";
  EXPECT_EQ(decimater.decimate(5), 5U);

  decimater.module(cost).set_arithmetic(Arithmetic::stock);
  decimater.initialize();
  EXPECT_THAT(message(decimater), testing::HasSubstr("module GarlandHeckbert"));
}

TEST(PairDecimaterDrivers, AutomaticTakesTheEngineWhereItCan) {
  Decimation<DoubleMesh> set(sphere(3));
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::engine);
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::engine) << "the second run goes on where the first ended";
  set.decimater.initialize();
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::engine);
  set.mesh.status(*set.mesh.vertices().begin()).set_feature(true);
  set.decimater.initialize();
  set.decimater.decimate(50);
  EXPECT_EQ(set.decimater.last_driver(), Driver::engine) << "it knows features";
}

TEST(PairDecimaterDrivers, TwoRunsAreOne) {
  // The engine driver keeps the module's quadrics up to date, so that the next run continues from them.
  for (const IndexedMesh& shape : {blob(3, 7), moved(terrain(18, 4), Vec3(500, -70, 90))}) {
    Decimation<DoubleMesh> at_once(shape, Driver::mesh);
    at_once.decimater.decimate(400);
    Decimation<DoubleMesh> in_parts(shape);
    in_parts.decimater.decimate(150);
    EXPECT_EQ(in_parts.decimater.last_driver(), Driver::engine);
    in_parts.decimater.decimate(100);
    EXPECT_EQ(in_parts.decimater.last_driver(), Driver::engine);
    in_parts.decimater.decimate(150);
    expect_same_contractions(at_once.contractions, in_parts.contractions, "in parts");
  }
}

TEST_P(PairDecimater, InitializeTwiceStartsAnew) {
  const IndexedMesh shape = noisy_sphere(3, 0.05, 3);
  Decimation<DoubleMesh> once(shape, GetParam());
  once.decimater.decimate(200);
  Decimation<DoubleMesh> twice(shape, GetParam());
  ASSERT_TRUE(twice.decimater.initialize());
  twice.decimater.decimate(200);
  expect_same_contractions(once.contractions, twice.contractions, "initialized twice");

  // After another `initialize()` the run starts from a fresh state.
  ASSERT_TRUE(twice.decimater.initialize());
  twice.contractions.clear();
  twice.decimater.decimate(200);
  Decimation<DoubleMesh> again(geometry_of(once.mesh), GetParam());
  again.decimater.decimate(200);
  EXPECT_EQ(again.contractions.size(), twice.contractions.size());
  EXPECT_TRUE(geometry_of(again.mesh).positions == geometry_of(twice.mesh).positions);
}

// Observer ------------------------------------------------------------------------------------------------------------

TEST_P(PairDecimater, TheObserverIsToldCountsAndMayAbort) {
  const IndexedMesh shape = noisy_torus(40, 20, 1, 0.4, 0.02, 5);
  Decimation<DoubleMesh> whole(shape, GetParam());
  whole.decimater.decimate(300);

  Decimation<DoubleMesh> set(shape, GetParam());
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

  // It continues when asked to.
  set.decimater.set_observer(nullptr);
  set.decimater.set_driver(Driver::automatic);
  EXPECT_EQ(set.decimater.decimate(180), 180U);
  expect_same_contractions(whole.contractions, set.contractions, "aborted and resumed");
}

// What the protections are for ----------------------------------------------------------------------------------------

/// Records how far the faces around each contraction turn.
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
  EXPECT_GT(decimater.result().refusals[Refusal::flip], 0U) << "nothing to guard against";
}

TEST_P(PairDecimater, UnitAndPlaceChangeNoContraction) {
  const IndexedMesh shape = noisy_sphere(3, 0.05, 12);
  const auto pairs = [](const IndexedMesh& s) {
    Decimation<DoubleMesh> set(s, GetParam());
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
  // The same contractions as on a mesh of doubles with the same rounded input.
  IndexedMesh shape = noisy_torus(40, 20, 1, 0.4, 0.02, 5);
  for (Vec3& p : shape.positions) p = p.cast<float>().cast<double>();
  Decimation<FloatMesh> single(shape, GetParam());
  Decimation<DoubleMesh> twice(shape, GetParam());
  single.decimater.decimate(600);
  twice.decimater.decimate(600);
  expect_same_contractions(twice.contractions, single.contractions, "float");
  for (const VertexHandle v : single.mesh.vertices()) {
    EXPECT_EQ(to_vec3(single.mesh.point(v)), to_vec3(twice.mesh.point(v)).cast<float>().cast<double>());
  }
}

}  // namespace
}  // namespace whittle::test
