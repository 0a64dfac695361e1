#pragma once

#include "whittle/core/detail/lanes.hh"

// Lindstrom–Turk inside a surface. Three things fix v̄: the volume is kept; the squared volumes are least; and where
// these leave a choice, as on flat ground and along creases, the squared distances to the neighbours are least. For one
// pair or several at once: `Real` is double, Double2 or Double4. lindstrom_turk.hh has the rest.

namespace whittle {

inline constexpr double lindstrom_turk_volume_weight = 0.5;  ///< λ

/// ε: a cost is greater by ε λ tr(A) / 36 · (|v̄ − v0|² + |v̄ − v1|²) / 2, A that of Σ (6 V_t)². On flat ground, where
/// nothing else does, that tells near pairs from far ones.
inline constexpr double lindstrom_turk_regularization = 1e-9;

/// Square of the sine of the least angle between a constraint and what those before it fix: 1°.
inline constexpr double least_constraint_sine_sq = 3.0458649045213493e-4;

/// A gradient's share of its quadric's trace below which rounding decides its direction.
inline constexpr double constraint_noise_share = 1e-10;

/// Sums over faces, about some origin.
template <class Real>
struct VolumeLanes {
  PointLanes<Real> normal;  ///< Σ n
  Real offset;              ///< Σ n · p
  // Σ (n · (x − p))² = xᵀ A x + 2 b · x + c
  Real xx, xy, xz, yy, yz, zz;
  PointLanes<Real> b;
  Real c;

