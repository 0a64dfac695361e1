#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hh"
#include "unit/render/image_files.hh"
#include "whittle/render/picture.hh"
#include "whittle/render/pixels.hh"

namespace whittle::render {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// 13 × 9 pixels of all kinds of colours, 8 bits each.
Picture sample_picture() {
  Picture picture{13, 9, {}, {}};
  for (int i = 0; i < 13 * 9; ++i) {
    picture.pixels.push_back(
        {static_cast<float>(i * 2) / 255, static_cast<float>(255 - i) / 255, static_cast<float>(i * 37 % 256) / 255});
  }
  return picture;
}

TEST(WritePng, IsReadBackAsItWas) {
  const Picture picture = sample_picture();
  const Pixels texture = read_image(write_png(picture));
  ASSERT_EQ(texture.width, 13);
  ASSERT_EQ(texture.height, 9);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(static_cast<float>(texture.rgba[4 * i + k]) / 255, picture.pixels[i][k]) << i;
    }
    EXPECT_EQ(texture.rgba[4 * i + 3], 255);
  }
}

TEST(WritePng, RefusesAPictureWithoutPixels) {
  EXPECT_THROW(write_png({}), std::invalid_argument);
  EXPECT_THROW(write_png({4, 4, std::vector<Rgb>(15), {}}), std::invalid_argument);
}

TEST(SideBySide, PutsPicturesInARow) {
  const Picture a{1, 2, {{0, 0, 0}, {1, 1, 1}}, {}};
  const Picture b{2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}, {}};
  const Picture row = side_by_side({a, b});
  EXPECT_EQ(row.width, 3);
  EXPECT_EQ(row.height, 2);
  EXPECT_THAT(row.pixels,
              ElementsAre(Rgb{0, 0, 0}, Rgb{1, 0, 0}, Rgb{0, 1, 0}, Rgb{1, 1, 1}, Rgb{0, 0, 1}, Rgb{1, 1, 0}));
  EXPECT_THROW(side_by_side({a, {1, 1, {{0, 0, 0}}, {}}}), std::invalid_argument);
}

TEST(ReadPng, ReadsEveryKindOfPixel) {
  // Two pixels: with as many numbers as the kind has.
  EXPECT_THAT(read_image(png_file({.kind = PngKind::gray, .bits = 8}, {10, 200})).rgba,
              ElementsAre(10, 10, 10, 255, 200, 200, 200, 255));
  EXPECT_THAT(read_image(png_file({.kind = PngKind::gray, .bits = 1}, {0x40})).rgba,
              ElementsAre(0, 0, 0, 255, 255, 255, 255, 255));
  EXPECT_THAT(read_image(png_file({.kind = PngKind::gray_alpha, .bits = 8}, {10, 20, 200, 40})).rgba,
              ElementsAre(10, 10, 10, 20, 200, 200, 200, 40));
  EXPECT_THAT(read_image(png_file({.kind = PngKind::rgb, .bits = 8}, {1, 2, 3, 4, 5, 6})).rgba,
              ElementsAre(1, 2, 3, 255, 4, 5, 6, 255));
  EXPECT_THAT(read_image(png_file({.kind = PngKind::rgba, .bits = 8}, {1, 2, 3, 4, 5, 6, 7, 8})).rgba,
              ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(read_image(png_file({.kind = PngKind::gray, .bits = 16}, {0x80, 0x80, 0xFF, 0xFF})).rgba,
              ElementsAre(0x80, 0x80, 0x80, 255, 255, 255, 255, 255));
  EXPECT_THAT(read_image(png_file({.kind = PngKind::palette, .bits = 8}, {1, 0})).rgba,
              ElementsAre(7, 8, 9, 255, 1, 2, 3, 255));
}

TEST(ReadPng, IgnoresGamma) {
  const std::vector<std::uint8_t> pixels = {10, 20, 30, 100, 150, 250};
  EXPECT_EQ(read_image(png_file({.kind = PngKind::rgb, .bits = 8, .gamma = 1.0}, pixels)).rgba,
            read_image(png_file({.kind = PngKind::rgb, .bits = 8}, pixels)).rgba);
}

TEST(ReadPng, ReadsInterlacedFiles) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 2 * 50 * 3; ++i) pixels.push_back(static_cast<std::uint8_t>(i));
  EXPECT_EQ(read_image(png_file({.kind = PngKind::rgb, .bits = 8, .height = 50, .is_interlaced = true}, pixels)).rgba,
            read_image(png_file({.kind = PngKind::rgb, .bits = 8, .height = 50}, pixels)).rgba);
}

