#include "repair/triangulate.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "support/random.hh"

namespace whittle::io {
namespace {

using whittle::test::Random;

struct Plane {
  Vec3 u, v, origin;
  Vec3 at(double x, double y) const { return origin + x * u + y * v; }
  Vec3 normal() const { return u.cross(v); }
};

const Plane flat{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0)};

Plane random_plane(Random& random) {
  const auto vector = [&] { return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
  const Vec3 u = vector().normalized();
  return {u, u.cross(vector()).normalized(), 100 * vector()};
}

std::vector<Triangle> triangulate(const std::vector<Vec3>& positions) {
  std::vector<Index> polygon(positions.size());
  std::iota(polygon.begin(), polygon.end(), Index{0});
  std::vector<Triangle> triangles(positions.size() - 2);
  PolygonTriangulator().triangulate(polygon, positions, triangles);
  return triangles;
}

Vec3 area_vector(const std::vector<Vec3>& p, const Triangle& t) {
  return 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

// In the plane z = 0.
void make_counter_clockwise(std::vector<Vec3>& polygon) {
  double doubled_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    doubled_area += polygon[i].cross(polygon[(i + 1) % polygon.size()]).z();
  }
  if (doubled_area < 0) std::reverse(polygon.begin(), polygon.end());
}

// Triangles cover the polygon exactly once if all have its orientation and their areas add up to its area.
void expect_triangulation(const std::vector<Vec3>& positions, const Plane& plane, const std::string& what) {
  const std::vector<Triangle> triangles = triangulate(positions);
  const Vec3 normal = plane.normal();
  double polygon_area = 0;
  double triangle_area = 0;
  for (std::size_t i = 1; i + 1 < positions.size(); ++i) {
    const Triangle fan{0, static_cast<Index>(i), static_cast<Index>(i + 1)};
    polygon_area += area_vector(positions, fan).dot(normal);
  }
  const double rounding = 1e-9 * polygon_area;
  for (const Triangle& t : triangles) {
    const double area = area_vector(positions, t).dot(normal);
    EXPECT_GT(area, 0) << what;
    triangle_area += area;
  }
  EXPECT_NEAR(triangle_area, polygon_area, rounding) << what;
}

TEST(Triangulation, LeavesATriangleAsItIs) {
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(Triangulation, SplitsASquareAlongTheFirstDiagonal) {
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulation, SplitsAConvexQuadAlongTheShorterDiagonal) {
  EXPECT_EQ(triangulate({{0, 0, 0}, {1, -0.5, 0}, {3, 0, 0}, {1, 0.5, 0}}),
            (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(Triangulation, KeepsBothTrianglesOfAnArrowOnTheSameSide) {
  // Corner 1 is reflex: the diagonal 0–2 is shorter but lies outside.
  EXPECT_EQ(triangulate({{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 6, 0}}), (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(triangulate({{0, 6, 0}, {-1, 0, 0}, {0, 1, 0}, {1, 0, 0}}), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulation, FansAConvexPolygon) {
  std::vector<Vec3> positions;
  positions.reserve(6);
  for (int i = 0; i < 6; ++i) positions.push_back(flat.at(std::cos(i), std::sin(i)));
  EXPECT_EQ(triangulate(positions), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}));
}

TEST(Triangulation, GivesNoCornerOfALargeConvexPolygonManyTriangles) {
  for (const int n : {17, 18, 33, 100, 1000}) {
    std::vector<Vec3> positions;
    for (int i = 0; i < n; ++i)
      positions.push_back(flat.at(std::cos(2 * 3.14159 * i / n), std::sin(2 * 3.14159 * i / n)));
    const std::vector<Triangle> faces = triangulate(positions);
    ASSERT_EQ(faces.size(), positions.size() - 2);
    std::vector<int> n_faces(positions.size());
    double area = 0;
    for (const auto& [a, b, c] : faces) {
      for (const Index v : {a, b, c}) ++n_faces[v];
      const double part = (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm() / 2;
      EXPECT_GT(part, 0);
      area += part;
    }
    EXPECT_NEAR(area, 0.5 * n * std::sin(2 * 3.14159 / n), 1e-4) << n;
    EXPECT_LE(*std::max_element(n_faces.begin(), n_faces.end()), 2 * std::log2(n)) << n;
  }
}

TEST(Triangulation, CoversRandomStarShapedPolygonsInAnyPlane) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Plane plane = random_plane(random);
    const auto corners = static_cast<int>(5 + random.below(40));
    std::vector<Vec3> positions;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const double radius = random.uniform(0.2, 1);
      positions.push_back(plane.at(radius * std::cos(angle), radius * std::sin(angle)));
    }
    expect_triangulation(positions, plane, "seed " + std::to_string(seed));
  }
}

TEST(Triangulation, CoversCombsAndSpirals) {
  std::vector<Vec3> comb;
  for (int i = 0; i < 40; ++i) {
    comb.push_back(flat.at(i, 0));
    comb.push_back(flat.at(i + 0.5, 10));
  }
  comb.push_back(flat.at(40, 12));
  comb.push_back(flat.at(-1, 11));
  make_counter_clockwise(comb);
  expect_triangulation(comb, flat, "comb");

  std::vector<Vec3> spiral;
  for (int i = 0; i <= 100; ++i)
    spiral.push_back(flat.at((1 + 0.1 * i) * std::cos(0.2 * i), (1 + 0.1 * i) * std::sin(0.2 * i)));
  for (int i = 100; i >= 0; --i) {
    spiral.push_back(flat.at((0.8 + 0.1 * i) * std::cos(0.2 * i), (0.8 + 0.1 * i) * std::sin(0.2 * i)));
  }
  make_counter_clockwise(spiral);
  expect_triangulation(spiral, flat, "spiral");
}

TEST(Triangulation, CoversASquareWithCornersAlongItsSides) {
  std::vector<Vec3> positions;
  const int n = 8;
  positions.reserve(4 * n);
  for (int i = 0; i < n; ++i) positions.push_back(flat.at(i, 0));
  for (int i = 0; i < n; ++i) positions.push_back(flat.at(n, i));
  for (int i = 0; i < n; ++i) positions.push_back(flat.at(n - i, n));
  for (int i = 0; i < n; ++i) positions.push_back(flat.at(0, n - i));
  expect_triangulation(positions, flat, "square");
}

TEST(Triangulation, CoversAPolygonWithABridgeToItsHole) {
  // A square with a square hole: the outline runs along the bridge 0–4 twice.
  const std::vector<Vec3> p = {flat.at(0, 0), flat.at(9, 0), flat.at(9, 9), flat.at(0, 9), flat.at(0, 0),
                               flat.at(3, 3), flat.at(3, 6), flat.at(6, 6), flat.at(6, 3), flat.at(3, 3)};
  expect_triangulation(p, flat, "hole");
}

TEST(Triangulation, DoesNotDependOnUnitsOrPosition) {
  Random random(7);
  std::vector<Vec3> positions;
  for (int i = 0; i < 30; ++i) {
    const double radius = std::round(random.uniform(100, 1000));
    positions.push_back(flat.at(std::round(radius * std::cos(0.2 * i)), std::round(radius * std::sin(0.2 * i))));
  }
  const std::vector<Triangle> expected = triangulate(positions);
  for (const double scale : {0x1p-300, 0x1p-30, 0x1p30, 0x1p300}) {
    std::vector<Vec3> scaled = positions;
    for (Vec3& p : scaled) p *= scale;
    EXPECT_EQ(triangulate(scaled), expected) << "scale " << scale;
  }
  std::vector<Vec3> moved = positions;
  for (Vec3& p : moved) p += Vec3(0x1p40, 0x1p40, 0x1p40);
  EXPECT_EQ(triangulate(moved), expected);
}

TEST(Triangulation, OfAPolygonThatCrossesItselfStillHasNMinusTwoTriangles) {
  std::vector<Vec3> star;
  star.reserve(5);
  for (int i = 0; i < 5; ++i) star.push_back(flat.at(std::cos(2.513 * i), std::sin(2.513 * i)));
  for (const Triangle& t : triangulate(star)) EXPECT_TRUE(has_three_corners(t));
  std::vector<Vec3> point(7, Vec3(1, 2, 3));
  for (const Triangle& t : triangulate(point)) EXPECT_TRUE(has_three_corners(t));
}

TEST(Triangulation, CoversAGearOfManyCorners) {
  std::vector<Vec3> gear;
  const int corners = 20000;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double radius = i % 4 < 2 ? 1 : 0.99;
    gear.push_back(flat.at(radius * std::cos(angle), radius * std::sin(angle)));
  }
  expect_triangulation(gear, flat, "gear");
}

TEST(Triangulation, EndsSoonOnAHostilePolygon) {
  // Zigzags that cross each other; there is hardly an ear.
  Random random(1);
  std::vector<Vec3> positions;
  positions.reserve(5000);
  for (int i = 0; i < 5000; ++i) positions.push_back(flat.at(random.uniform(), random.uniform()));
  EXPECT_EQ(triangulate(positions).size(), positions.size() - 2);
}

}  // namespace
}  // namespace whittle::io
