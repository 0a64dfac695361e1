#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/render/render_scenes.hh"
#include "whittle/render/picture_error.hh"

namespace whittle::render {
namespace {

Picture grey_picture(float value) {
  Picture picture{4, 4, std::vector<Rgb>(16, {value, value, value}), std::vector<float>(16, 0)};
  picture.coverage[5] = 1;
  return picture;
}

TEST(Psnr, IsInfiniteForEqualPictures) {
  EXPECT_EQ(psnr(grey_picture(0.5F), grey_picture(0.5F)), infinity);
  EXPECT_EQ(psnr(Picture{}, Picture{}), infinity);
}

TEST(Psnr, IsThatOfTheFormula) {
  // 10 log10(255² / 51²) where all numbers differ by 51.
  EXPECT_NEAR(psnr(grey_picture(0.2F), grey_picture(0.4F)), 20 * std::log10(5.0), 1e-5);
  EXPECT_NEAR(psnr(grey_picture(0), grey_picture(1), PixelSet::all), 0, 1e-12);
}

TEST(Psnr, CountsPixelsWhereOneOfBothShowsTheModel) {
  Picture a = grey_picture(0.5F);
  Picture b = a;
  b.pixels[0] = {1, 1, 1};
  EXPECT_EQ(psnr(a, b), infinity);
  EXPECT_NEAR(psnr(a, b, PixelSet::all), 20 * std::log10(2.0) + 10 * std::log10(16.0), 1e-6);
  b.coverage[0] = 0.25F;
  EXPECT_NEAR(psnr(a, b), 20 * std::log10(2.0) + 10 * std::log10(2.0), 1e-6);
  EXPECT_EQ(psnr(a, b), psnr(b, a));
  b.coverage.clear();
  EXPECT_EQ(psnr(a, b), psnr(a, b, PixelSet::all));
}

TEST(Psnr, RefusesPicturesOfOtherSizes) {
  Picture wide = grey_picture(0);
  wide.width = 8;
  wide.height = 2;
  EXPECT_THROW(psnr(grey_picture(0), wide), std::invalid_argument);
}

using PsnrOfPictures = Drawing;

TEST_F(PsnrOfPictures, FallsWithEachTexelThatATextureMoves) {
  std::vector<std::uint32_t> pixels;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double distance = std::hypot(x - 31.5, y - 31.5) / 32;
      const auto value = static_cast<std::uint32_t>(255 * std::exp(-4 * distance * distance));
      pixels.push_back(value << 24 | (255 - value) << 16 | 0x80FF);
    }
  }
  const IndexedMesh mesh = square();
  Material material = textured(make_image(64, pixels));
  const Picture original = draw(scene_of(mesh, material), from_front(), {128, 4});
  double last_psnr = infinity;
  double last_flip = 0;
  for (int shift = 1; shift <= 8; ++shift) {
    material.base_color_texture->transform.translate(Eigen::Vector2d(1.0 / 64, 0));
    const Picture moved = draw(scene_of(mesh, material), from_front(), {128, 4});
    EXPECT_LT(psnr(original, moved), last_psnr) << shift;
    EXPECT_GT(flip(original, moved), last_flip) << shift;
    last_psnr = psnr(original, moved);
    last_flip = flip(original, moved);
  }
}

}  // namespace
}  // namespace whittle::render
