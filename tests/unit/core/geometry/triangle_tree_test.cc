#include "whittle/core/geometry/triangle_tree.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "oracle/point_distance.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle {
namespace {

using test::distance_by_features;
using test::Random;
using Wide = test::LongVec3;

Vec3 random_point(Random& random, double low, double high) {
  const double x = random.uniform(low, high), y = random.uniform(low, high), z = random.uniform(low, high);
  return {x, y, z};
}

/// Separate triangles around random centres in the unit cube. The size of each is 10 to a random power.
IndexedMesh random_triangles(std::size_t n, double min_log_size, double max_log_size, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh;
  for (std::size_t f = 0; f < n; ++f) {
    const Vec3 center = random_point(random, 0.0, 1.0);
    const double size = std::pow(10.0, random.uniform(min_log_size, max_log_size));
    const auto first = static_cast<Index>(mesh.positions.size());
    for (int c = 0; c < 3; ++c) mesh.positions.emplace_back(center + size * random_point(random, -1.0, 1.0));
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Among others: points, segments, needles (two corners close by), caps (a corner near the middle of the opposite
/// side).
IndexedMesh random_thin_triangles(std::size_t n, double thickness, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh = random_triangles(n, -1.5, 0.0, seed);
  for (std::size_t f = 0; f < n; ++f) {
    Vec3 &a = mesh.positions[3 * f], &b = mesh.positions[3 * f + 1], &c = mesh.positions[3 * f + 2];
    const Vec3 off = thickness * random_point(random, -1.0, 1.0);
    switch (f % 4) {
      case 0:
        c = b + off;
        break;
      case 1:
        c = a + random.uniform() * (b - a) + off;
        break;
      case 2:
        b = a;
        break;
      default:
        b = c = a;
    }
  }
  return mesh;
}

/// Tolerance: point, corners and origin are rounded once each (2^-53 of the extent). The foot on a side or plane is off
/// by a few such units. In all 32 units of the extent of mesh and query. `extra` is relative to the same extent.
void expect_agrees_with_brute_force(const IndexedMesh& mesh, const std::string& what, std::uint64_t seed,
                                    double extra = 0.0) {
  const Box box = bounds_of(mesh);
  const TriangleTree tree(mesh);
  Random random(seed);
  for (int i = 0; i < 400; ++i) {
    // Near, around and far outside the mesh.
    const double reach = i % 4 == 3 ? 10.0 : 0.6;
    const Vec3 point = center_of(box) + reach * (box.max() - box.min()).cwiseProduct(random_point(random, -1.0, 1.0));
    const ClosestPoint found = tree.nearest(point);
    const double distance = std::sqrt(found.distance_sq);
    const auto expected = static_cast<double>(distance_by_features(mesh, point));
    const double tolerance = (32 * 0x1p-53 + extra) * (diagonal_of(box) + expected + center_of(box).norm() * 0.25);
    ASSERT_NEAR(distance, expected, tolerance) << what << ", seed " << seed << ", query " << i;
    // The point lies on the face, at the reported distance.
    const auto [a, b, c] = mesh.faces[found.face];
    ASSERT_LE(static_cast<double>(
                  distance_by_features(found.point.cast<long double>(), mesh.positions[a].cast<long double>(),
                                       mesh.positions[b].cast<long double>(), mesh.positions[c].cast<long double>())),
              1e-10 * diagonal_of(box) + tolerance)
        << what << ", seed " << seed << ", query " << i;
    ASSERT_NEAR((found.point - point).norm(), distance, tolerance) << what << ", seed " << seed << ", query " << i;
  }
}

TEST(TriangleTree, AgreesWithBruteForceOnRandomTriangles) {
  expect_agrees_with_brute_force(random_triangles(300, -1.0, -1.0, 1), "equal sizes", 1);
  expect_agrees_with_brute_force(random_triangles(300, -6.0, 0.0, 2), "sizes from 1e-6 to 1", 2);
  expect_agrees_with_brute_force(random_triangles(300, -3.0, 3.0, 3), "sizes from 1e-3 to 1e3", 3);
  expect_agrees_with_brute_force(random_triangles(1, -1.0, -1.0, 4), "one face", 4);
}

TEST(TriangleTree, AgreesWithBruteForceOnThinAndDegenerateTriangles) {
  for (const double thickness : {1e-3, 1e-6, 0.0}) {
    expect_agrees_with_brute_force(random_thin_triangles(200, thickness, 5), "thin, case " + std::to_string(thickness),
                                   5);
  }
  // A face that is almost a line is replaced by its sides: error at most half of 1e-11, see `trusted_normal`.
  for (int exponent = 8; exponent <= 16; ++exponent) {
    expect_agrees_with_brute_force(random_thin_triangles(200, std::pow(10.0, -exponent), 5),
                                   "thickness 1e-" + std::to_string(exponent), 5, 5e-12);
  }
}

TEST(TriangleTree, IsAccurateRightAboveThinTriangles) {
  // Query points whose foot on the plane lies inside the face. Random points never hit these faces.
  for (int exponent = 3; exponent <= 17; ++exponent) {
    const IndexedMesh mesh = random_thin_triangles(200, std::pow(10.0, -exponent), 16);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (f % 4 > 1) continue;  // the other faces are lines and points
      const auto& [ia, ib, ic] = mesh.faces[f];
      const Wide a = mesh.positions[ia].cast<long double>(), b = mesh.positions[ib].cast<long double>();
      const Wide c = mesh.positions[ic].cast<long double>();
      const Wide normal = (b - a).cross(c - a).normalized();
      if (!normal.allFinite()) continue;
      const double reach = f % 8 < 4 ? 1.0 : 1e-3;
      const Vec3 point = ((a + b + c) / 3.0L + reach * normal).cast<double>();
      IndexedMesh alone;
      alone.positions = mesh.positions;
      alone.faces = {mesh.faces[f]};
      const double found = std::sqrt(TriangleTree(alone, Vec3::Zero()).nearest(point).distance_sq);
      const auto expected = static_cast<double>(distance_by_features(point.cast<long double>(), a, b, c));
      ASSERT_NEAR(found, expected, 5e-12 * (diagonal_of(bounds_of(alone)) + reach))
          << "thickness 1e-" << exponent << ", face " << f;
    }
  }
}

TEST(TriangleTree, AgreesWithBruteForceOnNamedMeshes) {
  for (const auto& [name, mesh] : test::all_meshes()) expect_agrees_with_brute_force(mesh, name, 6);
}

TEST(TriangleTree, AgreesWithBruteForceAtAnySizeAndPlace) {
  const IndexedMesh mesh = random_triangles(200, -3.0, 0.0, 7);
  expect_agrees_with_brute_force(test::scaled(mesh, 1e-9), "scaled 1e-9", 7);
  expect_agrees_with_brute_force(test::scaled(mesh, 1e9), "scaled 1e9", 7);
  expect_agrees_with_brute_force(test::scaled(mesh, 1e-40), "scaled 1e-40", 7);
  // The tolerance grows with the distance from the origin, by a quarter of the coordinates' rounding. The next test is
  // exact.
  expect_agrees_with_brute_force(test::moved(mesh, Vec3(1e6, -2e6, 3e6)), "moved far", 7);
}

TEST(TriangleTree, LosesNothingFarFromTheOrigin) {
  // The coordinates are exact at both places, so the distances must be equal to the last bit.
  Random random(8);
  IndexedMesh here = test::sphere(2);
  for (Vec3& p : here.positions) p = (p * 0x1p20).array().round() * 0x1p-20;
  const Vec3 offset(0x1p30, -0x1p31, 0x1p29);
  const IndexedMesh there = test::moved(here, offset);
  const TriangleTree near(here, Vec3::Zero()), far(there, offset);
  for (int i = 0; i < 300; ++i) {
    const Vec3 point = (random_point(random, -1.5, 1.5) * 0x1p20).array().round() * 0x1p-20;
    const ClosestPoint a = near.nearest(point), b = far.nearest(point + offset);
    ASSERT_EQ(a.distance_sq, b.distance_sq) << "query " << i;
    ASSERT_EQ(a.face, b.face) << "query " << i;
  }
}

TEST(TriangleTree, FindsVerticesAtDistanceZero) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    const TriangleTree tree(mesh);
    // The foot on the plane of a face may be off by some units in the last place.
    const double tolerance = 4 * 0x1p-52 * diagonal_of(bounds_of(mesh));
    for (const Triangle& face : mesh.faces) {
      for (const Index v : face) {
        ASSERT_LE(std::sqrt(tree.nearest(mesh.positions[v]).distance_sq), tolerance) << name << ", vertex " << v;
      }
    }
  }
}

TEST(TriangleTree, PrefersTheLowestOfCoincidentFaces) {
  const IndexedMesh once = test::blob(2, 3);
  const std::size_t n = once.faces.size();
  ASSERT_GT(n, 0U);
  IndexedMesh thrice = once;
  for (std::size_t f = 0; f < 2 * n; ++f) {
    const auto& [a, b, c] = once.faces[n - 1 - f % n];
    thrice.faces.push_back(f < n ? Triangle{b, c, a} : Triangle{c, b, a});
  }
  const TriangleTree tree(thrice);
  Random random(9);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = random_point(random, -2.0, 2.0);
    ASSERT_LT(tree.nearest(point).face, n) << "query " << i;
  }
}

