// Proofs with a tolerance at each vertex, compared with points of both surfaces and all faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/brute_distance.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::test {

using namespace metrics;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Case {
  IndexedMesh first;
  IndexedMesh second;
  std::vector<double> tolerances;
  double max_distance;

  double limit(Index face) const {
    double least = max_distance;
    for (const Index v : first.faces[face]) least = std::min(least, tolerances[v]);
    return least;
  }
  /// How much farther a point of the first surface is than its face allows.
  double excess_of_first(Index face, const Vec3& point) const { return distance_to_all(second, point) - limit(face); }
  /// How much farther a point is from each face of the first surface than that allows, at least.
  double excess_of_second(const Vec3& point) const {
    double least = infinite;
    for (Index f = 0; f < first.faces.size(); ++f) {
      least = std::min(least, distance_to_triangle(corners_of(first, f), point) - limit(f));
    }
    return least;
  }
};

Vec3 random_point(const Corners& corners, Random& random) {
  double second = random.uniform();
  double third = random.uniform();
  if (second + third > 1) second = 1 - second, third = 1 - third;
  return corners[0] + second * (corners[1] - corners[0]) + third * (corners[2] - corners[0]);
}

double largest_excess(const Case& c, Random& random) {
  double most = -infinite;
  for (int i = 0; i < 40; ++i) {
    for (Index f = 0; f < c.first.faces.size(); ++f) {
      most = std::max(most, c.excess_of_first(f, random_point(corners_of(c.first, f), random)));
    }
    for (Index f = 0; f < c.second.faces.size(); ++f) {
      most = std::max(most, c.excess_of_second(random_point(corners_of(c.second, f), random)));
    }
  }
  return most;
}

TEST(Tolerances, AreKeptWhereThatIsProven) {
  Random random(7);
  int n_proven = 0;
  int n_refuted = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    Case c;
    c.first = random_faces(1 + random.below(6), random);
    c.second = c.first;
    for (Vec3& p : c.second.positions) p += random.uniform(0, 0.2) * random.uniform_vector(-1, 1);
    for (std::size_t v = 0; v < c.first.positions.size(); ++v) c.tolerances.push_back(random.uniform(0.02, 0.5));
    c.max_distance = random.uniform(0.1, 0.6);
    const Certification found = certify(c.first, c.second, c.max_distance, {.threads = 1, .tolerances = c.tolerances});
    if (found.verdict == Verdict::proven) {
      ++n_proven;
      EXPECT_LE(largest_excess(c, random), 1e-12);
    } else if (found.verdict == Verdict::refuted) {
      ++n_refuted;
      const FarPoint& far = *found.farther;
      EXPECT_GT(far.is_on_first ? c.excess_of_first(far.face, far.point) : c.excess_of_second(far.point), -1e-12);
    }
  }
  EXPECT_GT(n_proven, 300);
  EXPECT_GT(n_refuted, 300);
  EXPECT_GE(n_proven + n_refuted, 2995);
}

TEST(Tolerances, AreOneDistanceIfAllAreEqual) {
  const IndexedMesh mesh = noisy_torus(24, 12, 1, 0.4, 0.02, 1);
  const IndexedMesh other = noisy_torus(24, 12, 1, 0.4, 0.02, 2);
  const LargestDistances largest = largest_distances(mesh, other, 1e-4);
  const double most = std::max(largest.forward.at_most, largest.backward.at_most);
  for (const double share : {0.9, 0.99, 1.01, 1.1}) {
    const std::vector<double> tolerances(mesh.positions.size(), share * most);
    EXPECT_EQ(certify(mesh, other, 10, {.tolerances = tolerances}).verdict, certify(mesh, other, share * most).verdict);
  }
}

/// Half of a plane is raised: by as much as is allowed there, or a little more.
TEST(Tolerances, HoldWhereTheyAre) {
  const IndexedMesh low = grid(8, 8);
  IndexedMesh high = low;
  std::vector<double> tolerances;
  for (Vec3& p : high.positions) {
    const double tolerance = p.x() < low.positions[0].x() + 1e-9 ? 0.001 : 0.1;
    p.z() += 0.9 * tolerance;
    tolerances.push_back(tolerance);
  }
  EXPECT_EQ(certify(low, high, 1, {.tolerances = tolerances}).verdict, Verdict::refuted)
      << "at faces with a tight corner the result rises to the loose one";
  for (Index v = 0; v < high.positions.size(); ++v) high.positions[v].z() = low.positions[v].z() + 0.0009;
  EXPECT_EQ(certify(low, high, 1, {.tolerances = tolerances}).verdict, Verdict::proven);
  EXPECT_EQ(certify(low, high, 0.0008, {.tolerances = tolerances}).verdict, Verdict::refuted);
}

TEST(Tolerances, AreRefusedWhereTheyDoNotFit) {
  const IndexedMesh mesh = cube();
  std::vector<double> tolerances(mesh.positions.size(), 1);
  EXPECT_EQ(certify(mesh, mesh, 1, {.tolerances = tolerances}).verdict, Verdict::proven);
  EXPECT_THROW(certify(mesh, mesh, infinite, {.tolerances = tolerances}), std::invalid_argument);
  tolerances[3] = infinite;
  EXPECT_EQ(certify(mesh, mesh, 1, {.tolerances = tolerances}).verdict, Verdict::proven);
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    tolerances[3] = wrong;
    EXPECT_THROW(certify(mesh, mesh, 1, {.tolerances = tolerances}), std::invalid_argument);
  }
  tolerances = {1, 1};
  EXPECT_THROW(certify(mesh, mesh, 1, {.tolerances = tolerances}), std::invalid_argument);
  tolerances.assign(mesh.positions.size(), 1);
  EXPECT_THROW(certify_borders(mesh, mesh, 1, {.tolerances = tolerances}), std::invalid_argument);
}

/// By offsets, as by looking at each face.
TEST(Tolerances, CountInTheSearchOfFaces) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const IndexedMesh mesh = random_faces(1 + random.below(60), random);
    std::vector<double> offsets;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) offsets.push_back(random.uniform(0, 0.5));
    TriangleTree tree(mesh, Vec3::Zero());
    tree.set_offsets(offsets);
    for (int k = 0; k < 20; ++k) {
      const Vec3 point = random.uniform_vector(-1.5, 1.5);
      double expected = infinite;
      for (Index f = 0; f < mesh.faces.size(); ++f) {
        expected = std::min(expected, distance_to_triangle(corners_of(mesh, f), point) + offsets[f]);
      }
      const Index hint = k % 2 == 0 ? invalid_index : static_cast<Index>(random.below(mesh.faces.size()));
      const auto [face, distance] = tree.nearest_by_offsets(point, hint);
      EXPECT_NEAR(distance, expected, 1e-12);
      EXPECT_NEAR(distance_to_triangle(corners_of(mesh, face), point) + offsets[face], distance, 1e-12);
    }
  }
}

}  // namespace
}  // namespace whittle::test
