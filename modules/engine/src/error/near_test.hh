#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "whittle/core/geometry/proof/linked_faces.hh"

namespace whittle {

/// Tells of points whether they are near to one face. Right up to rounding.
class NearTest {
 public:
  /// For few points.
  static NearTest of_corners(const Corners& corners) { return NearTest(corners, Unprepared{}); }

  /// For many points. \param corners two may be one
  explicit NearTest(const Corners& corners) : corners_(corners) {
    const auto& [a, b, c] = corners;
    const double longest_sq = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const Vec3 normal = area_normal(a, b, c);
    const double length = normal.norm();
    if (!(length > thin * longest_sq)) return;
    normal_ = normal / length;
    for (std::size_t i = 0; i < 3; ++i) {
      inward_[i] = normal_.cross(corners[(i + 1) % 3] - corners[i]);
      least_[i] = inward_[i].dot(corners[i] - a);
    }
  }

  bool is_within(const Vec3& point, double reach) const {
    const Vec3 from_first = point - corners_[0];
    if (std::abs(normal_.dot(from_first)) > reach) return false;
    const bool is_over_face = inward_[0].dot(from_first) >= least_[0] && inward_[1].dot(from_first) >= least_[1] &&
                              inward_[2].dot(from_first) >= least_[2];
    return is_over_face || distance_to(corners_, point) <= reach;
  }

  /// The last point of a segment that is over the face, if its first one is; else the first one. \pre prepared for many
  Vec3 last_over(const Vec3& first, const Vec3& last) const {
    double way = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double inside_at_first = inward_[i].dot(first - corners_[0]) - least_[i];
      const double inside_at_last = inward_[i].dot(last - corners_[0]) - least_[i];
      if (!(inside_at_first >= 0)) return first;
      if (inside_at_last < 0) way = std::min(way, inside_at_first / (inside_at_first - inside_at_last));
    }
    return first + way * (last - first);
  }

 private:
  struct Unprepared {};
  NearTest(const Corners& corners, Unprepared) : corners_(corners) {}

  static constexpr double thin = 1e-6;  ///< height over length below which the normal is too inexact

  Corners corners_;
  // Of a thin face, or one for few points, there is no normal, and nothing is over it.
  Vec3 normal_ = Vec3::Zero();
  std::array<Vec3, 3> inward_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};        ///< per side, in the plane
  std::array<double, 3> least_{std::numeric_limits<double>::infinity(), 0, 0};  ///< along these from the first corner
};

}  // namespace whittle