TEST(TriangleTree, PrefersTheLowestOfFacesAroundAnEdge) {
  // Outside a convex edge both faces are equally near, at the same point of the edge; likewise at a corner.
  const IndexedMesh cube = test::tessellated_cube(4);
  const TriangleTree tree(cube);
  Random random(10);
  for (int i = 0; i < 300; ++i) {
    const Vec3 point(random.uniform(1.1, 2.0), random.uniform(1.1, 2.0), i % 2 == 0 ? 1.5 : random.uniform(-1.0, 1.0));
    const ClosestPoint found = tree.nearest(point);
    for (Index f = 0; f < found.face; ++f) {
      IndexedMesh alone;
      alone.positions = cube.positions;
      alone.faces = {cube.faces[f]};
      ASSERT_GT(TriangleTree(alone, tree.origin()).nearest(point).distance_sq, found.distance_sq)
          << "query " << i << ", face " << f;
    }
  }
}

TEST(TriangleTree, AnswersTheSameWithAnyHint) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    const TriangleTree tree(mesh);
    Random random(11);
    for (int i = 0; i < 50; ++i) {
      const Vec3 point = random_point(random, -2.0, 2.0);
      const ClosestPoint plain = tree.nearest(point);
      for (Index hint = 0; hint <= mesh.faces.size(); ++hint) {  // the last hint is no face
        const ClosestPoint hinted = tree.nearest(point, hint);
        ASSERT_EQ(hinted.face, plain.face) << name << ", query " << i << ", hint " << hint;
        ASSERT_EQ(hinted.distance_sq, plain.distance_sq) << name << ", query " << i << ", hint " << hint;
        ASSERT_EQ(hinted.point, plain.point) << name << ", query " << i << ", hint " << hint;
      }
    }
  }
}

