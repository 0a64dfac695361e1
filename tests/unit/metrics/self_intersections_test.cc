#include "whittle/metrics/self_intersections.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "oracle/clipping.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"

namespace whittle::metrics {
namespace {

using test::Random;
using Pairs = std::vector<std::array<Index, 2>>;
IndexedMesh random_integer_mesh(std::uint64_t n_vertices, std::uint64_t n_faces, std::uint64_t size, bool flat,
                                std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh;
  for (std::uint64_t v = 0; v < n_vertices; ++v) {
    const auto x = static_cast<double>(random.below(size)), y = static_cast<double>(random.below(size));
    mesh.positions.emplace_back(x, y, flat ? 0.0 : static_cast<double>(random.below(size)));
  }
  for (std::uint64_t f = 0; f < n_faces; ++f) {
    Triangle face{};
    for (Index& v : face) v = static_cast<Index>(random.below(n_vertices));
    mesh.faces.push_back(face);
  }
  return mesh;
}

/// Two faces: (0,0,0), (4,0,0), (0,4,0) and the one given.
Pairs with_base(const Vec3& a, const Vec3& b, const Vec3& c) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a, b, c};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  return self_intersections(mesh);
}

const Pairs none{};
const Pairs one{{0, 1}};

TEST(SelfIntersections, OfFacesApart) {
  EXPECT_EQ(with_base({1, 1, -1}, {1, 1, 1}, {9, 9, 0}), one) << "pierced";
  EXPECT_EQ(with_base({1, 1, 1}, {1, 2, 1}, {9, 9, 2}), none) << "above";
  EXPECT_EQ(with_base({3, 3, -1}, {3, 3, 1}, {9, 9, 0}), none) << "beside";
  EXPECT_EQ(with_base({1, 1, 0}, {1, 1, 1}, {9, 9, 1}), one) << "a corner in the face";
  EXPECT_EQ(with_base({2, 0, 0}, {1, -1, 1}, {3, -1, 1}), one) << "a corner on the side";
  EXPECT_EQ(with_base({1, 0, -1}, {1, 0, 1}, {1, -5, 0}), one) << "side on side";
  EXPECT_EQ(with_base({-1, 2, 0}, {2, -1, 0}, {-5, -5, 0}), one) << "overlapping in one plane";
  EXPECT_EQ(with_base({1, 1, 0}, {2, 1, 0}, {1, 2, 0}), one) << "inside in one plane";
  EXPECT_EQ(with_base({-9, -9, 0}, {29, -9, 0}, {-9, 29, 0}), one) << "around in one plane";
  EXPECT_EQ(with_base({5, 0, 0}, {9, 0, 0}, {5, 4, 0}), none) << "beside in one plane";
  EXPECT_EQ(with_base({4, 1, 0}, {9, 1, 0}, {3, 1.5, 0}), none) << "close by in one plane";
}

TEST(SelfIntersections, OfFacesWithACommonCorner) {
  EXPECT_EQ(with_base({0, 0, 0}, {-1, -1, 0}, {-1, -1, 1}), none);
  EXPECT_EQ(with_base({0, 0, 0}, {1, 0, 1}, {0, 1, 1}), none) << "above";
  EXPECT_EQ(with_base({0, 0, 0}, {1, 1, 1}, {1, 1, -1}), one) << "through the face";
  EXPECT_EQ(with_base({0, 0, 0}, {9, 9, 1}, {9, 9, -1}), one) << "through the opposite side";
  EXPECT_EQ(with_base({0, 0, 0}, {5, 0, 0}, {5, 0, 5}), one) << "along a side";
  EXPECT_EQ(with_base({0, 0, 0}, {-1, 0, 0}, {0, -1, 0}), none) << "opposite in one plane";
  EXPECT_EQ(with_base({0, 0, 0}, {1, 2, 0}, {2, 1, 0}), one) << "inside in one plane";
}

