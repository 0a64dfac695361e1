#include "whittle/metrics/shape.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"

namespace whittle::metrics {
namespace {

IndexedMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  IndexedMesh mesh;
  mesh.positions = {a, b, c};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

/// Two faces of height 1 on the x axis whose normals form the angle `deg`. The second is reversed if `misoriented`.
IndexedMesh hinge(double deg, bool misoriented) {
  const double angle = deg * std::numbers::pi / 180.0;
  IndexedMesh mesh;
  mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 1.0, 0.0}, {0.5, -std::cos(angle), -std::sin(angle)}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}};
  if (misoriented) std::swap(mesh.faces[1][0], mesh.faces[1][1]);
  return mesh;
}

TEST(Shape, OfEquilateralFaces) {
  const Shape s = shape(test::icosahedron());
  EXPECT_NEAR(s.radius_ratio_mean, 1.0, 1e-14);
  EXPECT_NEAR(s.radius_ratio_min, 1.0, 1e-14);
  EXPECT_NEAR(s.min_angle_mean_deg, 60.0, 1e-12);
  EXPECT_NEAR(s.min_angle_min_deg, 60.0, 1e-12);
  EXPECT_NEAR(s.edge_length_cv, 0.0, 1e-14);
  EXPECT_EQ(s.folds, 0U);
  EXPECT_EQ(s.degenerate_faces, 0U);
}

TEST(Shape, OfRightTriangles) {
  const Shape half_square = shape(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_NEAR(half_square.radius_ratio_min, 2.0 * (std::numbers::sqrt2 - 1.0), 1e-15);
  EXPECT_NEAR(half_square.min_angle_min_deg, 45.0, 1e-13);
  const Shape pythagoras = shape(triangle({3, 0, 0}, {0, 0, 0}, {0, 4, 0}));
  EXPECT_NEAR(pythagoras.radius_ratio_min, 2.0 * 1.0 / 2.5, 1e-15);
  EXPECT_NEAR(pythagoras.min_angle_min_deg, std::atan(0.75) * 180.0 / std::numbers::pi, 1e-13);
  EXPECT_DOUBLE_EQ(pythagoras.edge_length_mean, 4.0);
  EXPECT_DOUBLE_EQ(pythagoras.edge_length_cv, std::sqrt(2.0 / 3.0) / 4.0);
}

TEST(Shape, OfThinFaces) {
  // A needle of width h has 2r/R near 2h (8 A² / (s a b c) with A = h/2, sides h, 1, 1), a cap of height h near 8h².
  const double h = 1e-4;
  const Shape needle = shape(triangle({0, 0, 0}, {1, 0, 0}, {1, h, 0}));
  EXPECT_NEAR(needle.min_angle_min_deg, std::atan(h) * 180.0 / std::numbers::pi, 1e-14);
  EXPECT_NEAR(needle.radius_ratio_min, 2.0 * h, 2.0 * h * h);
  EXPECT_EQ(needle.degenerate_faces, 0U);
  const Shape cap = shape(triangle({0, 0, 0}, {1, 0, 0}, {0.5, 0.01, 0}));
  EXPECT_NEAR(cap.radius_ratio_min, 8.0 * 0.01 * 0.01, 1e-6);
  EXPECT_EQ(shape(triangle({0, 0, 0}, {1, 0, 0}, {0.5, 1e-8, 0})).degenerate_faces, 1U);
}

TEST(Shape, CountsDegenerateFaces) {
  for (const Vec3& third : {Vec3(0.5, 0, 0), Vec3(2, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}) {
    const Shape s = shape(triangle({0, 0, 0}, {1, 0, 0}, third));
    EXPECT_EQ(s.degenerate_faces, 1U) << third.transpose();
    EXPECT_EQ(s.radius_ratio_mean, 0.0) << third.transpose();
    EXPECT_EQ(s.min_angle_min_deg, 0.0) << third.transpose();
  }
  const Shape point = shape(triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3}));
  EXPECT_EQ(point.degenerate_faces, 1U);
  EXPECT_EQ(point.min_angle_mean_deg, 0.0);
  EXPECT_EQ(point.edge_length_cv, 0.0);

  IndexedMesh mesh = test::cube();
  mesh.faces.push_back({2, 2, 5});
  const Shape collapsed = shape(mesh), cube = shape(test::cube());
  EXPECT_EQ(collapsed.degenerate_faces, 1U);
  EXPECT_EQ(collapsed.radius_ratio_min, 0.0);
  EXPECT_NEAR(collapsed.radius_ratio_mean, cube.radius_ratio_mean * 12.0 / 13.0, 1e-15);
  EXPECT_EQ(collapsed.valence.histogram, cube.valence.histogram);
}

TEST(Shape, CoefficientOfVariationOfACube) {
  // Twelve edges of length 2, six diagonals.
  const double mean = (12.0 * 2.0 + 6.0 * std::sqrt(8.0)) / 18.0;
  const double mean_sq = (12.0 * 4.0 + 6.0 * 8.0) / 18.0;
  const Shape s = shape(test::cube());
  EXPECT_DOUBLE_EQ(s.edge_length_mean, mean);
  EXPECT_NEAR(s.edge_length_cv, std::sqrt(mean_sq - mean * mean) / mean, 1e-14);
}

