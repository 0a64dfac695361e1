#pragma once

#include "whittle/core/detail/lanes.hh"
#include "whittle/core/detail/portable_math.hh"

namespace whittle {

/// How far a face may turn when one of its corners moves.
class FlipLimit {
 public:
  /// \param max_angle_deg (0, 180]; at 180 only a face that loses its area is beyond the limit
  explicit FlipLimit(double max_angle_deg)
      : least_cosine_(max_angle_deg < 180 ? detail::cosine_of_deg(max_angle_deg) : never),
        signed_min_cosine_sq_(max_angle_deg < 180 ? signed_square<double>(least_cosine_) : never) {}

  /// The least cosine between a face's normals before and after; below all cosines if there is no limit.
  double least_cosine() const { return least_cosine_; }

  /// Whether faces have an area. \param normal_sq the square of twice the area \param arm, opposite two of their sides
  template <class Real>
  WHITTLE_INLINE static auto has_area(const Real& normal_sq, const PointLanes<Real>& arm,
                                      const PointLanes<Real>& opposite) {
    return normal_sq > (no_area_sine_sq * opposite.dot(opposite)) * arm.dot(arm);
  }

  /// Whether the face (corner, x, y) turns further, or loses its area, when its corner moves. A face that has no area
  /// has no direction to keep.
  bool is_exceeded(const Vec3& from, const Vec3& to, const Vec3& x, const Vec3& y) const {
    return is_exceeded(point_lanes(from), point_lanes(to), point_lanes(x), point_lanes(y));
  }
  /// Whether one of several faces side by side does.
  template <class Real>
  WHITTLE_INLINE bool is_exceeded(const PointLanes<Real>& from, const PointLanes<Real>& to, const PointLanes<Real>& x,
                                  const PointLanes<Real>& y) const {
    const auto opposite = y - x;
    const auto arm_before = x - from;
    const auto arm_after = x - to;
    const auto before = arm_before.cross(opposite);
    const auto after = arm_after.cross(opposite);
    const Real before_sq = before.dot(before);
    const Real after_sq = after.dot(after);
    // before · after < cos · |before| |after|, without the root.
    const Real cosine = before.dot(after);
    const auto turns = signed_square(cosine) < signed_min_cosine_sq_ * (before_sq * after_sq);
    const auto had_area = has_area(before_sq, arm_before, opposite);
    const auto keeps_area = has_area(after_sq, arm_after, opposite);
    return any_lane((had_area & (turns | (keeps_area == 0))) != 0);
  }

 private:
  /// Square of the sine of a corner's angle below which a face has no area: its normal would be mostly rounding, which
  /// is about 1e-16 over the sine.
  static constexpr double no_area_sine_sq = 1e-20;
  static constexpr double never = -2;  ///< below all cosines, with rounding

  template <class Real>
  WHITTLE_INLINE static Real signed_square(const Real& x) {
    return x * select_lanes(x < 0, -x, x);
  }

  double least_cosine_;
  double signed_min_cosine_sq_;
};

}  // namespace whittle
