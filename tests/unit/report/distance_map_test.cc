#include "whittle/report/distance_map.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "support/brute_distance.hh"
#include "support/random.hh"
#include "support/suites.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::report {
namespace {

using test::NamedMesh;
using test::Random;

IndexedMesh half_of(const IndexedMesh& mesh) {
  return decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 2)).mesh;
}

IndexedMesh largest_mesh() {
  const std::vector<NamedMesh> all = test::closed_meshes();
  return std::ranges::max(all, {}, [](const NamedMesh& named) { return named.mesh.faces.size(); }).mesh;
}

double area_of(const IndexedMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.faces) {
    area += (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm() / 2;
  }
  return area;
}

TEST(DistanceMap, HasTheDistanceAtEachVertex) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    SCOPED_TRACE(name);
    const IndexedMesh other = half_of(mesh);
    if (other.faces.empty()) continue;
    const DistanceMap map = distance_map(mesh, TriangleTree(other));
    ASSERT_EQ(map.signed_distances.size(), map.mesh.positions.size());
    double max = 0;
    for (Index v = 0; v < map.signed_distances.size(); ++v) {
      EXPECT_NEAR(std::abs(map.signed_distances[v]), test::distance_to_all(other, map.mesh.positions[v]), 1e-12);
    }
    for (const Triangle& face : map.mesh.faces) {
      for (const Index v : face) max = std::max(max, std::abs(map.signed_distances[v]));
    }
    EXPECT_EQ(map.max, max);
    EXPECT_LE(map.usual, map.max);
    EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), map.mesh.positions.begin()));
  }
}

TEST(SlowDistanceMap, CutsFacesAndLeavesTheSurface) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    SCOPED_TRACE(name);
    const IndexedMesh other = half_of(mesh);
    if (other.faces.empty()) continue;
    const DistanceMap map = distance_map(other, TriangleTree(mesh), {.tolerance = 0.02, .spacing = 0.1});
    EXPECT_NEAR(area_of(map.mesh), area_of(other), 1e-9 * area_of(other));
    EXPECT_GE(map.mesh.faces.size(), other.faces.size());
  }
}

TEST(SlowDistanceMap, IsNearlyRightInside) {
  for (const auto& [name, mesh] : test::closed_meshes()) {
    SCOPED_TRACE(name);
    const IndexedMesh other = half_of(mesh);
    const DistanceMapOptions options{.tolerance = 0.05, .spacing = 0.05};
    const DistanceMap map = distance_map(other, TriangleTree(mesh), options);
    if (map.max < 1e-9) continue;
    Random random(7);
    int n_beyond = 0;
    constexpr int n = 300;
    for (int i = 0; i < n; ++i) {
      const Triangle& face = map.mesh.faces[random.below(map.mesh.faces.size())];
      double u = random.uniform();
      double v = random.uniform();
      if (u + v > 1) std::tie(u, v) = std::pair(1 - u, 1 - v);
      const auto at = [&](const auto& values) {
        return ((1 - u - v) * values[face[0]] + u * values[face[1]] + v * values[face[2]]);
      };
      const double exact = test::distance_to_all(mesh, Vec3(at(map.mesh.positions)));
      const double size = std::max(map.usual, exact);
      n_beyond += int{std::abs(std::abs(at(map.signed_distances)) - exact) > 2 * options.tolerance * size};
    }
    EXPECT_LE(n_beyond, n / 8);
  }
}

/// The cuts that are written down give the faces that there are.
TEST(DistanceMap, WritesDownItsCuts) {
  const IndexedMesh mesh = largest_mesh();
  const IndexedMesh other = half_of(mesh);
  const DistanceMap map = distance_map(other, TriangleTree(mesh), {.tolerance = 0.01, .spacing = 0.1});
  ASSERT_GT(map.rounds.size(), 1U);
  std::size_t n_open = other.faces.size();
  std::size_t n_done = 0;
  for (const auto& round : map.rounds) {
    ASSERT_EQ(round.size(), n_open);
    n_open = 0;
    for (const std::uint8_t cut : round) {
      const int n_cut = (cut & 1) + (cut >> 1 & 1) + (cut >> 2 & 1);
      n_done += std::size_t{n_cut == 0};
      n_open += n_cut == 0 ? 0U : static_cast<std::size_t>(n_cut) + 1;
    }
  }
  EXPECT_EQ(n_done + n_open, map.mesh.faces.size());
}

TEST(DistanceMap, KeepsToItsNumberOfFaces) {
  const IndexedMesh mesh = largest_mesh();
  const IndexedMesh other = half_of(mesh);
  const TriangleTree tree(mesh);
  const std::size_t most = 3 * other.faces.size();
  const DistanceMap small = distance_map(other, tree, {.tolerance = 1e-3, .spacing = 0.05, .most_faces = most});
  const DistanceMap large = distance_map(other, tree, {.tolerance = 1e-3, .spacing = 0.05});
  EXPECT_LE(small.mesh.faces.size(), most);
  EXPECT_GT(large.mesh.faces.size(), most);
  EXPECT_LT(large.deviation, small.deviation);
}

TEST(DistanceMap, IsTheSameForAnyNumberOfThreads) {
  const IndexedMesh mesh = largest_mesh();
  const TriangleTree tree(half_of(mesh));
  const DistanceMap one = distance_map(mesh, tree, {.threads = 1});
  const DistanceMap three = distance_map(mesh, tree, {.threads = 3});
  EXPECT_EQ(one.signed_distances, three.signed_distances);
  EXPECT_EQ(one.mesh.faces, three.mesh.faces);
}

TEST(DistanceMap, SaysWhichSideTheOtherSurfaceIsOn) {
  IndexedMesh below;
  below.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  below.faces = {{0, 1, 2}};
  IndexedMesh above = below;
  for (Vec3& p : above.positions) p.z() = 0.25;
  EXPECT_EQ(distance_map(below, TriangleTree(above)).signed_distances, std::vector<double>(3, 0.25));
  EXPECT_EQ(distance_map(above, TriangleTree(below)).signed_distances, std::vector<double>(3, -0.25));
}

TEST(DistanceMap, RefusesWhatCantBe) {
  const IndexedMesh mesh = largest_mesh();
  const TriangleTree tree(mesh);
  EXPECT_THROW(distance_map(IndexedMesh{}, tree), std::invalid_argument);
  EXPECT_THROW(distance_map(mesh, tree, {.tolerance = 0}), std::invalid_argument);
  EXPECT_THROW(distance_map(mesh, tree, {.tolerance = 1.5}), std::invalid_argument);
  EXPECT_THROW(distance_map(mesh, tree, {.spacing = 0}), std::invalid_argument);
}

TEST(DistanceHistogram, HasAllOfTheArea) {
  const IndexedMesh mesh = largest_mesh();
  const DistanceMap map = distance_map(mesh, TriangleTree(half_of(mesh)));
  const std::vector<double> shares = distance_histogram(map, map.max, 10);
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
  EXPECT_GT(shares.front(), shares.back());
}

}  // namespace
}  // namespace whittle::report
