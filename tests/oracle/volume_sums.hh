#pragma once

#include "whittle/engine/formula/lindstrom_turk.hh"

namespace whittle::test {

/// The sums of Lindstrom–Turk by their definitions, about an origin o: compare `VolumeLanes` and `NeighbourLanes`.
struct VolumeSums {
  Vec3 normal = Vec3::Zero();  ///< Σ n
  double offset = 0;           ///< Σ n · p
  Quadric squares;             ///< x ↦ Σ (n · (x − p))²

  VolumeSums& operator+=(const VolumeSums& other) {
    normal += other.normal;
    offset += other.offset;
    squares += other.squares;
    return *this;
  }
  /// The same sums about o + t.
  VolumeSums about(const Vec3& t) const { return {normal, offset - dot(normal, t), about_point(t)}; }

  VolumeLanes<double> lanes() const {
    const auto& [a, b, c] = squares;
    return {point_lanes(normal), offset, a.xx, a.xy, a.xz, a.yy, a.yz, a.zz, point_lanes(b), c};
  }

 private:
  // Fixed summation order, the same as that of the lanes.
  static double dot(const Vec3& a, const Vec3& b) { return a.x() * b.x() + a.y() * b.y() + a.z() * b.z(); }
  Quadric about_point(const Vec3& t) const {
    const Vec3 at = squares.a * t;
    return {squares.a, squares.b + at, squares.c + dot(t, 2 * squares.b + at)};
  }
};

struct NeighbourSums {
  Vec3 position = Vec3::Zero();  ///< Σ p
  int n = 0;

  NeighbourSums& operator+=(const NeighbourSums& other) {
    position += other.position;
    n += other.n;
    return *this;
  }
  /// The same sums about o + t.
  NeighbourSums about(const Vec3& t) const { return {position - n * t, n}; }
  void add(const Vec3& p) {
    position += p;
    ++n;
  }
  void remove(const Vec3& p) {
    position -= p;
    --n;
  }

  NeighbourLanes<double> lanes() const { return {point_lanes(position), static_cast<double>(n)}; }
};

}  // namespace whittle::test
