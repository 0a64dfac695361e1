#include "whittle/core/geometry/vertex_normals.hh"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

double length(const std::array<float, 3>& n) { return std::hypot(double{n[0]}, double{n[1]}, double{n[2]}); }

TEST(VertexNormals, HaveUnitLengthHoweverSmallTheFacesAre) {
  for (const double scale : {1.0, 1e-40, 1e-70, 1e-78, 1e-80, 1e-81, 1e-150}) {
    IndexedMesh mesh = sphere(2);
    for (Vec3& p : mesh.positions) p *= scale;
    for (const auto& normal : vertex_normals(mesh, Frame{})) EXPECT_NEAR(length(normal), 1, 1e-6) << scale;
  }
}

TEST(VertexNormals, AreZeroWithoutArea) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 6}};
  mesh.faces = {{0, 1, 2}};
  for (const auto& normal : vertex_normals(mesh, Frame{})) EXPECT_EQ(length(normal), 0);
}

TEST(VertexNormals, PointAwayFromTheMiddleOfASphere) {
  const IndexedMesh mesh = sphere(3);
  const auto normals = vertex_normals(mesh, Frame::of_points(mesh.positions));
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 normal(normals[v][0], normals[v][1], normals[v][2]);
    EXPECT_GT(normal.dot(mesh.positions[v]), 0.999);
  }
}

}  // namespace
}  // namespace whittle::test
