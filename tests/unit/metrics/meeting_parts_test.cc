#include "whittle/metrics/meeting_parts.hh"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/parts.hh"
#include "whittle/metrics/self_intersections.hh"

namespace whittle::metrics {
namespace {

using test::Random;
using Pairs = std::vector<std::array<Index, 2>>;

std::vector<Index> identity(const IndexedMesh& mesh) {
  std::vector<Index> map(mesh.positions.size());
  std::iota(map.begin(), map.end(), Index{0});
  return map;
}

/// Blobs at random places; many overlap.
IndexedMesh scattered_blobs(int count, double extent, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh all;
  for (int i = 0; i < count; ++i) {
    IndexedMesh one = test::blob(1, seed + static_cast<std::uint64_t>(i));
    const Vec3 shift = random.uniform_vector(0, extent);
    for (Vec3& p : one.positions) p = 0.5 * p + shift;
    all = all.positions.empty() ? one : test::joined(all, one);
  }
  return all;
}

/// From the list of all intersections.
std::set<std::array<Index, 2>> meeting_by_brute_force(const IndexedMesh& mesh) {
  const Parts parts = find_parts(mesh.positions.size(), mesh.faces);
  std::set<std::array<Index, 2>> pairs;
  for (const auto& [f, g] : self_intersections(mesh)) {
    const Index p = parts.part_of[mesh.faces[f][0]];
    const Index q = parts.part_of[mesh.faces[g][0]];
    if (p != q) pairs.insert({std::min(p, q), std::max(p, q)});
  }
  return pairs;
}

TEST(MeetingParts, AreThoseOfTheIntersectionsThatAreNew) {
  std::size_t n_new = 0;
  std::size_t n_old = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const IndexedMesh before = scattered_blobs(24, 3.5, seed);
    IndexedMesh after = before;
    Random random(seed);
    for (Vec3& p : after.positions) p += random.uniform_vector(-0.15, 0.15);
    const auto earlier = meeting_by_brute_force(before);
    Pairs expected;
    for (const auto& pair : meeting_by_brute_force(after)) {
      earlier.contains(pair) ? ++n_old : ++n_new;
      if (!earlier.contains(pair)) expected.push_back(pair);
    }
    for (const unsigned threads : {1U, 3U}) {
      EXPECT_EQ(newly_meeting_parts(before, after, identity(before), threads), expected) << seed;
    }
  }
  EXPECT_GT(n_new, 3U);
  EXPECT_GT(n_old, 50U);
}

TEST(MeetingParts, AreComparedThoughThereAreThousands) {
  const IndexedMesh before = test::boxes(50, 50);
  IndexedMesh after = before;
  const Vec3 shift(0.3, 0, 0);
  for (std::size_t v = 0; v < 8; ++v) after.positions[v] += shift;  // the first cube moves into the second
  EXPECT_EQ(newly_meeting_parts(before, after, identity(before)).size(), 1U);
  EXPECT_TRUE(newly_meeting_parts(after, after, identity(after)).empty());
}

TEST(MeetingParts, FollowTheVertexMap) {
  // Before, both spheres intersect; the result has them in the other order, and without the third.
  IndexedMesh before = test::spheres(3, 1, -0.5);
  const IndexedMesh one = test::sphere(1);
  const std::size_t n = one.positions.size();
  IndexedMesh after = test::spheres(2, 1, -0.5);
  std::vector<Index> map(before.positions.size(), invalid_index);
  for (std::size_t v = 0; v < n; ++v) {
    map[v] = static_cast<Index>(n + v);
    map[n + v] = static_cast<Index>(v);
  }
  EXPECT_TRUE(newly_meeting_parts(before, after, map).empty());
  std::fill(map.begin(), map.begin() + static_cast<std::ptrdiff_t>(n), invalid_index);
  EXPECT_EQ(newly_meeting_parts(before, after, map), (Pairs{{0, 1}}));
}

TEST(MeetingParts, RefuseAMapThatDoesNotFit) {
  const IndexedMesh mesh = test::spheres(2, 0);
  EXPECT_THROW(newly_meeting_parts(mesh, mesh, std::vector<Index>(3)), std::invalid_argument);
  EXPECT_THROW(newly_meeting_parts(mesh, mesh, std::vector<Index>(mesh.positions.size(), 1000)), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
