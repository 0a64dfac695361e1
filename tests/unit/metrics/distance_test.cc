// Comparisons with closed forms. A distance that is the same at every point must be exact but for rounding. A distance
// that varies must be within five standard errors of independent samples, 5 sigma / sqrt(n). Stratified samples have
// smaller errors.
#include "whittle/metrics/distance.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/core/geometry/bounds.hh"

namespace whittle::metrics {
namespace {

constexpr std::size_t n_samples = 40'000;
const DistanceOptions many_samples{.samples = n_samples, .seed = 7};

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

TEST(SurfaceDistance, IsZeroBeforeAnythingIsMeasured) {
  const SurfaceDistance d;
  for (const double number :
       {d.mean, d.mean_sq, d.rms, d.max, d.garland_heckbert, d.normal_deviation_deg, d.flipped_percent, d.diagonal}) {
    EXPECT_EQ(number, 0);
  }
  for (const DirectedDistance& direction : {d.forward, d.backward}) {
    for (const double number : {direction.mean, direction.mean_sq, direction.rms, direction.max,
                                direction.normal_deviation_deg, direction.flipped_percent}) {
      EXPECT_EQ(number, 0);
    }
  }
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

/// Thin faces are replaced by their sides: in the search for the nearest point, and where they are sampled.
TEST(SurfaceDistance, IsExactlyZeroBetweenEqualMeshesWithThinFaces) {
  for (const double height : {0.0, 1e-13, 1e-12, 9e-12, 1.1e-11, 1e-9}) {
    IndexedMesh mesh;
    mesh.positions = {{0, 0, 2}, {1, 0, 2}, {0.3, height, 2}};
    mesh.faces = {{0, 1, 2}};
    const SurfaceDistance d = surface_distance(mesh, mesh, {.samples = 2000});
    EXPECT_EQ(d.max, 0.0) << height;
  }
}

TEST(SurfaceDistance, OfParallelSquaresIsTheirOffset) {
  const double h = 0.37;  // rounding of a sum of 40,000, in blocks of 2048: at most 2048 * 2^-53 of h
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), square(0.0, 1.0, h), many_samples);
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
  // The large square has nine parts. One is the small square. On four strips the distance is uniform in [0, 1]. On four
  // corners it is that of a unit square's points from a corner: mean (sqrt 2 + asinh 1) / 3, mean square 2/3.
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), square(-1.0, 2.0, 0.0), many_samples);
  expect_zero(d.forward, "small to large");
  const double mean = (4.0 * 0.5 + 4.0 * (std::numbers::sqrt2 + std::asinh(1.0)) / 3.0) / 9.0;
  const double mean_sq = (4.0 / 3.0 + 4.0 * 2.0 / 3.0) / 9.0;
  EXPECT_NEAR(d.backward.mean, mean, 5.0 * standard_error(mean, mean_sq));
  // The squares are in [0, 2] with mean 4/9, so their standard deviation is below sqrt(2 * 4/9).
  EXPECT_NEAR(d.backward.mean_sq, mean_sq, 5.0 * std::sqrt(8.0 / 9.0 / n_samples));
  EXPECT_DOUBLE_EQ(d.backward.max, std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(d.mean, 0.5 * d.backward.mean);
  EXPECT_DOUBLE_EQ(d.mean_sq, 0.5 * d.backward.mean_sq);
  EXPECT_DOUBLE_EQ(d.rms, std::sqrt(d.mean_sq));
  EXPECT_DOUBLE_EQ(d.max, std::numbers::sqrt2);
}

TEST(SurfaceDistance, GarlandHeckbertTakesSamplesAndVerticesAlike) {
  // As above. The four vertices of the large square have squared distance 2, those of the small one 0.
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), square(-1.0, 2.0, 0.0), many_samples);
  const double n = n_samples;
  EXPECT_NEAR(d.garland_heckbert, (n * d.backward.mean_sq + 4.0 * 2.0) / (2.0 * n + 8.0), 1e-14);
}

TEST(SurfaceDistance, BetweenScaledCubes) {
  // The faces of (±1)³ lie s − 1 inside those of (±s)³. In the other direction, points beyond the edges are farther
  // away.
  const double s = 1.25, gap = s - 1.0;
  const SurfaceDistance d = surface_distance(test::cube(), test::scaled(test::cube(), s), many_samples);
  expect_constant(d.forward, gap, 1e-13, "small to large");
  const double mean_sq = gap * gap + 2.0 * gap * gap * gap / (3.0 * s);
  EXPECT_NEAR(d.backward.mean_sq, mean_sq, 5.0 * 2.0 * gap * gap / std::sqrt(n_samples));
  EXPECT_DOUBLE_EQ(d.backward.max, std::numbers::sqrt3 * gap);
  EXPECT_EQ(d.flipped_percent, 0.0);
}

