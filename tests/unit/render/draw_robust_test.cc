// What a picture doesn't depend on, and scenes that are not as they should be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <thread>

#include "support/meshes.hh"
#include "unit/render/render_scenes.hh"

namespace whittle::render {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using DrawRobust = Drawing;

void expect_equal(const Picture& a, const Picture& b) {
  EXPECT_TRUE(a.pixels == b.pixels);
  EXPECT_TRUE(a.coverage == b.coverage);
}

Scene textured_box(const IndexedMesh& box) { return scene_of(box, textured(colorful_image())); }

TEST_F(DrawRobust, GivesTheSameBytesAgain) {
  const IndexedMesh box = box_with_seams();
  const Scene scene = textured_box(box);
  const std::vector<View> views = views_around(bounding_sphere(scene), 4);
  Renderer first(scene, views[0].sphere, {});
  Renderer second(scene, views[0].sphere, {});
  for (const View& view : views) {
    const Picture picture = first.draw(view);
    expect_equal(picture, second.draw(view));
    expect_equal(picture, first.draw(view));
    expect_equal(picture, draw(scene, view));
  }
}

TEST_F(DrawRobust, GivesTheSameBytesOnAnotherThread) {
  const IndexedMesh box = box_with_seams();
  const Scene scene = textured_box(box);
  const View view = view_from(bounding_sphere(scene), {1, 2, 3});
  Renderer renderer(scene, view.sphere);
  const Picture here = renderer.draw(view);
  Picture there;
  std::thread([&] { there = renderer.draw(view); }).join();
  expect_equal(here, there);
}

TEST_F(DrawRobust, HasColorsOfEightBits) {
  const IndexedMesh box = box_with_seams();
  const Picture picture = draw(textured_box(box), view_from({Vec3::Zero(), 2}, {1, 2, 3}), {64, 4});
  for (const Rgb& pixel : picture.pixels) {
    for (const float value : pixel) EXPECT_EQ(value, std::round(value * 255) / 255);
  }
}

TEST_F(DrawRobust, IsTheSameFarFromTheOriginAndInOtherUnits) {
  const IndexedMesh box = box_with_seams();
  const Scene scene = textured_box(box);
  const Picture expected = draw(scene, view_from(bounding_sphere(scene), {1, 2, 3}), {64, 4});
  for (const double unit : {0x1p-300, 0x1p10, 0x1p300}) {
    Eigen::Affine3d place = Eigen::Affine3d::Identity();
    place.scale(unit).translate(Vec3(4096, -8192, 1024));
    const Scene moved = scene_of(box, textured(colorful_image()), place);
    expect_equal(expected, draw(moved, view_from(bounding_sphere(moved), {1, 2, 3}), {64, 4}));
  }
}

void expect_sound(const Picture& picture) {
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    for (const float value : picture.pixels[i]) ASSERT_TRUE(value >= 0 && value <= 1) << i;
    ASSERT_TRUE(picture.coverage[i] >= 0 && picture.coverage[i] <= 1) << i;
  }
}

TEST_F(DrawRobust, LeavesOutFacesThatAreNone) {
  IndexedMesh mesh = square();
  const Picture expected = draw(textured_box(mesh), from_front(), {64, 4});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.positions.insert(mesh.positions.end(),
                        {{nan, 0, 1}, {std::numeric_limits<double>::infinity(), 0, 1}, {0, 0, 0}});
  mesh.attributes[0].values.insert(mesh.attributes[0].values.end(), {nan, nan, 0, 0, 1e300, -1e300});
  mesh.faces.insert(mesh.faces.end(), {{0, 1, 4}, {0, 5, 2}, {1, 1, 2}, {0, 6, 2}});
  const Picture picture = draw(textured_box(mesh), from_front(), {64, 4});
  expect_equal(expected, picture);
}

