#include "whittle/core/two_sided.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"

namespace whittle::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Lt;
using testing::SizeIs;

constexpr Index none = invalid_index;

IndexedMesh on_four_vertices(std::vector<Triangle> faces) {
  IndexedMesh mesh;
  mesh.positions.resize(4, Vec3::Zero());
  mesh.faces = std::move(faces);
  return mesh;
}

TEST(TwoSided, BacksAreTheLaterFacesOnTheSameVertices) {
  EXPECT_THAT(fronts_of_backs(on_four_vertices({{0, 1, 2}, {2, 1, 0}, {0, 2, 3}, {3, 2, 0}})),
              ElementsAre(none, 0, none, 2));
  const IndexedMesh sheet = with_backs(grid(3, 2));
  const std::vector<Index> fronts = fronts_of_backs(sheet);
  ASSERT_EQ(fronts.size(), 24U);
  for (Index f = 0; f < 12; ++f) {
    EXPECT_EQ(fronts[f], none);
    EXPECT_EQ(fronts[12 + f], f);
  }
}

TEST(TwoSided, AClosedSurfaceMayHaveTwoSides) { EXPECT_EQ(fronts_of_backs(with_backs(octahedron())).back(), 7U); }

TEST(TwoSided, ASheetMayEndAtFacesOfOneSide) {
  EXPECT_THAT(fronts_of_backs(with_backs(grid(3, 1), 2)), ElementsAre(none, none, none, none, none, none, 0, 1));
}

TEST(TwoSided, FacesOfOneOrientationAreNoPair) {
  EXPECT_THAT(fronts_of_backs(with_duplicate_faces(grid(2, 2), 8)), IsEmpty());
}

/// Of the first square one pair is left, which is no sheet by itself.
TEST(TwoSided, OfThreeFacesOnTheSameVerticesNoTwoAreAPair) {
  IndexedMesh mesh = with_backs(grid(2, 1));
  mesh.faces.push_back(mesh.faces[0]);
  EXPECT_THAT(fronts_of_backs(mesh), ElementsAre(none, none, none, none, none, none, 2, 3, none));
}

TEST(TwoSided, APocketOfTwoFacesIsNoSheet) {
  EXPECT_THAT(fronts_of_backs(pillow()), IsEmpty());
  EXPECT_THAT(fronts_of_backs(two_sided_leaf(6)), IsEmpty());
}

TEST(TwoSided, FacesWithTwoEqualCornersHaveNoBack) {
  EXPECT_THAT(fronts_of_backs(on_four_vertices({{0, 0, 1}, {1, 0, 0}, {2, 2, 3}, {3, 2, 2}})), IsEmpty());
}

TEST(TwoSided, AWallBetweenTwoBodiesIsNoSheet) {
  IndexedMesh cubes = joined(tessellated_cube(3), tessellated_cube(3));
  for (std::size_t v = cubes.positions.size() / 2; v < cubes.positions.size(); ++v) cubes.positions[v].x() += 2;
  const IndexedMesh touching = glued(cubes);
  ASSERT_LT(touching.positions.size(), cubes.positions.size());
  EXPECT_THAT(fronts_of_backs(touching), IsEmpty());
}

TEST(FacesThatMayCoincide, AreAllThatDoOnAnyNumberOfThreads) {
  std::mt19937 random(5);
  for (const Index n_vertices : {3U, 5U, 40U, 3000U}) {
    std::uniform_int_distribution<Index> any(0, n_vertices - 1);
    std::vector<Triangle> faces;
    for (int f = 0; f < 20'000; ++f) {
      const Index a = any(random);
      const Index b = any(random);
      const Index c = any(random);
      faces.push_back({a, b, c});
    }
    std::map<Triangle, int> n_faces;  // by corners in ascending order
    const auto sorted = [](Triangle face) {
      std::sort(face.begin(), face.end());
      return face;
    };
    for (const Triangle& face : faces) ++n_faces[sorted(face)];
    const std::vector<Index> found = faces_that_may_coincide(faces, n_vertices, 1);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (Index f = 0; f < faces.size(); ++f) {
      const bool is_found = std::binary_search(found.begin(), found.end(), f);
      if (!has_three_corners(faces[f])) {
        EXPECT_FALSE(is_found);
      } else if (n_faces[sorted(faces[f])] > 1) {
        EXPECT_TRUE(is_found);
      }
    }
    EXPECT_EQ(faces_that_may_coincide(faces, n_vertices, 3), found);
  }
  EXPECT_THAT(faces_that_may_coincide(grid(100, 100).faces, 101 * 101), SizeIs(Lt(2000U)));
  EXPECT_THAT(faces_that_may_coincide(std::vector<Triangle>{{7, 8, 9}, {7, 8, 9}}, 3), IsEmpty());  // no such vertices
}

}  // namespace
}  // namespace whittle::test