TEST(SurfaceDistance, BetweenACubeAndItsMovedCopy) {
  // Moved by δ along x. One end face is δ away everywhere. On the other end face, points nearer than δ to the rim are
  // nearer to the sides. On the four sides a strip sticks out by up to δ.
  const double delta = 0.05, n_sides = 24.0;  // total area of the faces
  const SurfaceDistance d =
      surface_distance(test::cube(), test::moved(test::cube(), Vec3(delta, 0.0, 0.0)), many_samples);
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
  // Faces lie inside the sphere, at most as deep as the foot of the origin on them. So points of the unit sphere's mesh
  // have radii in [inner, 1], and those of the other mesh have s times that. Along a ray from the origin the meshes are
  // between s·inner − 1 and s − inner apart. These bound the distance from below and above.
  const IndexedMesh sphere = test::sphere(4);
  double inner = 1.0;
  for (const auto& [a, b, c] : sphere.faces) {
    const Vec3 &pa = sphere.positions[a], &pb = sphere.positions[b], &pc = sphere.positions[c];
    inner = std::min(inner, std::abs((pb - pa).cross(pc - pa).normalized().dot(pa)));
  }
  ASSERT_GT(inner, 0.998);
  const double s = 1.1;
  const SurfaceDistance d = surface_distance(sphere, test::scaled(sphere, s), many_samples);
  for (const DirectedDistance& direction : {d.forward, d.backward}) {
    for (const double distance : {direction.mean, direction.rms, direction.max}) {
      EXPECT_GE(distance, s * inner - 1.0);
      EXPECT_LE(distance, s - inner);
    }
    // A foot point is at most half a face away from the point's ray. Normals differ by less than a face's angle, 2 asin
    // of half the longest edge: below 4.5 degrees at level 4.
    EXPECT_LT(direction.normal_deviation_deg, 4.5);
    EXPECT_EQ(direction.flipped_percent, 0.0);
  }
}

TEST(SurfaceDistance, TellsASphereWithoutItsCapFromTheWholeOne) {
  // The cap above the polar angle 3π/16 is missing. Its pole is farthest away. The nearest points are the edge
  // midpoints of the surrounding polygon of 32 edges.
  const IndexedMesh whole = test::uv_sphere(16, 32);
  const double polar = 3.0 * std::numbers::pi / 16.0;
  IndexedMesh open = whole;
  std::erase_if(open.faces, [&](const Triangle& face) {
    return std::all_of(face.begin(), face.end(),
                       [&](Index v) { return whole.positions[v].z() > std::cos(polar) - 1e-9; });
  });
  ASSERT_EQ(whole.faces.size() - open.faces.size(), 32U * 5U);
  const SurfaceDistance d = surface_distance(whole, open, many_samples);
  const double pole = std::hypot(std::sin(polar) * std::cos(std::numbers::pi / 32.0), 1.0 - std::cos(polar));
  EXPECT_NEAR(d.forward.max, pole, 1e-12);
  EXPECT_GT(d.forward.mean, 0.0);
  expect_zero(d.backward, "without cap to whole");
  EXPECT_EQ(d.backward.normal_deviation_deg, 0.0);

  const SurfaceDistance swapped = surface_distance(open, whole, many_samples);
  expect_zero(swapped.forward, "without cap to whole");
  EXPECT_NEAR(swapped.backward.max, pole, 1e-12);
}

TEST(SurfaceDistance, VerticesCountForTheMaximumOnly) {
  // A spike whose faces have almost no area: no sample lies near its tip.
  IndexedMesh spiked = square(0.0, 1.0, 0.0);
  spiked.positions.emplace_back(0.5, 0.5, 3.0);
  spiked.positions.emplace_back(0.5 + 1e-9, 0.5, 0.0);
  spiked.positions.emplace_back(0.5, 0.5 + 1e-9, 0.0);
  spiked.faces.push_back({4, 5, 6});
  const SurfaceDistance d = surface_distance(square(0.0, 1.0, 0.0), spiked, many_samples);
  EXPECT_DOUBLE_EQ(d.backward.max, 3.0);
  EXPECT_LT(d.backward.mean, 1e-3);
  EXPECT_NEAR(d.garland_heckbert, 9.0 / (2.0 * n_samples + 4.0 + 7.0), 1e-9);
}

TEST(SurfaceDistance, DoesNotSampleUnusedVertices) {
  IndexedMesh mesh = test::cube();
  mesh.positions.emplace_back(50.0, 0.0, 0.0);
  const SurfaceDistance d = surface_distance(test::cube(), mesh, many_samples);
  EXPECT_EQ(d.max, 0.0);
  EXPECT_DOUBLE_EQ(surface_distance(mesh, test::cube(), many_samples).diagonal, std::sqrt(12.0));
}

