#include "whittle/metrics/line_distance.hh"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle::metrics {
namespace {

using Lines = std::vector<Segment>;
using Wide = Eigen::Matrix<long double, 3, 1>;

/// Some segments are points; sizes from a thousandth to ten.
Lines random_lines(std::size_t n, std::uint64_t seed) {
  test::Random random(seed);
  Lines lines;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 from = random.uniform_vector(-1.0, 1.0);
    const double size = i % 7 == 6 ? 0.0 : std::pow(10.0, random.uniform(-3.0, 1.0));
    lines.push_back({from, from + size * random.uniform_vector(-1.0, 1.0)});
  }
  return lines;
}

double diagonal_of(const Lines& lines) {
  Vec3 low = lines[0].from, high = low;
  for (const auto& [from, to] : lines) {
    low = low.cwiseMin(from).cwiseMin(to);
    high = high.cwiseMax(from).cwiseMax(to);
  }
  return (high - low).norm();
}

long double distance(const Wide& point, const Lines& lines) {
  long double best = std::numeric_limits<long double>::infinity();
  for (const Segment& line : lines) {
    const Wide from = line.from.cast<long double>(), along = line.to.cast<long double>() - from;
    const long double length_sq = along.squaredNorm();
    const long double t = length_sq > 0 ? std::clamp(along.dot(point - from) / length_sq, 0.0L, 1.0L) : 0.0L;
    best = std::min(best, (point - from - t * along).norm());
  }
  return best;
}

/// By definition: the mean by Simpson's rule instead of the trapezoidal rule, every distance against all lines.
DirectedLineDistance brute_force(const Lines& from, const Lines& to, double spacing) {
  long double total = 0, integral = 0, max = 0;
  for (const Segment& line : from) {
    const Wide begin = line.from.cast<long double>(), along = line.to.cast<long double>() - begin;
    const auto n = static_cast<int>(std::ceil(along.norm() / spacing)) + 1;
    const auto at = [&](int i) { return distance(begin + along * (static_cast<long double>(i) / (2 * n)), to); };
    long double sum = 0;
    for (int i = 0; i < n; ++i) {
      const long double a = at(2 * i), b = at(2 * i + 1), c = at(2 * i + 2);
      sum += (a + 4 * b + c) / 6;
      max = std::max({max, a, b, c});
    }
    total += along.norm();
    integral += sum / n * along.norm();
  }
  return {static_cast<double>(integral / total), static_cast<double>(max)};
}

Lines transformed(const Lines& lines, const Eigen::Affine3d& transform) {
  Lines result;
  for (const auto& [from, to] : lines) result.push_back({transform * from, transform * to});
  return result;
}

std::vector<double> numbers_of(const LineDistance& d) {
  return {d.mean, d.max, d.forward.mean, d.forward.max, d.backward.mean, d.backward.max};
}

void expect_near(const LineDistance& d, const LineDistance& expected, double factor, double tolerance,
                 const std::string& what) {
  const std::vector<double> now = numbers_of(d), then = numbers_of(expected);
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_NEAR(now[i] / factor, then[i], tolerance) << what << ", number " << i;
  }
}

LineDistance distance_between(const Lines& reference, const Lines& test, const LineDistanceOptions& options = {}) {
  const std::optional<LineDistance> d = line_distance(reference, test, options);
  EXPECT_TRUE(d.has_value());
  return d.value_or(LineDistance{});
}

