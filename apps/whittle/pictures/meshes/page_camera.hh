#pragma once

#include "pictures/picture_view.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/render/figure.hh"

namespace whittle::app {

/// Looks at all of a box from the front, a little from above and from the side, unless the view says otherwise.
/// \param aspect width of the picture over its height
render::Camera page_camera(const Box& box, const PictureView& view, double aspect);

/// Where a point is in a picture, in pixels from its middle.
class Projection {
 public:
  Projection(const render::Camera& camera, double height);

  /// How long a segment looks, in pixels; 0 if all of it is beyond one side of the picture, or an end behind the eye.
  double seen_length(const Vec3& a, const Vec3& b, double width) const;

 private:
  Vec3 eye_;
  Eigen::Matrix3d axes_;  ///< rows: right, up, towards the eye
  double height_;
  double scale_;  ///< pixels a unit at distance 1
};

}  // namespace whittle::app