TEST(TriangleTree, AnswersTheSameWithAnyHintWhereRoundingMatters) {
  // Points on and close to the faces, sides and corners of a rotated mesh. There rounding may put the foot outside the
  // box.
  const IndexedMesh mesh = test::rotated(test::joined(test::tessellated_cube(6), test::sphere(2)), 14);
  const TriangleTree tree(mesh, Vec3::Zero());
  Random random(14);
  for (int i = 0; i < 20'000; ++i) {
    const auto& [a, b, c] = mesh.faces[random.below(mesh.faces.size())];
    const double u = i % 3 == 0 ? 0.0 : random.uniform(), v = i % 5 == 0 ? 0.0 : random.uniform(0.0, 1.0 - u);
    const Vec3 on = (1.0 - u - v) * mesh.positions[a] + u * mesh.positions[b] + v * mesh.positions[c];
    const Vec3 point = on * (i % 2 == 0 ? 1.0 : 1.0 + 1e-15);
    const ClosestPoint plain = tree.nearest(point);
    for (int j = 0; j < 4; ++j) {
      const auto hint = static_cast<Index>(random.below(mesh.faces.size()));
      const ClosestPoint hinted = tree.nearest(point, hint);
      ASSERT_EQ(hinted.face, plain.face) << "query " << i << ", hint " << hint;
      ASSERT_EQ(hinted.distance_sq, plain.distance_sq) << "query " << i << ", hint " << hint;
    }
  }
}