TEST(LineDistance, AgreesWithBruteForce) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Lines reference = random_lines(5 * seed, seed), test = random_lines(40 / seed, 100 + seed);
    const LineDistanceOptions options{.spacing_rel = 1e-3};
    const double spacing = options.spacing_rel * std::max(diagonal_of(reference), diagonal_of(test));
    const LineDistance d = distance_between(reference, test, options);
    for (const bool forward : {true, false}) {
      const DirectedLineDistance expected =
          forward ? brute_force(reference, test, spacing) : brute_force(test, reference, spacing);
      const DirectedLineDistance& found = forward ? d.forward : d.backward;
      // The distance changes along a line by at most the arc length, so at a peak it can be off by half a spacing. At
      // each kink the mean is off by about the spacing squared over the length. There are few kinks.
      const std::string what = "seed " + std::to_string(seed) + (forward ? ", forward" : ", backward");
      EXPECT_NEAR(found.max, expected.max, 0.5 * spacing) << what;
      EXPECT_NEAR(found.mean, expected.mean, 0.01 * spacing) << what;
    }
    EXPECT_DOUBLE_EQ(d.mean, 0.5 * (d.forward.mean + d.backward.mean));
    EXPECT_EQ(d.max, std::max(d.forward.max, d.backward.max));
  }
}

TEST(LineDistance, OfEndsIsExact) {
  // With the coarsest spacing only the ends are samples, so each number is a brute-force result to rounding.
  const Lines reference = random_lines(50, 11), test = random_lines(60, 12);
  const LineDistance d = distance_between(reference, test, {.spacing_rel = 1.0});
  long double total = 0, integral = 0, max = 0;
  for (const auto& [from, to] : reference) {
    const long double a = distance(from.cast<long double>(), test), b = distance(to.cast<long double>(), test);
    const long double length = (to - from).cast<long double>().norm();
    total += length;
    integral += length * (a + b) / 2;
    max = std::max({max, a, b});
  }
  EXPECT_NEAR(d.forward.max, static_cast<double>(max), 1e-14 * diagonal_of(reference));
  EXPECT_NEAR(d.forward.mean, static_cast<double>(integral / total), 1e-14 * diagonal_of(reference));
}

TEST(LineDistance, IsExactlyZeroBetweenEqualLines) {
  for (const Vec3& offset : {Vec3(0.0, 0.0, 0.0), Vec3(1e6, 3e6, -2e6)}) {
    const Lines lines = transformed(random_lines(200, 3), Eigen::Affine3d(Eigen::Translation3d(offset)));
    for (const double x : numbers_of(distance_between(lines, lines))) EXPECT_EQ(x, 0.0) << offset.transpose();
  }
}

