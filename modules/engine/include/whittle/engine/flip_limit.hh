#pragma once

#include <cmath>
#include <numbers>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// How far a face may turn when one of its corners moves.
class FlipLimit {
 public:
  /// \param max_angle_deg (0, 180]; at 180 only a face that loses its area is too much
  explicit FlipLimit(double max_angle_deg)
      : signed_min_cosine_sq_(signed_square(std::cos(max_angle_deg * std::numbers::pi / 180))) {}

  /// Whether the face (corner, x, y) turns further, or loses its area, when its corner moves. A face that has no area
  /// has no direction to keep.
  bool is_exceeded(const Vec3& from, const Vec3& to, const Vec3& x, const Vec3& y) const {
    const Vec3 opposite = y - x;
    const Vec3 arm_before = x - from;
    const Vec3 arm_after = x - to;
    const Vec3 before = arm_before.cross(opposite);
    const Vec3 after = arm_after.cross(opposite);
    const double before_sq = before.squaredNorm();
    const double after_sq = after.squaredNorm();
    const double no_area_sq = no_area_sine_sq * opposite.squaredNorm();
    if (before_sq <= no_area_sq * arm_before.squaredNorm()) return false;
    if (after_sq <= no_area_sq * arm_after.squaredNorm()) return true;
    // before · after < cos · |before| |after|, without the root.
    return signed_square(before.dot(after)) < signed_min_cosine_sq_ * (before_sq * after_sq);
  }

 private:
  /// Square of the sine of a corner's angle below which a face has no area: its normal would be mostly rounding, which
  /// is about 1e-16 over the sine.
  static constexpr double no_area_sine_sq = 1e-20;

  static double signed_square(double x) { return x * std::abs(x); }

  double signed_min_cosine_sq_;
};

}  // namespace whittle
