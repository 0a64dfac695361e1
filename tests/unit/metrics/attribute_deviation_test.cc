// Closed forms on squares, and an oracle that looks at all faces for each sample.
#include "whittle/metrics/attribute_deviation.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sampling/surface_sampler.hh"
#include "support/brute_distance.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/wedges.hh"

namespace whittle::metrics {
namespace {

const DistanceOptions few_samples{.samples = 5'000, .seed = 3};

/// [0, 1]² at height z, with an attribute. \param values of the corners (0, 0), (1, 0), (1, 1), (0, 1)
IndexedMesh square_with(AttributeKind kind, std::size_t n_components, std::vector<double> values, double z = 0) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  mesh.attributes = {{.name = "a", .kind = kind, .n_components = n_components, .values = std::move(values)}};
  return mesh;
}

/// The same value at all corners.
IndexedMesh square_of(AttributeKind kind, const std::vector<double>& value, double z = 0) {
  std::vector<double> values;
  for (int corner = 0; corner < 4; ++corner) values.insert(values.end(), value.begin(), value.end());
  return square_with(kind, value.size(), values, z);
}

/// Of the one attribute.
AttributeDeviation only_deviation(const IndexedMesh& a, const IndexedMesh& b) {
  const std::vector<AttributeDeviation> all = attribute_deviations(a, b, few_samples);
  EXPECT_EQ(all.size(), 1U);
  return all.empty() ? AttributeDeviation{} : all.front();
}

void expect_constant(AttributeKind kind, const std::vector<double>& a, const std::vector<double>& b, double expected) {
  const AttributeDeviation d = only_deviation(square_of(kind, a), square_of(kind, b, 0.01));
  EXPECT_EQ(d.kind, kind);
  for (const double number : {d.mean, d.max, d.forward.mean, d.forward.max, d.backward.mean, d.backward.max}) {
    EXPECT_NEAR(number, expected, 1e-12);
  }
}

TEST(AttributeDeviation, MeasuresEachKindInItsUnit) {
  expect_constant(AttributeKind::texcoord, {0.1, 0.2}, {0.4, 0.6}, 0.5);
  expect_constant(AttributeKind::normal, {0, 0, 1}, {0, 0.5, std::sqrt(0.75)}, 30);
  expect_constant(AttributeKind::tangent, {1, 0, 0, 1}, {0, -2, 0, 1}, 90);
  expect_constant(AttributeKind::color, {0, 0, 0, 1}, {1, 1, 1, 0}, 2);
  expect_constant(AttributeKind::displacement, {1, 2, 3}, {1, 2, 5}, 2);
  expect_constant(AttributeKind::direction, {0, 0, 0}, {3, 0, 4}, 5);
  expect_constant(AttributeKind::scalar, {-1}, {6}, 7);
  expect_constant(AttributeKind::category, {3, 1}, {3, 1}, 0);
  expect_constant(AttributeKind::category, {3, 1}, {3, 2}, 1);
  // Joint 5 has 0.75 and 0.25, joint 2 has 0.25 and nothing, joint 9 nothing and 0.75; unused joints don't count.
  expect_constant(AttributeKind::joint_weights, {5, 2, 0.75, 0.25}, {9, 5, 0, 0, 0.75, 0.25, 0, 0}, 0.75);
  expect_constant(AttributeKind::joint_weights, {0, 0, 1, 0}, {0, 7, 1, 0}, 0);
}

TEST(AttributeDeviation, InterpolatesBetweenCorners) {
  const IndexedMesh slope = square_with(AttributeKind::scalar, 1, {0, 1, 1, 0});
  const AttributeDeviation d = only_deviation(slope, square_of(AttributeKind::scalar, {0}));
  EXPECT_NEAR(d.mean, 0.5, 0.01);
  EXPECT_NEAR(d.max, 1, 0.01);
  // Three joints meet in a face; each sample has all of them in the other mesh, too.
  const IndexedMesh skinned = square_with(AttributeKind::joint_weights, 2, {1, 1, 2, 1, 3, 1, 2, 1});
  EXPECT_NEAR(only_deviation(skinned, test::moved(skinned, Vec3(0, 0, 0.01))).max, 0, 1e-12);
}

TEST(AttributeDeviation, TellsTheShareOfTheAreaOfAnotherCategory) {
  IndexedMesh mesh = square_with(AttributeKind::category, 1, {1, 1, 1, 2});
  mesh.positions[3] = {-2, 1, 0};
  const AttributeDeviation d = only_deviation(mesh, [&] {
    IndexedMesh other = mesh;
    other.attributes[0].values = {1, 1, 1, 1};
    return other;
  }());
  // In the second face, which has 3/4 of the area, the corner outweighs both others in a quarter.
  EXPECT_NEAR(d.mean, 0.1875, 0.02);
  EXPECT_EQ(d.max, 1);
}

TEST(AttributeDeviation, IsZeroBetweenAMeshAndItself) {
  for (const IndexedMesh& mesh : {test::charted_cube(3), test::textured_torus(12, 8)}) {
    for (const AttributeDeviation& d : attribute_deviations(mesh, mesh, few_samples)) {
      EXPECT_EQ(d.mean, 0) << d.name;
      EXPECT_EQ(d.max, 0) << d.name;
    }
  }
}

TEST(AttributeDeviation, ComparesTheRightSideOfASeam) {
  IndexedMesh fine = test::charted_cube(6), coarse = test::charted_cube(2);
  join_equal_wedges(fine);
  join_equal_wedges(coarse);
  const std::vector<AttributeDeviation> exact = attribute_deviations(fine, coarse, few_samples);
  ASSERT_EQ(exact.size(), 2U) << "normals and texture coordinates";
  EXPECT_EQ(exact[0].name, "NORMAL");
  for (const AttributeDeviation& d : exact) EXPECT_LT(d.max, 1e-5) << d.name;
  // A point near an edge of the larger cube is nearest to an edge of the smaller one, and that has both charts.
  const IndexedMesh larger = test::scaled(fine, 1.0005);
  for (const AttributeDeviation& d : attribute_deviations(larger, coarse, few_samples)) {
    EXPECT_LT(d.max, 1e-3) << d.name;
  }
}

/// A square in two charts; the seam is at x.
IndexedMesh two_charts(double x) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {x, 0, 0}, {1, 0, 0}, {1, 1, 0}, {x, 1, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
  mesh.wedges = {0, 1, 4, 0, 4, 5, 6, 2, 3, 6, 3, 7};
  mesh.attributes = {{.name = "uv", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}}};
  for (const auto& [u, v] : std::vector<std::pair<double, double>>{
           {0, 0}, {x, 0}, {11, 0}, {11, 1}, {x, 1}, {0, 1}, {10 + x, 0}, {10 + x, 1}}) {
    mesh.attributes[0].values.insert(mesh.attributes[0].values.end(), {u, v});
  }
  return mesh;
}

TEST(AttributeDeviation, ForgivesASeamThatSlipsALittle) {
  EXPECT_LT(only_deviation(two_charts(0.5), two_charts(0.501)).max, 1.1e-3);
  const AttributeDeviation far = only_deviation(two_charts(0.5), two_charts(0.6));
  EXPECT_NEAR(far.max, 10, 1e-9);
  EXPECT_NEAR(far.mean, 1, 0.05) << "a tenth of the area has the other chart";
}

TEST(AttributeDeviation, TakesTheRightSideOfAThinWall) {
  const auto wall = [](double thickness) {
    IndexedMesh mesh = square_of(AttributeKind::color, {1, 0, 0, 1}, thickness);
    const IndexedMesh back = test::inside_out(square_of(AttributeKind::color, {0, 0, 1, 1}));
    mesh.positions.insert(mesh.positions.end(), back.positions.begin(), back.positions.end());
    for (const auto& [a, b, c] : back.faces) mesh.faces.push_back({a + 4, b + 4, c + 4});
    auto& values = mesh.attributes[0].values;
    values.insert(values.end(), back.attributes[0].values.begin(), back.attributes[0].values.end());
    return mesh;
  };
  EXPECT_EQ(only_deviation(wall(0.0005), test::moved(wall(0.0005), Vec3(0, 0, 0.0004))).max, 0);
}

TEST(AttributeDeviation, ComparesWhatBothMeshesHave) {
  IndexedMesh a = square_of(AttributeKind::scalar, {1}), b = a;
  a.attributes.push_back({.name = "only here", .kind = AttributeKind::scalar, .values = {1, 2, 3, 4}});
  a.attributes.push_back(
      {.name = "uv", .kind = AttributeKind::texcoord, .n_components = 2, .values = std::vector<double>(8)});
  b.attributes.push_back(
      {.name = "uv", .kind = AttributeKind::scalar, .n_components = 2, .values = std::vector<double>(8)});
  a.colors.assign(4, {1, 1, 1, 1});
  a.normals = b.normals = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const std::vector<AttributeDeviation> all = attribute_deviations(a, b, few_samples);
  ASSERT_EQ(all.size(), 1U) << "names and kinds agree in one alone, and the normals are undefined";
  EXPECT_EQ(all[0].name, "a");
  EXPECT_TRUE(attribute_deviations(test::sphere(1), test::sphere(1), few_samples).empty());
}

TEST(AttributeDeviation, RefusesWhatTheDistanceRefuses) {
  const IndexedMesh mesh = square_of(AttributeKind::scalar, {1});
  EXPECT_THROW(attribute_deviations(mesh, mesh, {.samples = 0}), std::invalid_argument);
  EXPECT_THROW(attribute_deviations(mesh, IndexedMesh{}, few_samples), std::invalid_argument);
}

std::vector<double> numbers_of(const std::vector<AttributeDeviation>& all) {
  std::vector<double> numbers;
  for (const AttributeDeviation& d : all) {
    numbers.insert(numbers.end(), {d.mean, d.max, d.forward.mean, d.forward.max, d.backward.mean, d.backward.max});
  }
  return numbers;
}

TEST(AttributeDeviation, HasTheSameBytesForAnyNumberOfThreads) {
  const IndexedMesh a = test::textured_torus(24, 12), b = test::textured_torus(9, 7);
  const auto measured = [&](unsigned threads) {
    return numbers_of(attribute_deviations(a, b, {.samples = 20'000, .seed = 2, .threads = threads}));
  };
  const std::vector<double> expected = measured(1);
  EXPECT_GT(expected.at(0), 0);
  for (const unsigned threads : {2U, 3U, 0U}) EXPECT_EQ(measured(threads), expected) << threads;
}

TEST(AttributeDeviation, DependsOnNeitherSizeNorPlace) {
  const IndexedMesh a = test::textured_torus(24, 12), b = test::textured_torus(9, 7);
  const std::vector<double> expected = numbers_of(attribute_deviations(a, b, few_samples));
  for (const double scale : {1e-3, 1e3, 1e-80, 1e90}) {
    const std::vector<double> found =
        numbers_of(attribute_deviations(test::scaled(a, scale), test::scaled(b, scale), few_samples));
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6) << scale;
  }
}

// The oracle ----------------------------------------------------------------------------------------------------------

/// The value at the point of a face that is nearest to p, by the areas of the three triangles around it.
std::vector<double> value_near(const IndexedMesh& mesh, Index face, const Vec3& p) {
  const auto& [a, b, c] = test::corners_of(mesh, face);
  IndexedMesh triangle;
  triangle.positions = {a, b, c};
  triangle.faces = {{0, 1, 2}};
  const Vec3 nearest = TriangleTree::nearest_without_tree(triangle, p).point;
  const auto area = [&](const Vec3& u, const Vec3& v) { return (u - nearest).cross(v - nearest).norm(); };
  const std::array<double, 3> weights{area(b, c), area(c, a), area(a, b)};
  const double sum = weights[0] + weights[1] + weights[2];
  const Attribute& attribute = mesh.attributes.front();
  std::vector<double> value(attribute.n_components);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < value.size(); ++i)
      value[i] += weights[k] / sum * attribute.value(mesh.wedge(face, k))[i];
  }
  return value;
}

/// Whether two faces have a corner at the same vertex with the same value.
bool are_joined(const IndexedMesh& mesh, Index f, Index g) {
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = mesh.attributes[0].value(mesh.wedge(f, j)), b = mesh.attributes[0].value(mesh.wedge(g, k));
      if (mesh.faces[f][j] == mesh.faces[g][k] && std::equal(a.begin(), a.end(), b.begin())) return true;
    }
  }
  return false;
}

