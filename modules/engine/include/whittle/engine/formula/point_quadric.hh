#pragma once

#include "whittle/engine/formula/pair_minimum.hh"

namespace whittle {

/// Σ W |x − p|² over the vertices merged into one: W the weight of a vertex's planes, p its position in the input. Kept
/// as W_sum |x − center|² + spread.
struct PointQuadric {
  Vec3 center = Vec3::Zero();
  double weight = 0;
  double spread = 0;

  friend PointQuadric operator+(const PointQuadric& a, const PointQuadric& b) {
    const double sum = a.weight + b.weight;
    if (!(sum > 0)) return {};
    const double share = b.weight / sum;
    const Vec3 between = b.center - a.center;
    return {a.center + share * between, sum, a.spread + b.spread + a.weight * share * between.squaredNorm()};
  }
};

template <class Real>
struct PointQuadricLanes {
  PointLanes<Real> center;
  Real weight, spread;
};

/// Adds `factor` times the points.
template <class Real>
WHITTLE_INLINE void add_points(QuadricLanes<Real>& v, const PointQuadricLanes<Real>& points, double factor) {
  const Real weight = factor * points.weight;
  const auto offset = PointLanes<Real>{v.px, v.py, v.pz} - points.center;
  v.xx += weight, v.yy += weight, v.zz += weight;
  v.bx += weight * offset.x, v.by += weight * offset.y, v.bz += weight * offset.z;
  v.c += weight * offset.dot(offset) + factor * points.spread;
}

/// v and `factor` times its points.
inline PlacedQuadric with_points(const PlacedQuadric& v, const PointQuadric& points, double factor) {
  QuadricLanes<double> sum = quadric_lanes(v);
  add_points(sum, {point_lanes(points.center), points.weight, points.spread}, factor);
  return {v.position, {{sum.xx, sum.xy, sum.xz, sum.yy, sum.yz, sum.zz}, {sum.bx, sum.by, sum.bz}, sum.c}};
}

}  // namespace whittle