TEST(LineDistance, DoesNotDependOnHowALineIsCut) {
  const Lines whole{{{0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}}};
  const Lines cut{
      {{3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {{3.0, 0.0, 0.0}, {3.5, 0.0, 0.0}}, {{3.5, 0.0, 0.0}, {8.0, 0.0, 0.0}}};
  const Lines other{{{-1.0, 2.0, 0.0}, {9.0, 2.0, 0.0}}};
  for (const double x : numbers_of(distance_between(whole, cut))) EXPECT_EQ(x, 0.0);
  for (const Lines& lines : {whole, cut}) {
    const LineDistance d = distance_between(lines, other);
    EXPECT_DOUBLE_EQ(d.forward.mean, 2.0);
    EXPECT_DOUBLE_EQ(d.forward.max, 2.0);
    EXPECT_DOUBLE_EQ(d.backward.max, std::sqrt(5.0));
    // At x beyond either end the distance is sqrt(4 + x²). The trapezoidal rule's error is of the order of the spacing
    // squared.
    const double beyond = 0.5 * (std::sqrt(5.0) + 4.0 * std::asinh(0.5));
    EXPECT_NEAR(d.backward.mean, (8.0 * 2.0 + 2.0 * beyond) / 10.0, 1e-6);
  }
}

TEST(LineDistance, WeightsByLength) {
  // A line of length 3 at height 1 and one of length 1 at height 2, far from each other.
  const Lines ground{{{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}}};
  const Lines above{{{0.0, 0.0, 1.0}, {3.0, 0.0, 1.0}}, {{90.0, 0.0, 2.0}, {91.0, 0.0, 2.0}}};
  const LineDistance d = distance_between(above, ground);
  EXPECT_DOUBLE_EQ(d.forward.mean, (3.0 * 1.0 + 1.0 * 2.0) / 4.0);
  EXPECT_DOUBLE_EQ(d.forward.max, 2.0);
}

TEST(LineDistance, TellsALineThatIsMissing) {
  const Lines one{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}};
  Lines two = one;
  two.push_back({{0.0, 3.0, 0.0}, {1.0, 3.0, 0.0}});
  const LineDistance missing = distance_between(two, one), added = distance_between(one, two);
  EXPECT_DOUBLE_EQ(missing.forward.max, 3.0);
  EXPECT_DOUBLE_EQ(missing.forward.mean, 1.5);
  EXPECT_EQ(missing.backward.max, 0.0);
  EXPECT_EQ(added.forward.max, 0.0);
  EXPECT_DOUBLE_EQ(added.backward.max, 3.0);
  EXPECT_DOUBLE_EQ(added.mean, 0.75);
}

TEST(LineDistance, OfPointsWeightsThemAlike) {
  const Vec3 zero(0.0, 0.0, 0.0), one(1.0, 0.0, 0.0), four(4.0, 0.0, 0.0);
  const LineDistance d = distance_between({{zero, zero}}, {{one, one}, {four, four}});
  EXPECT_EQ(d.forward.mean, 1.0);
  EXPECT_EQ(d.forward.max, 1.0);
  EXPECT_EQ(d.backward.mean, 2.5);
  EXPECT_EQ(d.backward.max, 4.0);
  EXPECT_EQ(distance_between({{one, one}}, {{one, one}}).max, 0.0);
}

TEST(LineDistance, IsNothingWhereThereAreNoLines) {
  const Lines lines = random_lines(3, 1);
  EXPECT_FALSE(line_distance({}, lines).has_value());
  EXPECT_FALSE(line_distance(lines, {}).has_value());
  EXPECT_FALSE(line_distance({}, {}).has_value());
}

TEST(LineDistance, OfTheFeaturesOfABoxAndItsMovedCopy) {
  // Moved by δ along x. Of the 4 edges along x, a piece of length δ sticks out. The 8 others are δ away from their
  // copies. But the ends of 4 of these, on the side the box moves to, are nearer to the copies of edges along x.
  const double delta = 0.05;
  const IndexedMesh box = test::tessellated_cube(3);
  const Lines lines = feature_lines(box, 40.0);
  const Lines moved = feature_lines(test::moved(box, Vec3(delta, 0.0, 0.0)), 40.0);
  const LineDistance d = distance_between(lines, moved);
  const double mean = (4.0 * delta * delta / 2.0 + 4.0 * 2.0 * delta + 4.0 * (2.0 * delta - delta * delta)) / 24.0;
  // The rule is exact except in the 12 intervals with kinks. There its error is at most an eighth of the spacing
  // squared.
  const double spacing = std::sqrt(12.0) / 2000.0, tolerance = 12.0 * spacing * spacing / 8.0 / 24.0;
  for (const DirectedLineDistance& direction : {d.forward, d.backward}) {
    EXPECT_NEAR(direction.mean, mean, tolerance);
    EXPECT_NEAR(direction.max, delta, 1e-15);
  }
  // Moved along its diagonal: the corner at the back is farthest away.
  const LineDistance aslant = distance_between(lines, feature_lines(test::moved(box, Vec3(delta, delta, delta)), 40.0));
  EXPECT_NEAR(aslant.max, std::numbers::sqrt3 * delta, 1e-15);
}

TEST(LineDistance, OfTheBordersOfOpenGrids) {
  const IndexedMesh grid = test::grid(6, 4);
  const LineDistance lifted =
      distance_between(border_lines(grid), border_lines(test::moved(grid, Vec3(0.0, 0.0, 0.25))));
  for (const double x : numbers_of(lifted)) EXPECT_NEAR(x, 0.25, 1e-14);
  // One row of squares is missing: one side of it, and a piece of length 1 at either end.
  const LineDistance shorter = distance_between(border_lines(grid), border_lines(test::grid(6, 3)));
  EXPECT_DOUBLE_EQ(shorter.forward.max, 1.0);
  EXPECT_NEAR(shorter.forward.mean, (6.0 * 1.0 + 2.0 * 0.5) / 20.0, 1e-12);
  // The far side of the smaller grid lies 1 inside the larger one's, with its ends on the larger one's sides.
  EXPECT_DOUBLE_EQ(shorter.backward.max, 1.0);
  EXPECT_NEAR(shorter.backward.mean, (4.0 * 1.0 + 2.0 * 0.5) / 18.0, 1e-6);
}

TEST(LineDistance, HasTheSameBytesForAnyNumberOfThreads) {
  const Lines reference = random_lines(500, 21), test = random_lines(300, 22);
  const LineDistanceOptions one{.spacing_rel = 0.01, .threads = 1};
  const std::vector<double> expected = numbers_of(distance_between(reference, test, one));
  for (const unsigned threads : {2U, 5U, 0U}) {
    const std::vector<double> now =
        numbers_of(distance_between(reference, test, {.spacing_rel = 0.01, .threads = threads}));
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(now[i]), std::bit_cast<std::uint64_t>(expected[i])) << threads;
    }
  }
}

