#include "whittle/core/detail/edge_table.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/core/geometry/proof/border_edges.hh"

namespace whittle::test {
namespace {

using detail::border_edges;
using detail::EdgeTable;
using testing::ElementsAre;
using testing::IsEmpty;

/// Every mesh of the suite, and one with faces that have two equal corners.
std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> meshes = all_meshes();
  IndexedMesh collapsed = grid(4, 3);
  collapsed.faces.insert(collapsed.faces.begin() + 5, {{0, 0, 1}, {7, 8, 7}, {3, 3, 3}});
  meshes.push_back({"collapsed faces", collapsed});
  return meshes;
}

std::map<VertexPair, std::vector<Index>> counted(const IndexedMesh& mesh) {
  std::map<VertexPair, std::vector<Index>> edges;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Triangle& face = mesh.faces[f];
    if (!has_three_corners(face)) continue;
    for (Index i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(face[i], face[(i + 1) % 3]);
      edges[{low, high}].push_back(3 * f + i);
    }
  }
  return edges;
}

TEST(EdgeTable, HasEachEdgeOnceWithItsSides) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    const EdgeTable edges(mesh.faces, mesh.positions.size());
    const auto expected = counted(mesh);
    ASSERT_EQ(edges.size(), expected.size());
    std::size_t e = 0;
    for (const auto& [ends, sides] : expected) {
      EXPECT_EQ(edges[e], ends);
      const std::vector<Index> found(edges.sides(e).begin(), edges.sides(e).end());
      EXPECT_EQ(found, sides);
      ++e;
    }
  }
}

TEST(EdgeTable, TellsWhichEdgesAreRegular) {
  const std::vector<Triangle> faces{{0, 1, 2}, {1, 0, 3}, {1, 2, 3}};  // 1-2 runs the same way in first and last
  const EdgeTable edges(faces, 4);
  ASSERT_EQ(edges.size(), 6U);
  std::vector<VertexPair> regular;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.is_regular(e, faces)) regular.push_back(edges[e]);
  }
  EXPECT_THAT(regular, ElementsAre(VertexPair{0, 1}));
}

TEST(EdgeTable, LeavesFacesOutThatAreNotChosen) {
  const std::vector<Triangle> faces{{0, 1, 2}, {1, 0, 3}};
  const EdgeTable edges(faces, 4, std::vector<std::uint8_t>{0, 1});
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_EQ(edges[0], (VertexPair{0, 1}));
  EXPECT_THAT(edges.sides(0), ElementsAre(3));
}

TEST(EdgeTable, MayBeEmpty) {
  EXPECT_EQ(EdgeTable().size(), 0U);
  EXPECT_EQ(EdgeTable({}, 0).size(), 0U);
  EXPECT_EQ(EdgeTable({}, 3).size(), 0U);
  EXPECT_THAT(border_edges({}, 0), IsEmpty());
}

TEST(BorderEdges, AreTheEdgesWithOneSide) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    std::vector<VertexPair> expected;
    for (const auto& [ends, sides] : counted(mesh)) {
      if (sides.size() == 1) expected.push_back(ends);
    }
    EXPECT_EQ(border_edges(mesh.faces, mesh.positions.size()), expected);
  }
}

TEST(BorderEdges, AreSegmentsWithTheirFaces) {
  for (const auto& [name, mesh] : meshes()) {
    SCOPED_TRACE(name);
    std::vector<Index> sides;
    for (const auto& [ends, of_edge] : counted(mesh)) {
      if (of_edge.size() == 1) sides.push_back(of_edge[0]);
    }
    std::sort(sides.begin(), sides.end());
    BorderEdges expected;
    if (!sides.empty()) expected.mesh.positions = mesh.positions;
    for (const Index side : sides) {
      const Triangle& face = mesh.faces[side / 3];
      const Index to = face[(side + 1) % 3];
      expected.mesh.faces.push_back({face[side % 3], to, to});
      expected.faces.push_back(side / 3);
    }
    const BorderEdges found = border_edges_of(mesh);
    EXPECT_EQ(found.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(found.mesh.faces, expected.mesh.faces);
    EXPECT_EQ(found.faces, expected.faces);
  }
}

TEST(Sides, GoAroundTheirFace) {
  for (const Index first : {0U, 3U, 300U}) {
    EXPECT_EQ(detail::next_in_face(first), first + 1);
    EXPECT_EQ(detail::next_in_face(first + 2), first);
    EXPECT_EQ(detail::previous_in_face(first), first + 2);
    EXPECT_EQ(detail::previous_in_face(first + 1), first);
    EXPECT_EQ(detail::face_of(first + 2), first / 3);
  }
}

}  // namespace
}  // namespace whittle::test
