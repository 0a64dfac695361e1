// ModValenceT and ModRadiusRatioT: what they refuse in OpenMesh's decimaters and in PairDecimaterT.
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cmath>
#include <limits>
#include <numbers>
#include <whittle/openmesh/mod_radius_ratio.hh>
#include <whittle/openmesh/mod_valence.hh>

#include "common/decimation.hh"
#include "common/modules.hh"
#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

using OpenMesh::VertexHandle;
using StockDecimater = OpenMesh::Decimater::DecimaterT<DoubleMesh>;

/// A fan of n faces around vertex 0 in the plane, with rim vertices 1 to n, and its collapses.
struct Fan {
  explicit Fan(int n) {
    const VertexHandle center = mesh.add_vertex({0, 0, 0});
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.add_vertex({std::cos(angle), std::sin(angle), 0});
    }
    for (int i = 0; i < n; ++i) mesh.add_face(center, VertexHandle(1 + i), VertexHandle(1 + (i + 1) % n));
    mesh.request_vertex_status();
    mesh.request_edge_status();
  }
  OpenMesh::Decimater::CollapseInfoT<DoubleMesh> collapse(int v0, int v1) {
    return {mesh, mesh.find_halfedge(VertexHandle(v0), VertexHandle(v1))};
  }
  DoubleMesh mesh;
};

// Valences ------------------------------------------------------------------------------------------------------------

/// How far outside the default ranges the worst vertex is.
int worst_excess(const DoubleMesh& mesh) {
  int worst = 0;
  for (const VertexHandle v : mesh.vertices()) {
    const ValenceRange range = mesh.is_boundary(v) ? ValenceRange{2, 7} : ValenceRange{4, 9};
    const auto valence = static_cast<int>(mesh.valence(v));
    worst = std::max({worst, range.min - valence, valence - range.max});
  }
  return worst;
}

TEST(ModValence, NoVertexOfAClosedSphereLeavesTheRange) {
  for (const NamedCost& cost : named_costs()) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(3, 0.1, 4));
    PairDecimaterT<DoubleMesh> decimater(mesh);
    add_cost(decimater, cost.options);
    add_module<ModValenceT<DoubleMesh>>(decimater);
    ASSERT_TRUE(decimater.initialize());
    decimater.set_listener([&](const Contraction&) { ASSERT_EQ(worst_excess(mesh), 0) << cost.name; });
    EXPECT_EQ(decimater.decimate_to_faces(0, 100), 590U) << cost.name;
    EXPECT_EQ(decimater.last_driver(), Driver::mesh);
    EXPECT_EQ(worst_excess(mesh), 0) << cost.name;
    expect_sound(mesh, cost.name);
    if (cost.name != "quadric") continue;
    ASSERT_EQ(decimater.module_refusals().size(), 1U) << "it would have stayed within without the module";
    EXPECT_EQ(decimater.module_refusals()[0].module, "Valence");
  }
}

TEST(ModValence, BordersHaveARangeOfTheirOwn) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_grid(16, 16, 0.2, 4));
  PairDecimaterT<DoubleMesh> decimater(mesh);
  add_cost(decimater, {});
  add_module<ModValenceT<DoubleMesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate_to_faces(0, 60), 150U);
  EXPECT_EQ(worst_excess(mesh), 0);
  expect_sound(mesh, "after the run");
}

TEST(ModValence, WhatWaitsIsWokenWhenValencesChange) {
  // A further run looks at all pairs. It would contract any refused pair that had not been looked at again.
  for (const bool foreign : {false, true}) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(3, 0.1, 6));
    PairDecimaterT<DoubleMesh> decimater(mesh);
    if (foreign) {
      add_module<OpenMesh::Decimater::ModQuadricT<DoubleMesh>>(decimater).unset_max_err();
    } else {
      add_cost(decimater, {});
    }
    add_module<ModValenceT<DoubleMesh>>(decimater).set_inner_range({5, 7});
    ASSERT_TRUE(decimater.initialize());
    EXPECT_GT(decimater.decimate(), 300U);
    EXPECT_EQ(decimater.decimate(), 0U) << (foreign ? "foreign" : "own");
  }
}

