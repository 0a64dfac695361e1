#include "whittle/metrics/crossing_walls.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/metrics/self_intersections.hh"

namespace whittle::metrics {
namespace {

using test::Random;
using Pairs = std::vector<std::array<Index, 2>>;

/// Whether a vertex of the face became a corner of the other one.
bool became(const Triangle& before, const Triangle& after, const std::vector<Index>& map) {
  return std::any_of(before.begin(), before.end(), [&](Index v) {
    return map[v] != invalid_index && std::find(after.begin(), after.end(), map[v]) != after.end();
  });
}

/// By the definition, from the lists of all intersections. \param n_old counts the pairs that aren't new
Pairs new_crossings(const IndexedMesh& before, const IndexedMesh& after, const std::vector<Index>& map,
                    std::size_t& n_old) {
  const Parts parts = find_parts(after.positions.size(), after.faces);
  const Pairs earlier = self_intersections(before);
  Pairs expected;
  for (const auto& [f, g] : self_intersections(after)) {
    const Triangle& face = after.faces[f];
    const Triangle& other = after.faces[g];
    const auto is_corner_of_other = [&](Index v) {
      return std::any_of(other.begin(), other.end(), [&](Index w) { return after.positions[v] == after.positions[w]; });
    };
    if (parts.part_of[face[0]] != parts.part_of[other[0]]) continue;
    if (std::any_of(face.begin(), face.end(), is_corner_of_other)) continue;
    const bool is_old = std::any_of(earlier.begin(), earlier.end(), [&](const auto& pair) {
      const Triangle& a = before.faces[pair[0]];
      const Triangle& b = before.faces[pair[1]];
      return (became(a, face, map) && became(b, other, map)) || (became(b, face, map) && became(a, other, map));
    });
    n_old += std::size_t{is_old};
    if (!is_old) expected.push_back({f, g});
  }
  return expected;
}

TEST(CrossingWalls, AreThePairsOfFacesThatAreNew) {
  std::size_t n_new = 0;
  std::size_t n_old = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    IndexedMesh before = test::joined(test::noisy_sphere(2, 0.5, seed), test::noisy_torus(16, 10, 1, 0.3, 0.2, seed));
    Random random(seed);
    for (Vec3& p : before.positions) p += random.uniform_vector(-0.15, 0.15);
    IndexedMesh after = before;
    for (Vec3& p : after.positions) p += random.uniform_vector(-0.15, 0.15);
    // The vertices afterwards in another order, and some of those before are gone.
    std::vector<Index> map(before.positions.size());
    std::iota(map.rbegin(), map.rend(), Index{0});
    std::reverse(after.positions.begin(), after.positions.end());
    for (Triangle& face : after.faces) {
      for (Index& v : face) v = map[v];
    }
    for (std::size_t v = 0; v < map.size(); v += 7) map[v] = invalid_index;
    const Pairs expected = new_crossings(before, after, map, n_old);
    n_new += expected.size();
    for (const unsigned threads : {1U, 3U}) {
      EXPECT_EQ(newly_crossing_faces(before, after, map, threads), expected) << seed;
    }
  }
  EXPECT_GT(n_new, 100U);
  EXPECT_GT(n_old, 100U);
}

TEST(CrossingWalls, AreFoundInWhatIsSimplifiedTooFar) {
  const IndexedMesh wall = test::thin_wall(60);
  const auto crossings_at = [&](std::size_t n_faces) {
    const Decimation result = decimate(wall, DecimateTarget::faces(n_faces));
    return newly_crossing_faces(wall, result.mesh, result.vertex_map).size();
  };
  EXPECT_EQ(crossings_at(wall.faces.size()), 0U);
  EXPECT_GT(crossings_at(wall.faces.size() / 30), 10U);
}

TEST(CrossingWalls, AreNotThereInOnePlane) {
  const IndexedMesh mesh = test::grid(40, 40);
  std::vector<Index> same(mesh.positions.size());
  std::iota(same.begin(), same.end(), Index{0});
  EXPECT_TRUE(newly_crossing_faces(mesh, mesh, same).empty());
}

TEST(CrossingWalls, RefuseAMapThatDoesNotFit) {
  const IndexedMesh mesh = test::sphere(1);
  EXPECT_THROW(newly_crossing_faces(mesh, mesh, std::vector<Index>(3)), std::invalid_argument);
  EXPECT_THROW(newly_crossing_faces(mesh, mesh, std::vector<Index>(mesh.positions.size(), 1000)),
               std::invalid_argument);
  EXPECT_THROW(newly_crossing_faces({}, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
