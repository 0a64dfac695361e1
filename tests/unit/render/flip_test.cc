#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "whittle/render/picture_error.hh"

namespace whittle::render {
namespace {

/// A picture of 8-bit colours. \param color gives red, green, blue of a column and row, 0 … 255
template <class ColorAt>
Picture picture_of_colors(int width, int height, const ColorAt& color) {
  Picture picture{static_cast<std::size_t>(width), static_cast<std::size_t>(height), {}, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::array<int, 3> rgb = color(x, y);
      picture.pixels.push_back(
          {static_cast<float>(rgb[0]) / 255, static_cast<float>(rgb[1]) / 255, static_cast<float>(rgb[2]) / 255});
    }
  }
  return picture;
}

Picture plain(std::array<int, 3> rgb) {
  return picture_of_colors(24, 16, [&](int, int) { return rgb; });
}

int wave(int t, int period) { return 255 * std::abs(2 * (t % period) - period) / period; }

Picture waves() {
  return picture_of_colors(96, 64, [](int x, int y) { return std::array{wave(x, 40), wave(y, 25), wave(x + y, 90)}; });
}
Picture other_waves() {
  return picture_of_colors(96, 64, [](int x, int y) {
    return std::array{wave(x + 2, 40), wave(y, 27), (x / 8 + y / 8) % 2 * 200};
  });
}
Picture less_green_waves() {
  return picture_of_colors(96, 64, [](int x, int y) {
    return std::array{wave(x, 40), wave(y, 25) * 3 / 4, wave(x + y, 90)};
  });
}

TEST(Flip, IsZeroForEqualPictures) {
  EXPECT_EQ(flip(waves(), waves()), 0);
  EXPECT_THAT(flip_map(waves(), waves()).values, ::testing::Each(0));
}

TEST(Flip, IsSymmetric) { EXPECT_EQ(flip_map(waves(), other_waves()).values, flip_map(other_waves(), waves()).values); }

TEST(Flip, IsBetweenZeroAndOne) {
  const Picture noise = picture_of_colors(64, 64, [](int x, int y) {
    return std::array{(x * 7919 + y * 104729) % 2 * 255, (x * 31 + y * 17) % 2 * 255, (x / 3 + y / 5) % 2 * 255};
  });
  Picture inverse = noise;
  for (Rgb& pixel : inverse.pixels) {
    for (float& value : pixel) value = 1 - value;
  }
  for (const double pixels_per_degree : {1.0, 10.0, 67.0, 1000.0}) {
    for (const float value : flip_map(noise, inverse, pixels_per_degree).values) {
      ASSERT_TRUE(value >= 0 && value <= 1) << pixels_per_degree;
    }
  }
}

// Means that the program by the authors of the paper (version 1.6) prints for the same pictures. Its matrix of sRGB has
// other digits.
TEST(Flip, AgreesWithTheAuthorsProgram) {
  struct Row {
    Picture a, b;
    double pixels_per_degree, mean;
  };
  const Row rows[] = {
      {waves(), other_waves(), 67, 0.737189},
      {waves(), other_waves(), 20, 0.753458},
      {waves(), other_waves(), 120, 0.716588},
      {waves(), less_green_waves(), 67, 0.552275},
      {waves(), less_green_waves(), 20, 0.497646},
      {waves(), less_green_waves(), 120, 0.603526},
      {plain({0, 0, 0}), plain({255, 255, 255}), 67, 0.967395},
      {plain({128, 128, 128}), plain({138, 128, 128}), 67, 0.125694},
  };
  for (const Row& row : rows) {
    EXPECT_NEAR(flip(row.a, row.b, row.pixels_per_degree), row.mean, 1e-5) << row.pixels_per_degree;
  }
}

/// HyAB of two colours in CIELAB with Hunt's effect, from the formulas alone.
double hunt_hyab(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const auto lab = [](const std::array<double, 3>& rgb) {
    const auto curve = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29; };
    const double x = curve((0.4123908 * rgb[0] + 0.3575843 * rgb[1] + 0.1804808 * rgb[2]) / 0.9504559);
    const double y = curve(0.2126390 * rgb[0] + 0.7151687 * rgb[1] + 0.0721923 * rgb[2]);
    const double z = curve((0.0193308 * rgb[0] + 0.1191948 * rgb[1] + 0.9505322 * rgb[2]) / 1.0890578);
    const double lightness = 116 * y - 16;
    return std::array{lightness, lightness / 100 * 500 * (x - y), lightness / 100 * 200 * (y - z)};
  };
  const std::array<double, 3> p = lab(a);
  const std::array<double, 3> q = lab(b);
  return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

double decoded(int value) {
  const double x = value / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

// Blurring changes nothing, and there are no edges: what is left is the distance of two colours.
TEST(Flip, HasTheValueOfTheFormulaForPlainPictures) {
  const double largest = std::pow(hunt_hyab({0, 1, 0}, {0, 0, 1}), 0.7);
  const std::array<int, 3> colors[] = {{0, 0, 0},       {255, 255, 255}, {0, 255, 0},   {0, 0, 255},
                                       {128, 128, 128}, {138, 128, 128}, {128, 128, 96}};
  for (const auto& a : colors) {
    for (const auto& b : colors) {
      const double distance = std::pow(
          hunt_hyab({decoded(a[0]), decoded(a[1]), decoded(a[2])}, {decoded(b[0]), decoded(b[1]), decoded(b[2])}), 0.7);
      const double knee = 0.4 * largest;
      const double expected =
          distance < knee ? 0.95 * distance / knee : 0.95 + 0.05 * (distance - knee) / (largest - knee);
      EXPECT_NEAR(flip(plain(a), plain(b)), expected, 2e-4) << a[0] << a[1] << a[2] << " " << b[0] << b[1] << b[2];
    }
  }
  EXPECT_NEAR(flip(plain({0, 255, 0}), plain({0, 0, 255})), 1, 1e-6);
}

TEST(Flip, GrowsWithContrast) {
  double last = 0;
  for (const int contrast : {2, 5, 10, 20, 50, 100}) {
    const Picture stripes = picture_of_colors(64, 64, [&](int x, int) {
      return std::array{128 + x / 8 % 2 * contrast, 128, 128 - x / 8 % 2 * contrast};
    });
    const double found = flip(stripes, picture_of_colors(64, 64, [](int, int) { return std::array{128, 128, 128}; }));
    EXPECT_GT(found, last) << contrast;
    last = found;
  }
}

TEST(Flip, SeesNoDetailThatIsTooFineForTheEye) {
  const Picture grey = picture_of_colors(64, 64, [](int, int) { return std::array{188, 188, 188}; });
  const Picture checks = picture_of_colors(64, 64, [](int x, int y) {
    return std::array<int, 3>{(x + y) % 2 * 255, (x + y) % 2 * 255, (x + y) % 2 * 255};
  });
  EXPECT_LT(flip(grey, checks, 1000), flip(grey, checks, 20));
}

TEST(Flip, DoesNotDependOnWhereThePictureIsMirrored) {
  const auto mirrored = [](const Picture& picture) {
    Picture result = picture;
    for (std::size_t y = 0; y < picture.height; ++y) {
      const auto row = result.pixels.begin() + static_cast<std::ptrdiff_t>(y * picture.width);
      std::reverse(row, row + static_cast<std::ptrdiff_t>(picture.width));
    }
    return result;
  };
  EXPECT_NEAR(flip(waves(), other_waves()), flip(mirrored(waves()), mirrored(other_waves())), 1e-7);
}

TEST(Flip, RefusesWhatCannotBeCompared) {
  EXPECT_THROW(flip(waves(), plain({0, 0, 0})), std::invalid_argument);
  EXPECT_THROW(flip(Picture{}, Picture{}), std::invalid_argument);
  for (const double pixels_per_degree : {0.0, -1.0, 1001.0, std::nan("")}) {
    EXPECT_THROW(flip(waves(), waves(), pixels_per_degree), std::invalid_argument);
  }
}

TEST(ErrorMap, IsShownFromBlackToPaleYellow) {
  const Picture picture = picture_of(ErrorMap{5, 1, {0, 0.25F, 0.5F, 0.75F, 1}});
  ASSERT_EQ(picture.pixels.size(), 5);
  EXPECT_LT(picture.pixels[0][0] + picture.pixels[0][1] + picture.pixels[0][2], 0.1F);
  EXPECT_GT(picture.pixels[4][0] + picture.pixels[4][1] + picture.pixels[4][2], 2.5F);
  for (std::size_t i = 1; i < 5; ++i) EXPECT_GT(picture.pixels[i][1], picture.pixels[i - 1][1]);
}

}  // namespace
}  // namespace whittle::render
