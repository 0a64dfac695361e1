// Against closed forms. What is the same at every point of a surface has to come out exactly, but for rounding; what
// varies has to come out within five standard errors of independent samples, 5 sigma / sqrt(n), which stratified ones
// stay below.
#include "whittle/metrics/distance.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "support/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/metrics/bounds.hh"

namespace whittle::metrics {
namespace {

constexpr std::size_t n_samples = 40'000;
const DistanceOptions options{.samples = n_samples, .seed = 7};

/// [low, high]² at height z, two faces, normals up.
IndexedMesh square(double low, double high, double z) {
  IndexedMesh mesh;
  mesh.positions = {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

double standard_error(double mean, double mean_sq) {
  return std::sqrt((mean_sq - mean * mean) / static_cast<double>(n_samples));
}

void expect_constant(const DirectedDistance& direction, double expected, double tolerance, const char* what) {
  EXPECT_NEAR(direction.mean, expected, tolerance) << what;
  EXPECT_NEAR(direction.rms, expected, tolerance) << what;
  EXPECT_NEAR(direction.max, expected, tolerance) << what;
  EXPECT_NEAR(direction.mean_sq, expected * expected, tolerance * expected) << what;
}

void expect_zero(const DirectedDistance& direction, const std::string& what) {
  EXPECT_EQ(direction.mean, 0.0) << what;
  EXPECT_EQ(direction.rms, 0.0) << what;
  EXPECT_EQ(direction.max, 0.0) << what;
  EXPECT_EQ(direction.mean_sq, 0.0) << what;
}

TEST(SurfaceDistance, IsExactlyZeroBetweenEqualMeshes) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    for (const Vec3& offset : {Vec3(0.0, 0.0, 0.0), Vec3(1e6, 3e6, -2e6)}) {
      const IndexedMesh moved = test::moved(mesh, offset);
      const SurfaceDistance d = surface_distance(moved, moved, {.samples = 2000});
      expect_zero(d.forward, name);
      expect_zero(d.backward, name);
      EXPECT_EQ(d.max, 0.0) << name;
      EXPECT_EQ(d.garland_heckbert, 0.0) << name;
      EXPECT_EQ(d.flipped_percent, 0.0) << name;
      EXPECT_EQ(d.normal_deviation_deg, 0.0) << name;
    }
  }
}

TEST(SurfaceDistance, OfParallelSquaresIsTheirOffset) {
  const double h = 0.37;  // sums of 40,000 of it round, block by block of 2048, by at most 2048 * 2^-53 of it
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), square(0.0, 1.0, h), options);
  expect_constant(d.forward, h, 1e-13, "forward");
  expect_constant(d.backward, h, 1e-13, "backward");
  EXPECT_NEAR(d.mean, h, 1e-13);
  EXPECT_NEAR(d.rms, h, 1e-13);
  EXPECT_NEAR(d.max, h, 1e-15);
  EXPECT_NEAR(d.garland_heckbert, h * h, 1e-13);
  EXPECT_EQ(d.normal_deviation_deg, 0.0);
  EXPECT_EQ(d.flipped_percent, 0.0);
  EXPECT_DOUBLE_EQ(d.diagonal, std::sqrt(2.0));
}

TEST(SurfaceDistance, OfSquaresOfDifferentSizeCountsTheBorder) {
  // Of the large square's nine parts one is the small one, four are strips (distance uniform in [0, 1]) and four are
  // corners (the distance of a unit square's points from a corner: mean (sqrt 2 + asinh 1) / 3, mean square 2/3).
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), square(-1.0, 2.0, 0.0), options);
  expect_zero(d.forward, "small to large");
  const double mean = (4.0 * 0.5 + 4.0 * (std::numbers::sqrt2 + std::asinh(1.0)) / 3.0) / 9.0;
  const double mean_sq = (4.0 / 3.0 + 4.0 * 2.0 / 3.0) / 9.0;
  EXPECT_NEAR(d.backward.mean, mean, 5.0 * standard_error(mean, mean_sq));
  // The squares are in [0, 2] with the mean 4/9: their standard deviation is below sqrt(2 * 4/9).
  EXPECT_NEAR(d.backward.mean_sq, mean_sq, 5.0 * std::sqrt(8.0 / 9.0 / n_samples));
  EXPECT_DOUBLE_EQ(d.backward.max, std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(d.mean, 0.5 * d.backward.mean);
  EXPECT_DOUBLE_EQ(d.mean_sq, 0.5 * d.backward.mean_sq);
  EXPECT_DOUBLE_EQ(d.rms, std::sqrt(d.mean_sq));
  EXPECT_DOUBLE_EQ(d.max, std::numbers::sqrt2);
}

TEST(SurfaceDistance, GarlandHeckbertTakesSamplesAndVerticesAlike) {
  // As above; the four vertices of the large square have squared distance 2, those of the small one 0.
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), square(-1.0, 2.0, 0.0), options);
  const double n = n_samples;
  EXPECT_NEAR(d.garland_heckbert, (n * d.backward.mean_sq + 4.0 * 2.0) / (2.0 * n + 8.0), 1e-14);
}

