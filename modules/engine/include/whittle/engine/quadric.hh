#pragma once

#include <Eigen/Core>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// A symmetric 3x3 matrix, its upper triangle.
struct SymmetricMatrix {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  /// weight · n nᵀ
  static SymmetricMatrix outer(const Vec3& n, double weight) {
    const Vec3 w = weight * n;
    return {w.x() * n.x(), w.x() * n.y(), w.x() * n.z(), w.y() * n.y(), w.y() * n.z(), w.z() * n.z()};
  }
  /// weight · I
  static SymmetricMatrix identity(double weight) { return {weight, 0, 0, weight, 0, weight}; }

  SymmetricMatrix& operator+=(const SymmetricMatrix& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    return *this;
  }
  SymmetricMatrix& operator-=(const SymmetricMatrix& o) {
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    return *this;
  }
  friend SymmetricMatrix operator+(SymmetricMatrix a, const SymmetricMatrix& b) { return a += b; }
  friend Vec3 operator*(const SymmetricMatrix& m, const Vec3& v) {
    return {m.xx * v.x() + m.xy * v.y() + m.xz * v.z(), m.xy * v.x() + m.yy * v.y() + m.yz * v.z(),
            m.xz * v.x() + m.yz * v.y() + m.zz * v.z()};
  }
  double trace() const { return xx + yy + zz; }
};

/// A quadric error function about a local origin o: E(o + x) = xᵀ A x + 2 bᵀ x + c, in weight · distance².
///
/// Whittle keeps a vertex's quadric about that vertex's own position. There every plane of its faces passes through the
/// origin, so b and c start at exactly zero, and the rounding noise of a cost is relative to the size of the
/// neighbourhood, not to that of the mesh or to its distance from the world's origin.
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