TEST(ModValence, WhatIsOutsideMayGetBetterAndNotWorse) {
  // Both poles have 24 edges. They may lose some, but not gain any.
  DoubleMesh mesh = open_mesh<DoubleMesh>(uv_sphere(12, 24));
  PairDecimaterT<DoubleMesh> decimater(mesh);
  add_cost(decimater, {});
  add_module<ModValenceT<DoubleMesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  int worst = worst_excess(mesh);
  EXPECT_EQ(worst, 15);
  decimater.set_listener([&](const Contraction&) {
    EXPECT_LE(worst_excess(mesh), worst);
    worst = worst_excess(mesh);
  });
  EXPECT_GT(decimater.decimate_to_faces(0, 150), 150U);
  EXPECT_LT(worst, 15);
}

TEST(ModValence, RefusesByTheNumbersOfTheMergedVertexAndTheWings) {
  Fan fan(6);
  ModValenceT<DoubleMesh> module(fan.mesh);
  const auto allows = [&](int v0, int v1) { return module.collapse_priority(fan.collapse(v0, v1)) >= 0; };
  // Center into the rim: merged 6 + 3 − 4 = 5 edges, on the border; wings on the border, 3 before and 2 after.
  EXPECT_TRUE(allows(0, 1));
  module.set_border_range({2, 4});
  EXPECT_FALSE(allows(0, 1)) << "merged";
  module.set_border_range({3, 7});
  EXPECT_FALSE(allows(0, 1)) << "wings";
  // Along the rim: merged 3 + 3 − 3 = 3, on the border; the wing is the center, 6 before and 5 after.
  EXPECT_TRUE(allows(1, 2));
  module.set_inner_range({6, 9});
  EXPECT_FALSE(allows(1, 2)) << "wing";
  module.set_inner_range({7, 9});
  EXPECT_FALSE(allows(1, 2)) << "wing, outside before, and farther after";
  module.set_inner_range({2, 4});
  EXPECT_TRUE(allows(1, 2)) << "wing, outside after, and farther before";
}

TEST(ModValence, RangesAreChecked) {
  DoubleMesh mesh;
  ModValenceT<DoubleMesh> module(mesh);
  EXPECT_TRUE(module.is_binary());
  EXPECT_EQ(module.inner_range(), (ValenceRange{4, 9}));
  EXPECT_EQ(module.border_range(), (ValenceRange{2, 7}));
  EXPECT_THROW(module.set_inner_range({5, 4}), std::invalid_argument);
  EXPECT_THROW(module.set_border_range({-1, 4}), std::invalid_argument);
  EXPECT_EQ(module.inner_range(), (ValenceRange{4, 9}));
}

TEST(ModValence, OpenMeshsDecimaterAsksItWhenACollapseIsQueued) {
  const auto n_outside = [](bool with_module) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_torus(64, 32, 1, 0.4, 0.02, 3));
    StockDecimater decimater(mesh);
    add_cost(decimater, {});
    if (with_module) add_module<ModValenceT<DoubleMesh>>(decimater);
    EXPECT_TRUE(decimater.initialize());
    EXPECT_EQ(decimater.decimate_to_faces(0, 1000), 1548U);
    expect_sound(mesh, "after the run");
    const auto vertices = mesh.vertices();
    return std::count_if(vertices.begin(), vertices.end(),
                         [&](VertexHandle v) { return mesh.valence(v) < 4 || mesh.valence(v) > 9; });
  };
  EXPECT_GT(n_outside(false), 10);
  EXPECT_LT(n_outside(true), n_outside(false)) << "fewer, but what has been queued is not asked about again";
}

// Radius ratios -------------------------------------------------------------------------------------------------------

double least_radius_ratio(const DoubleMesh& mesh) {
  double least = 1;
  for (const OpenMesh::FaceHandle f : mesh.faces()) {
    const auto [a, b, c] = face_corners(mesh, f);
    const auto at = [&](VertexHandle v) { return to_vec3(mesh.point(v)); };
    least = std::min(least, radius_ratio(at(a), at(b), at(c)));
  }
  return least;
}

class ModRadiusRatio : public EachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, ModRadiusRatio, each_driver, driver_name);

TEST_P(ModRadiusRatio, NoFaceGetsThinnerThanTheLimit) {
  for (const NamedCost& cost : named_costs()) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(3, 0.05, 4));
    ASSERT_GT(least_radius_ratio(mesh), 0.4);
    PairDecimaterT<DoubleMesh> decimater(mesh);
    add_cost(decimater, cost.options);
    add_module<ModRadiusRatioT<DoubleMesh>>(decimater).set_min_radius_ratio(0.4);
    decimater.set_driver(GetParam());
    ASSERT_TRUE(decimater.initialize());
    EXPECT_EQ(decimater.engine_obstacle(), "");
    const DecimateResult result = decimater.decimate(to_faces(150));
    EXPECT_EQ(result.n_faces, 150U) << cost.name;
    EXPECT_GE(least_radius_ratio(mesh), 0.4 * (1 - 1e-9)) << cost.name;
    EXPECT_TRUE(decimater.module_refusals().empty());
    if (cost.name != "quadric") continue;
    EXPECT_GT(result.refusals[Refusal::shape], 10U);
  }
}