TEST(SurfaceDistance, BetweenScaledCubes) {
  // The faces of (±1)³ lie s − 1 inside of those of (±s)³; the other way the parts beyond the edges are further off.
  const double s = 1.25, gap = s - 1.0;
  const SurfaceDistance d = surface_distance(test::cube(), test::scaled(test::cube(), s), options);
  expect_constant(d.forward, gap, 1e-13, "small to large");
  const double mean_sq = gap * gap + 2.0 * gap * gap * gap / (3.0 * s);
  EXPECT_NEAR(d.backward.mean_sq, mean_sq, 5.0 * 2.0 * gap * gap / std::sqrt(n_samples));
  EXPECT_DOUBLE_EQ(d.backward.max, std::numbers::sqrt3 * gap);
  EXPECT_EQ(d.flipped_percent, 0.0);
}

TEST(SurfaceDistance, BetweenACubeAndItsMovedCopy) {
  // Moved by δ along x: one end face is δ away everywhere; of the other, points nearer than δ to its rim are nearer to
  // the sides; of the four sides a strip sticks out by up to δ.
  const double delta = 0.05, n_sides = 24.0;  // area
  const SurfaceDistance d = surface_distance(test::cube(), test::moved(test::cube(), Vec3(delta, 0.0, 0.0)), options);
  const double end = 4.0 * delta;
  const double other_end = 4.0 * (delta - delta * delta + delta * delta * delta / 3.0);
  const double strips = 4.0 * 2.0 * (delta * delta / 2.0);
  const double mean = (end + other_end + strips) / n_sides;
  const double tolerance = 5.0 * delta / std::sqrt(n_samples);
  EXPECT_NEAR(d.forward.mean, mean, tolerance);
  EXPECT_NEAR(d.backward.mean, mean, tolerance);
  EXPECT_NEAR(d.forward.max, delta, 1e-15);
  EXPECT_NEAR(d.backward.max, delta, 1e-15);
}

TEST(SurfaceDistance, BetweenConcentricSpheres) {
  // Faces dip inside the sphere as far as the foot of the origin on them. So points of the unit sphere's mesh are at
  // radii in [inner, 1], those of the other at s times that; whatever is s·inner − 1 … s − inner apart along a ray
  // through the origin can't be nearer than the first, nor further than the second.
  const IndexedMesh sphere = test::sphere(4);
  double inner = 1.0;
  for (const auto& [a, b, c] : sphere.faces) {
    const Vec3 &pa = sphere.positions[a], &pb = sphere.positions[b], &pc = sphere.positions[c];
    inner = std::min(inner, std::abs((pb - pa).cross(pc - pa).normalized().dot(pa)));
  }
  ASSERT_GT(inner, 0.998);
  const double s = 1.1;
  const SurfaceDistance d = surface_distance(sphere, test::scaled(sphere, s), options);
  for (const DirectedDistance& direction : {d.forward, d.backward}) {
    for (const double distance : {direction.mean, direction.rms, direction.max}) {
      EXPECT_GE(distance, s * inner - 1.0);
      EXPECT_LE(distance, s - inner);
    }
    // A foot point is at most half a face away from the point's ray; normals within a face's angle, 2 asin of the
    // longest edge's half, at level 4 below 4.5 degrees.
    EXPECT_LT(direction.normal_deviation_deg, 4.5);
    EXPECT_EQ(direction.flipped_percent, 0.0);
  }
}

TEST(SurfaceDistance, TellsASphereWithoutItsCapFromTheWholeOne) {
  // The cap above the polar angle 3π/16 is missing. Its pole is furthest off: nearest are the middles of the polygon of
  // 32 edges around it.
  const IndexedMesh whole = test::uv_sphere(16, 32);
  const double polar = 3.0 * std::numbers::pi / 16.0;
  IndexedMesh open = whole;
  std::erase_if(open.faces, [&](const Triangle& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](Index v) { return whole.positions[v].z() > std::cos(polar) - 1e-9; });
  });
  ASSERT_EQ(whole.faces.size() - open.faces.size(), 32U * 5U);
  const SurfaceDistance d = surface_distance(whole, open, options);
  const double pole = std::hypot(std::sin(polar) * std::cos(std::numbers::pi / 32.0), 1.0 - std::cos(polar));
  EXPECT_NEAR(d.forward.max, pole, 1e-12);
  EXPECT_GT(d.forward.mean, 0.0);
  expect_zero(d.backward, "without cap to whole");
  EXPECT_EQ(d.backward.normal_deviation_deg, 0.0);

  const SurfaceDistance swapped = surface_distance(open, whole, options);
  expect_zero(swapped.forward, "without cap to whole");
  EXPECT_NEAR(swapped.backward.max, pole, 1e-12);
}

