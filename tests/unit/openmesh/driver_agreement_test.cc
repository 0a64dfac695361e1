// Both drivers of PairDecimaterT make the same contractions: same pairs, places and costs, to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <whittle/openmesh/mod_garland_heckbert.hh>

#include "meshes.hh"
#include "support/meshes.hh"
#include "support/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

struct Setting {
  std::string name;
  QuadricOptions quadric;
  double max_normal_flip_deg = 75;
  bool lock_some = false;
};

struct Run {
  std::vector<Contraction> contractions;
  DecimateResult result;
  IndexedMesh mesh;
};

template <class MeshT>
Run run(MeshT mesh, const Setting& setting, const DecimateTarget& target, Driver driver) {
  PairDecimaterT<MeshT> decimater(mesh);
  typename ModGarlandHeckbertT<MeshT>::Handle cost;
  typename ModFlipGuardT<MeshT>::Handle guard;
  decimater.add(cost);
  decimater.add(guard);
  decimater.module(cost).set_options(setting.quadric);
  decimater.module(guard).set_max_normal_flip_deg(setting.max_normal_flip_deg);
  for (const OpenMesh::VertexHandle v : mesh.vertices()) {
    if (setting.lock_some) mesh.status(v).set_locked(v.idx() % 7 == 2 || v.idx() % 11 < 2);
  }
  Run result;
  decimater.set_listener([&](const Contraction& made) { result.contractions.push_back(made); });
  decimater.set_driver(driver);
  EXPECT_TRUE(decimater.initialize());
  result.result = decimater.decimate(target);
  EXPECT_EQ(decimater.last_driver(), driver);
  expect_sound(mesh, "after the run");
  result.mesh = geometry_of(mesh);
  return result;
}

template <class MeshT>
void expect_agreement(const MeshT& mesh, const Setting& setting, const DecimateTarget& target,
                      const std::string& name) {
  const std::string context = name + ", " + setting.name;
  const Run by_mesh = run(mesh, setting, target, Driver::mesh);
  const Run by_engine = run(mesh, setting, target, Driver::engine);
  expect_same_contractions(by_mesh.contractions, by_engine.contractions, context);
  EXPECT_TRUE(by_mesh.mesh.positions == by_engine.mesh.positions) << context;
  EXPECT_TRUE(by_mesh.mesh.faces == by_engine.mesh.faces) << context;
  EXPECT_EQ(by_mesh.result.n_faces, by_engine.result.n_faces) << context;
  EXPECT_EQ(by_mesh.result.n_vertices, by_engine.result.n_vertices) << context;
  EXPECT_EQ(by_mesh.result.max_cost, by_engine.result.max_cost) << context;
  EXPECT_EQ(by_mesh.result.stop, by_engine.result.stop) << context;
}

std::vector<Setting> settings() {
  std::vector<Setting> result{{"defaults", {}}};
  const auto add = [&result](const std::string& name, auto change) {
    result.push_back({name, {}});
    change(result.back());
  };
  add("uniform", [](Setting& s) { s.quadric.weights = Weights::uniform; });
  add("area_angle", [](Setting& s) { s.quadric.weights = Weights::area_angle; });
  add("midpoint", [](Setting& s) { s.quadric.placement = Placement::midpoint; });
  add("endpoint", [](Setting& s) { s.quadric.placement = Placement::endpoint; });
  add("free border", [](Setting& s) { s.quadric.boundary_weight = 0; });
  add("flip 20", [](Setting& s) { s.max_normal_flip_deg = 20; });
  add("flip 180", [](Setting& s) { s.max_normal_flip_deg = 180; });
  add("locked vertices", [](Setting& s) { s.lock_some = true; });
  return result;
}

TEST(DriverAgreement, OnEveryShapeUnderEverySetting) {
  for (const auto& [name, shape] : holdable_meshes()) {
    for (const Setting& setting : settings()) {
      expect_agreement(open_mesh<DoubleMesh>(shape), setting, {}, name);
      expect_agreement(open_mesh<FloatMesh>(shape), setting, {}, name + ", float");
    }
  }
}

TEST(DriverAgreement, RotatedScaledMovedAndPermuted) {
  for (const auto& [name, shape] : holdable_meshes()) {
    const IndexedMesh turned = rotated(shape, 3);
    expect_agreement(open_mesh<DoubleMesh>(turned), {"rotated", {}}, {}, name);
    expect_agreement(open_mesh<DoubleMesh>(scaled(turned, 1e-3)), {"scaled", {}}, {}, name);
    expect_agreement(open_mesh<DoubleMesh>(moved(turned, Vec3(1e5, -3e6, 7))), {"moved", {}}, {}, name);
    expect_agreement(open_mesh<DoubleMesh>(permuted(turned, 5).mesh), {"permuted", {}}, {}, name);
  }
}

TEST(DriverAgreement, WithoutRegularisationAsFarAsCostsStandOutFromRounding) {
  // Then every contraction on flat ground costs zero but for rounding. The engine's queue rests on lower bounds, which
  // rounding breaks there, and the orders part ways. Until they do, everything is the same; where they do, both cost
  // nothing but rounding (frame size 1, weights of at most 1).
  Setting setting{"unregularised", {}};
  setting.quadric.regularization = 0;
  constexpr double rounding_floor = 1e-14;
  for (const auto& [name, shape] : holdable_meshes()) {
    const auto by_mesh = run(open_mesh<DoubleMesh>(shape), setting, {}, Driver::mesh).contractions;
    const auto by_engine = run(open_mesh<DoubleMesh>(shape), setting, {}, Driver::engine).contractions;
    const auto [m, e] = std::mismatch(by_mesh.begin(), by_mesh.end(), by_engine.begin(), by_engine.end(), same_bits);
    if (m == by_mesh.end() && e == by_engine.end()) continue;
    std::cout << "[     NOTE ] " << name << ": orders part at contraction " << m - by_mesh.begin() << " of "
              << by_mesh.size() << '\n';
    ASSERT_TRUE(m != by_mesh.end() && e != by_engine.end()) << name;
    const double unit = std::pow(diagonal(shape), 4);
    EXPECT_LE(m->cost, rounding_floor * unit) << name;
    EXPECT_LE(e->cost, rounding_floor * unit) << name;
  }
}

class DriverAgreementOnRealMesh : public testing::TestWithParam<const char*> {};

TEST_P(DriverAgreementOnRealMesh, DownToOnePercent) {
  WHITTLE_REAL_MESH_OR_SKIP(file, GetParam());
  const auto mesh = read_open_mesh<DoubleMesh>(file);
  expect_agreement(mesh, {"defaults", {}}, to_faces(mesh.n_faces() / 100), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Meshes, DriverAgreementOnRealMesh,
                         testing::Values("dinosaur.obj", "bunny.obj", "camel.off", "kitten.obj", "lion-head.off",
                                         "fandisk.obj", "rocker.obj", "joint.off"),
                         [](const auto& test) {
                           std::string name = test.param;
                           name.resize(name.find('.'));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace whittle::test
