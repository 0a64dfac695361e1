#pragma once

#include <vector>

#include "whittle/render/draw.hh"

namespace whittle::render {

/// What a picture should be, by shooting a ray through each sample at every triangle. Shares no code with the module.
/// Textures are read at full size: they must not be drawn smaller.
struct RayCast {
  Picture picture;
  /// For each pixel: whether its samples, and those around it, see the same triangles. Elsewhere rounding may matter.
  std::vector<bool> is_inside;
};

RayCast cast_rays(const Scene& scene, const View& view, int size, int grid);

/// How far a picture is from what it should be.
struct PictureDeviation {
  double largest_inside;  ///< over the pixels inside triangles, [0, 1]
  double mean;            ///< over the whole picture, [0, 1]
  std::size_t n_inside;
};

PictureDeviation deviation(const RayCast& expected, const Picture& picture);

}  // namespace whittle::render
