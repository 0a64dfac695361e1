#pragma once

#include <Eigen/Core>
#include <optional>

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
  friend SymmetricMatrix operator+(SymmetricMatrix a, const SymmetricMatrix& b) { return a += b; }
  friend SymmetricMatrix operator-(const SymmetricMatrix& a, const SymmetricMatrix& b) {
    return {a.xx - b.xx, a.xy - b.xy, a.xz - b.xz, a.yy - b.yy, a.yz - b.yz, a.zz - b.zz};
  }
  friend Vec3 operator*(const SymmetricMatrix& m, const Vec3& v) {
    return {m.xx * v.x() + m.xy * v.y() + m.xz * v.z(), m.xy * v.x() + m.yy * v.y() + m.yz * v.z(),
            m.xz * v.x() + m.yz * v.y() + m.zz * v.z()};
  }
  double trace() const { return xx + yy + zz; }

  /// The x with M x = rhs for a positive definite M, by LDLᵀ (backward stable, unlike the adjugate, which loses the
  /// small eigenvalue of a nearly flat neighbourhood). Nothing where a pivot is below 1e-13 of the trace: there
  /// rounding decides, and the caller falls back to another placement.
  std::optional<Vec3> solve(const Vec3& rhs) const {
    const double smallest_pivot = 1e-13 * trace();
    const double inverse_d0 = 1 / xx;
    const double l10 = xy * inverse_d0;
    const double l20 = xz * inverse_d0;
    const double d1 = yy - l10 * xy;
    const double inverse_d1 = 1 / d1;
    const double e21 = yz - l20 * xy;
    const double l21 = e21 * inverse_d1;
    const double d2 = zz - l20 * xz - l21 * e21;
    if (!(xx > smallest_pivot && d1 > smallest_pivot && d2 > smallest_pivot)) return std::nullopt;
    const double y1 = rhs.y() - l10 * rhs.x();
    const double z = (rhs.z() - l20 * rhs.x() - l21 * y1) / d2;
    const double y = y1 * inverse_d1 - l21 * z;
    const double x = rhs.x() * inverse_d0 - l10 * y - l20 * z;
    return Vec3(x, y, z);
  }
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

}  // namespace whittle
