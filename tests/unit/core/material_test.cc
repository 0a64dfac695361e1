#include "whittle/core/material/material.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace whittle::test {
namespace {

TEST(MediaType, IsToldByTheFirstBytes) {
  EXPECT_EQ(media_type("\x89PNG\r\n\x1A\n and so on"), "image/png");
  EXPECT_EQ(media_type("\xFF\xD8\xFF\xE0"), "image/jpeg");
  EXPECT_EQ(media_type("RIFFsizeWEBP"), "image/webp");
  for (const char* const other : {"", "RIFF", "RIFFWEBP", "GIF89a", "root:x:0:0"}) EXPECT_EQ(media_type(other), "");
}

TEST(MediaType, IsNoneWhereACopyAsTextBrokeTheFile) {
  EXPECT_EQ(media_type("\x89PNG\n\x1A\n"), "") << "\\r\\n became \\n";
  EXPECT_EQ(media_type("\x89PNG\r\r\n\x1A\r\n"), "") << "\\n became \\r\\n";
}

TEST(BaseColorFactor, IsHiddenByATextureThatIsNotTinted) {
  using Rgba = std::array<double, 4>;
  Material material{.base_color = {0.5, 0, 0, 0.25}};
  EXPECT_EQ(base_color_factor(material), (Rgba{0.5, 0, 0, 0.25}));
  material.base_color_texture = Texture{.image = std::make_shared<const Image>()};
  EXPECT_EQ(base_color_factor(material), (Rgba{0.5, 0, 0, 0.25}));
  material.base_color_texture->is_tinted = false;
  EXPECT_EQ(base_color_factor(material), (Rgba{1, 1, 1, 0.25}));
}

}  // namespace
}  // namespace whittle::test
