#include "intersections/predicates.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "support/random.hh"

namespace whittle::metrics {
namespace {

using test::Random;
__extension__ using Int128 = __int128;
using IntegerPoint = std::array<std::int64_t, 3>;

int sign(Int128 x) { return (x > 0) - (x < 0); }

int exact_orient3d(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c, const IntegerPoint& d) {
  std::array<std::array<Int128, 3>, 3> m{};
  const std::array<const IntegerPoint*, 3> rows{&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = Int128{(*rows[i])[j]} - d[j];
  }
  return sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
              m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

/// Integers below 2^40 are exact in doubles, and their determinants, below 6·2^123, in 128 bits.
Vec3 as_point(const IntegerPoint& p, double unit) {
  return Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])) * unit;
}

IntegerPoint random_point(Random& random, std::int64_t limit) {
  IntegerPoint p{};
  for (auto& x : p) x = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(2 * limit + 1))) - limit;
  return p;
}

TEST(Predicates, Orient3dIsPositiveBelowACounterclockwiseFace) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orient3d(a, b, c, Vec3(0, 0, -1)), 1);
  EXPECT_EQ(orient3d(a, b, c, Vec3(0, 0, 1)), -1);
  EXPECT_EQ(orient3d(a, b, c, Vec3(5, 7, 0)), 0);
}

TEST(Predicates, Orient2dIsPositiveForALeftTurn) {
  const Vec3 a(0, 0, 9), b(1, 0, -9), c(0, 1, 3);
  EXPECT_EQ(orient2d(a, b, c, 0, 1), 1);
  EXPECT_EQ(orient2d(a, b, c, 1, 0), -1);
  EXPECT_EQ(orient2d(a, b, Vec3(4, 0, 1), 0, 1), 0);
}

TEST(Predicates, Orient3dIsExactOnNearlyFlatIntegers) {
  // d is a combination of the other points: on their plane, or a few units off it.
  int zeros = 0, nonzeros = 0;
  for (const double unit : {1.0, 0x1p-70, 0x1p60}) {
    Random random(1);
    for (int i = 0; i < 20'000; ++i) {
      const std::int64_t limit = std::int64_t{1} << random.below(36);
      const IntegerPoint a = random_point(random, limit), b = random_point(random, limit);
      const IntegerPoint c = random_point(random, limit), off = random_point(random, i % 3);
      const auto s = static_cast<std::int64_t>(random.below(5)) - 2, t = static_cast<std::int64_t>(random.below(5)) - 2;
      IntegerPoint d{};
      for (std::size_t k = 0; k < 3; ++k) d[k] = a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]) + off[k];
      const int expected = exact_orient3d(a, b, c, d);
      ++(expected == 0 ? zeros : nonzeros);
      ASSERT_EQ(orient3d(as_point(a, unit), as_point(b, unit), as_point(c, unit), as_point(d, unit)), expected)
          << "case " << i << ", unit " << unit;
    }
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(nonzeros, 1000);
}

TEST(Predicates, Orient3dIsExactOnMixedMagnitudes) {
  // Differences that don't fit into a double: coordinates of very different size, on a plane except for one unit.
  for (int i = -3; i <= 3; ++i) {
    const double tiny = i * 0x1p-40;
    const Vec3 a(0x1p60, 0, 1), b(0, 0x1p60, 1), c(-0x1p60, -0x1p60, 1), d(3, 5, 1 + tiny);
    EXPECT_EQ(orient3d(a, b, c, d), i > 0 ? -1 : i < 0 ? 1 : 0) << i;
  }
}

TEST(Predicates, Orient2dIsExactNearALine) {
  // Kettner et al.: Classroom Examples of Robustness Problems in Geometric Computations. Points a few units in the last
  // place around (0.5, 0.5), against the line through (12, 12) and (24, 24). In units of 2^-53 all are integers.
  const auto exact = [](std::int64_t px, std::int64_t py) {
    const std::int64_t one = std::int64_t{1} << 53;
    const Int128 q = Int128{12} * one, r = Int128{24} * one;
    return sign((q - px) * (r - py) - (q - py) * (r - px));
  };
  const Vec3 q(12, 12, 0), r(24, 24, 0);
  int zeros = 0;
  for (std::int64_t i = 0; i < 64; ++i) {
    for (std::int64_t j = 0; j < 64; ++j) {
      const std::int64_t px = (std::int64_t{1} << 52) + i, py = (std::int64_t{1} << 52) + j;
      const Vec3 p(static_cast<double>(px) * 0x1p-53, static_cast<double>(py) * 0x1p-53, 0);
      ASSERT_EQ(orient2d(p, q, r, 0, 1), exact(px, py)) << i << ", " << j;
      ASSERT_EQ(orient2d(q, r, p, 0, 1), exact(px, py)) << i << ", " << j;
      if (exact(px, py) == 0) ++zeros;
    }
  }
  EXPECT_EQ(zeros, 64);
}

TEST(Predicates, ChangeSignWithTheOrder) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& x : p) x = as_point(random_point(random, 3), 0.1);  // rounded, and often nearly on one plane
    const int s = orient3d(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(orient3d(p[1], p[0], p[2], p[3]), -s);
    ASSERT_EQ(orient3d(p[1], p[2], p[0], p[3]), s);
    ASSERT_EQ(orient3d(p[3], p[1], p[2], p[0]), -s);
    ASSERT_EQ(orient3d(p[2], p[3], p[0], p[1]), s);
    ASSERT_EQ(orient2d(p[0], p[1], p[2], 0, 2), -orient2d(p[1], p[0], p[2], 0, 2));
    ASSERT_EQ(orient2d(p[0], p[1], p[2], 0, 2), orient2d(p[1], p[2], p[0], 0, 2));
  }
}

}  // namespace
}  // namespace whittle::metrics