TEST(TriangleTree, AnswersTheSameWithAnyHintAboveAFlatGrid) {
  // Above a vertex of an axis-parallel plane six faces and their boxes are equally near. The foot on the plane must not
  // round to nearer than that: then the other faces would be skipped.
  const IndexedMesh mesh = test::moved(test::scaled(test::grid(6, 6), 0.37), Vec3(0.0, 0.0, 0.1));
  const TriangleTree tree(mesh, Vec3::Zero());
  Random random(15);
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 point = mesh.positions[random.below(mesh.positions.size())] + Vec3(0.0, 0.0, random.uniform());
    const ClosestPoint plain = tree.nearest(point);
    const ClosestPoint hinted = tree.nearest(point, static_cast<Index>(random.below(mesh.faces.size())));
    ASSERT_EQ(hinted.face, plain.face) << "query " << i;
  }
}

/// As it does with a hint, wherever a point lies and whatever offsets are.
TEST(TriangleTree, FindsWhatALookAtAllFacesFinds) {
  const IndexedMesh solid = test::rotated(test::joined(test::tessellated_cube(6), test::sphere(2)), 14);
  const IndexedMesh flat = test::moved(test::scaled(test::grid(6, 6), 0.37), Vec3(0.0, 0.0, 0.1));
  for (const IndexedMesh& mesh : {solid, flat, random_thin_triangles(200, 1e-6, 5), random_thin_triangles(200, 0, 6)}) {
    Random random(21);
    std::vector<double> offsets;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) offsets.push_back(0.25 * static_cast<double>(random.below(3)));
    TriangleTree tree(mesh, Vec3::Zero());
    tree.set_offsets(offsets);
    for (int i = 0; i < 2'000; ++i) {
      const Vec3 vertex = mesh.positions[random.below(mesh.positions.size())];
      const Vec3 point = i % 3 == 0   ? random_point(random, -2.0, 2.0)
                         : i % 3 == 1 ? Vec3(vertex + Vec3(0.0, 0.0, random.uniform()))
                                      : Vec3(vertex * (1.0 + 1e-15));
      const ClosestPoint found = tree.nearest(point);
      const ClosestPoint scanned = TriangleTree::nearest_without_tree(mesh, point);
      ASSERT_EQ(scanned.face, found.face) << "point " << i;
      ASSERT_EQ(scanned.point, found.point) << "point " << i;
      ASSERT_EQ(scanned.distance_sq, found.distance_sq) << "point " << i;
      const auto [face, distance] = tree.nearest_by_offsets(point, invalid_index);
      const auto [scanned_face, scanned_distance] = TriangleTree::nearest_without_tree(mesh, offsets, point);
      ASSERT_EQ(scanned_face, face) << "point " << i;
      ASSERT_EQ(scanned_distance, distance) << "point " << i;
    }
  }
}

