// Feature bits in PairDecimaterT with either driver: what they prevent, and how they change.
#include <gtest/gtest.h>

#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cmath>
#include <limits>
#include <whittle/core/feature_edges.hh>

#include "common/decimation.hh"
#include "common/modules.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle::test {
namespace {

using OpenMesh::VertexHandle;

class FeatureLines : public EachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, FeatureLines, each_driver, driver_name);

/// The vertices with two marked edges.
std::vector<VertexHandle> vertices_on_lines(const DoubleMesh& mesh) {
  std::vector<VertexHandle> result;
  for (const VertexHandle v : mesh.vertices()) {
    if (count_feature_edges(mesh, v) == 2) result.push_back(v);
  }
  return result;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}

/// Distance to the nearest marked edge.
double distance_to_lines(const DoubleMesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : marked_edges(mesh)) {
    const auto at = [&mesh](Index v) { return to_vec3(mesh.point(VertexHandle(static_cast<int>(v)))); };
    least = std::min(least, distance_to_segment(p, at(a), at(b)));
  }
  return least;
}

/// A cylinder with 24 vertices around; the ring at half its height is a feature line.
struct Ring {
  explicit Ring(Driver driver) : shape(open_cylinder(24, 8)), set(shape, driver) {
    for (const auto e : set.mesh.edges()) set.mesh.status(e).set_feature(is_on(e.v0()) && is_on(e.v1()));
    EXPECT_TRUE(set.decimater.initialize());
  }
  bool is_on(VertexHandle v) const { return std::abs(set.mesh.point(v)[2] - 1) < 1e-9; }

  IndexedMesh shape;
  Decimation<DoubleMesh> set;
};

TEST_P(FeatureLines, ALineMovesAlongItselfAndStaysALoop) {
  Ring ring(GetParam());
  ring.set.decimater.set_feature_tolerance(std::numeric_limits<double>::infinity());
  ring.set.decimater.decimate();
  EXPECT_EQ(ring.set.decimater.last_driver(), GetParam());
  const std::vector<VertexHandle> on_line = vertices_on_lines(ring.set.mesh);
  for (const VertexHandle v : on_line) {
    const Vec3 p = to_vec3(ring.set.mesh.point(v));
    EXPECT_TRUE(std::count(ring.shape.positions.begin(), ring.shape.positions.end(), p)) << p.transpose();
    EXPECT_NEAR(p.z(), 1, 1e-9);
  }
  EXPECT_EQ(on_line.size(), marked_edges(ring.set.mesh).size()) << "one closed line";
  EXPECT_LT(on_line.size(), 24U) << "nothing was contracted along the line";
  EXPECT_GE(on_line.size(), 3U);
  expect_sound(ring.set.mesh, "after the run");
}

TEST_P(FeatureLines, ALineStaysWithinTheTolerance) {
  std::size_t n_before = 0;
  for (const double tolerance : {0.0, 5e-4, 0.02, 0.1}) {
    Ring ring(GetParam());
    if (tolerance != 5e-4) ring.set.decimater.set_feature_tolerance(tolerance);
    EXPECT_EQ(ring.set.decimater.feature_tolerance(), tolerance) << "the default is 5e-4";
    ring.set.decimater.decimate();
    const std::size_t n_on_line = vertices_on_lines(ring.set.mesh).size();
    if (tolerance > 5e-4) {
      EXPECT_LT(n_on_line, n_before);
    } else {
      EXPECT_EQ(n_on_line, 24U) << "the ring is too round for any contraction";
    }
    n_before = n_on_line;
    for (const Vec3& p : ring.shape.positions) {
      if (std::abs(p.z() - 1) > 1e-9) continue;
      EXPECT_LE(distance_to_lines(ring.set.mesh, p),
                tolerance * diagonal_of(mesh_bounds(open_mesh<DoubleMesh>(ring.shape))) + 1e-12);
    }
  }
}

TEST_P(FeatureLines, ACubeIsHeldByItsEdges) {
  // Each side's inner edges vanish. Each edge of the cube becomes one edge. Its corners, where three edges meet, stay.
  const IndexedMesh shape = tessellated_cube(6);
  Decimation<DoubleMesh> set(shape, GetParam());
  mark_edges(set.mesh, feature_edges(shape, 45));
  ASSERT_TRUE(set.decimater.initialize());
  set.decimater.decimate_to_faces(0, 12);
  EXPECT_EQ(set.decimater.result().n_faces, 12U);
  const std::vector<VertexPair> left = marked_edges(set.mesh);
  EXPECT_EQ(left.size(), 12U);
  for (const auto& [a, b] : left) {
    const Vec3 edge = to_vec3(set.mesh.point(VertexHandle(static_cast<int>(b)))) -
                      to_vec3(set.mesh.point(VertexHandle(static_cast<int>(a))));
    EXPECT_EQ(edge.norm(), 2) << "an edge of the cube (±1)³";
  }
}

TEST_P(FeatureLines, EndsAndMeetingsStay) {
  // A feature line along the middle row of a grid, and one that meets it from below.
  const IndexedMesh shape = noisy_grid(12, 12, 0.2, 3);
  const auto number = [](int x, int y) { return static_cast<Index>(y * 13 + x); };
  ASSERT_EQ(shape.positions[number(5, 6)].head<2>(), Eigen::Vector2d(5, 6));
  std::vector<VertexPair> lines;
  for (int x = 2; x < 10; ++x) lines.push_back({number(x, 6), number(x + 1, 6)});
  for (int y = 2; y < 6; ++y) lines.push_back({number(5, y), number(5, y + 1)});
  std::sort(lines.begin(), lines.end());
  Decimation<DoubleMesh> set(shape, GetParam());
  mark_edges(set.mesh, lines);
  set.decimater.set_feature_tolerance(1);
  ASSERT_TRUE(set.decimater.initialize());
  set.decimater.decimate();
  for (const auto& [x, y] : {std::pair(2, 6), std::pair(10, 6), std::pair(5, 6), std::pair(5, 2)}) {
    EXPECT_TRUE(unmoved(set.mesh, shape, VertexHandle(static_cast<int>(number(x, y))))) << x << ", " << y;
  }
  EXPECT_GT(set.decimater.result().refusals[Refusal::feature], 0U);
  const std::size_t n_left = marked_edges(set.mesh).size();
  EXPECT_GE(n_left, 3U);
  EXPECT_LT(n_left, lines.size());
}

