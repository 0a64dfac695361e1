#pragma once

#include "whittle/core/detail/lanes.hh"
#include "whittle/engine/formula/quadric.hh"
#include "whittle/engine/formula/quadric_term.hh"

// The minimum of the sum of two quadrics, for one pair or several at once: `Real` is double, Double2 or Double4.

namespace whittle {

/// Largest distance of an optimal placement from the middle of the pair, in lengths of the pair. The planes of a long,
/// slightly conical surface nearly meet at its distant tip: without a limit a contraction there makes a spike.
/// Elsewhere the limit hardly matters: the mean error over six scans and CAD parts at 10 % and 1 % of the faces, as a
/// share of ModQuadric's, was 0.6515, 0.6509 and 0.6509 for a reach of 2, 8 and 1000.
inline constexpr double max_placement_reach = 8;

/// The elements of one placed quadric, or of several side by side.
template <class Real>
struct QuadricLanes {
  Real px, py, pz;
  Real xx, xy, xz, yy, yz, zz;
  Real bx, by, bz;
  Real c;
};

inline QuadricLanes<double> quadric_lanes(const PlacedQuadric& v) {
  const auto& [p, q] = v;
  return {p.x(), p.y(), p.z(), q.a.xx, q.a.xy, q.a.xz, q.a.yy, q.a.yz, q.a.zz, q.b.x(), q.b.y(), q.b.z(), q.c};
}

template <class Real>
struct PairMinimum {
  Real value;              ///< at least 0; 0 where there is no minimum
  Real x, y, z;            ///< where it is
  LaneMask<Real> is_near;  ///< whether there is one, and within reach
};

/// Two quadrics about the position of the first, together: the sum of both.
template <class Real>
struct QuadricSumLanes {
  Real xx, xy, xz, yy, yz, zz;
  Real bx, by, bz;
  Real c;
};

/// By LDLᵀ, which is backward stable, unlike the adjugate, which loses the small eigenvalue of a nearly flat
/// neighbourhood. There is no minimum if a pivot is below 1e-13 of the trace: rounding would decide.
/// \param from the first position \param d the second one, as seen from there
template <class Real>
WHITTLE_INLINE PairMinimum<Real> minimum_of_sum(const QuadricSumLanes<Real>& sum, const PointLanes<Real>& from,
                                                const PointLanes<Real>& d) {
  const auto& [d0, xy, xz, yy, yz, zz, bx, by, bz, c] = sum;
  const Real inverse_d0 = 1 / d0;
  const Real l10 = xy * inverse_d0;
  const Real l20 = xz * inverse_d0;
  const Real d1 = yy - l10 * xy;
  const Real inverse_d1 = 1 / d1;
  const Real e21 = yz - l20 * xy;
  const Real l21 = e21 * inverse_d1;
  const Real d2 = zz - l20 * xz - l21 * e21;
  const Real y1 = by - l10 * bx;
  const Real y2 = bz - l20 * bx - l21 * y1;
  const Real z = -y2 / d2;
  const Real scaled_y1 = y1 * inverse_d1;
  const Real scaled_bx = bx * inverse_d0;
  const Real y = -scaled_y1 - l21 * z;
  const Real x = -scaled_bx - l10 * y - l20 * z;
  const Real value = c + (y2 * z - y1 * scaled_y1 - bx * scaled_bx);

  const Real smallest_pivot = 1e-13 * (d0 + yy + zz);
  const auto exists = (d0 > smallest_pivot) & (d1 > smallest_pivot) & (d2 > smallest_pivot);
  const PointLanes<Real> from_middle{x - 0.5 * d.x, y - 0.5 * d.y, z - 0.5 * d.z};
  const Real reach_sq = (max_placement_reach * max_placement_reach) * d.dot(d);
  const LaneMask<Real> is_near = (exists & (from_middle.dot(from_middle) <= reach_sq)) != 0;
  return {select_lanes(exists & (value > 0), value, Real{}), from.x + x, from.y + y, from.z + z, is_near};
}

/// The minimum of the sum of two quadrics.
template <class Real>
WHITTLE_INLINE PairMinimum<Real> pair_minimum(const QuadricLanes<Real>& q0, const QuadricLanes<Real>& q1) {
  // Both about p0. Q₁ about p0 = p1 − d: b = b₁ − A₁ d, c = c₁ + dᵀ(A₁ d − 2 b₁).
  const PointLanes<Real> d{q1.px - q0.px, q1.py - q0.py, q1.pz - q0.pz};
  const Real tx = q1.xx * d.x + q1.xy * d.y + q1.xz * d.z;
  const Real ty = q1.xy * d.x + q1.yy * d.y + q1.yz * d.z;
  const Real tz = q1.xz * d.x + q1.yz * d.y + q1.zz * d.z;
  const Real moved_c =
      q1.c + (d.x * (tx - (q1.bx + q1.bx)) + d.y * (ty - (q1.by + q1.by)) + d.z * (tz - (q1.bz + q1.bz)));
  return minimum_of_sum<Real>({q0.xx + q1.xx, q0.xy + q1.xy, q0.xz + q1.xz, q0.yy + q1.yy, q0.yz + q1.yz, q0.zz + q1.zz,
                               q0.bx + (q1.bx - tx), q0.by + (q1.by - ty), q0.bz + (q1.bz - tz), q0.c + moved_c},
                              {q0.px, q0.py, q0.pz}, d);
}

/// The same of two quadrics without slope and constant, those of planes through their vertices.
template <class Real>
WHITTLE_INLINE PairMinimum<Real> level_pair_minimum(const SymmetricLanes<Real>& a0, const PointLanes<Real>& p0,
                                                    const SymmetricLanes<Real>& a1, const PointLanes<Real>& p1) {
  const PointLanes<Real> d = p1 - p0;
  const Real tx = a1.xx * d.x + a1.xy * d.y + a1.xz * d.z;
  const Real ty = a1.xy * d.x + a1.yy * d.y + a1.yz * d.z;
  const Real tz = a1.xz * d.x + a1.yz * d.y + a1.zz * d.z;
  return minimum_of_sum<Real>({a0.xx + a1.xx, a0.xy + a1.xy, a0.xz + a1.xz, a0.yy + a1.yy, a0.yz + a1.yz, a0.zz + a1.zz,
                               -tx, -ty, -tz, d.x * tx + d.y * ty + d.z * tz},
                              p0, d);
}

}  // namespace whittle