/// 16 × 16 pixels that change slowly, as JPEG likes it; `n_channels` numbers each.
std::vector<std::uint8_t> smooth_pixels(int n_channels) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 256; ++i) {
    for (int k = 0; k < n_channels; ++k)
      pixels.push_back(static_cast<std::uint8_t>(100 + i / 16 * (3 + k) + i % 16 * (5 - k)));
  }
  return pixels;
}

TEST(ReadJpeg, ReadsColorAndGray) {
  for (const int n_channels : {1, 3}) {
    for (const bool is_progressive : {false, true}) {
      const std::vector<std::uint8_t> pixels = smooth_pixels(n_channels);
      const Pixels texture = read_image(jpeg_file(16, n_channels, is_progressive, pixels));
      ASSERT_EQ(texture.width, 16);
      ASSERT_EQ(texture.rgba.size(), 1024);
      for (std::size_t i = 0; i < 256; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t channel = n_channels == 1 ? 0 : k;
          EXPECT_NEAR(texture.rgba[4 * i + k], pixels[i * static_cast<std::size_t>(n_channels) + channel], 4);
        }
        EXPECT_EQ(texture.rgba[4 * i + 3], 255);
      }
    }
  }
}

TEST(ReadJpeg, ReadsInvertedCmyk) {
  const std::vector<std::uint8_t> pixels = smooth_pixels(4);
  const Pixels texture = read_image(jpeg_file(16, 4, false, pixels));
  for (std::size_t i = 0; i < 256; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(texture.rgba[4 * i + k], pixels[4 * i + k] * pixels[4 * i + 3] / 255, 4);
    }
  }
}

TEST(ReadImage, RefusesTruncatedFiles) {
  const std::string files[] = {write_png(sample_picture()), jpeg_file(16, 3, false, smooth_pixels(3)),
                               jpeg_file(16, 3, true, smooth_pixels(3))};
  for (const std::string& file : files) {
    read_image(file);
    for (std::size_t n = 0; n + 2 < file.size(); ++n) {
      EXPECT_THROW(read_image(std::string_view(file).substr(0, n)), std::runtime_error) << n << " of " << file.size();
    }
  }
}

TEST(ReadImage, RefusesOtherBytesInOneLine) {
  for (const std::string& bytes : {std::string(), std::string("GIF89a"), std::string(100, '\0'),
                                   std::string("\x89PNG\r\n\x1A\n") + std::string(100, 'x'),
                                   std::string("\xFF\xD8\xFF") + std::string(100, 'x')}) {
    try {
      read_image(bytes);
      ADD_FAILURE();
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), ::testing::Not(HasSubstr("\n")));
      EXPECT_THAT(error.what(), HasSubstr("image"));
    }
  }
}

TEST(ReadImage, SurvivesDamagedFiles) {
  test::Random random(5);
  const std::string files[] = {write_png(sample_picture()), jpeg_file(16, 3, false, smooth_pixels(3)),
                               jpeg_file(16, 4, true, smooth_pixels(4)),
                               png_file({.kind = PngKind::palette, .bits = 8}, {1, 0})};
  for (int i = 0; i < 4000; ++i) {
    std::string damaged = files[i % 4];
    for (std::uint64_t n = random.below(4) + 1; n > 0; --n)
      damaged[random.below(damaged.size())] = static_cast<char>(random.bits());
    try {
      const Pixels texture = read_image(damaged);
      EXPECT_EQ(texture.rgba.size(), 4 * texture.width * texture.height);
    } catch (const std::runtime_error&) {
    }
  }
}

TEST(ReadImage, RefusesSidesThatAreTooLong) {
  std::string file = write_png(sample_picture());
  EXPECT_THROW(read_image(with_png_width(file, 16385)), std::runtime_error);
}

}  // namespace
}  // namespace whittle::render