TEST_P(FeatureLines, WithoutFeatureEdgesFeatureVerticesAreCorners) {
  const IndexedMesh shape = blob(3, 5);
  Decimation<DoubleMesh> set(shape, GetParam());
  for (const VertexHandle v : set.mesh.vertices()) set.mesh.status(v).set_feature(v.idx() % 5 == 0);
  ASSERT_TRUE(set.decimater.initialize());
  set.decimater.decimate();
  for (int v = 0; v < 642; v += 5) EXPECT_TRUE(unmoved(set.mesh, shape, VertexHandle(v))) << v;
  EXPECT_GT(set.decimater.result().n_contractions, 300U);
}

TEST_P(FeatureLines, TheBitsLeftAreTheFeatureEdgesOfTheEngine) {
  for (const IndexedMesh& shape : {bracket(3), cone(16), open_cylinder(24, 8)}) {
    const std::vector<VertexPair> features = feature_edges(shape, 30);
    DecimateOptions options;
    options.feature_edges = features;
    const DecimateTarget target = to_faces(shape.faces.size() / 3);
    const whittle::Decimation expected = whittle::decimate(shape, target, options);
    Decimation<DoubleMesh> set(shape, GetParam());
    mark_edges(set.mesh, features);
    ASSERT_TRUE(set.decimater.initialize());
    set.decimater.decimate(target);
    std::vector<VertexPair> by_origin;
    for (const auto& [a, b] : expected.feature_edges) {
      by_origin.push_back({expected.mesh.origins[a], expected.mesh.origins[b]});
    }
    EXPECT_TRUE(marked_edges(set.mesh) == by_origin) << shape.faces.size() << " faces";
  }
}

TEST(FeatureLinesOfCopies, BitsAreTheEnginesWhereThresholdPairsAreContracted) {
  const IndexedMesh shape = boxes(2, 2);
  const std::vector<VertexPair> features = feature_edges(shape, 30);
  DecimateOptions options;
  options.feature_edges = features;
  options.pairs.threshold = 0.25;
  const DecimateTarget target = to_vertices(20);
  const whittle::Decimation expected = whittle::decimate(shape, target, options);
  Decimation<DoubleMesh> set(shape);
  mark_edges(set.mesh, features);
  set.decimater.set_pair_threshold(0.25);
  ASSERT_TRUE(set.decimater.initialize());
  set.decimater.decimate(target);
  EXPECT_EQ(set.decimater.last_driver(), Driver::engine);
  // Several mesh edges may become one edge, because its ends have copies.
  const detail::VertexNumbers numbers = detail::number_vertices(set.mesh, Copies::joined);
  std::vector<VertexPair> actual;
  for (const auto& [a, b] : marked_edges(set.mesh)) {
    const auto [low, high] = std::minmax({numbers.number_of[a], numbers.number_of[b]});
    actual.push_back({low, high});
  }
  std::sort(actual.begin(), actual.end());
  actual.erase(std::unique(actual.begin(), actual.end()), actual.end());
  EXPECT_TRUE(actual == expected.feature_edges) << actual.size() << " and " << expected.feature_edges.size();
}

TEST(FeatureLines, HoldForCostsOfOpenMeshToo) {
  // Only edges have bits: OpenMesh's own rule sees no feature.
  const IndexedMesh shape = tessellated_cube(6);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  PairDecimaterT<DoubleMesh> decimater(mesh);
  add_module<OpenMesh::Decimater::ModQuadricT<DoubleMesh>>(decimater).unset_max_err();
  mark_edges(mesh, feature_edges(shape, 45));
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, 60);
  for (int v = 0; v < static_cast<int>(shape.positions.size()); ++v) {
    const Vec3& p = shape.positions[static_cast<std::size_t>(v)];
    if (p.cwiseAbs().minCoeff() < 1) continue;
    EXPECT_TRUE(unmoved(mesh, shape, VertexHandle(v))) << p.transpose();
  }
  EXPECT_GT(decimater.result().refusals[Refusal::feature], 0U);
  EXPECT_LT(marked_edges(mesh).size(), 72U);
  for (const auto& [a, b] : marked_edges(mesh)) {
    const Vec3 edge = shape.positions[b] - shape.positions[a];
    EXPECT_EQ((edge.array() == 0).count(), 2) << "along the cube's edges";
  }
}

TEST(FeatureLines, TheToleranceIsANumberFromZeroOn) {
  DoubleMesh mesh;
  PairDecimaterT<DoubleMesh> decimater(mesh);
  EXPECT_EQ(decimater.feature_tolerance(), DecimateOptions().feature_tolerance);
  EXPECT_THROW(decimater.set_feature_tolerance(-1e-9), std::invalid_argument);
  EXPECT_THROW(decimater.set_feature_tolerance(std::nan("")), std::invalid_argument);
  EXPECT_EQ(decimater.feature_tolerance(), DecimateOptions().feature_tolerance);
}

}  // namespace
}  // namespace whittle::test
