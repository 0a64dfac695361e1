#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "whittle/core/detail/compiler.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/quadric.hh"

namespace whittle {

// What a wedge costs in attributes. On a face t of the input, a component j of an attribute is a linear function f_tj
// of the position, constant along the face's normal. A wedge has the faces of all wedges merged into it, each with its
// area w_t. If its vertex is at x, its best value of j is the mean of the f_tj(x), and it costs
//
//   E(x) = Σ_j Σ_t w_t (f_tj(x) - m_j(x))²,   m_j = Σ_t w_t f_tj / W,   W = Σ_t w_t
//
// That is the quadric of Hoppe 1999 with the attribute solved for: a quadric over positions alone. W, the m_j and E are
// all that a wedge needs to know. Two that become one have
//
//   W = W₁ + W₂,   m_j = (W₁ m_1j + W₂ m_2j) / W,   E = E₁ + E₂ + (W₁ W₂ / W) Σ_j (m_1j - m_2j)²
//
// so nothing is the difference of large numbers, and single precision will do. No slope is longer than `steepest`.
// Unit: length² · area, as that of the planes: before, components are multiplied by a length (`scaled_attributes`).
// \cite hoppe_1999_attributes, \cite garland_1998_color

/// How a face makes linear functions of values at its corners.
struct FaceGradient {
  /// Without area, the slopes of the face are of no meaning.
  explicit FaceGradient(const std::array<Vec3, 3>& corners);

  double area;
  Vec3 center;
  Vec3 dual_u, dual_v;  ///< what the slope gains by each unit that the second, the third corner has more than the first
};

/// A face of the input in a wedge.
struct WedgeFace {
  FaceGradient gradient;
  Vec3 from_center;                     ///< from the middle of the face to the origin of the wedge
  std::array<const double*, 3> values;  ///< at each corner, a row as those of `ScaledAttributes`
};

/// The quadrics of many wedges, each about an origin of its own.
class WedgeQuadrics {
 public:
  /// None.
  WedgeQuadrics() = default;
  /// Of wedges without a face.
  WedgeQuadrics(std::size_t n_wedges, std::size_t n_components);

  bool any() const { return !numbers_.empty(); }
  void prefetch(Index w) const {
    for (std::size_t i = 0; i < stride_; i += 16) prefetch_line(of(w) + i);
  }
  std::size_t n_components() const { return n_components_; }
  double weight(Index w) const { return of(w)[0]; }
  /// As `WedgeLayout` has them.
  const float* numbers(Index w) const { return of(w); }
  Quadric quadric(Index w) const;

  /// Of both wedges as one, about the origin of the first. \param a_to_b from one origin to the other
  Quadric quadric_of_both(Index a, Index b, const Vec3& a_to_b) const;
  /// What both as one cost at a position more than both alone. \param from_a the position, from the origin of a
  double error_between(Index a, Index b, const Vec3& from_a, const Vec3& from_b) const;

  /// Sums up the faces of a wedge. \param values at its origin, a row as those of `ScaledAttributes`
  void set(Index w, std::span<const WedgeFace> faces, const double* values);
  void move_origin(Index w, const Vec3& by);
  /// A table of so many wedges, without faces, that have as many components.
  WedgeQuadrics of_same_kind(std::size_t n_wedges) const;
  /// \pre both tables have as many components
  void copy(Index to, const WedgeQuadrics& from_table, Index from);
  /// A table of some of them.
  WedgeQuadrics gathered(std::span<const Index> wedges) const;
  /// \pre both have one origin
  void join(Index into, Index other);

 private:
  struct FaceSum;
  float* of(Index w) { return numbers_.data() + w * stride_; }
  const float* of(Index w) const { return numbers_.data() + w * stride_; }

  std::size_t n_groups() const { return (n_components_ + 3) / 4; }  ///< of four components

  std::size_t n_components_ = 0;
  std::size_t stride_ = 0;
  LargeArray<float> numbers_;
};

}  // namespace whittle
