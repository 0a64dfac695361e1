// Whole pictures against a ray caster.
#include "whittle/render/draw.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/render/ray_caster.hh"
#include "unit/render/render_scenes.hh"

namespace whittle::render {
namespace {

constexpr int size = 96;
constexpr std::array<Wrap, 2> clamped = {Wrap::clamp_to_edge, Wrap::clamp_to_edge};

/// Rounding to 8 bits is half a step. Inside of triangles one more: filters of textures round, too. At edges a sample
/// may fall on the other side: OpenGL rounds vertices to 1/256 of a sample. No view may be so steep that a texture is
/// drawn smaller than it is.
void expect_picture(const Scene& scene, const View& view) {
  const RayCast expected = cast_rays(scene, view, size, 2);
  const PictureDeviation found = deviation(expected, draw(scene, view, {size, 4}));
  EXPECT_LT(found.largest_inside, 1.6 / 255);
  EXPECT_LT(found.mean, 0.6 / 255);
  EXPECT_GT(found.n_inside, size * size / 2);
}

using Draw = Drawing;

TEST_F(Draw, ShowsATextureOnASquare) {
  const IndexedMesh mesh = square();
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
    Material material = textured(colorful_image(), {wrap, Wrap::repeat});
    material.base_color_texture->transform.translate(Eigen::Vector2d(-0.7, 0.3)).scale(1.9).rotate(0.3);
    expect_picture(scene_of(mesh, material), from_front());
  }
}

TEST_F(Draw, ShowsKnownTexelsAtKnownPixels) {
  const IndexedMesh mesh = square();
  const auto image = make_image(2, {0xFF0000FF, 0x00FF00FF, 0x0000FFFF, 0xFFFFFFFF});
  const Picture picture = draw(scene_of(mesh, textured(image, clamped)), from_front(), {256, 4});
  // Seen from the front, light is 0.3 + 0.6: sRGB 243.
  EXPECT_EQ(pixel_at(picture, 16, 16), (std::array<int, 3>{243, 0, 0}));
  EXPECT_EQ(pixel_at(picture, 239, 16), (std::array<int, 3>{0, 243, 0}));
  EXPECT_EQ(pixel_at(picture, 16, 239), (std::array<int, 3>{0, 0, 243}));
  EXPECT_EQ(pixel_at(picture, 239, 239), (std::array<int, 3>{243, 243, 243}));
  EXPECT_EQ(pixel_at(picture, 0, 0), (std::array<int, 3>{128, 128, 128}));
  EXPECT_EQ(picture.coverage[0], 0);
  EXPECT_EQ(picture.coverage[256 * 128 + 128], 1);
}

TEST_F(Draw, ShowsTheColorWhereATextureThatHidesItCantBeShown) {
  IndexedMesh mesh = square();
  Material material = textured(make_image(1, {0x00FF00FF}));
  material.base_color = {1, 0, 0, 1};
  material.base_color_texture->is_tinted = false;
  const auto color = [&] { return pixel_at(draw(scene_of(mesh, material), from_front(), {32, 4}), 16, 16); };
  EXPECT_EQ(color(), (std::array<int, 3>{0, 243, 0}));
  mesh.attributes.clear();
  EXPECT_EQ(color(), (std::array<int, 3>{243, 0, 0}));
}

TEST(DecodeImages, TriesEachOnceAndSaysWhichAreNone) {
  const IndexedMesh mesh;
  Scene scene = scene_of(mesh);
  const auto none = std::make_shared<const Image>(Image{.name = "image 3", .bytes = "GIF89a"});
  const auto lost = std::make_shared<const Image>(Image{.name = "texture a.png", .problem = "it is lost"});
  const auto sound = colorful_image();
  scene.parts[0].materials = {textured(none), {}, textured(sound), textured(lost), textured(none)};
  EXPECT_THAT(decode_images(scene), ::testing::ElementsAre("image 3 is not drawn: an image is neither PNG nor JPEG",
                                                           "texture a.png is not drawn: it is lost"));
  ASSERT_EQ(scene.images.size(), 1U);
  EXPECT_EQ(scene.images.at(sound).width, 8U);
}

TEST_F(Draw, ShowsBothSidesOfASeam) {
  const IndexedMesh mesh = box_with_seams();
  const Scene scene = scene_of(mesh, textured(colorful_image()));
  for (const View& view : views_around(bounding_sphere(scene), 7)) expect_picture(scene, view);
}

TEST_F(Draw, ShadesWithNormalsOfVertices) {
  const IndexedMesh mesh = smooth_octahedron();
  const Scene scene = scene_of(mesh);
  for (const View& view : views_around(bounding_sphere(scene), 5)) expect_picture(scene, view);
}

TEST_F(Draw, TurnsFacesAndNormalsWhereTheTransformMirrors) {
  IndexedMesh mesh = smooth_octahedron();
  std::vector<Uv> uvs;
  for (const Vec3& p : mesh.positions) uvs.push_back({0.5 + 0.4 * p[0] + 0.1 * p[2], 0.5 + 0.4 * p[1] + 0.2 * p[2]});
  mesh.attributes = {texcoords(uvs)};
  Eigen::Affine3d mirror = Eigen::Affine3d::Identity();
  mirror.translate(Vec3(5, -3, 2)).rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).scale(Vec3(-2, 1, 0.6));
  const Scene scene = scene_of(mesh, textured(colorful_image()), mirror);
  for (const View& view : views_around(bounding_sphere(scene), 5)) expect_picture(scene, view);
  // Without normals, too.
  mesh.normals.clear();
  for (const View& view : views_around(bounding_sphere(scene), 5)) expect_picture(scene, view);
}

