#include "whittle/core/feature_edges.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

TEST(FeatureEdges, OfACubeAreItsTwelve) {
  const std::vector<VertexPair> edges = feature_edges(cube(), 40);
  EXPECT_EQ(edges.size(), 12U);
  EXPECT_TRUE(std::ranges::is_sorted(edges));
  for (const auto& [a, b] : edges) {
    EXPECT_LT(a, b);
    EXPECT_EQ((cube().positions[a] - cube().positions[b]).norm(), 2);  // no diagonals
  }
  EXPECT_EQ(feature_edges(cube(), 89.9).size(), 12U);
  EXPECT_EQ(feature_edges(cube(), 90.1).size(), 0U);
  EXPECT_EQ(feature_edges(tessellated_cube(5), 40).size(), 60U);
}

TEST(FeatureEdges, OfASmoothSurfaceThereAreNone) {
  EXPECT_TRUE(feature_edges(sphere(3), 20).empty());
  EXPECT_TRUE(feature_edges(torus(40, 30), 20).empty());
  EXPECT_TRUE(feature_edges(grid(4, 4), 1).empty());  // border edges are not features
}

TEST(FeatureEdges, DoNotDependOnWhichSideFacesShow) {
  Random random(1);
  IndexedMesh mesh = bracket(2);
  const std::vector<VertexPair> expected = feature_edges(mesh, 40);
  ASSERT_FALSE(expected.empty());
  for (Triangle& face : mesh.faces) {
    if (random.below(2) == 0) std::swap(face[0], face[1]);
  }
  EXPECT_EQ(feature_edges(mesh, 40), expected);
  EXPECT_TRUE(feature_edges(moebius(60, 3), 20).empty());
}

TEST(FeatureEdges, DoNotDependOnTheUnitNorThePlace) {
  const IndexedMesh mesh = bracket(2);
  const std::vector<VertexPair> expected = feature_edges(mesh, 40);
  EXPECT_EQ(feature_edges(scaled(mesh, 1e-200), 40), expected);
  EXPECT_EQ(feature_edges(scaled(mesh, 1e200), 40), expected);
  EXPECT_EQ(feature_edges(moved(mesh, Vec3(1e6, -1e6, 1e6)), 40), expected);
  EXPECT_EQ(feature_edges(rotated(mesh, 1), 40), expected);
}

TEST(FeatureEdges, OfFacesWithoutAreaThereAreNone) {
  IndexedMesh mesh = cube();
  mesh.faces.push_back({0, 0, 1});  // left out: collapsed
  EXPECT_EQ(feature_edges(mesh, 40).size(), 12U);

  // A wedge with a face without area along its ridge. Neither edge of that face lies between two normals.
  IndexedMesh wedge = two_triangles();
  ASSERT_EQ(feature_edges(wedge, 5).size(), 1U);
  const auto [a, b] = feature_edges(wedge, 5).front();
  const auto middle = static_cast<Index>(wedge.positions.size());
  wedge.positions.push_back(wedge.positions[a]);
  for (Index& v : wedge.faces[0]) v = v == a ? middle : v;
  wedge.faces.push_back({a, b, middle});
  EXPECT_TRUE(feature_edges(wedge, 5).empty());
}

/// The first face's corners are in a line, up to rounding: the direction of its normal is noise.
TEST(FeatureEdges, OfFacesWithAreaByRoundingThereAreNone) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = random.uniform_vector(-1, 1);
    const Vec3 b = random.uniform_vector(-1, 1);
    IndexedMesh mesh;
    mesh.positions = {a, b, a + random.uniform(0.1, 0.9) * (b - a), random.uniform_vector(-1, 1)};
    mesh.faces = {{0, 1, 2}, {1, 0, 3}};
    EXPECT_TRUE(feature_edges(mesh, 40).empty());
  }
}

TEST(FeatureEdges, HaveExactlyTwoFaces) {
  EXPECT_TRUE(feature_edges(three_faces_on_an_edge(), 5).empty());
  EXPECT_TRUE(feature_edges(single_triangle(), 5).empty());
  EXPECT_EQ(feature_edges(pillow(), 179).size(), 3U);  // its two sides are back to back
  EXPECT_TRUE(feature_edges(pillow(), 180).empty());
}

TEST(FeatureEdges, RefuseWhatIsNoAngleAndNoMesh) {
  EXPECT_THROW(feature_edges(cube(), -1), std::invalid_argument);
  EXPECT_THROW(feature_edges(cube(), 181), std::invalid_argument);
  EXPECT_THROW(feature_edges(cube(), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  IndexedMesh broken = cube();
  broken.faces.push_back({0, 1, 100});
  EXPECT_THROW(feature_edges(broken, 40), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::test
