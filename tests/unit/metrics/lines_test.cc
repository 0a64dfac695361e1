#include "whittle/metrics/lines.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::metrics {
namespace {

double length_of(const std::vector<Segment>& lines) {
  double length = 0.0;
  for (const Segment& line : lines) length += (line.to - line.from).norm();
  return length;
}

/// Two faces along the x axis. One of them is turned up by `angle_deg` from the plane of the other.
IndexedMesh hinge(double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  IndexedMesh mesh;
  mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, -1.0, 0.0}, {0.5, std::cos(angle), std::sin(angle)}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}};
  return mesh;
}

TEST(BorderLines, AreTheBoundaryEdgesOfTheTopology) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    EXPECT_EQ(border_lines(mesh).size(), topology(mesh).boundary_edges) << name;
  }
}

TEST(BorderLines, OfAGridGoAroundIt) {
  const std::vector<Segment> lines = border_lines(test::grid(5, 3));
  EXPECT_EQ(lines.size(), 16U);
  EXPECT_DOUBLE_EQ(length_of(lines), 16.0);
  const auto on_side = [](const Vec3& p, const Vec3& q) {
    const auto both_at = [&](Eigen::Index axis, double x) { return p[axis] == x && q[axis] == x; };
    return both_at(0, 0.0) || both_at(0, 5.0) || both_at(1, 0.0) || both_at(1, 3.0);
  };
  for (const auto& [from, to] : lines) EXPECT_TRUE(on_side(from, to)) << from.transpose() << ", " << to.transpose();
}

TEST(BorderLines, AreAMatterOfVertexNumbersNotOfPositions) {
  const IndexedMesh cube = test::cube();
  EXPECT_TRUE(border_lines(cube).empty());
  EXPECT_EQ(border_lines(test::soup(cube)).size(), 36U);
}

TEST(BorderLines, LeaveOutCollapsedFaces) {
  IndexedMesh mesh = test::single_triangle();
  mesh.faces.push_back({0, 1, 1});
  EXPECT_EQ(border_lines(mesh).size(), 3U);
}

TEST(FeatureLines, OfABoxAreItsTwelveEdges) {
  for (const int n : {1, 4}) {
    const std::vector<Segment> lines = feature_lines(test::tessellated_cube(n), 40.0);
    EXPECT_EQ(lines.size(), 12U * static_cast<std::size_t>(n));
    EXPECT_DOUBLE_EQ(length_of(lines), 24.0);
    for (const auto& [from, to] : lines) {
      const Eigen::Array<bool, 3, 1> at_side = from.array().abs() == 1.0 && to.array().abs() == 1.0;
      EXPECT_GE((at_side && from.array() == to.array()).count(), 2) << from.transpose() << ", " << to.transpose();
    }
  }
}

TEST(FeatureLines, AreSharperThanTheAngle) {
  for (const double angle : {0.01, 1.0, 40.0, 90.0, 135.0, 179.9}) {
    // The cosine can't resolve angles this close to 0 or 180 degrees. A rounding error of 1e-16 must not show at 1e-9.
    EXPECT_EQ(feature_lines(hinge(angle), angle - 1e-9).size(), 1U) << angle;
    EXPECT_EQ(feature_lines(hinge(angle), angle + 1e-9).size(), 0U) << angle;
    EXPECT_EQ(feature_lines(hinge(-angle), angle - 1e-9).size(), 1U) << angle;
    EXPECT_EQ(feature_lines(hinge(-angle), angle + 1e-9).size(), 0U) << angle;
  }
  const std::vector<Segment> lines = feature_lines(hinge(60.0), 40.0);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].from, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(lines[0].to, Vec3(1.0, 0.0, 0.0));
}

TEST(FeatureLines, TakeFacesAsIfTheyWereOrientedAlike) {
  IndexedMesh mesh = hinge(30.0);
  std::swap(mesh.faces[1][0], mesh.faces[1][1]);
  EXPECT_EQ(feature_lines(mesh, 29.0).size(), 1U);
  EXPECT_EQ(feature_lines(mesh, 31.0).size(), 0U);
  const IndexedMesh cube = test::inside_out(test::cube());
  EXPECT_EQ(feature_lines(cube, 40.0).size(), 12U);
}

TEST(FeatureLines, HaveExactlyTwoFaces) {
  EXPECT_TRUE(feature_lines(test::single_triangle(), 1.0).empty());
  EXPECT_TRUE(feature_lines(test::three_faces_on_an_edge(), 1.0).empty());
  EXPECT_TRUE(feature_lines(test::soup(test::cube()), 40.0).empty());
}

TEST(FeatureLines, DontLieAtFacesWithoutANormal) {
  IndexedMesh mesh = hinge(0.0);
  mesh.positions[3] = {0.5, 0.0, 0.0};  // on the common edge
  EXPECT_TRUE(feature_lines(mesh, 1.0).empty());
}

TEST(FeatureLines, DontDependOnUnitPlaceAndOrder) {
  const IndexedMesh mesh = test::bracket(6);
  const std::vector<Segment> lines = feature_lines(mesh, 40.0);
  ASSERT_GT(lines.size(), 50U);
  for (const double factor : {1e-9, 1000.0}) {
    const std::vector<Segment> scaled = feature_lines(test::scaled(mesh, factor), 40.0);
    EXPECT_EQ(scaled.size(), lines.size()) << factor;
    EXPECT_NEAR(length_of(scaled) / factor, length_of(lines), 1e-12 * length_of(lines)) << factor;
  }
  const std::vector<IndexedMesh> others{test::rotated(mesh, 1), test::moved(mesh, Vec3(1e4, -2e4, 3e4)),
                                        test::permuted(mesh, 2).mesh};
  for (const IndexedMesh& other : others) {
    const std::vector<Segment> now = feature_lines(other, 40.0);
    EXPECT_EQ(now.size(), lines.size());
    EXPECT_NEAR(length_of(now), length_of(lines), 1e-9 * length_of(lines));  // 3e4 away rounding is 1e-11 of a unit
  }
}

TEST(Lines, RejectBadArguments) {
  const IndexedMesh cube = test::cube();
  for (const double angle : {0.0, 180.0, -40.0, 181.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(feature_lines(cube, angle), std::invalid_argument) << angle;
  }
  IndexedMesh broken = cube;
  broken.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(feature_lines(broken, 40.0), std::invalid_argument);
  EXPECT_THROW(border_lines(broken), std::invalid_argument);
  broken = cube;
  broken.faces[0][0] = 8;
  EXPECT_THROW(feature_lines(broken, 40.0), std::invalid_argument);
  EXPECT_THROW(border_lines(broken), std::invalid_argument);
  EXPECT_THROW(border_lines(IndexedMesh{}), std::invalid_argument);
  EXPECT_THROW(feature_lines(IndexedMesh{}, 40.0), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