  /// Without a face through the origin. \param n its normal, as long as twice its area
  WHITTLE_INLINE void remove(const PointLanes<Real>& n) {
    normal = normal - n;
    xx -= n.x * n.x;
    xy -= n.x * n.y;
    xz -= n.x * n.z;
    yy -= n.y * n.y;
    yz -= n.y * n.z;
    zz -= n.z * n.z;
  }
  WHITTLE_INLINE Real trace() const { return xx + yy + zz; }
  WHITTLE_INLINE PointLanes<Real> times(const PointLanes<Real>& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
};

/// Sums over neighbours, about some origin.
template <class Real>
struct NeighbourLanes {
  PointLanes<Real> position;  ///< Σ p
  Real n;
};

/// Constraints a · x = b on v̄, the rows a of any length.
template <class Real>
struct VolumeConstraints {
  PointLanes<Real> normal;         ///< of unit length: volume preservation
  PointLanes<Real> second, third;  ///< volume optimisation
  Real normal_value, second_value, third_value;
  LaneMask<Real> has_normal;  ///< if not, nothing else counts
  LaneMask<Real> has_second;  ///< if not, `second` is any direction across `normal`, and has no value yet
  LaneMask<Real> has_third;
};

template <class Real>
struct VolumePlacement {
  PointLanes<Real> position;
  Real cost;  ///< with its regularisation
};

/// The regularisation of a cost, without the factor λ / 36.
template <class Real>
WHITTLE_INLINE Real spread_cost(const Real& trace, const PointLanes<Real>& to_first,
                                const PointLanes<Real>& to_second) {
  return (0.5 * lindstrom_turk_regularization) * trace * (to_first.dot(to_first) + to_second.dot(to_second));
}

/// s · p + t · q
template <class Real>
WHITTLE_INLINE PointLanes<Real> combined(const Real& s, const PointLanes<Real>& p, const Real& t,
                                         const PointLanes<Real>& q) {
  return {s * p.x + t * q.x, s * p.y + t * q.y, s * p.z + t * q.z};
}

template <class Mask, class Real>
WHITTLE_INLINE PointLanes<Real> choose(const Mask& condition, const PointLanes<Real>& yes, const PointLanes<Real>& no) {
  return {select_lanes(condition, yes.x, no.x), select_lanes(condition, yes.y, no.y),
          select_lanes(condition, yes.z, no.z)};
}

/// Two unit vectors perpendicular to a third one and to one another.
template <class Real>
struct NormalBasis {
  PointLanes<Real> u, v;
};

/// \cite duff_2017_basis
template <class Real>
WHITTLE_INLINE NormalBasis<Real> basis_across(const PointLanes<Real>& n) {
  const Real sign = select_lanes(n.z < 0, Real{} - 1, Real{} + 1);
  const Real p = -1 / (sign + n.z);
  const Real q = n.x * n.y * p;
  return {{1 + sign * n.x * n.x * p, sign * q, -sign * n.x}, {q, sign + n.y * n.y * p, -n.y}};
}

/// The direction in which a quadric on a plane grows most, in a basis of it; the one in which it grows least is
/// (−sine, cosine).
template <class Real>
struct MainDirection {
  Real cosine, sine;
  Real length_sq;  ///< cosine² + sine²
};

/// \param xx, xy, yy the quadric's matrix
template <class Real>
WHITTLE_INLINE MainDirection<Real> main_direction(const Real& xx, const Real& xy, const Real& yy) {
  const Real half_difference = 0.5 * (xx - yy);
  Real radius = half_difference * half_difference + xy * xy;
  take_square_roots(radius);
  // Of two forms the one without cancellation.
  const Real cosine = select_lanes(half_difference >= 0, radius + half_difference, xy);
  const Real sine = select_lanes(half_difference >= 0, xy, radius - half_difference);
  const Real length_sq = cosine * cosine + sine * sine;
  const auto differ = length_sq > 0;  // or it is the same in all directions
  return {select_lanes(differ, cosine, Real{} + 1), sine, select_lanes(differ, length_sq, Real{} + 1)};
}

/// The constraints by volumes alone. Gradients of the squares are taken along the directions across the normal in which
/// the squares grow most and least, so that the mesh may be turned; each only if it is independent of those before.
template <class Real>
WHITTLE_INLINE VolumeConstraints<Real> volume_constraints(const VolumeLanes<Real>& sums) {
  const Real trace = sums.trace();
  Real length = sums.normal.dot(sums.normal);
  const auto has_normal = length > (constraint_noise_share * constraint_noise_share) * trace;
  take_square_roots(length);
  const Real inverse_length = 1 / length;
  const PointLanes<Real> n{sums.normal.x * inverse_length, sums.normal.y * inverse_length,
                           sums.normal.z * inverse_length};

  const auto [u, v] = basis_across(n);
  const PointLanes<Real> row_u = sums.times(u);
  const PointLanes<Real> row_v = sums.times(v);
  const auto [cosine, sine, length_sq] = main_direction<Real>(u.dot(row_u), v.dot(row_u), v.dot(row_v));
  const PointLanes<Real> greatest = combined(cosine, row_u, sine, row_v);
  const PointLanes<Real> least = combined(cosine, row_v, -sine, row_u);
  const Real u_value = -u.dot(sums.b);
  const Real v_value = -v.dot(sums.b);

  const Real noise = constraint_noise_share * trace;
  const Real noise_sq = noise * noise * length_sq;
  const Real greatest_sq = greatest.dot(greatest);
  const Real least_sq = least.dot(least);
  const Real greatest_along_n = n.dot(greatest);
  const Real least_along_n = n.dot(least);
  const PointLanes<Real> fixed = n.cross(greatest);
  const Real determinant = fixed.dot(least);
  const auto has_greatest =
      (greatest_sq > noise_sq) & (greatest_along_n * greatest_along_n < (1 - least_constraint_sine_sq) * greatest_sq);
  const auto is_beside_normal = least_along_n * least_along_n < (1 - least_constraint_sine_sq) * least_sq;
  const auto is_beside_both = determinant * determinant > least_constraint_sine_sq * fixed.dot(fixed) * least_sq;
  const auto has_least =
      (least_sq > noise_sq) & ((has_greatest & is_beside_both) | ((has_greatest == 0) & is_beside_normal));

  const PointLanes<Real> second = choose(has_greatest, greatest, choose(has_least, least, u));
  const Real least_value = cosine * v_value - sine * u_value;
  const Real second_value = select_lanes(has_greatest, cosine * u_value + sine * v_value, least_value);
  return {n,
          second,
          least,
          sums.offset * inverse_length,
          second_value,
          least_value,
          has_normal != 0,
          (has_greatest | has_least) != 0,
          (has_greatest & has_least) != 0};
}

/// Takes v̄ as near to the neighbours' mean as the constraints allow.
template <class Real>
WHITTLE_INLINE void add_neighbours(VolumeConstraints<Real>& constraints, const NeighbourLanes<Real>& neighbours) {
  const Real share = 1 / neighbours.n;
  const PointLanes<Real> mean{neighbours.position.x * share, neighbours.position.y * share,
                              neighbours.position.z * share};
  const PointLanes<Real> across = constraints.normal.cross(constraints.second);
  constraints.second_value =
      select_lanes(constraints.has_second, constraints.second_value, constraints.second.dot(mean));
  constraints.third = choose(constraints.has_third, constraints.third, across);
  constraints.third_value = select_lanes(constraints.has_third, constraints.third_value, across.dot(mean));
}

/// By Cramer's rule. \param first, second v0 and v1 as seen from the sums' origin
template <class Real>
WHITTLE_INLINE VolumePlacement<Real> place_by_volume(const VolumeConstraints<Real>& constraints,
                                                     const VolumeLanes<Real>& sums, const PointLanes<Real>& first,
                                                     const PointLanes<Real>& second) {
  const auto& [n, row1, row2, n_value, value1, value2, has_normal, has_second, has_third] = constraints;
  const PointLanes<Real> c01 = n.cross(row1);
  const PointLanes<Real> c12 = row1.cross(row2);
  const PointLanes<Real> c20 = row2.cross(n);
  const Real inverse = 1 / c01.dot(row2);
  const PointLanes<Real> x{(n_value * c12.x + value1 * c20.x + value2 * c01.x) * inverse,
                           (n_value * c12.y + value1 * c20.y + value2 * c01.y) * inverse,
                           (n_value * c12.z + value1 * c20.z + value2 * c01.z) * inverse};
  const PointLanes<Real> ax = sums.times(x);
  const PointLanes<Real> slope{2 * sums.b.x + ax.x, 2 * sums.b.y + ax.y, 2 * sums.b.z + ax.z};
  const Real squares = sums.c + x.dot(slope);
  const Real spread = spread_cost(sums.trace(), x - first, x - second);
  return {x, (lindstrom_turk_volume_weight / 36) * (select_lanes(squares > 0, squares, Real{}) + spread)};
}

}  // namespace whittle
