#pragma once

#include "whittle/core/geometry/symmetric_matrix.hh"

namespace whittle {

/// A quadric error function about a local origin o: E(o + x) = xᵀ A x + 2 bᵀ x + c, in weight · distance².
///
/// A vertex's quadric is about the vertex's own position. Every plane of its faces passes through it, so b and c start
/// at exactly zero. The rounding of a cost is relative to the size of the neighbourhood, not to the size of the mesh or
/// its distance from the world's origin.
/// \cite garland_1997_surface section 4
struct Quadric {
  SymmetricMatrix a;
  Vec3 b = Vec3::Zero();
  double c = 0;

  Quadric& operator+=(const Quadric& o) {
    a += o.a;
    b += o.b;
    c += o.c;
    return *this;
  }
  /// E at offset x from the origin.
  double operator()(const Vec3& x) const { return c + x.dot(2 * b + a * x); }
  /// The same function about the origin o + t.
  Quadric about(const Vec3& t) const {
    const Vec3 at = a * t;
    return {a, b + at, c + t.dot(2 * b + at)};
  }
};

/// A vertex as its cost sees it.
struct PlacedQuadric {
  Vec3 position = Vec3::Zero();
  Quadric quadric;  ///< about `position`
};

}  // namespace whittle