TEST(SelfIntersections, OfFacesWithACommonEdge) {
  EXPECT_EQ(with_base({0, 0, 0}, {4, 0, 0}, {0, -4, 0}), none) << "flat";
  EXPECT_EQ(with_base({0, 0, 0}, {4, 0, 0}, {0, 4, 1e-300}), none) << "hardly open";
  EXPECT_EQ(with_base({0, 0, 0}, {4, 0, 0}, {9, 9, 0}), one) << "folded over";
  EXPECT_EQ(with_base({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), one) << "the same face";
  EXPECT_EQ(with_base({0, 4, 0}, {4, 0, 0}, {0, 0, 0}), one) << "the same face, turned over";
}

TEST(SelfIntersections, KnowCornersByPosition) {
  EXPECT_EQ(with_base({-0.0, 0, -0.0}, {4, 0, 0}, {0, -4, 0}), none) << "minus zero is zero";
  for (const auto& [name, mesh] : test::closed_meshes()) {
    EXPECT_EQ(self_intersections(test::soup(mesh)), self_intersections(mesh)) << name;
  }
}

TEST(SelfIntersections, NamedMeshesHaveNone) {
  // Sheets and solids that don't intersect. Two cubes that meet in a common edge share only that edge.
  for (const auto& [name, mesh] : test::closed_meshes()) {
    if (name.rfind("csaszar", 0) == 0) continue;  // tested below
    EXPECT_EQ(self_intersections(mesh), none) << name;
  }
  for (const auto& [name, mesh] : test::open_meshes()) EXPECT_EQ(self_intersections(mesh), none) << name;
  EXPECT_EQ(self_intersections(test::bow_tie()), none);
  EXPECT_EQ(self_intersections(test::two_cubes_on_an_edge()), none);
  EXPECT_EQ(self_intersections(test::csaszar_torus()), test::intersections_by_clipping(test::csaszar_torus()));
}

TEST(SelfIntersections, LeaveFacesWithoutAreaOut) {
  EXPECT_EQ(with_base({1, 1, -1}, {1, 1, 1}, {1, 1, 5}), none) << "a segment through the face";
  EXPECT_EQ(with_base({1, 1, 0}, {1, 1, 0}, {1, 1, 0}), none) << "a point in the face";
}

TEST(SelfIntersections, CountDuplicatesOnce) {
  EXPECT_EQ(self_intersections(test::with_duplicate_faces(test::sphere(1), 5)).size(), 5U);
}

TEST(SelfIntersections, AgreeWithRationalClipping) {
  std::size_t n_pairs = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const std::uint64_t size = 2 + seed % 6;
    const bool flat = seed % 5 == 0;
    const IndexedMesh mesh = random_integer_mesh(6 + seed % 30, 14, size, flat, seed);
    const Pairs expected = test::intersections_by_clipping(mesh);
    n_pairs += expected.size();
    ASSERT_EQ(self_intersections(mesh), expected) << "seed " << seed << ", size " << size << ", flat " << flat;
  }
  EXPECT_GT(n_pairs, 1000U);
}

TEST(SelfIntersections, DontDependOnUnitPlaceOrOrder) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const IndexedMesh mesh = random_integer_mesh(20, 30, 6, seed % 5 == 0, seed);
    const Pairs expected = self_intersections(mesh);
    EXPECT_EQ(self_intersections(test::scaled(mesh, 0x1p-60)), expected) << "seed " << seed;
    EXPECT_EQ(self_intersections(test::scaled(mesh, 0x1p60)), expected) << "seed " << seed;
    EXPECT_EQ(self_intersections(test::scaled(mesh, 1000.0)), expected) << "seed " << seed;
    EXPECT_EQ(self_intersections(test::moved(mesh, Vec3(0x1p40, -0x1p45, 0x1p30))), expected) << "seed " << seed;
    IndexedMesh sheared = mesh;  // exact; afterwards no plane is parallel to the axes
    for (Vec3& p : sheared.positions) p = Vec3(p.x() + 3.0 * p.y(), p.y() - 2.0 * p.z(), p.z() + 5.0 * p.x());
    EXPECT_EQ(self_intersections(sheared), expected) << "seed " << seed;

    const test::Permuted permuted = test::permuted(mesh, seed);
    Pairs back;
    for (const auto& [f, g] : self_intersections(permuted.mesh)) {
      const auto [low, high] = std::minmax(permuted.old_face[f], permuted.old_face[g]);
      back.push_back({low, high});
    }
    std::sort(back.begin(), back.end());
    EXPECT_EQ(back, expected) << "seed " << seed;
  }
}

TEST(SelfIntersections, AreTheSameForAnyNumberOfThreads) {
  const IndexedMesh sphere = test::sphere(4);
  const IndexedMesh mesh = test::joined(sphere, test::moved(sphere, Vec3(0.7, 0.2, 0.1)));
  const Pairs expected = self_intersections(mesh, 1);
  EXPECT_GT(expected.size(), 50U);
  EXPECT_TRUE(std::is_sorted(expected.begin(), expected.end()));
  for (const unsigned threads : {2U, 3U, 8U, 0U}) EXPECT_EQ(self_intersections(mesh, threads), expected) << threads;
}

TEST(SelfIntersections, DontDependOnVerticesOfNoFace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double scale : {1.0, 0x1p-900, 0x1p400}) {
    const IndexedMesh sphere = test::scaled(test::sphere(2), scale);
    const IndexedMesh mesh = test::joined(sphere, test::moved(sphere, Vec3(0.7, 0.2, 0.1) * scale));
    const Pairs expected = self_intersections(mesh);
    EXPECT_FALSE(expected.empty()) << scale;
    for (const double far : {nan, -nan, 1e308, -1e308, HUGE_VAL}) {
      IndexedMesh with = mesh;
      with.positions.emplace_back(far, far, 0);
      EXPECT_EQ(self_intersections(with), expected) << far << " at " << scale;
    }
  }
}

TEST(SelfIntersections, RejectWhatIsNoSurface) {
  EXPECT_THROW(self_intersections(IndexedMesh{}), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
