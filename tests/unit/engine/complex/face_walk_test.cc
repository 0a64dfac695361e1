#include "complex/face_walk.hh"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace whittle::test {
namespace {

using CommonFaces = std::vector<std::pair<Index, int>>;

/// The third corner and the turn of each face of v and w, in the order of the walk. All are numbers of the input.
CommonFaces common_faces(const std::vector<Triangle>& faces, Index v, Index w) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  TriangleComplex complex(points, faces, Frame{}, 1);
  complex.connect({}, 1);
  std::vector<Index> vertex_of(points.size());
  for (Index vertex = 0; vertex < points.size(); ++vertex) vertex_of[complex.origin(vertex)] = vertex;
  CommonFaces walked;
  for_each_common_face(complex, vertex_of[v], vertex_of[w],
                       [&](Index c, int turn) { walked.emplace_back(complex.origin(c), turn); });
  return walked;
}

TEST(FaceWalk, GoesOverCommonFacesByTheirThirdCorner) {
  const std::vector<Triangle> tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_EQ(common_faces(tetrahedron, 0, 1), (CommonFaces{{2, -1}, {3, 1}}));
  EXPECT_EQ(common_faces(tetrahedron, 1, 0), (CommonFaces{{2, 1}, {3, -1}}));
}

TEST(FaceWalk, OfTwoSidesOfATriangleTakesTheOneThatTurnsForwardFirst) {
  const std::vector<Triangle> both_sides_and_another = {{0, 2, 1}, {0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(common_faces(both_sides_and_another, 0, 1), (CommonFaces{{2, 1}, {2, -1}, {3, -1}}));
  EXPECT_EQ(common_faces(both_sides_and_another, 1, 0), (CommonFaces{{2, 1}, {2, -1}, {3, 1}}));
}

}  // namespace
}  // namespace whittle::test