TEST_P(ModRadiusRatio, AFaceBelowTheLimitMayVanishOrGetBetter) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(3, 0.1, 4));
  const double least = least_radius_ratio(mesh);
  ASSERT_LT(least, 0.77);
  PairDecimaterT<DoubleMesh> decimater(mesh);
  add_cost(decimater, {});
  add_module<ModRadiusRatioT<DoubleMesh>>(decimater).set_min_radius_ratio(0.8);
  decimater.set_driver(GetParam());
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate(), 100U);
  EXPECT_GE(least_radius_ratio(mesh), least * (1 - 1e-9));
}

TEST(ModRadiusRatio, LooksAtBothStarsWithTheMergedVertexInItsPlace) {
  Fan fan(6);
  ModRadiusRatioT<DoubleMesh> guard(fan.mesh);
  guard.set_min_radius_ratio(0.3);
  EXPECT_TRUE(guard.is_binary());
  // v1 keeps its position. The thinnest remaining face is (1, 2, 3), with an angle of 120°: ratio 0.46….
  EXPECT_GE(guard.collapse_priority(fan.collapse(0, 1)), 0);
  guard.set_min_radius_ratio(0.6);
  EXPECT_LT(guard.collapse_priority(fan.collapse(0, 1)), 0);
  // With a cost module that moves the merged vertex to the middle, all faces are rounder than that.
  ModMidpointT<DoubleMesh> midpoint(fan.mesh);
  midpoint.initialize();
  guard.set_cost_module(&midpoint);
  EXPECT_GE(guard.collapse_priority(fan.collapse(0, 1)), 0);
  guard.set_min_radius_ratio(0.95);
  EXPECT_LT(guard.collapse_priority(fan.collapse(0, 1)), 0);
  guard.set_min_radius_ratio(0);
  guard.set_cost_module(nullptr);
  EXPECT_GE(guard.collapse_priority(fan.collapse(0, 1)), 0) << "off";
}

TEST(ModRadiusRatio, LimitsAreCheckedAndTheToleranceFactorTightensThem) {
  DoubleMesh mesh;
  ModRadiusRatioT<DoubleMesh> guard(mesh);
  for (const double wrong : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(guard.set_min_radius_ratio(wrong), std::invalid_argument) << wrong;
  }
  EXPECT_EQ(guard.min_radius_ratio(), 0.1);
  guard.set_min_radius_ratio(0.2);
  for (const double factor : {0.5, 0.0, 1.0}) {
    guard.set_error_tolerance_factor(factor);
    EXPECT_DOUBLE_EQ(guard.min_radius_ratio(), 1 - 0.8 * factor);
  }
  guard.set_min_radius_ratio(0);
  guard.set_error_tolerance_factor(0.5);
  EXPECT_EQ(guard.min_radius_ratio(), 0) << "off stays off";
}

TEST(ModRadiusRatio, OpenMeshsDecimaterAsksItWhenACollapseIsQueued) {
  const auto n_thin = [](bool with_module) {
    DoubleMesh mesh = open_mesh<DoubleMesh>(noisy_sphere(3, 0.05, 4));
    StockDecimater decimater(mesh);
    auto& cost = add_cost(decimater, {});
    if (with_module) {
      auto& guard = add_module<ModRadiusRatioT<DoubleMesh>>(decimater);
      guard.set_min_radius_ratio(0.4);
      guard.set_cost_module(&cost);
    }
    EXPECT_TRUE(decimater.initialize());
    EXPECT_GT(decimater.decimate_to_faces(0, 300), 300U);
    expect_sound(mesh, "after the run");
    const auto faces = mesh.faces();
    return std::count_if(faces.begin(), faces.end(), [&](OpenMesh::FaceHandle f) {
      const auto [a, b, c] = face_corners(mesh, f);
      return radius_ratio(to_vec3(mesh.point(a)), to_vec3(mesh.point(b)), to_vec3(mesh.point(c))) < 0.4;
    });
  };
  EXPECT_GT(n_thin(false), 10);
  EXPECT_LT(n_thin(true), n_thin(false) / 2);
}

}  // namespace
}  // namespace whittle::test
