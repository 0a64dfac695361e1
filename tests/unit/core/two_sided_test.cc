#include "whittle/core/two_sided.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"

namespace whittle::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Index none = invalid_index;

TEST(TwoSided, BacksAreTheLaterFacesOnTheSameVertices) {
  const std::vector<Triangle> square{{0, 1, 2}, {2, 1, 0}, {0, 2, 3}, {3, 2, 0}};
  EXPECT_THAT(fronts_of_backs(square), ElementsAre(none, 0, none, 2));
  const IndexedMesh sheet = with_backs(grid(3, 2));
  const std::vector<Index> fronts = fronts_of_backs(sheet.faces);
  ASSERT_EQ(fronts.size(), 24U);
  for (Index f = 0; f < 12; ++f) {
    EXPECT_EQ(fronts[f], none);
    EXPECT_EQ(fronts[12 + f], f);
  }
}

TEST(TwoSided, AClosedSurfaceMayHaveTwoSides) { EXPECT_EQ(fronts_of_backs(with_backs(octahedron()).faces).back(), 7U); }

TEST(TwoSided, ASheetMayEndAtFacesOfOneSide) {
  EXPECT_THAT(fronts_of_backs(with_backs(grid(3, 1), 2).faces), ElementsAre(none, none, none, none, none, none, 0, 1));
}

TEST(TwoSided, FacesOfOneOrientationAreNoPair) {
  EXPECT_THAT(fronts_of_backs(with_duplicate_faces(grid(2, 2), 8).faces), IsEmpty());
}

/// Of the first square one pair is left, which is no sheet by itself.
TEST(TwoSided, OfThreeFacesOnTheSameVerticesNoTwoAreAPair) {
  IndexedMesh mesh = with_backs(grid(2, 1));
  mesh.faces.push_back(mesh.faces[0]);
  EXPECT_THAT(fronts_of_backs(mesh.faces), ElementsAre(none, none, none, none, none, none, 2, 3, none));
}

TEST(TwoSided, APocketOfTwoFacesIsNoSheet) {
  EXPECT_THAT(fronts_of_backs(pillow().faces), IsEmpty());
  EXPECT_THAT(fronts_of_backs(two_sided_leaf(6).faces), IsEmpty());
}

TEST(TwoSided, FacesWithTwoEqualCornersHaveNoBack) {
  EXPECT_THAT(fronts_of_backs(std::vector<Triangle>{{0, 0, 1}, {1, 0, 0}, {2, 2, 3}, {3, 2, 2}}), IsEmpty());
}

TEST(TwoSided, AWallBetweenTwoBodiesIsNoSheet) {
  IndexedMesh cubes = joined(tessellated_cube(3), tessellated_cube(3));
  for (std::size_t v = cubes.positions.size() / 2; v < cubes.positions.size(); ++v) cubes.positions[v].x() += 2;
  const IndexedMesh touching = glued(cubes);
  ASSERT_LT(touching.positions.size(), cubes.positions.size());
  EXPECT_THAT(fronts_of_backs(touching.faces), IsEmpty());
}

}  // namespace
}  // namespace whittle::test
