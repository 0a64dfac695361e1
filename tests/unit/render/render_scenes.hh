#pragma once

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "whittle/render/draw.hh"

namespace whittle::render {

// Small scenes, and what tests of pictures share.

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Tests that draw say "skipped" where there is no OpenGL.
class Drawing : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const auto why = why_nothing_can_be_drawn()) GTEST_SKIP() << *why;
  }
};

using Uv = std::array<double, 2>;

/// Texture coordinates of all wedges, as the attribute TEXCOORD_0.
Attribute texcoords(const std::vector<Uv>& values);

/// The square [-1, 1]² at height z, seen from +z, with texture coordinates (0, 0) at its upper left corner.
IndexedMesh square(double z = 0);

/// A box [-1, 1]³, whose six sides have the whole texture each: every vertex has three wedges.
IndexedMesh box_with_seams();

/// An octahedron around the origin with normals away from it.
IndexedMesh smooth_octahedron();

/// An image out of numbers 0 … 0xRRGGBBAA, row by row.
std::shared_ptr<const Image> make_image(std::size_t width, const std::vector<std::uint32_t>& pixels);

/// 8 × 8 pixels that all differ, opaque.
std::shared_ptr<const Image> colorful_image();

/// A scene of one mesh, which has to outlive it, with decoded images.
Scene scene_of(const IndexedMesh& mesh, const Material& material = {},
               const Eigen::Affine3d& transform = Eigen::Affine3d::Identity());

Material textured(std::shared_ptr<const Image> image, const std::array<Wrap, 2>& wrap = {});

/// From +z, so that [-1, 1]² fills the picture but for the margin.
View from_front();

/// The colour of a pixel, from 0 to 255. (0, 0) is the upper left one.
std::array<int, 3> pixel_at(const Picture& picture, std::size_t x, std::size_t y);

}  // namespace whittle::render
