// What polish brings down: the weights of points, how far vertices are from the original, and `Fit`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "decimated.hh"
#include "fit/fit_weights.hh"
#include "guard/drifted_vertices.hh"
#include "original/backward_offsets.hh"
#include "support/meshes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::test {

using namespace polishing;

namespace {

double distance_of(const TriangleTree& tree, const Vec3& point) { return (tree.nearest(point).point - point).norm(); }

TEST(FitWeights, HaveTheLossThatTheyComeFrom) {
  for (const double far : {4.3, 7.0, std::numeric_limits<double>::infinity()}) {
    const double unit = 0.3;
    const FitWeights weights(unit, far);
    for (const double distance : {0.01, 0.3, 0.9, 1.2, 1.31, 2.5, 9.0}) {
      const double step = 1e-6;
      const auto loss = [&](double d) { return weights.loss({{d * d, 1}}); };
      const double slope = (loss(distance + step) - loss(distance - step)) / (2 * step);
      EXPECT_NEAR(slope, weights.weight(distance) * distance / (unit * unit), 1e-6 * slope) << far << ' ' << distance;
    }
  }
}

TEST(FitWeights, CountFarPointsForMoreOnlyWhereAsked) {
  const FitWeights fair(1, std::numeric_limits<double>::infinity());
  const FitWeights max(1, 4.3);
  EXPECT_DOUBLE_EQ(fair.weight(10), 1.0 / 11);
  EXPECT_DOUBLE_EQ(max.weight(-10), 1.0 / 11 + 1);
  EXPECT_NEAR(max.weight(0.5), fair.weight(0.5), 1e-5);
}

IndexedMesh in_its_frame(IndexedMesh mesh) {
  const Frame frame = Frame::of_points(mesh.positions);
  for (Vec3& p : mesh.positions) p = frame.to_frame(p);
  return mesh;
}

/// A decimated mesh, some of whose vertices are moved off, and what measures how far.
struct Moved {
  explicit Moved(const IndexedMesh& mesh)
      : original(in_its_frame(mesh)),
        decimation(decimated(original, 0.2)),
        surface(original, 1),
        origins(surface, decimation.vertex_map, decimation.mesh.positions.size(), 1, 1),
        corners(corners_by_vertex(decimation.mesh.faces, decimation.mesh.positions.size())),
        positions(decimation.mesh.positions),
        tree(original) {
    Random random(3);
    for (std::size_t v = 0; v < positions.size(); v += 5) {
      positions[v] += 0.01 * size() * random.uniform_vector(-1, 1);
    }
  }
  double size() const { return diagonal_of(original.positions); }
  Surface before() const { return {decimation.mesh.faces, corners, decimation.mesh.positions}; }
  Surface after() const { return {decimation.mesh.faces, corners, positions}; }

