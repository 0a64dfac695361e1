#include "whittle/core/detail/portable_math.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/random.hh"

namespace whittle::detail {
namespace {

constexpr int n_tries = 20'000;

/// How far `value` is from what it should be, in units of the last place.
/// \param noise of the system's function, where that is more than such a unit
double ulps(double value, long double exact, double noise = 0) {
  const double size = std::abs(static_cast<double>(exact));
  const double ulp = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return static_cast<double>(std::abs(value - exact) / std::max(ulp, noise));
}

/// A number whose order of magnitude is random.
double random_size(test::Random& random, double least_exponent, double most_exponent) {
  return std::ldexp(random.uniform(0.5, 1), static_cast<int>(random.uniform(least_exponent, most_exponent)));
}

TEST(PortableMath, CosinesAreRight) {
  test::Random random(1);
  for (int i = 0; i < n_tries; ++i) {
    const double angle_deg = random.uniform(0, 180);
    const double angle = angle_deg * std::numbers::pi / 180;
    ASSERT_LE(ulps(cosine_of_deg(angle_deg), std::cos(static_cast<long double>(angle)), 1e-19), 1) << angle_deg;
  }
  EXPECT_EQ(cosine_of_deg(0), 1);
  EXPECT_EQ(cosine_of_deg(60), 0.50000000000000011);  // of the double next to π/3
  EXPECT_EQ(cosine_of_deg(90), 6.123233995736766e-17);
  EXPECT_EQ(cosine_of_deg(180), -1);
}

TEST(PortableMath, HypotenusesAreRight) {
  test::Random random(2);
  for (int i = 0; i < n_tries; ++i) {
    const double x = random_size(random, -20, 20);
    const double y = -random_size(random, -20, 20);
    ASSERT_LE(ulps(hypotenuse(x, y), std::hypot(static_cast<long double>(x), static_cast<long double>(y))), 1);
  }
  EXPECT_EQ(hypotenuse(0, 0), 0);
  EXPECT_EQ(hypotenuse(3e300, -4e300), 5e300);
  EXPECT_EQ(hypotenuse(3e-300, 0), 3e-300);
  EXPECT_EQ(hypotenuse(1, -std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
}

TEST(PortableMath, AnglesAreRight) {
  test::Random random(3);
  for (int i = 0; i < n_tries; ++i) {
    const double y = random_size(random, -10, 10);
    const double x = random_size(random, -10, 10) * (i % 2 == 0 ? 1 : -1);
    ASSERT_LE(ulps(angle_of(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))), 3);
  }
  EXPECT_EQ(angle_of(0, 1), 0);
  EXPECT_EQ(angle_of(0, 0), 0);
  EXPECT_EQ(angle_of(0, -1), std::numbers::pi);
  EXPECT_EQ(angle_of(2, 0), std::numbers::pi / 2);
  EXPECT_EQ(angle_of(1e-200, 1e-200), std::numbers::pi / 4);
}

TEST(PortableMath, LogarithmsAreRight) {
  test::Random random(4);
  for (int i = 0; i < n_tries; ++i) {
    const double x = random_size(random, -40, 40);
    ASSERT_LE(ulps(log_of_one_plus(x), std::log1p(static_cast<long double>(x))), 2) << x;
  }
  EXPECT_EQ(log_of_one_plus(0), 0);
}

TEST(PortableMath, PowersAreRight) {
  test::Random random(5);
  for (int i = 0; i < n_tries; ++i) {
    const double base = random_size(random, -100, 100);
    const double exponent = random.uniform(0, 1);
    const long double exact = std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
    ASSERT_LE(ulps(power(base, exponent), exact), 2) << base << ' ' << exponent;
  }
  EXPECT_EQ(power(0, 0), 1);
  EXPECT_EQ(power(0, 0.5), 0);
  EXPECT_EQ(power(7, 1), 7);
  EXPECT_EQ(power(0x1p-30, 2.5), 0x1p-75);
  EXPECT_EQ(power(0x1p31, 2.5), 0x1p77 * std::numbers::sqrt2);
  EXPECT_EQ(power(0x1p1000, 3), std::numeric_limits<double>::infinity());
  EXPECT_EQ(power(0x1p-1000, 3), 0);
}

}  // namespace
}  // namespace whittle::detail