TEST(Shape, FoldsAreSharperThanTheirCosine) {
  // The cosine −0.94 is at 160.05 degrees.
  for (const bool misoriented : {false, true}) {
    for (const double deg : {0.0, 60.0, 90.0, 159.0, 160.0}) {
      EXPECT_EQ(shape(hinge(deg, misoriented)).folds, 0U) << deg << (misoriented ? ", misoriented" : "");
    }
    for (const double deg : {160.1, 175.0, 180.0}) {
      EXPECT_EQ(shape(hinge(deg, misoriented)).folds, 1U) << deg << (misoriented ? ", misoriented" : "");
    }
  }
  EXPECT_EQ(shape(test::pillow()).folds, 3U);
  EXPECT_EQ(shape(test::cube()).folds, 0U);
}

TEST(Shape, FoldsNeedTwoNormals) {
  IndexedMesh mesh = hinge(180.0, false);
  mesh.positions[3] = Vec3(0.25, 0.0, 0.0);  // on the hinge
  EXPECT_EQ(shape(mesh).folds, 0U);
  mesh = hinge(180.0, false);
  mesh.positions.emplace_back(0.5, 0.0, 1.0);
  mesh.faces.push_back({0, 1, 4});  // three faces at the hinge
  EXPECT_EQ(shape(mesh).folds, 0U);
}

TEST(Shape, ValencesAreOfInnerVertices) {
  const ValenceStats octahedron = shape(test::octahedron()).valence;
  EXPECT_EQ(octahedron.min, 4U);
  EXPECT_EQ(octahedron.max, 4U);
  EXPECT_EQ(octahedron.share_5_to_7, 0.0);
  const ValenceStats pole = shape(test::uv_sphere(4, 9)).valence;
  EXPECT_EQ(pole.max, 9U);
  EXPECT_EQ(pole.histogram.at(9), 2U);
  EXPECT_EQ(pole.vertices, 3U * 9U + 2U);
  const ValenceStats torus = shape(test::torus(8, 6)).valence;
  EXPECT_EQ(torus.share_5_to_7, 1.0);
  EXPECT_EQ(torus.histogram, (std::map<std::size_t, std::size_t>{{6, 48}}));
  const ValenceStats grid = shape(test::grid(5, 4)).valence;
  EXPECT_EQ(grid.vertices, 4U * 3U);
  const ValenceStats open = shape(test::single_triangle()).valence;
  EXPECT_EQ(open.vertices, 0U);
  EXPECT_EQ(open.max, 0U);
  EXPECT_TRUE(open.histogram.empty());
}

TEST(Shape, ValencesAddUpToTwiceTheEdges) {
  for (const auto& [name, mesh] : test::closed_meshes()) {
    const ValenceStats valence = shape(mesh).valence;
    std::size_t vertices = 0, ends = 0, regular = 0;
    for (const auto& [n, count] : valence.histogram) {
      vertices += count;
      ends += n * count;
      if (n >= 5 && n <= 7) regular += count;
    }
    EXPECT_EQ(vertices, valence.vertices) << name;
    EXPECT_EQ(ends, 3 * mesh.faces.size()) << name;
    EXPECT_DOUBLE_EQ(valence.share_5_to_7, static_cast<double>(regular) / static_cast<double>(vertices)) << name;
  }
}

TEST(Shape, DoesNotDependOnUnitPlaceOrOrder) {
  for (const test::NamedMesh& entry : test::all_meshes()) {
    const std::string& name = entry.name;
    const IndexedMesh& mesh = entry.mesh;
    const Shape expected = shape(mesh);
    const auto expect_same = [&](const IndexedMesh& other, double tolerance, const std::string& what) {
      const Shape s = shape(other);
      // Tolerances are absolute, because ratios, angles and the coefficient have no unit.
      EXPECT_NEAR(s.radius_ratio_mean, expected.radius_ratio_mean, tolerance) << name << what;
      EXPECT_NEAR(s.radius_ratio_min, expected.radius_ratio_min, tolerance) << name << what;
      EXPECT_NEAR(s.min_angle_mean_deg, expected.min_angle_mean_deg, 60.0 * tolerance) << name << what;
      EXPECT_NEAR(s.min_angle_min_deg, expected.min_angle_min_deg, 60.0 * tolerance) << name << what;
      EXPECT_NEAR(s.edge_length_cv, expected.edge_length_cv, tolerance) << name << what;
      EXPECT_EQ(s.folds, expected.folds) << name << what;
      EXPECT_EQ(s.degenerate_faces, expected.degenerate_faces) << name << what;
      EXPECT_EQ(s.valence.histogram, expected.valence.histogram) << name << what;
    };
    expect_same(test::rotated(mesh, 1), 1e-12, ", rotated");
    for (const double factor : {1e3, 1e-3, 1e60, 1e-60}) {
      expect_same(test::scaled(mesh, factor), 1e-12, ", scaled " + std::to_string(factor));
    }
    expect_same(test::permuted(mesh, 2).mesh, 1e-12, ", permuted");
    // A million away, coordinates are rounded to 1e-10, so edges of length 0.1 are rounded to 1e-9 of themselves.
    expect_same(test::moved(mesh, Vec3(1e6, -1e6, 1e6)), 1e-7, ", moved");
  }
}

TEST(Shape, RejectsWhatIsNoSurface) {
  EXPECT_THROW(shape(IndexedMesh{}), std::invalid_argument);
  IndexedMesh mesh = test::cube();
  mesh.faces[0][0] = 8;
  EXPECT_THROW(shape(mesh), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
