#pragma once

#include "whittle/engine/lanes.hh"

// Lindstrom–Turk inside a surface, where two things fix v̄: the volume is kept, and the squared volumes are least. For
// one pair or for several at once: `Real` is double, Double2 or Double4. lindstrom_turk.hh has the rest.

namespace whittle {

inline constexpr double lindstrom_turk_volume_weight = 0.5;  ///< λ

/// ε: a cost is greater by ε λ tr(A) / 36 · (|v̄ − v0|² + |v̄ − v1|²) / 2, A that of Σ (6 V_t)². On flat ground, where
/// nothing else does, that tells near pairs from far ones.
inline constexpr double lindstrom_turk_regularization = 1e-9;

/// Square of the sine of the least angle between a constraint and what those before it fix: 1°.
inline constexpr double least_constraint_sine_sq = 3.0458649045213493e-4;

/// A gradient's share of its quadric's trace below which rounding decides its direction.
inline constexpr double constraint_noise_share = 1e-10;

/// `VolumeSums`, for one pair or several side by side.
template <class Real>
struct VolumeLanes {
  PointLanes<Real> normal;
  Real offset;
  Real xx, xy, xz, yy, yz, zz;
  PointLanes<Real> b;
  Real c;

  [[gnu::always_inline]] PointLanes<Real> times(const PointLanes<Real>& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
};

template <class Real>
struct VolumePlacement {
  PointLanes<Real> position;
  Real cost;                     ///< with what regularises it
  LaneMask<Real> is_determined;  ///< whether the constraints are independent; if not, nothing else counts
};

/// What regularises a cost, but for λ / 36.
template <class Real>
[[gnu::always_inline]] inline Real spread_cost(const Real& trace, const PointLanes<Real>& to_first,
                                               const PointLanes<Real>& to_second) {
  return (0.5 * lindstrom_turk_regularization) * trace * (to_first.dot(to_first) + to_second.dot(to_second));
}

/// \param first, second v0 and v1 as seen from the sums' origin
template <class Real>
[[gnu::always_inline]] inline VolumePlacement<Real> place_by_volume(const VolumeLanes<Real>& sums,
                                                                    const PointLanes<Real>& first,
                                                                    const PointLanes<Real>& second) {
  const Real trace = sums.xx + sums.yy + sums.zz;
  Real length = sums.normal.dot(sums.normal);
  const auto has_volume = length > (constraint_noise_share * constraint_noise_share) * trace;
  take_square_roots(length);
  const Real inverse_length = 1 / length;
  const PointLanes<Real> n{sums.normal.x * inverse_length, sums.normal.y * inverse_length,
                           sums.normal.z * inverse_length};
  const Real n_value = sums.offset * inverse_length;

  // Two unit vectors perpendicular to n and to one another. \cite duff_2017_basis
  const Real sign = n.z < 0 ? Real{} - 1 : Real{} + 1;
  const Real p = -1 / (sign + n.z);
  const Real q = n.x * n.y * p;
  const PointLanes<Real> along1{1 + sign * n.x * n.x * p, sign * q, -sign * n.x};
  const PointLanes<Real> along2{q, sign + n.y * n.y * p, -n.y};

  const PointLanes<Real> row1 = sums.times(along1);
  const PointLanes<Real> row2 = sums.times(along2);
  const Real value1 = -along1.dot(sums.b);
  const Real value2 = -along2.dot(sums.b);
  const Real row1_sq = row1.dot(row1);
  const Real row2_sq = row2.dot(row2);
  const Real noise = constraint_noise_share * trace;
  const Real noise_sq = noise * noise;
  const Real cosine = n.dot(row1);
  const PointLanes<Real> fixed = n.cross(row1);
  const Real sine = fixed.dot(row2);  // the determinant, too
  const auto is_determined = has_volume & (row1_sq > noise_sq) & (row2_sq > noise_sq) &
                             (cosine * cosine < (1 - least_constraint_sine_sq) * row1_sq) &
                             (sine * sine > least_constraint_sine_sq * fixed.dot(fixed) * row2_sq);

  const PointLanes<Real> c12 = row1.cross(row2);
  const PointLanes<Real> c20 = row2.cross(n);
  const Real inverse = 1 / sine;
  const PointLanes<Real> x{(n_value * c12.x + value1 * c20.x + value2 * fixed.x) * inverse,
                           (n_value * c12.y + value1 * c20.y + value2 * fixed.y) * inverse,
                           (n_value * c12.z + value1 * c20.z + value2 * fixed.z) * inverse};
  const PointLanes<Real> ax = sums.times(x);
  const PointLanes<Real> slope{2 * sums.b.x + ax.x, 2 * sums.b.y + ax.y, 2 * sums.b.z + ax.z};
  const Real squares = sums.c + x.dot(slope);
  const Real spread = spread_cost(trace, x - first, x - second);
  const Real cost = (lindstrom_turk_volume_weight / 36) * ((squares > 0 ? squares : Real{}) + spread);
  return {x, cost, is_determined != 0};
}

}  // namespace whittle
