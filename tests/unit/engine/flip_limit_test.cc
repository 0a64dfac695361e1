#include "whittle/engine/formula/flip_limit.hh"

#include <gtest/gtest.h>

#include <numbers>

namespace whittle::test {
namespace {

/// The third corner of a face over the edge (x, y), rotated about that edge by an angle.
Vec3 turned_corner(double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return Vec3(0.3, std::cos(angle), std::sin(angle));
}
const Vec3 x(0, 0, 0);
const Vec3 y(1, 0, 0);

TEST(FlipLimit, IsTheAngleTheNormalTurnsBy) {
  for (const double limit : {5.0, 45.0, 89.0, 90.0, 91.0, 120.0, 179.0}) {
    const FlipLimit flip_limit(limit);
    EXPECT_FALSE(flip_limit.is_exceeded(turned_corner(0), turned_corner(limit - 0.01), x, y)) << limit;
    EXPECT_TRUE(flip_limit.is_exceeded(turned_corner(0), turned_corner(limit + 0.01), x, y)) << limit;
    EXPECT_TRUE(flip_limit.is_exceeded(turned_corner(0), turned_corner(-limit - 0.01), x, y)) << limit;
  }
}

TEST(FlipLimit, At180DegreesOnlyALostAreaIsTooMuch) {
  const FlipLimit flip_limit(180);
  EXPECT_FALSE(flip_limit.is_exceeded(turned_corner(0), turned_corner(180), x, y));
  EXPECT_TRUE(flip_limit.is_exceeded(turned_corner(0), Vec3(0.4, 0, 0), x, y)) << "on the edge";
  EXPECT_TRUE(flip_limit.is_exceeded(turned_corner(0), x, x, y)) << "on a corner";
}

TEST(FlipLimit, AFaceWithoutAreaHasNoDirectionToKeep) {
  const FlipLimit flip_limit(10);
  for (const double angle : {0.0, 90.0, 180.0}) {
    EXPECT_FALSE(flip_limit.is_exceeded(Vec3(0.4, 0, 0), turned_corner(angle), x, y)) << angle;
  }
}

}  // namespace
}  // namespace whittle::test
