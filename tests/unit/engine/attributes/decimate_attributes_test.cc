// Colours and normals of a decimation.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

TEST(Decimate, GivesColorsOfThePlaceWhereAVertexGoes) {
  IndexedMesh mesh = grid(10, 10);
  for (const Vec3& p : mesh.positions) mesh.colors.push_back({static_cast<float>(p.x() / 10), 0.25F, 1, 1});
  const Decimation d = decimate(mesh, DecimateTarget::faces(20));
  ASSERT_EQ(d.mesh.colors.size(), d.mesh.positions.size());
  for (std::size_t v = 0; v < d.mesh.positions.size(); ++v) {
    EXPECT_NEAR(d.mesh.colors[v][0], d.mesh.positions[v].x() / 10, 1e-6);
    EXPECT_EQ(d.mesh.colors[v][1], 0.25F);
  }
}

/// A flat grid in the plane z = 0 with normals that lean outwards.
IndexedMesh grid_with_normals() {
  IndexedMesh mesh = grid(10, 10);
  for (const Vec3& p : mesh.positions) {
    const Eigen::Vector3f normal = Vec3(p.x() - 5, p.y() - 5, 4).normalized().cast<float>();
    mesh.normals.push_back({normal.x(), normal.y(), normal.z()});
  }
  return mesh;
}

TEST(Decimate, GivesNormalsOfThePlaceWhereAVertexGoes) {
  const IndexedMesh mesh = grid_with_normals();
  const Decimation d = decimate(mesh, DecimateTarget::faces(150));
  ASSERT_EQ(d.mesh.normals.size(), d.mesh.positions.size());
  std::vector<int> counts(d.mesh.positions.size());
  for (const Index v : d.vertex_map) ++counts[v];
  std::size_t n_alone = 0;
  for (std::size_t v = 0; v < counts.size(); ++v) {
    const auto& n = d.mesh.normals[v];
    const Vec3 there(d.mesh.positions[v].x() - 5, d.mesh.positions[v].y() - 5, 4);
    EXPECT_LT((Vec3(n[0], n[1], n[2]) - there.normalized()).norm(), 0.05) << v;
    if (counts[v] > 1) continue;
    ++n_alone;
    EXPECT_EQ(n, mesh.normals[d.mesh.origins[v]]) << "to the bit";
  }
  EXPECT_GT(n_alone, 0U);
  EXPECT_EQ(decimate(mesh, DecimateTarget::faces(1000)).mesh.normals, mesh.normals) << "nothing is contracted";
}

TEST(Decimate, RecomputesOrDropsNormalsIfAsked) {
  const IndexedMesh mesh = grid_with_normals();
  const Decimation anew = decimate(mesh, DecimateTarget::faces(20), {.normals = Normals::recompute});
  ASSERT_EQ(anew.mesh.normals.size(), anew.mesh.positions.size());
  for (const auto& normal : anew.mesh.normals) EXPECT_NEAR(normal[2], 1, 1e-6);
  EXPECT_TRUE(decimate(mesh, DecimateTarget::faces(20), {.normals = Normals::drop}).mesh.normals.empty());
  for (const Normals normals : {Normals::keep, Normals::recompute}) {
    EXPECT_TRUE(decimate(grid(10, 10), DecimateTarget::faces(20), {.normals = normals}).mesh.normals.empty());
  }
}

/// The largest angle between the normal of a corner and that of its face, degrees.
double farthest_from_faces(const IndexedMesh& mesh) {
  double largest = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto [a, b, c] = mesh.faces[f];
    const Vec3 of_face = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& n = mesh.normals[mesh.wedge(f, k)];
      const Vec3 of_corner(n[0], n[1], n[2]);
      largest = std::max(largest, std::atan2(of_face.cross(of_corner).norm(), of_face.dot(of_corner)));
    }
  }
  return largest * 180 / std::numbers::pi;
}

TEST(Simplify, BreaksNormalsThatAreComputedAnewAtCreases) {
  IndexedMesh plain = test::tessellated_cube(6);
  plain.normals = vertex_normals(plain, Frame{});
  for (const IndexedMesh& cube : {plain, test::charted_cube(6)}) {
    for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
      for (const CostTraits& traits : all_cost_traits) {
        const Cost cost = traits.cost;
        SimplifyOptions options;
        options.decimate.normals = Normals::recompute;
        options.decimate.cost = cost;
        options.decimate.feature_angle_deg = 40;
        const auto target = DecimateTarget::faces(100);
        const IndexedMesh mesh = simplify(cube, target, effort, options).mesh;
        EXPECT_LT(farthest_from_faces(mesh), 0.1) << static_cast<int>(effort) << " " << to_string(cost);
        EXPECT_EQ(mesh.attributes.size(), cube.attributes.size());
        EXPECT_LT(farthest_from_faces(decimate(cube, target, options.decimate).mesh), 0.1) << to_string(cost);
        options.decimate.crease_angle_deg = 180;
        EXPECT_GT(farthest_from_faces(simplify(cube, target, effort, options).mesh), 30);
      }
    }
  }
}

TEST(SimplifyToLevels, BreaksNormalsThatAreComputedAnewAtCreases) {
  IndexedMesh cube = test::charted_cube(6);
  SimplifyOptions options;
  options.decimate.normals = Normals::recompute;
  options.decimate.feature_angle_deg = 40;
  const std::vector<DecimateTarget> targets{DecimateTarget::faces(200), DecimateTarget::faces(60)};
  for (const Simplification& level : simplify_to_levels(cube, targets, Effort::normal, options)) {
    EXPECT_LT(farthest_from_faces(level.mesh), 0.1);
  }
}

TEST(Decimate, RefusesAnAngleOfCreasesThatIsNone) {
  for (const double angle : {0.0, -1.0, 181.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(decimate(grid(3, 3), DecimateTarget::faces(4), {.crease_angle_deg = angle}), std::invalid_argument);
  }
}

TEST(Decimate, TakesTheNormalsOfTheFacesWhereThoseMergedCancelOut) {
  IndexedMesh mesh = grid(10, 10);
  const DecimateTarget one_less = DecimateTarget::vertices(mesh.positions.size() - 1);
  const std::vector<Index> vertex_map = decimate(mesh, one_less).vertex_map;
  Index kept = 0;
  Index removed = 0;
  for (Index v = 0; v < vertex_map.size(); ++v) {
    for (Index w = 0; w < v; ++w) {
      if (vertex_map[v] == vertex_map[w]) std::tie(kept, removed) = std::pair(v, w);
    }
  }
  ASSERT_NE(kept, removed);
  mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
  mesh.normals[kept] = {1, 0, 0};
  mesh.normals[removed] = {-1, 0, 0};
  const Decimation d = decimate(mesh, one_less, {.attribute_weights = {.normal = 0}});
  for (Index v = 0; v < vertex_map.size(); ++v) {
    const bool is_merged = v == kept || v == removed;
    EXPECT_EQ(d.mesh.normals[d.vertex_map[v]], (is_merged ? std::array<float, 3>{0, 0, 1} : mesh.normals[v]));
  }
}

}  // namespace
}  // namespace whittle::test
