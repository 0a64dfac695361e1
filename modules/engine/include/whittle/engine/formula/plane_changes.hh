#pragma once

#include <vector>

#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {

/// By how much memoryless quadrics change at the neighbours of a pair that becomes one vertex, where that vertex has no
/// ring (`MergedRing` is for those that have one). For each neighbour:
///
///   Σ over its faces at the merged vertex (planes after − planes before) − planes of its faces that vanish
///
/// A neighbour inside the surface has two of the first, and the order of two doesn't matter. What vanishes is added
/// last.
class PlaneChanges {
 public:
  struct Change {
    Index vertex;
    SymmetricMatrix planes;
  };
  /// A neighbour and where it is.
  struct Corner {
    Index vertex;
    Vec3 position;
  };

  explicit PlaneChanges(const QuadricOptions& options) : options_(options) {}

  void clear() { changes_.clear(); }
  /// A face (v, x, y) of one end v, which moves.
  void move_face(const Vec3& from, const Vec3& to, const Corner& x, const Corner& y);
  /// A face of both ends. \param opposite its third corner
  void remove_face(const Vec3& first, const Vec3& second, const Corner& opposite);

  /// Each neighbour once, ascending.
  const std::vector<Change>& sum();

 private:
  QuadricOptions options_;
  std::vector<Change> changes_;
};

}  // namespace whittle