double oracle_deviation(const IndexedMesh& mesh, const Vec3& p, const std::vector<double>& here, double tolerance) {
  std::vector<std::pair<double, Index>> near;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    near.emplace_back(test::distance_to_triangle(test::corners_of(mesh, f), p), f);
  std::sort(near.begin(), near.end());
  const double limit = std::hypot(near.front().first, tolerance);
  std::erase_if(near, [&](const auto& face) { return face.first > limit; });
  std::set<Index> seen;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [distance, face] : near) {
    if (!seen.insert(face).second) continue;
    const std::vector<double> there = value_near(mesh, face, p);
    least = std::min(least, std::hypot(here[0] - there[0], here[1] - there[1]));
    std::vector<Index> waiting{face};
    while (!waiting.empty()) {
      const Index f = waiting.back();
      waiting.pop_back();
      for (const auto& [other_distance, g] : near) {
        if (are_joined(mesh, f, g) && seen.insert(g).second) waiting.push_back(g);
      }
    }
  }
  return least;
}

TEST(AttributeDeviation, AgreesWithALookAtAllFaces) {
  constexpr std::size_t n_samples = 300;
  IndexedMesh cube = test::charted_cube(4), other = test::scaled(test::charted_cube(3), 1.001);
  join_equal_wedges(cube);
  join_equal_wedges(other);
  test::Random random(5);
  for (double& x : other.attributes[0].values) x += random.uniform(-0.01, 0.01);
  for (const auto& pair :
       {std::pair(cube, other), std::pair(test::textured_torus(14, 9), test::textured_torus(9, 8))}) {
    const IndexedMesh& a = pair.first;
    const IndexedMesh& b = pair.second;
    const double tolerance = 1e-3 * std::max(diagonal_of(bounds_of(a)), diagonal_of(bounds_of(b)));
    const SurfaceSampler sampler(a, Vec3::Zero(), n_samples, CounterRandom(3, 0));
    double sum = 0, max = 0;
    sampler.for_each(0, n_samples, [&](std::size_t face, const Vec3& p) {
      const double d = oracle_deviation(b, p, value_near(a, static_cast<Index>(face), p), tolerance);
      sum += d;
      max = std::max(max, d);
    });
    const auto all = attribute_deviations(a, b, {.samples = n_samples, .seed = 3});
    EXPECT_NEAR(all.back().forward.mean, sum / n_samples, 1e-9);
    EXPECT_NEAR(all.back().forward.max, max, 1e-9);
  }
}

}  // namespace
}  // namespace whittle::metrics
