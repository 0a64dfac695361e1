#include "whittle/render/figure.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/render/render_scenes.hh"
#include "whittle/render/draw.hh"

namespace whittle::render {
namespace {

using DrawFigure = Drawing;
using Color = std::array<int, 3>;

/// The square [-1, 1]² fills the middle half of a picture that is twice as wide as high.
const Camera from_ahead{{0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 90};
constexpr Canvas white_canvas{80, 40, {1, 1, 1}};

/// Of a surface that faces the eye: 0.35 + 0.5 + 0.15 · 0.45.
constexpr double light = 0.9175;

Layer layer_of(const IndexedMesh& mesh, const Material& material, Shade shade = Shade::full) {
  Layer layer;
  layer.part.mesh = &mesh;
  layer.part.materials = {material};
  layer.shade = shade;
  return layer;
}

TEST_F(DrawFigure, ShowsASquareInPerspective) {
  const IndexedMesh mesh = square();
  const Picture picture =
      draw_figure({{layer_of(mesh, plain_material({1, 0.5F, 0}))}, {}, {}}, from_ahead, white_canvas);
  ASSERT_EQ(picture.pixels.size(), 3200U);
  const Color lit{static_cast<int>(std::lround(255 * light)), static_cast<int>(std::lround(127.5 * light)), 0};
  for (const std::size_t x : {31U, 40U, 48U}) {
    for (const std::size_t y : {11U, 20U, 28U}) EXPECT_EQ(pixel_at(picture, x, y), lit) << x << ' ' << y;
  }
  for (const auto& [x, y] : {std::pair(29, 20), std::pair(50, 20), std::pair(40, 9), std::pair(40, 30)}) {
    EXPECT_EQ(pixel_at(picture, static_cast<std::size_t>(x), static_cast<std::size_t>(y)), (Color{255, 255, 255}));
  }
}

TEST_F(DrawFigure, ShowsBacksInTheirColour) {
  const IndexedMesh mesh = square();
  Layer layer = layer_of(mesh, plain_material({1, 1, 1}));
  layer.back = Rgb{0, 0, 1};
  const Camera from_behind{{0, 0, -2}, {0, 0, 0}, {0, 1, 0}, 90};
  const Picture picture = draw_figure({{layer}, {}, {}}, from_behind, white_canvas);
  EXPECT_EQ(pixel_at(picture, 40, 20), (Color{0, 0, static_cast<int>(std::lround(255 * light))}));
}

TEST_F(DrawFigure, ShadesColoursLessIfTheyAreToBeReadOff) {
  const IndexedMesh mesh = square();
  const auto shaded = [&](Shade shade) {
    return pixel_at(draw_figure({{layer_of(mesh, plain_material({1, 1, 1}), shade)}, {}, {}}, from_ahead, white_canvas),
                    40, 20)[0];
  };
  EXPECT_EQ(shaded(Shade::soft), std::lround(255 * (0.6 + 0.4 * light)));
  const Figure normals{{layer_of(mesh, plain_material({1, 1, 1}), Shade::normals)}, {}, {}};
  EXPECT_EQ(pixel_at(draw_figure(normals, from_ahead, white_canvas), 40, 20), (Color{128, 128, 255}));
}

TEST_F(DrawFigure, LetsWhatIsBehindShineThroughAsScreensDo) {
  const IndexedMesh behind = square(-0.1);
  const IndexedMesh in_front = square(0.1);
  const Figure figure{
      {layer_of(in_front, plain_material({0, 0, 0}, 0.25)), layer_of(behind, plain_material({1, 1, 1}))}, {}, {}};
  EXPECT_NEAR(pixel_at(draw_figure(figure, from_ahead, white_canvas), 40, 20)[0], 0.75 * 255 * light, 1);
}

TEST_F(DrawFigure, ShowsTextures) {
  const IndexedMesh mesh = square();
  const auto image = make_image(1, {0x00FF00FF});
  Scene scene = scene_of(mesh, textured(image));
  Figure figure{{layer_of(mesh, textured(image))}, {}, {}};
  figure.images = scene.images;
  EXPECT_EQ(pixel_at(draw_figure(figure, from_ahead, white_canvas), 40, 20)[1], std::lround(255 * light));
}

TEST_F(DrawFigure, HidesLinesBehindFacesUnlessToldNotTo) {
  const IndexedMesh mesh = square();
  const auto darkest = [&](double z, bool are_hidden) {
    Figure figure{{layer_of(mesh, plain_material({1, 1, 1}))}, {}, {}};
    figure.lines.push_back({{{-0.5, 0.01, z}, {0.5, 0.01, z}}, {0, 0, 0}, 1, are_hidden});
    const Picture picture = draw_figure(figure, from_ahead, white_canvas);
    int least = 255;
    for (std::size_t y = 12; y < 28; ++y) least = std::min(least, pixel_at(picture, 40, y)[0]);
    return least;
  };
  EXPECT_GT(darkest(-0.1, true), 200);
  EXPECT_LT(darkest(-0.1, false), 200);
  EXPECT_LT(darkest(0, true), 200) << "lines lie on faces";
}

TEST_F(DrawFigure, DrawsDotsAsLargeAsToldInTheirColours) {
  const IndexedMesh mesh = square(-0.2);
  Figure figure{{layer_of(mesh, plain_material({1, 1, 1}))}, {}, {}};
  figure.dots.push_back({{{-0.5, 0, 0}, {0.5, 0, 0}}, {{1, 0, 0}, {0, 0, 1}}, 6});
  const Picture picture = draw_figure(figure, from_ahead, white_canvas);
  EXPECT_EQ(pixel_at(picture, 35, 20), (Color{255, 0, 0}));
  EXPECT_EQ(pixel_at(picture, 45, 20), (Color{0, 0, 255}));
  std::size_t n_red = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) n_red += picture.pixels[i] == Rgb{1, 0, 0} ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(n_red), 36, 12);
}

/// The right half of what is symmetric is in other tiles.
TEST_F(DrawFigure, JoinsTilesWithoutASeam) {
  const IndexedMesh mesh = square();
  const Canvas canvas{1200, 1030, {1, 1, 1}};
  const Picture picture = draw_figure({{layer_of(mesh, plain_material({1, 0, 0}))}, {}, {}}, from_ahead, canvas);
  std::size_t n_different = 0;
  for (std::size_t y = 0; y < canvas.height; ++y) {
    for (std::size_t x = 0; x < canvas.width; ++x) {
      if (pixel_at(picture, x, y) != pixel_at(picture, canvas.width - 1 - x, canvas.height - 1 - y)) ++n_different;
    }
  }
  EXPECT_LE(n_different, 4U);
}

TEST_F(DrawFigure, DrawsNothingOfAnEmptyFigure) {
  const Picture picture = draw_figure({}, from_ahead, {5, 3, {0, 1, 0}});
  for (const Rgb& pixel : picture.pixels) EXPECT_EQ(pixel, (Rgb{0, 1, 0}));
}

TEST(FigureCheck, RefusesWhatCantBeDrawn) {
  EXPECT_THROW(draw_figure({}, from_ahead, {0, 3, {}}), std::invalid_argument);
  EXPECT_THROW(draw_figure({}, from_ahead, {3, 20'000, {}}), std::invalid_argument);
  EXPECT_THROW(draw_figure({{}, {{{Vec3::Zero()}}}, {}}, from_ahead, {}), std::invalid_argument);
  EXPECT_THROW(draw_figure({{}, {}, {{{Vec3::Zero()}, {}, 1}}}, from_ahead, {}), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::render
