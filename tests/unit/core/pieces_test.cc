#include "whittle/core/pieces.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace whittle::test {
namespace {

using testing::ElementsAre;

/// Two squares that have no vertex in common. The second one has a seam along its diagonal.
IndexedMesh two_squares() {
  IndexedMesh mesh;
  for (const double x : {0.0, 5.0}) {
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}) {
      mesh.positions.push_back(p + Vec3(x, 0, 0));
    }
  }
  mesh.faces = {{0, 1, 2}, {4, 5, 6}, {0, 2, 3}, {4, 6, 7}};
  mesh.wedges = {0, 1, 2, 4, 5, 6, 0, 2, 3, 8, 9, 7};
  mesh.attributes = {{.name = "s", .values = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  mesh.face_groups = {0, 1, 0, 2};
  mesh.group_names = {"a", "b", "c"};
  return mesh;
}

TEST(Pieces, HaveTheirFacesVerticesAndWedges) {
  const auto pieces = split_mesh(two_squares(), std::vector<Index>{0, 1, 0, 1}, 3);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_THAT(pieces[0].faces, ElementsAre(0, 2));
  EXPECT_THAT(pieces[1].vertices, ElementsAre(4, 5, 6, 7));
  const IndexedMesh& second = pieces[1].mesh;
  EXPECT_THAT(second.faces, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(second.wedges, ElementsAre(0, 1, 2, 4, 5, 3));
  EXPECT_THAT(second.attributes.front().values, ElementsAre(4, 5, 6, 7, 8, 9));
  EXPECT_THAT(second.face_groups, ElementsAre(1, 2));
  EXPECT_EQ(second.positions[1], Vec3(6, 0, 0));
  EXPECT_TRUE(pieces[2].mesh.faces.empty());
}

TEST(Pieces, MakeAWholeAgain) {
  const IndexedMesh whole = two_squares();
  IndexedMesh again;
  for (MeshPiece& piece : split_mesh(whole, std::vector<Index>{0, 1, 0, 1}, 2)) {
    piece.mesh.group_names.clear();
    append_mesh(again, std::move(piece.mesh));
  }
  EXPECT_EQ(again.positions, whole.positions);
  EXPECT_THAT(again.faces, ElementsAre(whole.faces[0], whole.faces[2], whole.faces[1], whole.faces[3]));
  EXPECT_EQ(again.attributes.front().values, whole.attributes.front().values);
  EXPECT_THAT(again.wedges, ElementsAre(0, 1, 2, 0, 2, 3, 4, 5, 6, 8, 9, 7));
}

TEST(Pieces, FillInWhatOneOfThemDoesNotHave) {
  IndexedMesh all;
  all.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  all.faces = {{0, 1, 2}};
  all.colors.assign(3, {0, 0, 0, 1});
  IndexedMesh more = two_squares();
  append_mesh(all, more);
  EXPECT_EQ(all.colors.size(), 13U);
  EXPECT_EQ(all.colors.back(), (Color{1, 1, 1, 1}));
  EXPECT_EQ(all.attributes.front().values[2], 0);
  EXPECT_EQ(all.attributes.front().values[12], 9);
  EXPECT_EQ(all.wedge(0, 2), 2U);
  EXPECT_EQ(all.wedge(4, 2), 10U);
}

}  // namespace
}  // namespace whittle::test
