#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "whittle/core/detail/lanes.hh"
#include "whittle/engine/formula/quadric.hh"

// Memoryless quadrics: a vertex has the planes of its faces as they are now, not of all that it has merged. E is the
// minimum of the sum of both quadrics, as with Garland–Heckbert (quadric_term.hh). A pair costs
//
//   E sqrt(W + 2 a₀)
//
// W is the weight of all planes in E, a₀ the mean area of the input's faces. E alone is best for the mean square of the
// distance, E W for the mean of its absolute value: where the surface is d off, these are W d² and (W |d|)². a₀ keeps
// small faces from counting for almost nothing. Unit: length⁵.
//
// v̄ leaves the minimum x* by a step that keeps the volume under the surface: of the points with Σ n_t · (x − p_t) = 0,
// over the faces t at either vertex, the one that is least in a damped quadric,
//
//   v̄ = x* + d (h / g · d),   d = (A + 0.01 tr(A) I)⁻¹ g,   g = Σ n_t,   h = Σ n_t · (p_t − x*)
//
// n_t is the normal of a face, as long as twice its area, p_t one of its corners. Where the n_t cancel, |g|² at most
// 1e-4 (Σ |n_t|)², or the step is longer than the way to the farthest neighbour, v̄ is x*.
//
// Planes don't see how long a needle is, or how wide a fin: almost no volume or area is lost with it. The faces there
// look to all sides, |g|² < ½ (Σ |n_t|)². Such a contraction costs at least as much as a surface that is d off over two
// faces of mean area a, of twelve around: 2 a d² sqrt(12 a). a is the mean area in the mesh as it is now; it grows in
// steps of about 2 %, for else each contraction would make all thin parts dearer. d is how far the surface moves: the
// largest distance of v0 and v1 from the faces afterwards, and of v̄ from the faces before.
//
// \cite lindstrom_1998_fast (volume preservation), \cite hoppe_1999_attributes (memoryless quadrics)

namespace whittle {

/// Sums over the faces at both ends of an edge, about some origin.
struct StarVolume {
  Vec3 normal = Vec3::Zero();  ///< Σ n
  double offset = 0;           ///< Σ n · p
  double length = 0;           ///< Σ |n|
  double farthest_sq = 0;      ///< of the neighbours, from the origin

  /// Whether the faces look to all sides, as at needles and fins.
  bool is_thin() const { return normal.squaredNorm() < 0.5 * length * length; }
};

/// What to multiply E by. Where large planes were taken away, rounding may leave less than nothing.
/// \param weight W \param first_area a₀
template <class Real>
WHITTLE_INLINE Real memoryless_factor(const Real& weight, double first_area) {
  const Real area = weight + 2 * first_area;
  Real factor = select_lanes(area > 0, area, Real{});
  take_square_roots(factor);
  return factor;
}

/// The least that a contraction costs at a thin part. \param displacement_sq d² \param area a
inline double thin_cost(double displacement_sq, double area) {
  return 2 * area * displacement_sq * std::sqrt(12 * area);
}

/// The mean area of a mesh's faces, at the start and later.
class MeanFaceArea {
 public:
  MeanFaceArea() = default;
  /// \param area of `n_summed` faces; kept in so few digits that the order of summing doesn't matter
  /// \param n_faces of the whole mesh
  MeanFaceArea(double area, std::uint64_t n_summed, std::uint64_t n_faces)
      : first_(n_summed > 0 ? static_cast<float>(area / static_cast<double>(n_summed)) : 0), n_faces_(n_faces) {}

  /// That of a part of the mesh with so many of its faces.
  MeanFaceArea of_part(std::uint64_t n_faces) const {
    MeanFaceArea part = *this;
    part.n_faces_ = n_faces;
    return part;
  }

  double first() const { return first_; }
  std::uint64_t n_faces() const { return n_faces_; }
  /// The mean area of so many faces on the same surface, or of a few less: those are counted to six binary digits.
  double now(std::uint64_t n_faces) const {
    constexpr int n_digits = 6;
    const int n_zeros = std::max(0, static_cast<int>(std::bit_width(n_faces)) - n_digits);
    const std::uint64_t n_counted = n_faces >> n_zeros << n_zeros;
    return first_ * static_cast<double>(n_faces_) / static_cast<double>(n_counted);
  }

 private:
  float first_ = 0;
  std::uint64_t n_faces_ = 0;
};

/// What v̄ is away from the minimum. \param a A, of the sum of both quadrics \param volume about the minimum
inline Vec3 volume_step(const SymmetricMatrix& a, const StarVolume& volume) {
  constexpr double damping = 0.01;
  constexpr double least_share = 1e-4;
  const Vec3& g = volume.normal;
  if (!(g.squaredNorm() > least_share * volume.length * volume.length)) return Vec3::Zero();
  // The adjugate serves as the inverse: only the direction of d counts, and the damping makes it well-conditioned.
  const double diagonal = damping * a.trace();
  const Vec3 row0(a.xx + diagonal, a.xy, a.xz);
  const Vec3 row1(a.xy, a.yy + diagonal, a.yz);
  const Vec3 row2(a.xz, a.yz, a.zz + diagonal);
  const Vec3 d(row1.cross(row2).dot(g), row2.cross(row0).dot(g), row0.cross(row1).dot(g));
  const Vec3 step = d * (volume.offset / g.dot(d));
  return step.squaredNorm() <= volume.farthest_sq ? step : Vec3::Zero();
}

}  // namespace whittle
