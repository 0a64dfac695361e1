#pragma once

#include "whittle/core/indexed_mesh.hh"

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

}  // namespace whittle