TEST(SurfaceDistance, VerticesCountForTheMaximumOnly) {
  // A spike whose faces have hardly any area: no sample comes near its tip.
  IndexedMesh spiked = square(0.0, 1.0, 0.0);
  spiked.positions.emplace_back(0.5, 0.5, 3.0);
  spiked.positions.emplace_back(0.5 + 1e-9, 0.5, 0.0);
  spiked.positions.emplace_back(0.5, 0.5 + 1e-9, 0.0);
  spiked.faces.push_back({4, 5, 6});
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), spiked, options);
  EXPECT_DOUBLE_EQ(d.backward.max, 3.0);
  EXPECT_LT(d.backward.mean, 1e-3);
  EXPECT_NEAR(d.garland_heckbert, 9.0 / (2.0 * n_samples + 4.0 + 7.0), 1e-9);
}

TEST(SurfaceDistance, DoesNotSampleUnusedVertices) {
  IndexedMesh mesh = test::cube();
  mesh.positions.emplace_back(50.0, 0.0, 0.0);
  const SurfaceDistance d = surface_distance(test::cube(), mesh, options);
  EXPECT_EQ(d.max, 0.0);
  EXPECT_DOUBLE_EQ(surface_distance(mesh, test::cube(), options).diagonal, std::sqrt(12.0));
}

TEST(SurfaceDistance, NormalDeviationOfATurnedPlaneIsItsAngle) {
  const IndexedMesh flat = test::moved(test::grid(6, 6), Vec3(-3.0, -3.0, 0.0));
  for (const double angle : {0.001, 10.0, 45.0, 89.9}) {
    const SurfaceDistance d = surface_distance(flat, test::rotated(flat, Vec3::UnitX(), angle), options);
    EXPECT_NEAR(d.forward.normal_deviation_deg, angle, 1e-10) << angle;
    EXPECT_NEAR(d.backward.normal_deviation_deg, angle, 1e-10) << angle;
    EXPECT_EQ(d.flipped_percent, 0.0) << angle;
  }
  const SurfaceDistance d = surface_distance(flat, test::rotated(flat, Vec3::UnitX(), 100.0), options);
  EXPECT_NEAR(d.normal_deviation_deg, 100.0, 1e-10);
  EXPECT_EQ(d.flipped_percent, 100.0);
}

TEST(SurfaceDistance, FacesTurnedOverAreFlipped) {
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), test::inside_out(square(0.0, 1.0, 0.1)), options);
  EXPECT_NEAR(d.normal_deviation_deg, 180.0, 1e-10);
  EXPECT_LE(d.normal_deviation_deg, 180.0);
  EXPECT_EQ(d.flipped_percent, 100.0);
}

TEST(SurfaceDistance, FacesWithoutNormalDontCountForAngles) {
  for (const double height : {0.0, 1e-12}) {  // none, or one that says nothing (at right angles to the other's)
    IndexedMesh line;
    line.positions = {{0.0, 0.0, 0.0}, {0.5, 0.0, height}, {1.0, 0.0, 0.0}};
    line.faces = {{0, 1, 2}};
    const SurfaceDistance d = surface_distance(line, square(0.0, 1.0, 1.0), options);
    expect_constant(d.forward, 1.0, 1e-11, "line to square");
    EXPECT_EQ(d.normal_deviation_deg, 0.0);
    // The other way: the distance of (x, y, 1) from the axis, sqrt(1 + y²), is sqrt 2 at most and 1 + 1/3 in mean
    // square.
    EXPECT_NEAR(d.backward.max, std::numbers::sqrt2, 1e-11);
    EXPECT_NEAR(d.backward.mean_sq, 4.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / n_samples));
  }
}

TEST(SurfaceDistance, SamplesAreSpreadByArea) {
  // One face a thousand times the other, the small one 1 above the plane of the reference: a thousandth of the samples.
  IndexedMesh flat;
  flat.positions = {{0.0, 0.0, 0.0},  {1000.0, 0.0, 0.0}, {0.0, 2.0, 0.0},
                    {10.0, 0.1, 1.0}, {11.0, 0.1, 1.0},   {10.0, 2.1, 1.0}};
  IndexedMesh both = flat;
  flat.faces = {{0, 1, 2}};
  both.faces = {{0, 1, 2}, {3, 4, 5}};
  const SurfaceDistance d = surface_distance(flat, both, options);
  EXPECT_NEAR(d.backward.mean_sq, 1.0 / 1001.0, 2.0 / n_samples);  // stratified: off by one sample at either end
}

TEST(SurfaceDistance, RejectsBadArguments) {
  const IndexedMesh cube = test::cube();
  EXPECT_THROW(surface_distance(cube, cube, {.samples = 0}), std::invalid_argument);
  EXPECT_THROW(surface_distance(cube, cube, {.samples = (std::size_t{1} << 40) + 1}), std::invalid_argument);
  EXPECT_THROW(surface_distance(cube, IndexedMesh{}), std::invalid_argument);
  EXPECT_THROW(surface_distance(IndexedMesh{}, cube), std::invalid_argument);
  IndexedMesh broken = cube;
  broken.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(surface_distance(cube, broken), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