TEST(LineDistance, DoesNotDependOnUnitPlaceAndOrder) {
  const Lines reference = random_lines(30, 31), test = random_lines(30, 32);
  const LineDistance expected = distance_between(reference, test);
  const double diagonal = std::max(diagonal_of(reference), diagonal_of(test));
  const auto by = [&](const Eigen::Affine3d& t) {
    return distance_between(transformed(reference, t), transformed(test, t));
  };
  const auto scale = [](double factor) { return Eigen::Affine3d(Eigen::Scaling(factor)); };
  for (const double factor : {1024.0, 0x1p-40}) expect_near(by(scale(factor)), expected, factor, 0.0, "powers of two");
  // Where a segment's length is close to a multiple of the spacing, rounding may add or drop a sample.
  const double spacing = diagonal / 2000.0;
  for (const double factor : {1000.0, 0.001}) {
    expect_near(by(scale(factor)), expected, factor, 1e-4 * spacing, "scaled " + std::to_string(factor));
  }
  const Eigen::Affine3d quarter(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ()));
  expect_near(by(quarter), expected, 1.0, 1e-4 * spacing, "turned by 90 degrees");
  const Eigen::Affine3d far(Eigen::Translation3d(1e5, -2e5, 3e5));
  expect_near(by(far), expected, 1.0, 1e-4 * spacing, "moved");
  // Rotated, the box has another diagonal, at most sqrt 3 times as long, so the samples are elsewhere.
  const Eigen::Affine3d turned(Eigen::AngleAxisd(1.0, Vec3(1.0, 2.0, 3.0).normalized()));
  expect_near(by(turned), expected, 1.0, 0.5 * std::numbers::sqrt3 * spacing, "turned");

  Lines backwards(reference.rbegin(), reference.rend());
  for (Segment& line : backwards) std::swap(line.from, line.to);
  expect_near(distance_between(backwards, test), expected, 1.0, 1e-12 * diagonal, "reversed");
}

TEST(LineDistance, RejectsBadArguments) {
  const Lines lines = random_lines(3, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double spacing : {0.0, -1.0, 1.01, 1e-7, nan}) {
    EXPECT_THROW(line_distance(lines, lines, {.spacing_rel = spacing}), std::invalid_argument) << spacing;
    EXPECT_THROW(line_distance({}, lines, {.spacing_rel = spacing}), std::invalid_argument) << spacing;
  }
  Lines broken = lines;
  broken[1].to.y() = nan;
  EXPECT_THROW(line_distance(broken, lines), std::invalid_argument);
  EXPECT_THROW(line_distance(lines, broken), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::metrics