TEST_F(Draw, HidesWhatIsBehind) {
  const IndexedMesh box = box_with_seams();
  const IndexedMesh ball = smooth_octahedron();
  Scene scene = scene_of(box, textured(colorful_image()));
  Material red;
  red.base_color = {0.8, 0.1, 0.1, 1};
  for (const double shift : {-1.5, 0.2, 1.5}) {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    place.translate(Vec3(shift, 0.3, -shift)).scale(1.1);
    scene.parts.push_back(scene_of(ball, red, place).parts[0]);
  }
  for (const Vec3& to_eye : {Vec3(1, 2, 3), Vec3(-2, 1, 1), Vec3(2, -1, -2), Vec3(-1, -2, 1.5)}) {
    expect_picture(scene, view_from(bounding_sphere(scene), to_eye));
  }
}

TEST_F(Draw, LeavesOutBackFacesUnlessBothSidesCount) {
  const IndexedMesh mesh = square();
  const View behind = view_from({Vec3::Zero(), 1}, -Vec3::UnitZ());
  const Picture nothing = draw(scene_of(mesh), behind, {32, 4});
  EXPECT_THAT(nothing.coverage, ::testing::Each(0));
  Material both;
  both.double_sided = true;
  const Scene scene = scene_of(mesh, both);
  expect_picture(scene, behind);
  EXPECT_EQ(pixel_at(draw(scene, behind, {32, 4}), 16, 16), (std::array<int, 3>{243, 243, 243}));
}

TEST_F(Draw, MultipliesWithVertexColors) {
  IndexedMesh mesh = smooth_octahedron();
  for (const float share : {0.0F, 0.15F, 0.3F, 0.5F, 0.7F, 1.0F}) mesh.colors.push_back({share, 1 - share, 0.3F, 1});
  Material material;
  material.base_color = {0.9, 0.7, 0.8, 1};
  Scene scene = scene_of(mesh, material);
  for (const ColorEncoding encoding : {ColorEncoding::linear, ColorEncoding::srgb}) {
    scene.parts[0].vertex_colors = encoding;
    expect_picture(scene, views_around(bounding_sphere(scene), 3)[1]);
  }
}

TEST_F(Draw, TakesMaterialsByFaceGroup) {
  IndexedMesh mesh = box_with_seams();
  for (Index f = 0; f < 12; ++f) mesh.face_groups.push_back(f / 2 % 4);
  Scene scene = scene_of(mesh, textured(colorful_image()));
  Material green;
  green.base_color = {0.1, 0.6, 0.2, 1};
  Material other = textured(make_image(2, {0x102030FF, 0xF0E0D0FF, 0x80FF80FF, 0xFF8080FF}));
  other.base_color_texture->transform.scale(0.5);
  scene.parts[0].materials.push_back(green);
  scene.parts[0].materials.push_back(other);  // group 3 has none
  decode_images(scene);
  for (const View& view : views_around(bounding_sphere(scene), 5)) expect_picture(scene, view);
}

TEST_F(Draw, CutsHolesWithAMask) {
  const IndexedMesh front = square(0.5);
  const IndexedMesh behind = square(-0.5);
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t i = 0; i < 16; ++i) pixels.push_back(0x40A060FFU - (i % 3) * 0x70);
  Material material = textured(make_image(4, pixels), clamped);
  material.alpha_mode = Alpha::mask;
  material.alpha_cutoff = 0.6;
  Scene scene = scene_of(front, material);
  scene.parts.push_back(scene_of(behind).parts[0]);
  const Picture picture = draw(scene, from_front(), {64, 4});
  const RayCast expected = cast_rays(scene, from_front(), 64, 2);
  // The edge of a hole isn't an edge of a triangle: whole pixels may differ in a sample.
  EXPECT_LT(deviation(expected, picture).mean, 0.8 / 255);
  EXPECT_NEAR(pixel_at(picture, 20, 4)[1], pixel_at(expected.picture, 20, 4)[1], 1);
  material.alpha_mode = Alpha::opaque;
  expect_picture(scene_of(front, material), from_front());
}

TEST_F(Draw, BlendsFromBackToFront) {
  const IndexedMesh near = square(0.6);
  const IndexedMesh middle = square(0);
  const IndexedMesh far = square(-0.6);
  const auto glass = [](double r, double g, double b, double opacity) {
    Material material;
    material.base_color = {r, g, b, opacity};
    material.alpha_mode = Alpha::blend;
    material.double_sided = true;
    return material;
  };
  Scene scene = scene_of(near, glass(0.9, 0.1, 0.1, 0.4));
  scene.parts.push_back(scene_of(far, glass(0.1, 0.1, 0.9, 0.7)).parts[0]);
  scene.parts.push_back(scene_of(middle, glass(0.1, 0.9, 0.2, 0.5)).parts[0]);
  expect_picture(scene, from_front());
  expect_picture(scene, view_from({Vec3::Zero(), 1.6}, {0.5, 0.3, -1}));
}

TEST_F(Draw, FiltersTexturesInLinearLight) {
  const IndexedMesh mesh = square();
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t i = 0; i < 1024 * 1024; ++i) pixels.push_back((i ^ (i >> 10)) & 1 ? 0xFFFFFFFF : 0xFF);
  const Picture picture = draw(scene_of(mesh, textured(make_image(1024, pixels))), from_front(), {32, 4});
  const double light = 0.5 * 0.9;
  const double srgb = 255 * (1.055 * std::pow(light, 1 / 2.4) - 0.055);
  for (std::size_t x = 4; x < 28; ++x) EXPECT_NEAR(pixel_at(picture, x, 16)[0], srgb, 1.5) << x;
}

}  // namespace
}  // namespace whittle::render
