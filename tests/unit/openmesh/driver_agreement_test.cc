// Both drivers of PairDecimaterT make the same contractions: same pairs, positions and costs, to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <whittle/core/feature_edges.hh>

#include "common/meshes.hh"
#include "common/modules.hh"
#include "support/meshes.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

/// Which feature bits are set.
enum class Features {
  none,
  sharp_edges,  ///< those of 30° and more, and some of their vertices
  many          ///< every seventh edge and every thirteenth vertex
};

struct Setting {
  std::string name;
  CostOptions cost;
  double max_normal_flip_deg = 75;
  double min_radius_ratio = 0;
  bool lock_some = false;
  Features features = Features::none;
  double feature_tolerance = DecimateOptions().feature_tolerance;
};

struct Run {
  std::vector<Contraction> contractions;
  DecimateResult result;
  IndexedMesh mesh;
  std::vector<VertexPair> feature_edges;  ///< ascending, by handle
};

template <class MeshT>
void set_features(MeshT& mesh, Features features) {
  if (features == Features::none) return;
  const std::vector<VertexPair> sharp = feature_edges(geometry_of(mesh), 30);
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    const bool is_sharp = std::binary_search(sharp.begin(), sharp.end(), ends(mesh, e));
    mesh.status(e).set_feature(features == Features::many ? e.idx() % 7 == 0 : is_sharp);
    const OpenMesh::VertexHandle v = mesh.to_vertex_handle(mesh.halfedge_handle(e, 0));
    if (mesh.status(e).feature() && e.idx() % 3 == 0) mesh.status(v).set_feature(true);
  }
  for (const OpenMesh::VertexHandle v : mesh.vertices()) {
    if (features == Features::many && v.idx() % 13 == 0) mesh.status(v).set_feature(true);
  }
}

template <class MeshT>
Run run(MeshT mesh, const Setting& setting, const DecimateTarget& target, Driver driver) {
  PairDecimaterT<MeshT> decimater(mesh);
  add_cost(decimater, setting.cost);
  add_module<ModFlipGuardT<MeshT>>(decimater).set_max_normal_flip_deg(setting.max_normal_flip_deg);
  add_module<ModRadiusRatioT<MeshT>>(decimater).set_min_radius_ratio(setting.min_radius_ratio);
  decimater.set_feature_tolerance(setting.feature_tolerance);
  set_features(mesh, setting.features);
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
  result.feature_edges = marked_edges(mesh);
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
  EXPECT_TRUE(by_mesh.feature_edges == by_engine.feature_edges) << context;
  EXPECT_EQ(by_mesh.result.n_faces, by_engine.result.n_faces) << context;
  EXPECT_EQ(by_mesh.result.n_vertices, by_engine.result.n_vertices) << context;
  EXPECT_EQ(by_mesh.result.max_cost, by_engine.result.max_cost) << context;
  EXPECT_EQ(by_mesh.result.stop, by_engine.result.stop) << context;
}

/// Collects named settings. Each changes some of the defaults.
class Settings {
 public:
  template <class Change>
  Settings& add(const std::string& name, Change change) {
    settings_.push_back({name, {}});
    change(settings_.back());
    return *this;
  }
  std::vector<Setting> take() { return std::move(settings_); }

 private:
  std::vector<Setting> settings_;
};

std::vector<Setting> quadric_settings() {
  return Settings()
      .add("defaults", [](Setting&) {})
      .add("uniform", [](Setting& s) { s.cost.quadric.weights = Weights::uniform; })
      .add("area_angle", [](Setting& s) { s.cost.quadric.weights = Weights::area_angle; })
      .add("midpoint", [](Setting& s) { s.cost.quadric.placement = Placement::midpoint; })
      .add("endpoint", [](Setting& s) { s.cost.quadric.placement = Placement::endpoint; })
      .add("free border", [](Setting& s) { s.cost.quadric.boundary_weight = 0; })
      .add("flip 20", [](Setting& s) { s.max_normal_flip_deg = 20; })
      .add("flip 180", [](Setting& s) { s.max_normal_flip_deg = 180; })
      .add("radius ratio 0.3", [](Setting& s) { s.min_radius_ratio = 0.3; })
      .add("locked vertices", [](Setting& s) { s.lock_some = true; })
      .take();
}

/// The other costs, each with every term that it takes.
std::vector<Setting> cost_settings() {
  return Settings()
      .add("valence", [](Setting& s) { s.cost.valence_weight = 1; })
      .add("isotropy", [](Setting& s) { s.cost.isotropy = 0.3; })
      .add("isotropy 1", [](Setting& s) { s.cost.isotropy = 1; })
      .add("isotropy, valence, uniform, locked",
           [](Setting& s) {
             s.cost.isotropy = 0.5;
             s.cost.valence_weight = 0.2;
             s.cost.quadric.weights = Weights::uniform;
             s.lock_some = true;
           })
      .add("memoryless", [](Setting& s) { s.cost.cost = Cost::memoryless; })
      .add("memoryless, to an end, free border, flip 30",
           [](Setting& s) {
             s.cost.cost = Cost::memoryless;
             s.cost.quadric.placement = Placement::endpoint;
             s.cost.quadric.boundary_weight = 0;
             s.max_normal_flip_deg = 30;
           })
      .add("memoryless, valence, radius ratio, locked",
           [](Setting& s) {
             s.cost.cost = Cost::memoryless;
             s.cost.valence_weight = 0.5;
             s.min_radius_ratio = 0.4;
             s.lock_some = true;
           })
      .add("edge length", [](Setting& s) { s.cost.cost = Cost::midpoint; })
      .add("edge length, valence, locked",
           [](Setting& s) {
             s.cost.cost = Cost::midpoint;
             s.cost.valence_weight = 3;
             s.lock_some = true;
           })
      .add("Lindstrom-Turk", [](Setting& s) { s.cost.cost = Cost::lindstrom_turk; })
      .add("Lindstrom-Turk, valence, radius ratio, locked",
           [](Setting& s) {
             s.cost.cost = Cost::lindstrom_turk;
             s.cost.valence_weight = 0.5;
             s.min_radius_ratio = 0.4;
             s.lock_some = true;
           })
      .take();
}