TEST(TriangleTree, AnswersManyThreadsAtOnce) {
  const IndexedMesh mesh = test::blob(4, 5);
  const TriangleTree tree(mesh);
  Random random(12);
  std::vector<Vec3> points(2000);
  for (Vec3& point : points) point = random_point(random, -2.0, 2.0);
  std::vector<std::vector<ClosestPoint>> answers(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(answers.size());
    for (auto& own : answers) {
      threads.emplace_back([&] {
        for (const Vec3& point : points) own.push_back(tree.nearest(point));
      });
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ClosestPoint alone = tree.nearest(points[i]);
    for (const auto& own : answers) {
      ASSERT_EQ(own[i].face, alone.face) << "query " << i;
      ASSERT_EQ(own[i].distance_sq, alone.distance_sq) << "query " << i;
    }
  }
}

TEST(TriangleTree, CopesWithSizesThatShrinkForever) {
  // Each face is a sixteenth of the size of the one before, and sixteen times nearer to zero. Any split by area
  // separates only the largest face.
  constexpr int n = 116;
  IndexedMesh mesh;
  for (int i = 0; i < n; ++i) {
    const double size = std::ldexp(1.0, 4 * (n / 2 - i));
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.emplace_back(size, 0.0, 0.0);
    mesh.positions.emplace_back(size, 0.25 * size, 0.0);
    mesh.positions.emplace_back(size, 0.0, 0.25 * size);
    mesh.faces.push_back({first, first + 1, first + 2});
  }
  const TriangleTree tree(mesh, Vec3::Zero());
  for (int i = 0; i < n; ++i) {
    const double size = std::ldexp(1.0, 4 * (n / 2 - i));
    const ClosestPoint found = tree.nearest(Vec3(1.125 * size, 0.0625 * size, 0.0625 * size));
    EXPECT_EQ(found.face, static_cast<Index>(i));
    EXPECT_DOUBLE_EQ(std::sqrt(found.distance_sq), 0.125 * size) << "face " << i;
  }
}

TEST(TriangleTree, CopesWithPointsFarFromATinyMesh) {
  for (const double size : {1e-60, 1e-70, 1e-150, 1e-300, 1e-310}) {
    IndexedMesh mesh = test::grid(9, 9);
    for (Vec3& p : mesh.positions) p *= size;
    const TriangleTree tree(mesh, Vec3::Zero());
    for (const double distance : {1e-3, 1.0, 1e20, 1e70}) {
      const Vec3 point(-distance, -distance, distance);
      const ClosestPoint expected = TriangleTree::nearest_without_tree(mesh, point);
      const ClosestPoint found = tree.nearest(point);
      EXPECT_EQ(found.face, expected.face) << size << ' ' << distance;
      EXPECT_EQ(found.distance_sq, expected.distance_sq) << size << ' ' << distance;
    }
  }
}

TEST(TriangleTree, CopesWithThousandsOfFacesInOnePlace) {
  IndexedMesh mesh = test::single_triangle();
  mesh.faces.assign(5000, mesh.faces[0]);
  const ClosestPoint found = TriangleTree(mesh).nearest(mesh.positions[0] + Vec3(0.0, 0.0, 2.0));
  EXPECT_EQ(found.face, 0U);
  EXPECT_DOUBLE_EQ(found.distance_sq, 4.0);
}

TEST(TriangleTree, VisitsExactlyTheFacesWhoseBoxesMeet) {
  const IndexedMesh mesh = random_triangles(300, -3.0, 0.0, 13);
  const TriangleTree tree(mesh, Vec3::Zero());
  Random random(13);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = random_point(random, -0.5, 1.5), q = random_point(random, -0.5, 1.5);
    const Box box{p.cwiseMin(q), p.cwiseMax(q)};
    std::vector<Index> visited, expected;
    tree.visit_boxes(box, [&](Index face) { visited.push_back(face); });
    std::sort(visited.begin(), visited.end());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const Vec3 &a = mesh.positions[3 * f], &b = mesh.positions[3 * f + 1], &c = mesh.positions[3 * f + 2];
      const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
      if ((low.array() <= box.max().array()).all() && (high.array() >= box.min().array()).all()) {
        expected.push_back(static_cast<Index>(f));
      }
    }
    ASSERT_EQ(visited, expected) << "box " << i;
  }
}