TEST(SurfaceDistance, NormalDeviationOfATurnedPlaneIsItsAngle) {
  const IndexedMesh flat = test::moved(test::grid(6, 6), Vec3(-3.0, -3.0, 0.0));
  for (const double angle : {0.001, 10.0, 45.0, 89.9}) {
    const SurfaceDistance d = surface_distance(flat, test::rotated(flat, Vec3::UnitX(), angle), many_samples);
    EXPECT_NEAR(d.forward.normal_deviation_deg, angle, 1e-10) << angle;
    EXPECT_NEAR(d.backward.normal_deviation_deg, angle, 1e-10) << angle;
    EXPECT_EQ(d.flipped_percent, 0.0) << angle;
  }
  const SurfaceDistance d = surface_distance(flat, test::rotated(flat, Vec3::UnitX(), 100.0), many_samples);
  EXPECT_NEAR(d.normal_deviation_deg, 100.0, 1e-10);
  EXPECT_EQ(d.flipped_percent, 100.0);
}

TEST(SurfaceDistance, FacesTurnedOverAreFlipped) {
  const SurfaceDistance d =
      surface_distance(square(0.0, 1.0, 0.0), test::inside_out(square(0.0, 1.0, 0.1)), many_samples);
  EXPECT_NEAR(d.normal_deviation_deg, 180.0, 1e-10);
  EXPECT_LE(d.normal_deviation_deg, 180.0);
  EXPECT_EQ(d.flipped_percent, 100.0);
}

TEST(SurfaceDistance, SidesOfSheetsAreComparedWithThoseThatFaceAlike) {
  const IndexedMesh sheet = test::with_backs(test::noisy_grid(6, 6, 0.2, 1));
  IndexedMesh backs_first = sheet;
  std::ranges::reverse(backs_first.faces);
  for (const IndexedMesh& other : {sheet, backs_first}) {
    const SurfaceDistance distance = surface_distance(sheet, other, {});
    EXPECT_LT(distance.normal_deviation_deg, 1e-5);
    EXPECT_EQ(distance.flipped_percent, 0);
  }
}

TEST(SurfaceDistance, FacesWithoutNormalDontCountForAngles) {
  for (const double height : {0.0, 1e-12}) {  // no normal, or one at right angles to the other's
    IndexedMesh line;
    line.positions = {{0.0, 0.0, 0.0}, {0.5, 0.0, height}, {1.0, 0.0, 0.0}};
    line.faces = {{0, 1, 2}};
    const SurfaceDistance d = surface_distance(line, square(0.0, 1.0, 1.0), many_samples);
    expect_constant(d.forward, 1.0, 1e-11, "line to square");
    EXPECT_EQ(d.normal_deviation_deg, 0.0);
    // Backward: the distance of (x, y, 1) from the axis is sqrt(1 + y²), at most sqrt 2, with a mean square of 1 + 1/3.
    EXPECT_NEAR(d.backward.max, std::numbers::sqrt2, 1e-11);
    EXPECT_NEAR(d.backward.mean_sq, 4.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / n_samples));
  }
}

TEST(SurfaceDistance, SamplesAreSpreadByArea) {
  // One face is a thousand times as large as the other. The small one lies 1 above the reference plane and gets a
  // thousandth of the samples.
  IndexedMesh flat;
  flat.positions = {{0.0, 0.0, 0.0},  {1000.0, 0.0, 0.0}, {0.0, 2.0, 0.0},
                    {10.0, 0.1, 1.0}, {11.0, 0.1, 1.0},   {10.0, 2.1, 1.0}};
  IndexedMesh both = flat;
  flat.faces = {{0, 1, 2}};
  both.faces = {{0, 1, 2}, {3, 4, 5}};
  const SurfaceDistance d = surface_distance(flat, both, many_samples);
  EXPECT_NEAR(d.backward.mean_sq, 1.0 / 1001.0, 2.0 / n_samples);  // stratified: one sample more or less per end
}

/// A reference that was measured before gives the same bytes, also where tests differ in size so much that coordinates
/// are scaled.
TEST(DistanceReference, MeasuresAsIfItWereTheFirstTime) {
  const IndexedMesh sphere = test::sphere(3);
  DistanceReference kept(sphere);
  for (const double radius : {1.1, 0.4, 1e-140, 3.0, 1e140, 1.0}) {
    for (const unsigned threads : {1U, 2U}) {
      DistanceOptions options{.samples = 2000, .seed = 5};
      options.threads = threads;
      const IndexedMesh other = test::scaled(test::sphere(2), radius);
      const SurfaceDistance again = kept.to(other, options), fresh = surface_distance(sphere, other, options);
      EXPECT_EQ(again.mean, fresh.mean) << radius;
      EXPECT_EQ(again.max, fresh.max) << radius;
      EXPECT_EQ(again.garland_heckbert, fresh.garland_heckbert) << radius;
      EXPECT_EQ(again.normal_deviation_deg, fresh.normal_deviation_deg) << radius;
      EXPECT_EQ(again.backward.rms, fresh.backward.rms) << radius;
    }
  }
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
