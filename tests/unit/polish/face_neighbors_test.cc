#include "surface/face_neighbors.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"

namespace whittle::test {

using namespace polishing;

namespace {

struct Mesh {
  explicit Mesh(const IndexedMesh& mesh)
      : faces(mesh.faces),
        corners(corners_by_vertex(faces, mesh.positions.size())),
        neighbors(faces, corners, detail::Workers(2)) {}

  std::vector<Triangle> faces;
  VertexCorners corners;
  FaceNeighbors neighbors;
};

bool has(const Triangle& face, Index v) { return std::find(face.begin(), face.end(), v) != face.end(); }

TEST(FaceNeighbors, AreWhatASearchOfAllFacesFinds) {
  for (const auto& [name, mesh] : all_meshes()) {
    SCOPED_TRACE(name);
    const Mesh m(mesh);
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      for (Index place = 0; place < 3; ++place) {
        const Index from = mesh.faces[f][place];
        const Index to = mesh.faces[f][(place + 1) % 3];
        std::vector<Index> others;
        for (Index g = 0; g < mesh.faces.size(); ++g) {
          if (g != f && has(mesh.faces[g], from) && has(mesh.faces[g], to)) others.push_back(g);
        }
        const auto [other, other_place] = m.neighbors.beyond(f, place);
        EXPECT_EQ(m.neighbors.is_border(f, place), others.empty());
        ASSERT_EQ(other, others.size() == 1 ? others[0] : invalid_index);
        if (other == invalid_index) continue;
        const Index begin = mesh.faces[other][other_place];
        const Index end = mesh.faces[other][(other_place + 1) % 3];
        const bool is_twisted = m.neighbors.is_twisted(f, place);
        EXPECT_EQ(begin, is_twisted ? from : to);
        EXPECT_EQ(end, is_twisted ? to : from);
      }
    }
  }
}

std::vector<Fan> fans(const IndexedMesh& mesh) {
  const Mesh m(mesh);
  std::vector<Fan> fans;
  for (Index v = 0; v < mesh.positions.size(); ++v) fans.push_back(m.neighbors.fan(v));
  return fans;
}

TEST(FaceNeighbors, TellClosedFansFromOpenOnesAndWhatIsNone) {
  for (const IndexedMesh& mesh : {tetrahedron(), csaszar_torus(), sphere(2), pillow()}) {
    EXPECT_EQ(fans(mesh), std::vector<Fan>(mesh.positions.size(), Fan::closed));
  }
  for (const IndexedMesh& mesh : {single_triangle(), two_triangles(), moebius(7)}) {
    EXPECT_EQ(fans(mesh), std::vector<Fan>(mesh.positions.size(), Fan::open));
  }
  const auto count = [](const IndexedMesh& mesh, Fan fan) {
    const std::vector<Fan> all = fans(mesh);
    return std::count(all.begin(), all.end(), fan);
  };
  const IndexedMesh plain = grid(4, 3);
  EXPECT_EQ(count(plain, Fan::open), 14);
  EXPECT_EQ(count(plain, Fan::closed), 6);
  EXPECT_EQ(count(bow_tie(), Fan::none), 1) << "two tetrahedra at one vertex";
  EXPECT_EQ(count(bow_tie(), Fan::closed), 6);
  EXPECT_EQ(count(three_faces_on_an_edge(), Fan::none), 2);
  EXPECT_EQ(count(three_faces_on_an_edge(), Fan::open), 3);
  EXPECT_EQ(count(two_cubes_on_an_edge(2), Fan::none), 3);
  EXPECT_EQ(count(with_isolated_vertices(tetrahedron(), 2, 1), Fan::none), 2);
}

/// Neither fan may use the other's faces for its own ring.
TEST(FaceNeighbors, SeesTwoFansOfDifferentSizes) {
  IndexedMesh mesh;  // fans of four and of three faces around vertex 0
  mesh.positions.resize(8, Vec3::Zero());
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {0, 5, 6}, {0, 6, 7}, {0, 7, 5}};
  EXPECT_EQ(fans(mesh)[0], Fan::none);
  mesh.faces.resize(6);  // a closed ring and an open row
  EXPECT_EQ(fans(mesh)[0], Fan::none);
  mesh.faces.resize(4);
  EXPECT_EQ(fans(mesh)[0], Fan::closed);
  mesh.faces.resize(3);
  EXPECT_EQ(fans(mesh)[0], Fan::open);
}

}  // namespace
}  // namespace whittle::test
