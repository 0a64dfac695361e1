#include "whittle/render/srgb.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace whittle::render {
namespace {

double srgb_of_linear(double light) {
  return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

TEST(Srgb, RoundsToTheNearestOfAllValues) {
  for (int i = 0; i <= 100'000; ++i) {
    const float light = static_cast<float>(i) / 100'000;
    const double exact = 255 * srgb_of_linear(static_cast<double>(light));
    EXPECT_NEAR(srgb8_of_linear(light), exact, 0.50001) << light;
  }
}

TEST(Srgb, ClampsLight) {
  EXPECT_EQ(srgb8_of_linear(-1), 0);
  EXPECT_EQ(srgb8_of_linear(7), 255);
  EXPECT_EQ(srgb8_of_linear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(to_8_bits(-1), 0);
  EXPECT_EQ(to_8_bits(2), 255);
  EXPECT_EQ(to_8_bits(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Srgb, IsTheInverseOfDecoding) {
  for (int i = 0; i <= 255; ++i) {
    EXPECT_NEAR(srgb_of_linear(linear_of_srgb(i / 255.0)), i / 255.0, 1e-7);
    EXPECT_EQ(srgb8_of_linear(static_cast<float>(linear_of_srgb(i / 255.0))), i);
    EXPECT_EQ(to_8_bits(static_cast<float>(i) / 255), i);
  }
}

}  // namespace
}  // namespace whittle::render
