#pragma once

#include "whittle/core/detail/lanes.hh"
#include "whittle/engine/formula/lindstrom_turk_pair.hh"
#include "whittle/engine/formula/volume_placement.hh"

// The sums that Lindstrom–Turk places a pair by. With a and b its vertices, d = b − a, and all seen from a:
//
//   volume       Σ over the faces at a or b = Σ at a + Σ at b − Σ over the common faces
//   neighbours   Σ over the neighbours of a or b = Σ at a + Σ at b − a − b − Σ over the corners of common faces
//
// The planes of faces at b have the offset n · d:  Σ (n · (x − d))² = xᵀ A x − 2 x · (A d) + d · (A d),  A = Σ n nᵀ.
// The planes of common faces pass through a, too, so there is no offset to take away.
//
// Lanes are pairs side by side: `Real` is double, Double2 or Double4. Only in `StarAdder` they are coordinates.

namespace whittle {

/// The coordinates, and the last one again.
WHITTLE_INLINE Double4 side_by_side(const Vec3& p) { return Double4{p.x(), p.y(), p.z(), p.z()}; }

/// From the second coordinate on.
WHITTLE_INLINE Double4 turned(const Double4& v) { return shuffled<1, 2, 0, 3>(v, v); }

/// Sums over a star. Points are `side_by_side`, seen from the vertex.
class StarAdder {
 public:
  /// Adds a face by its other two corners.
  WHITTLE_INLINE void add_face(const Double4& x, const Double4& y) {
    const Double4 n_from_z = x * turned(y) - turned(x) * y;
    const Double4 n = turned(n_from_z);
    normal_ += n;
    squares_ += n * n;
    products_ += n * n_from_z;
  }
  WHITTLE_INLINE void add_neighbour(const Double4& p) { neighbours_ += p; }

  /// \param p the vertex
  WHITTLE_INLINE StarSums sums(const Double4& p, std::size_t n_neighbours) const {
    return {{squares_[0], products_[1], products_[0], squares_[1], products_[2], squares_[2], normal_[0], normal_[1],
             normal_[2], p[0], p[1], p[2], neighbours_[0], neighbours_[1], neighbours_[2],
             static_cast<double>(n_neighbours)}};
  }

 private:
  Double4 normal_{};
  Double4 squares_{};
  Double4 products_{};  ///< xz, xy, yz
  Double4 neighbours_{};
};

/// `StarSums` side by side, without those over neighbours.
template <class Real>
struct StarLanes {
  Real xx, xy, xz, yy, yz, zz;
  PointLanes<Real> normal;
  PointLanes<Real> position;
};

/// \param star lane → StarSums
template <class Real, class StarAt>
WHITTLE_INLINE StarLanes<Real> star_lanes(const StarAt& star) {
  const auto load = [&](std::size_t first) WHITTLE_INLINE_LAMBDA {
    return transposed_lanes<Real>([&](std::size_t lane) { return &star(lane).values[first]; });
  };
  const auto [xx, xy, xz, yy] = load(0);
  const auto [yz, zz, nx, ny] = load(4);
  const auto [nz, x, y, z] = load(8);
  return {xx, xy, xz, yy, yz, zz, PointLanes<Real>{nx, ny, nz}, PointLanes<Real>{x, y, z}};
}

/// The position alone. \param star lane → StarSums
template <class Real, class StarAt>
WHITTLE_INLINE PointLanes<Real> star_positions(const StarAt& star) {
  const auto [nz, x, y, z] = transposed_lanes<Real>([&](std::size_t lane) { return &star(lane).values[8]; });
  return {x, y, z};
}

/// \param star lane → StarSums
template <class Real, class StarAt>
WHITTLE_INLINE NeighbourLanes<Real> neighbour_lanes(const StarAt& star) {
  const auto [x, y, z, n] = transposed_lanes<Real>([&](std::size_t lane) { return &star(lane).values[12]; });
  return {PointLanes<Real>{x, y, z}, n};
}

/// `CommonFace`, as seen from the first vertex.
template <class Real>
struct CommonFaceLanes {
  PointLanes<Real> corner;
  Real turn;
};

/// About the first vertex. \param d b − a \param common a range of `CommonFaceLanes`
template <class Real, class CommonFaces>
WHITTLE_INLINE VolumeLanes<Real> pair_volume(const StarLanes<Real>& a, const StarLanes<Real>& b,
                                             const PointLanes<Real>& d, const CommonFaces& common) {
  const VolumeLanes<Real> of_b{b.normal, Real{}, b.xx, b.xy, b.xz, b.yy, b.yz, b.zz, {}, Real{}};
  const PointLanes<Real> slope = of_b.times(d);
  VolumeLanes<Real> sums{a.normal + b.normal, b.normal.dot(d), a.xx + b.xx,
                         a.xy + b.xy,         a.xz + b.xz,     a.yy + b.yy,
                         a.yz + b.yz,         a.zz + b.zz,     {-slope.x, -slope.y, -slope.z},
                         d.dot(slope)};
  for (const auto& [corner, turn] : common) {
    const PointLanes<Real> n = d.cross(corner);
    sums.remove({turn * n.x, turn * n.y, turn * n.z});
  }
  return sums;
}

/// As `pair_volume`. \param common each third corner once
template <class Real, class CommonFaces>
WHITTLE_INLINE NeighbourLanes<Real> pair_neighbours(const NeighbourLanes<Real>& a, const NeighbourLanes<Real>& b,
                                                    const PointLanes<Real>& d, const CommonFaces& common) {
  const PointLanes<Real> b_from_a{b.position.x + b.n * d.x, b.position.y + b.n * d.y, b.position.z + b.n * d.z};
  PointLanes<Real> sum = a.position + b_from_a - d;
  for (const auto& [corner, turn] : common) sum = sum - corner;
  return {sum, a.n + b.n - static_cast<double>(2 + common.size())};
}

}  // namespace whittle