std::vector<Setting> feature_settings() {
  return Settings()
      .add("sharp edges", [](Setting& s) { s.features = Features::sharp_edges; })
      .add("many features", [](Setting& s) { s.features = Features::many; })
      .add("many features, anywhere",
           [](Setting& s) {
             s.features = Features::many;
             s.feature_tolerance = std::numeric_limits<double>::infinity();
           })
      .add("many features within 0.1, locked, isotropy",
           [](Setting& s) {
             s.features = Features::many;
             s.feature_tolerance = 0.1;
             s.lock_some = true;
             s.cost.isotropy = 0.5;
           })
      .add("sharp edges within 0.05, Lindstrom-Turk",
           [](Setting& s) {
             s.features = Features::sharp_edges;
             s.feature_tolerance = 0.05;
             s.cost.cost = Cost::lindstrom_turk;
           })
      .add("many features within 0.05, memoryless",
           [](Setting& s) {
             s.features = Features::many;
             s.feature_tolerance = 0.05;
             s.cost.cost = Cost::memoryless;
           })
      .take();
}

/// On meshes of doubles and of floats.
void expect_agreement_on_all_shapes(const std::vector<Setting>& settings) {
  for (const auto& [name, shape] : holdable_meshes()) {
    for (const Setting& setting : settings) {
      expect_agreement(open_mesh<DoubleMesh>(shape), setting, DecimateTarget::as_far_as_possible(), name);
      expect_agreement(open_mesh<FloatMesh>(shape), setting, DecimateTarget::as_far_as_possible(), name + ", float");
    }
  }
}

TEST(DriverAgreement, OnEveryShapeUnderEverySetting) { expect_agreement_on_all_shapes(quadric_settings()); }
TEST(DriverAgreement, OnEveryShapeByEveryCost) { expect_agreement_on_all_shapes(cost_settings()); }
TEST(DriverAgreement, OnEveryShapeWithFeatures) { expect_agreement_on_all_shapes(feature_settings()); }

TEST(DriverAgreement, RotatedScaledMovedAndPermuted) {
  for (const auto& [name, shape] : holdable_meshes()) {
    const IndexedMesh turned = rotated(shape, 3);
    expect_agreement(open_mesh<DoubleMesh>(turned), {"rotated", {}}, DecimateTarget::as_far_as_possible(), name);
    expect_agreement(open_mesh<DoubleMesh>(scaled(turned, 1e-3)), {"scaled", {}}, DecimateTarget::as_far_as_possible(),
                     name);
    expect_agreement(open_mesh<DoubleMesh>(moved(turned, Vec3(1e5, -3e6, 7))), {"moved", {}},
                     DecimateTarget::as_far_as_possible(), name);
    expect_agreement(open_mesh<DoubleMesh>(permuted(turned, 5).mesh), {"permuted", {}},
                     DecimateTarget::as_far_as_possible(), name);
  }
}

TEST(DriverAgreement, WithoutRegularisationAsFarAsCostsStandOutFromRounding) {
  // Then every contraction on flat ground costs zero but for rounding. The engine's queue needs lower bounds. Rounding
  // breaks these there, and the two orders differ. Until the first difference, everything is the same. There, both
  // costs are rounding only (frame size 1, weights of at most 1).
  Setting setting{"unregularised", {}};
  setting.cost.quadric.regularization = 0;
  constexpr double rounding_floor = 1e-14;
  for (const auto& [name, shape] : holdable_meshes()) {
    const auto by_mesh =
        run(open_mesh<DoubleMesh>(shape), setting, DecimateTarget::as_far_as_possible(), Driver::mesh).contractions;
    const auto by_engine =
        run(open_mesh<DoubleMesh>(shape), setting, DecimateTarget::as_far_as_possible(), Driver::engine).contractions;
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

TEST_P(DriverAgreementOnRealMesh, WithFeaturesAndValencesDownToFivePercent) {
  WHITTLE_REAL_MESH_OR_SKIP(file, GetParam());
  const auto mesh = read_open_mesh<DoubleMesh>(file);
  Setting setting{"sharp edges, valence", {}};
  setting.features = Features::sharp_edges;
  setting.cost.valence_weight = 0.5;
  expect_agreement(mesh, setting, to_faces(mesh.n_faces() / 20), GetParam());
}

TEST_P(DriverAgreementOnRealMesh, ByMemorylessQuadricsDownToFivePercent) {
  WHITTLE_REAL_MESH_OR_SKIP(file, GetParam());
  const auto mesh = read_open_mesh<DoubleMesh>(file);
  Setting setting{"memoryless", {}};
  setting.cost.cost = Cost::memoryless;
  expect_agreement(mesh, setting, to_faces(mesh.n_faces() / 20), GetParam());
}

INSTANTIATE_TEST_SUITE_P(SlowMeshes, DriverAgreementOnRealMesh,
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