TEST_F(DrawRobust, SurvivesNumbersThatAreNone) {
  IndexedMesh mesh = smooth_octahedron();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  mesh.normals = {{nan, 0, 0}, {0, 0, 0}, {1e-30F, 0, 0}, {1e30F, 1e30F, 0}, {0, 0, -1}, {0, 0, nan}};
  mesh.colors = {{nan, 1, 1, 1}, {2, -1, 0, 1}, {1, 1, 1, nan}, {1, 1, 1, 1}, {0, 0, 0, 0}, {1, 1, 1, 1}};
  mesh.attributes = {texcoords({{std::nan(""), 0}, {1e300, 0}, {-1e30, 1e30}, {0, 0}, {1, 1}, {0.5, 0.5}})};
  for (const Alpha mode : {Alpha::opaque, Alpha::mask, Alpha::blend}) {
    Material material = textured(colorful_image());
    material.alpha_mode = mode;
    for (const double flat : {1.0, 0.0, -1e-200}) {
      Eigen::Affine3d place = Eigen::Affine3d::Identity();
      place.scale(Vec3(1, 1, flat));
      const Scene scene = scene_of(mesh, material, place);
      for (const View& view : views_around(bounding_sphere(scene), 3)) expect_sound(draw(scene, view, {32, 4}));
    }
  }
}

TEST_F(DrawRobust, ShowsTheBackgroundWhereThereIsNothing) {
  const IndexedMesh empty;
  Scene flat = scene_of(empty);
  Eigen::Affine3d nowhere = Eigen::Affine3d::Identity();
  nowhere.linear().setZero();
  const IndexedMesh box = box_with_seams();
  for (const Scene& scene : {Scene{}, flat, scene_of(box, {}, nowhere)}) {
    EXPECT_EQ(bounding_sphere(scene).radius, 1);
    const Picture picture = draw(scene, view_from(bounding_sphere(scene), Vec3::UnitX()), {16, 1});
    EXPECT_THAT(picture.pixels, ::testing::Each(Rgb{background, background, background}));
    EXPECT_THAT(picture.coverage, ::testing::Each(0));
  }
}

TEST_F(DrawRobust, RefusesWhatIsOutOfRange) {
  const IndexedMesh mesh = square();
  const Scene scene = scene_of(mesh);
  for (const DrawOptions& options : {DrawOptions{0, 4}, {4097, 1}, {64, 0}, {64, 5}, {64, 81}, {2048, 25}, {64, -4}}) {
    EXPECT_THROW(draw(scene, from_front(), options), std::invalid_argument) << options.size << " " << options.samples;
  }
  IndexedMesh broken = square();
  broken.faces.push_back({0, 1, 4});
  EXPECT_THROW(draw(scene_of(broken), from_front()), std::invalid_argument);
  broken = square();
  broken.normals.resize(3);
  EXPECT_THROW(draw(scene_of(broken), from_front()), std::invalid_argument);
  broken = square();
  broken.face_groups = {0};
  EXPECT_THROW(draw(scene_of(broken), from_front()), std::invalid_argument);
  broken = square();
  broken.wedges = {0, 1, 2, 0, 2, 9};
  EXPECT_THROW(draw(scene_of(broken), from_front()), std::invalid_argument);
  Scene short_of_pixels = scene_of(mesh, textured(colorful_image()));
  short_of_pixels.images.begin()->second.rgba.pop_back();
  EXPECT_THROW(draw(short_of_pixels, from_front()), std::invalid_argument);
  EXPECT_THROW(draw({{Part{}}}, from_front()), std::invalid_argument);
}

// A process of its own: EGL is loaded once.
TEST(DrawWithoutOpenGl, SaysInOneLineWhatIsMissing) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto try_without_driver = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1);
    const IndexedMesh mesh = square();
    try {
      draw(scene_of(mesh), from_front());
    } catch (const std::runtime_error& error) {
      std::fprintf(stderr, "%s", error.what());
      std::exit(7);
    }
  };
  EXPECT_EXIT(try_without_driver(), ::testing::ExitedWithCode(7), "^cannot draw: [^\n]*Debian's package lib[^\n]*$");
}

}  // namespace
}  // namespace whittle::render
