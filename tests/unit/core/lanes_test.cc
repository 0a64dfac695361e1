// Formulas for several pairs at once, compared with the same formulas for one: each lane gets the same bits. So it does
// in the arrays that stand for vectors where the compiler has none.
#include "whittle/core/detail/lanes.hh"

#include <gtest/gtest.h>

#include <array>
#include <bit>

#include "support/random.hh"
#include "whittle/core/detail/lane_array.hh"
#include "whittle/engine/formula/flip_limit.hh"
#include "whittle/engine/formula/pair_minimum.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle::test {
namespace {

template <class Real>
class Lanes : public testing::Test {
 public:
  static constexpr std::size_t n = n_lanes<Real>;
};
using Widths = testing::Types<Double2, Double4, detail::LaneArray<double, 2>, detail::LaneArray<double, 4>>;
TYPED_TEST_SUITE(Lanes, Widths, );

/// Small integers, so some of the faces have no area.
Vec3 random_point(Random& random) {
  const auto coordinate = [&] { return static_cast<double>(random.below(7)) - 3; };
  const double x = coordinate();
  const double y = coordinate();
  return {x, y, coordinate()};
}

template <std::size_t n>
std::array<Vec3, n> random_points(Random& random) {
  std::array<Vec3, n> points;
  for (Vec3& p : points) p = random_point(random);
  return points;
}

template <class Real>
PointLanes<Real> side_by_side(const std::array<Vec3, n_lanes<Real>>& points) {
  return point_lanes<Real>([&](std::size_t i) -> const Vec3& { return points[i]; });
}

template <class Real>
QuadricLanes<Real> side_by_side(const std::array<QuadricLanes<double>, n_lanes<Real>>& quadrics) {
  constexpr std::size_t n_numbers = sizeof(QuadricLanes<double>) / sizeof(double);
  std::array<Real, n_numbers> all;
  for (std::size_t k = 0; k < n_lanes<Real>; ++k) {
    const auto one = std::bit_cast<std::array<double, n_numbers>>(quadrics[k]);
    for (std::size_t i = 0; i < n_numbers; ++i) all[i][k] = one[i];
  }
  return std::bit_cast<QuadricLanes<Real>>(all);
}

TYPED_TEST(Lanes, PairMinimaAreTheSame) {
  Random random(8);
  const auto random_quadric = [&](int n_planes) {
    Quadric sum;
    for (int i = 0; i < n_planes; ++i) {
      const Quadric plane{SymmetricMatrix::outer(random_point(random), random.uniform(0.1, 2)), Vec3::Zero(), 0};
      sum += plane.about(random_point(random));
    }
    return quadric_lanes({random_point(random), sum});
  };
  int n_near = 0;
  for (int i = 0; i < 1000; ++i) {
    std::array<QuadricLanes<double>, TestFixture::n> first, second;
    for (auto& q : first) q = random_quadric(1 + i % 4);
    for (auto& q : second) q = random_quadric(2);
    const auto all = pair_minimum(side_by_side<TypeParam>(first), side_by_side<TypeParam>(second));
    for (std::size_t k = 0; k < TestFixture::n; ++k) {
      const auto one = pair_minimum(first[k], second[k]);
      ASSERT_EQ(one.is_near, all.is_near[k] != 0);
      if (!one.is_near) continue;  // the divisor may be 0
      ++n_near;
      ASSERT_EQ(one.value, all.value[k]);
      ASSERT_EQ(Vec3(one.x, one.y, one.z), Vec3(all.x[k], all.y[k], all.z[k]));
    }
  }
  EXPECT_GT(n_near, 500);
}

TYPED_TEST(Lanes, CornerQuadricsAreTheSame) {
  Random random(3);
  for (const Weights weights : {Weights::area, Weights::uniform, Weights::area_angle}) {
    QuadricOptions options;
    options.weights = weights;
    for (int i = 0; i < 1000; ++i) {
      const auto corner = random_points<TestFixture::n>(random);
      const auto next = random_points<TestFixture::n>(random);
      const auto previous = random_points<TestFixture::n>(random);
      const auto all = corner_quadrics(side_by_side<TypeParam>(corner), side_by_side<TypeParam>(next),
                                       side_by_side<TypeParam>(previous), options);
      for (std::size_t k = 0; k < TestFixture::n; ++k) {
        const SymmetricMatrix one = corner_quadric(corner[k], next[k], previous[k], options);
        ASSERT_EQ(one.xx, all.xx[k]);
        ASSERT_EQ(one.xy, all.xy[k]);
        ASSERT_EQ(one.xz, all.xz[k]);
        ASSERT_EQ(one.yy, all.yy[k]);
        ASSERT_EQ(one.yz, all.yz[k]);
        ASSERT_EQ(one.zz, all.zz[k]);
      }
    }
  }
}

TYPED_TEST(Lanes, AFlipIsAnyLanesFlip) {
  Random random(7);
  int n_exceeded = 0;
  constexpr int n_tries = 20'000;
  for (int i = 0; i < n_tries; ++i) {
    const FlipLimit limit(30.0 * (1 + i % 6));
    const auto from = random_points<TestFixture::n>(random);
    const auto to = random_points<TestFixture::n>(random);
    const auto x = random_points<TestFixture::n>(random);
    const auto y = random_points<TestFixture::n>(random);
    bool expected = false;
    for (std::size_t k = 0; k < TestFixture::n; ++k) expected |= limit.is_exceeded(from[k], to[k], x[k], y[k]);
    ASSERT_EQ(limit.is_exceeded(side_by_side<TypeParam>(from), side_by_side<TypeParam>(to), side_by_side<TypeParam>(x),
                                side_by_side<TypeParam>(y)),
              expected)
        << i;
    n_exceeded += expected ? 1 : 0;
  }
  EXPECT_GT(n_exceeded, n_tries / 4);
  EXPECT_LT(n_exceeded, n_tries - n_tries / 50);
}

}  // namespace
}  // namespace whittle::test
