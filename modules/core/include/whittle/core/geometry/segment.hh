#pragma once

#include <algorithm>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Parameter of the closest point on a segment: 0 at `from`, 1 at `to`. The ends may coincide.
template <class Point>
double nearest_share(const Point& point, const Point& from, const Point& to) {
  const Point way = to - from;
  const double length_sq = way.squaredNorm();
  return length_sq > 0 ? std::clamp((point - from).dot(way) / length_sq, 0.0, 1.0) : 0;
}

/// The closest point on a segment. The ends may coincide.
inline Vec3 nearest_on_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double t = (point - from).dot(along), end = along.squaredNorm();
  if (!(t > 0.0)) return from;
  if (t >= end) return to;
  return from + (t / end) * along;
}

/// Squared distance of a point from a segment.
inline double distance_sq_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  return (point - from - nearest_share(point, from, to) * (to - from)).squaredNorm();
}

}  // namespace whittle
