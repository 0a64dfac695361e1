#include "whittle/core/geometry/vertex_normals.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/core/wedges.hh"

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

double angle_deg(const std::array<float, 3>& n, const Vec3& m) {
  const Vec3 a(n[0], n[1], n[2]);
  return std::atan2(a.cross(m).norm(), a.dot(m)) * 180 / std::numbers::pi;
}

/// The largest angle between the normal of a corner and that of its face.
double farthest_from_faces(const IndexedMesh& mesh) {
  double largest = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto [a, b, c] = mesh.faces[f];
    const Vec3 normal = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    for (std::size_t k = 0; k < 3; ++k) {
      largest = std::max(largest, angle_deg(mesh.normals[mesh.wedge(f, k)], normal));
    }
  }
  return largest;
}

IndexedMesh with_normals_anew(IndexedMesh mesh, double crease_angle_deg = default_crease_angle_deg) {
  recompute_normals(mesh, Frame::of_points(mesh.positions), crease_angle_deg);
  EXPECT_EQ(mesh.normals.size(), n_wedges(mesh));
  for (const Attribute& attribute : mesh.attributes) EXPECT_EQ(attribute.size(), n_wedges(mesh));
  return mesh;
}

/// A prism over a regular hexagon: `frustum` with both rings of radius 1.
IndexedMesh hexagonal_prism() {
  IndexedMesh mesh = frustum(6, 3);
  for (Vec3& p : mesh.positions) {
    const double radius = Vec3(p.x(), p.y(), 0).norm();
    if (radius > 0) p = {p.x() / radius, p.y() / radius, p.z()};
  }
  return mesh;
}

TEST(RecomputeNormals, BreaksAtTheEdgesOfACube) {
  for (int n = 1; n <= 3; ++n) {
    for (const IndexedMesh& cube : {tessellated_cube(n), rotated(tessellated_cube(n), 5),
                                    scaled(tessellated_cube(n), 1e3), moved(tessellated_cube(n), {1e5, 0, -1e4})}) {
      const IndexedMesh anew = with_normals_anew(cube);
      EXPECT_LT(farthest_from_faces(anew), 1e-3);
      EXPECT_EQ(anew.normals.size(), static_cast<std::size_t>(6 * (n + 1) * (n + 1)));
    }
  }
}

TEST(RecomputeNormals, TakesTheAngleAskedFor) {
  const IndexedMesh cube = tessellated_cube(2);
  for (const double angle : {20.0, 90.0}) EXPECT_LT(farthest_from_faces(with_normals_anew(cube, angle)), 1e-3) << angle;
  for (const double angle : {91.0, 180.0}) {
    EXPECT_GT(farthest_from_faces(with_normals_anew(cube, angle)), 40) << angle;
  }
  const IndexedMesh rounded = with_normals_anew(cube, 180);
  EXPECT_TRUE(rounded.wedges.empty());
  EXPECT_EQ(rounded.normals, vertex_normals(cube, Frame::of_points(cube.positions)));
}

TEST(RecomputeNormals, BreaksAtAllOfEqualEdges) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    IndexedMesh prism = rotated(hexagonal_prism(), seed);
    for (Vec3& p : prism.positions) p = p.cast<float>().cast<double>();
    const IndexedMesh anew = with_normals_anew(prism, 60);
    EXPECT_EQ(anew.normals.size(), 12U * 3U + 2U) << seed;
    EXPECT_LT(farthest_from_faces(anew), 1e-3) << seed;
  }
}

TEST(RecomputeNormals, LeavesASmoothSurfaceOneNormalAVertex) {
  for (const IndexedMesh& mesh : {sphere(1), sphere(3), torus(24, 12), noisy_sphere(3, 0.01, 2)}) {
    const IndexedMesh anew = with_normals_anew(mesh);
    EXPECT_TRUE(anew.wedges.empty());
    EXPECT_EQ(anew.normals, vertex_normals(mesh, Frame::of_points(mesh.positions)));
  }
}

TEST(RecomputeNormals, KeepsTheSidesOfACylinderSmoothAndItsCapsFlat) {
  const IndexedMesh mesh = with_normals_anew(frustum(16, 2));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.faces[f][k]];
      const auto& n = mesh.normals[mesh.wedge(f, k)];
      const bool is_cap = std::abs(n[2]) > 0.99F;
      const Vec3 outward = is_cap ? Vec3(0, 0, n[2]) : Vec3(p.x(), p.y(), 0.25 * Vec3(p.x(), p.y(), 0).norm());
      EXPECT_LT(angle_deg(n, outward), 12);
    }
  }
}

TEST(RecomputeNormals, KeepsTextureCoordinatesAndJoinsWhatDiffersByNormalsAlone) {
  const IndexedMesh torus = textured_torus(24, 12);
  const IndexedMesh anew = with_normals_anew(torus);
  EXPECT_EQ(n_wedges(anew), n_wedges(torus));
  for (std::size_t corner = 0; corner < torus.wedges.size(); ++corner) {
    const auto before = torus.attributes[0].value(torus.wedges[corner]);
    const auto after = anew.attributes[0].value(anew.wedges[corner]);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
  }
  const IndexedMesh cube = with_normals_anew(charted_cube(3));
  EXPECT_EQ(cube.normals.size(), 6U * 16U);
  EXPECT_LT(farthest_from_faces(cube), 1e-3);
  IndexedMesh bare = charted_cube(3);
  bare.attributes.clear();
  EXPECT_TRUE(with_normals_anew(bare, 180).wedges.empty());
}

TEST(RecomputeNormals, GivesBothSidesOfASheetTheirOwn) {
  EXPECT_LT(farthest_from_faces(with_normals_anew(pillow())), 1e-3);
  EXPECT_LT(farthest_from_faces(with_normals_anew(two_cubes_on_an_edge(2))), 1e-3);
}

TEST(RecomputeNormals, DoesNotDependOnTheOrderOfFaces) {
  const IndexedMesh cube = charted_cube(2);
  const IndexedMesh expected = with_normals_anew(cube);
  const Permuted other = permuted(cube, 4);
  const IndexedMesh anew = with_normals_anew(other.mesh);
  for (std::size_t f = 0; f < anew.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& n = expected.normals[expected.wedge(other.old_face[f], k)];
      EXPECT_LT(angle_deg(anew.normals[anew.wedge(f, k)], Vec3(n[0], n[1], n[2])), 1e-3);
    }
  }
}

TEST(RecomputeNormals, TakesFacesWithoutAreaAndVerticesWithoutAFace) {
  IndexedMesh mesh = with_isolated_vertices(tessellated_cube(1), 3, 1);
  const Triangle first = mesh.faces[0];
  mesh.faces.push_back({first[0], first[1], first[0]});
  mesh.positions.push_back((mesh.positions[first[0]] + mesh.positions[first[1]]) / 2);
  mesh.faces.push_back({first[0], first[1], static_cast<Index>(mesh.positions.size() - 1)});
  const IndexedMesh anew = with_normals_anew(mesh);
  for (std::size_t f = 0; f < anew.faces.size(); ++f) {
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(length(anew.normals[anew.wedge(f, k)]), 1, 1e-6);
  }
}

}  // namespace
}  // namespace whittle::test
