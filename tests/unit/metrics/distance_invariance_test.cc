// The distance must not depend on threads, units, position and order.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::metrics {
namespace {

/// A smooth lump and a coarser one near it.
const IndexedMesh& reference() {
  static const IndexedMesh mesh = test::blob(4, 3);
  return mesh;
}
const IndexedMesh& approximation() {
  static const IndexedMesh mesh = test::blob(2, 3);
  return mesh;
}
const DistanceOptions options{.samples = 30'000, .seed = 5};

std::vector<double> lengths(const SurfaceDistance& d) {
  return {d.mean,         d.rms,          d.max,         std::sqrt(d.garland_heckbert),
          d.forward.mean, d.forward.rms,  d.forward.max, d.backward.mean,
          d.backward.rms, d.backward.max, d.diagonal};
}

std::vector<std::uint64_t> bits(const SurfaceDistance& d) {
  std::vector<std::uint64_t> result;
  for (const double x : lengths(d)) result.push_back(std::bit_cast<std::uint64_t>(x));
  for (const DirectedDistance& direction : {d.forward, d.backward}) {
    for (const double x : {direction.mean_sq, direction.normal_deviation_deg, direction.flipped_percent}) {
      result.push_back(std::bit_cast<std::uint64_t>(x));
    }
  }
  return result;
}

/// \param tolerance of the lengths, relative. Angles may differ more: where a sample is equally near to two faces,
/// rounding decides which of them gives the normal.
void expect_same(const SurfaceDistance& d, double factor, double tolerance, double angle_tolerance,
                 const std::string& what) {
  const SurfaceDistance expected = surface_distance(reference(), approximation(), options);
  const std::vector<double> now = lengths(d), then = lengths(expected);
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_NEAR(now[i] / factor, then[i], tolerance * then[i]) << what << ", number " << i;
  }
  EXPECT_NEAR(d.normal_deviation_deg, expected.normal_deviation_deg, angle_tolerance) << what;
}

TEST(SurfaceDistance, HasTheSameBytesForAnyNumberOfThreads) {
  const auto expected = bits(surface_distance(reference(), approximation(), {.samples = 30'000, .threads = 1}));
  for (const unsigned threads : {2U, 3U, 8U, 0U}) {
    EXPECT_EQ(bits(surface_distance(reference(), approximation(), {.samples = 30'000, .threads = threads})), expected)
        << threads << " threads";
  }
}

TEST(SurfaceDistance, ChangesWithTheSeedWithinItsSamplingError) {
  const SurfaceDistance first = surface_distance(reference(), approximation(), {.samples = 30'000, .seed = 1});
  const SurfaceDistance second = surface_distance(reference(), approximation(), {.samples = 30'000, .seed = 2});
  EXPECT_NE(first.mean, second.mean);
  EXPECT_NEAR(first.mean, second.mean, 5.0 * first.rms / std::sqrt(30'000.0));
}

TEST(SurfaceDistance, OfASingleSampleIsRightOnAverage) {
  // The one sample may lie anywhere on the surface; distance_test.cc derives the mean of these squares.
  const auto square = [](double low, double high) {
    IndexedMesh mesh;
    mesh.positions = {{low, low, 0.0}, {high, low, 0.0}, {high, high, 0.0}, {low, high, 0.0}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
  };
  const IndexedMesh small = square(0.0, 1.0);
  IndexedMesh large = square(-1.0, 2.0);
  large.faces = {{0, 2, 3}, {0, 1, 2}};  // same surface; a sampler that starts with the first face gets the other one
  constexpr int n = 4000;
  double sum = 0.0, above = 0.0;
  for (std::uint64_t seed = 1; seed <= n; ++seed) {
    sum += surface_distance(small, large, {.samples = 1, .seed = seed, .threads = 1}).backward.mean;
    // The reference is half of the square. The sample lies on that half with probability 1/2.
    IndexedMesh half = large;
    half.faces.resize(1);
    above += surface_distance(half, large, {.samples = 1, .seed = seed, .threads = 1}).backward.mean == 0.0 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(sum / n, 0.5623, 5.0 * 0.36 / std::sqrt(n));
  EXPECT_NEAR(above / n, 0.5, 5.0 * 0.5 / std::sqrt(n));
}

TEST(SlowSurfaceDistance, ConvergesAtAnyNumberOfSamples) {
  const SurfaceDistance fine = surface_distance(reference(), approximation(), {.samples = 200'000});
  for (const std::size_t samples : {std::size_t{1}, std::size_t{2047}, std::size_t{2049}, std::size_t{20'000}}) {
    const SurfaceDistance d = surface_distance(reference(), approximation(), {.samples = samples});
    EXPECT_NEAR(d.mean, fine.mean, 5.0 * fine.rms / std::sqrt(static_cast<double>(samples))) << samples;
  }
}

TEST(SlowSurfaceDistance, ScalesWithTheUnit) {
  for (const double factor : {1024.0, 0x1p-40}) {  // powers of two: no rounding, so even ties are the same
    const SurfaceDistance d =
        surface_distance(test::scaled(reference(), factor), test::scaled(approximation(), factor), options);
    expect_same(d, factor, 0.0, 0.0, std::to_string(factor));
  }
  for (const double factor : {1000.0, 0.001, 1e-9, 1e9}) {
    const SurfaceDistance d =
        surface_distance(test::scaled(reference(), factor), test::scaled(approximation(), factor), options);
    expect_same(d, factor, 1e-9, 0.05, std::to_string(factor));
  }
}

TEST(SlowSurfaceDistance, DoesNotDependOnThePlace) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const SurfaceDistance d =
        surface_distance(test::rotated(reference(), seed), test::rotated(approximation(), seed), options);
    SurfaceDistance turned = d;  // the box has another diagonal
    turned.diagonal = surface_distance(reference(), approximation(), {.samples = 1}).diagonal;
    expect_same(turned, 1.0, 1e-9, 0.05, "rotated, seed " + std::to_string(seed));
  }
  // A million diagonals away, coordinates are rounded to 1e-10 of a diagonal. The mean distance is about a hundredth of
  // one.
  const Vec3 far(3e6, -1e6, 2e6);
  const SurfaceDistance d = surface_distance(test::moved(reference(), far), test::moved(approximation(), far), options);
  expect_same(d, 1.0, 1e-6, 0.05, "moved");
}

TEST(SurfaceDistance, DependsOnTheOrderOnlyThroughTheSamples) {
  const SurfaceDistance d =
      surface_distance(test::permuted(reference(), 1).mesh, test::permuted(approximation(), 2).mesh, options);
  // Another order of the faces moves the samples: 5 / sqrt(30000) is 3 %. The maximum is at a vertex in one run, or at
  // a sample near it in the other.
  expect_same(d, 1.0, 0.03, 0.3, "permuted");
}

}  // namespace
}  // namespace whittle::metrics