TEST(TriangleTree, VisitsExactlyTheFacesThatAreNear) {
  const IndexedMesh mesh = random_triangles(300, -2.0, -0.5, 8);
  const TriangleTree tree(mesh, Vec3::Zero());
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    const Vec3 point = random_point(random, -0.5, 1.5);
    const double most = random.uniform(0.01, 0.6);
    std::vector<Index> visited, expected;
    tree.visit_near(point, most * most, [&](const ClosestPoint& closest) {
      visited.push_back(closest.face);
      EXPECT_NEAR((closest.point - point).squaredNorm(), closest.distance_sq, 1e-14);
      return most * most;
    });
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      const auto distance =
          distance_by_features(point.cast<long double>(), mesh.positions[a].cast<long double>(),
                               mesh.positions[b].cast<long double>(), mesh.positions[c].cast<long double>());
      if (distance <= most) expected.push_back(f);
    }
    std::sort(visited.begin(), visited.end());
    EXPECT_EQ(visited, expected);
  }
}

TEST(TriangleTree, VisitsNoFacesBeyondWhatAVisitLeaves) {
  const IndexedMesh mesh = random_triangles(300, -2.0, -0.5, 8);
  const TriangleTree tree(mesh, Vec3::Zero());
  double least_sq = std::numeric_limits<double>::infinity();
  tree.visit_near(Vec3::Zero(), least_sq, [&](const ClosestPoint& closest) {
    EXPECT_LE(closest.distance_sq, least_sq);
    return least_sq = closest.distance_sq;
  });
  EXPECT_EQ(least_sq, tree.nearest_local(Vec3::Zero()).distance_sq);
}

TEST(TriangleTree, RejectsWhatIsNoSurface) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(TriangleTree(IndexedMesh{}), std::invalid_argument);
  IndexedMesh mesh = test::cube();
  EXPECT_THROW(TriangleTree(mesh, Vec3(0.0, nan, 0.0)), std::invalid_argument);
  mesh.positions[3].y() = nan;
  EXPECT_THROW(TriangleTree{mesh}, std::invalid_argument);
  mesh = test::cube();
  mesh.faces[5][2] = 8;
  EXPECT_THROW(TriangleTree{mesh}, std::invalid_argument);
}

TEST(Bounds, LookAtUsedVerticesOnly) {
  IndexedMesh mesh = test::cube();
  mesh.positions.emplace_back(100.0, 0.0, 0.0);
  mesh.positions.emplace_back(std::numeric_limits<double>::infinity(), 0.0, 0.0);
  const Box box = bounds_of(mesh);
  EXPECT_EQ(box.min(), Vec3(-1.0, -1.0, -1.0));
  EXPECT_EQ(box.max(), Vec3(1.0, 1.0, 1.0));
  EXPECT_EQ(center_of(box), Vec3(0.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(diagonal_of(box), std::sqrt(12.0));
}

TEST(Bounds, RejectMissingAndInfiniteVertices) {
  EXPECT_THROW(bounds_of(IndexedMesh{}), std::invalid_argument);
  IndexedMesh mesh = test::cube();
  mesh.positions[0].z() = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(bounds_of(mesh), std::invalid_argument);
  mesh = test::cube();
  mesh.faces[0][0] = invalid_index;
  EXPECT_THROW(bounds_of(mesh), std::invalid_argument);
}

}  // namespace
}  // namespace whittle
