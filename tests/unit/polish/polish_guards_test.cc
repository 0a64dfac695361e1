#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "guard/new_intersections.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "surface/face_neighbors.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/polish/polish.hh"

// The guards of polish, on meshes that would break without them.
namespace whittle::test {

using namespace polishing;

namespace {

struct Polished {
  IndexedMesh before;
  IndexedMesh after;
};

Polished polished_mesh(const IndexedMesh& original, double ratio, const PolishOptions& polish_options) {
  DecimateOptions options;
  options.cost = Cost::memoryless;
  Decimation d = decimate(
      original, DecimateTarget::faces(static_cast<std::uint64_t>(ratio * static_cast<double>(original.faces.size()))),
      options);
  Polished both{d.mesh, std::move(d.mesh)};
  polish(original, d.vertex_map, both.after, polish_options);
  return both;
}
Polished polished_mesh(const IndexedMesh& original, double ratio, unsigned passes) {
  return polished_mesh(original, ratio, PolishOptions{.passes = passes});
}

std::vector<NamedMesh> rough_meshes() {
  return {{"sphere", noisy_sphere(4, 0.05, 1)},
          {"rough sphere", noisy_sphere(4, 0.1, 2)},
          {"torus", noisy_torus(60, 30, 1, 0.4, 0.05, 3)},
          {"rough torus", noisy_torus(60, 30, 1, 0.4, 0.1, 3)},
          {"knot", knot(100, 16)},
          {"terrain", terrain(40, 4)},
          {"grid", noisy_grid(30, 30, 0.2, 6)}};
}

TEST(PolishGuards, MakeNoFolds) {
  for (const auto& [name, original] : rough_meshes()) {
    for (const double ratio : {0.5, 0.1, 0.02}) {
      SCOPED_TRACE(name + " to " + std::to_string(ratio));
      const Polished mesh = polished_mesh(original, ratio, 3);
      EXPECT_LE(metrics::shape(mesh.after).folds, metrics::shape(mesh.before).folds);
    }
  }
}

/// The flip limit on the angle between two faces is larger than the fold angle here.
TEST(PolishGuards, MakeNoFoldsByFlips) {
  for (const auto& [name, original] : rough_meshes()) {
    for (const double angle_deg : {150.0, 175.0}) {
      SCOPED_TRACE(name + ", " + std::to_string(angle_deg));
      const PolishOptions options{.passes = 3, .flips = true, .feature_angle_deg = angle_deg};
      const Polished mesh = polished_mesh(original, 0.5, options);
      const auto n_folds = [](const IndexedMesh& m) { return feature_edges(m, 121).size(); };
      EXPECT_LE(n_folds(mesh.after), n_folds(mesh.before));
    }
  }
}

TEST(PolishGuards, MakeNoThinFaces) {
  const auto least = [](const IndexedMesh& mesh) { return metrics::shape(mesh).radius_ratio_min; };
  for (const auto& [name, original] : rough_meshes()) {
    for (const double limit : {0.0, 0.2}) {
      for (const bool flips : {false, true}) {
        SCOPED_TRACE(name + ", " + std::to_string(limit));
        const Polished mesh = polished_mesh(original, 0.4, {.passes = 3, .flips = flips, .min_radius_ratio = limit});
        EXPECT_NE(mesh.after.positions, mesh.before.positions);
        EXPECT_GE(least(mesh.after), std::min(std::max(limit, 1e-3), least(mesh.before)) * (1 - 1e-9));
      }
    }
  }
}

using Pairs = std::vector<std::array<Index, 2>>;

/// The faces of the second mesh that the first one doesn't have.
Pairs added(const Pairs& before, const Pairs& after) {
  Pairs added;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
  return added;
}

TEST(PolishGuards, TakeBackWhateverIntersects) {
  Random random(2);
  std::size_t n_wrong = 0;
  for (const auto& [name, mesh] : all_meshes()) {
    SCOPED_TRACE(name);
    const VertexCorners corners = corners_by_vertex(mesh.faces, mesh.positions.size());
    const FaceNeighbors neighbors(mesh.faces, corners, detail::Workers(1));
    const FaceLimits limits(neighbors, {}, std::nullopt);
    IndexedMesh moved = mesh;
    const double length = 0.3 * metrics::shape(mesh).edge_length_mean;
    for (Vec3& p : moved.positions) p += random.uniform_vector(-length, length);
    const Pairs before = metrics::self_intersections(mesh);
    n_wrong += added(before, metrics::self_intersections(moved)).size();
    std::vector<Vec3> positions = moved.positions;
    take_back_intersections({mesh.faces, corners, mesh.positions}, limits, positions, {}, 1);
    std::vector<Vec3> again = moved.positions;
    take_back_intersections({mesh.faces, corners, mesh.positions}, limits, again, {}, 3);
    EXPECT_EQ(positions, again);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      EXPECT_TRUE(positions[v] == mesh.positions[v] || positions[v] == moved.positions[v]);
    }
    moved.positions = positions;
    EXPECT_EQ(added(before, metrics::self_intersections(moved)), Pairs());
  }
  EXPECT_GT(n_wrong, 100U);
}

TEST(PolishGuards, TakeNothingBackWhereNothingIntersects) {
  const IndexedMesh mesh = sphere(3);
  const VertexCorners corners = corners_by_vertex(mesh.faces, mesh.positions.size());
  const FaceNeighbors neighbors(mesh.faces, corners, detail::Workers(1));
  const FaceLimits limits(neighbors, {}, std::nullopt);
  const std::vector<Vec3> moved = noisy_sphere(3, 0.02, 1).positions;
  std::vector<Vec3> positions = moved;
  take_back_intersections({mesh.faces, corners, mesh.positions}, limits, positions, {}, 1);
  EXPECT_EQ(positions, moved);
}

/// Two rough sheets close to each other. If each were fitted alone, they would intersect.
TEST(PolishGuards, MakeNoIntersections) {
  const std::vector<NamedMesh> sheets{{"sphere", noisy_sphere(4, 0.05, 1)},
                                      {"torus", noisy_torus(60, 30, 1, 0.4, 0.05, 3)},
                                      {"terrain", terrain(40, 4)}};
  for (const auto& [name, original] : sheets) {
    SCOPED_TRACE(name);
    IndexedMesh above = original;
    for (Vec3& p : above.positions) p *= 1.02;
    const IndexedMesh both = joined(original, above);
    for (const double ratio : {0.3, 0.05}) {
      const Polished mesh = polished_mesh(both, ratio, 3);
      const Pairs before = metrics::self_intersections(mesh.before);
      EXPECT_EQ(added(before, metrics::self_intersections(mesh.after)), Pairs()) << ratio;
      EXPECT_NE(mesh.before.positions, mesh.after.positions);
    }
  }
}

}  // namespace
}  // namespace whittle::test