  IndexedMesh original;
  Decimation decimation;
  OriginalSurface surface;
  Origins origins;
  VertexCorners corners;
  std::vector<Vec3> positions;
  TriangleTree tree;
};

std::vector<NamedMesh> whole_meshes() {
  return {{"blob", blob(4, 1)},
          {"torus", noisy_torus(60, 30, 1, 0.4, 0.01, 3)},
          {"cube", tessellated_cube(16)},
          {"terrain", terrain(40, 4)},
          {"bracket", bracket(24)}};
}

/// How many offsets are wrong: zero though the vertex is far, or longer than to the nearest point.
std::size_t n_wrong(std::span<const Vec3> offsets, const Moved& moved, double near) {
  std::size_t n = 0;
  for (std::size_t v = 0; v < offsets.size(); ++v) {
    const double distance = distance_of(moved.tree, moved.positions[v]);
    const bool is_near = offsets[v].isZero();
    if (!is_near) {
      EXPECT_GE(offsets[v].norm(), distance * (1 - 1e-9)) << "a closest point lies on the surface";
    }
    const bool is_right = is_near ? distance <= 1.5 * near : offsets[v].norm() <= 1.001 * distance + 1e-12;
    n += static_cast<std::size_t>(!is_right);
  }
  return n;
}

TEST(BackwardOffsets, AreFromTheNearestPoints) {
  for (const auto& [name, mesh] : whole_meshes()) {
    SCOPED_TRACE(name);
    const Moved moved(mesh);
    const double near = 0.002 * moved.size();
    const BackwardOffsets at_once(moved.origins, moved.after(), near, 1);
    EXPECT_LE(n_wrong(at_once.offsets(), moved, near), moved.positions.size() / 50);
    const BackwardOffsets before(moved.origins, moved.before(), 0.5 * near, 1);
    EXPECT_LE(n_wrong(before.after_moves(moved.positions, near, 1), moved, near), moved.positions.size() / 50);
  }
}

TEST(DriftedVertices, GoBackAndOthersStay) {
  for (const auto& [name, mesh] : whole_meshes()) {
    SCOPED_TRACE(name);
    Moved moved(mesh);
    const std::vector<Vec3>& before = moved.decimation.mesh.positions;
    const double most = 0.004 * moved.size();
    const BackwardOffsets backward(moved.origins, moved.before(), 0.6 * most, 1);
    const std::vector<Vec3> spread = moved.positions;
    const std::vector<Index> taken_back = take_back_drifted_vertices(backward, most, moved.positions, 1);
    EXPECT_FALSE(taken_back.empty());
    std::size_t n_left = 0;
    for (Index v = 0; v < before.size(); ++v) {
      const bool is_back = std::binary_search(taken_back.begin(), taken_back.end(), v);
      EXPECT_EQ(moved.positions[v], is_back ? before[v] : spread[v]);
      const double limit = std::max(most, distance_of(moved.tree, before[v]));
      n_left += static_cast<std::size_t>(distance_of(moved.tree, moved.positions[v]) > 1.5 * limit);
    }
    EXPECT_LE(n_left, before.size() / 100);
  }
}

metrics::SurfaceDistance fitted(const IndexedMesh& original, const Decimation& d, Fit fit) {
  return metrics::surface_distance(original, polished(original, d, {.passes = 3, .fit = fit}), {.samples = 50'000});
}

TEST(SlowPolishFit, BringsDownWhatIsAskedFor) {
  double largest = 1;
  double mean = 1;
  for (const IndexedMesh& original : {sphere(5), blob(5, 4), noisy_torus(120, 60, 1, 0.4, 0.002, 5)}) {
    const Decimation d = decimated(original, 0.05);
    const metrics::SurfaceDistance balanced = fitted(original, d, Fit::balanced);
    const metrics::SurfaceDistance max = fitted(original, d, Fit::max);
    largest *= max.max / balanced.max;
    mean *= fitted(original, d, Fit::mean).mean / balanced.mean;
    EXPECT_LT(max.max, 1.05 * balanced.max);
    EXPECT_LT(max.mean, 1.1 * balanced.mean);
  }
  EXPECT_LT(std::cbrt(largest), 0.95);
  EXPECT_LT(std::cbrt(mean), 1.002);
}

TEST(PolishFit, LetsNoVertexStickOut) {
  for (const auto& [name, original] : whole_meshes()) {
    for (const double ratio : {0.3, 0.1, 0.03}) {
      SCOPED_TRACE(name + " to " + std::to_string(ratio));
      const Decimation d = decimated(original, ratio);
      IndexedMesh after = d.mesh;
      const PolishResult result = polish(original, d.vertex_map, after);
      const TriangleTree tree(original);
      for (std::size_t v = 0; v < after.positions.size(); ++v) {
        const double limit = std::max(distance_of(tree, d.mesh.positions[v]), 5.5 * result.rms_before);
        EXPECT_LE(distance_of(tree, after.positions[v]), 1.5 * limit + 1e-9);
      }
    }
  }
}

/// At the edge between a flat top and a curved wall nothing holds a vertex in the plane of the top but faces without
/// points.
TEST(PolishFit, LeavesVerticesBelowTheTopOfAPart) {
  WHITTLE_REAL_MESH_OR_SKIP(block, "block.obj");
  const IndexedMesh original = io::read_mesh(block).mesh;
  for (const double ratio : {0.1, 0.05}) {
    const Decimation d = decimated(original, ratio);
    const double before = metrics::surface_distance(original, d.mesh, {.samples = 100'000}).max;
    for (const Fit fit : {Fit::balanced, Fit::max}) {
      const IndexedMesh after = polished(original, d, {.fit = fit});
      EXPECT_LE(metrics::surface_distance(original, after, {.samples = 100'000}).max, 1.1 * before) << ratio;
    }
  }
}

}  // namespace
}  // namespace whittle::test
