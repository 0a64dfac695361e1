#pragma once

#include <vector>

#include "certify/target_surface.hh"

namespace whittle::metrics {

/// A set of numbers that is emptied in the time that it took to fill.
class NumberSet {
 public:
  /// \return whether it wasn't there
  bool insert(Index number);
  void clear();

 private:
  std::size_t slot_of(Index number) const;
  void grow();

  std::vector<Index> slots_ = std::vector<Index>(64, invalid_index);
  std::vector<std::size_t> taken_;  ///< slots
};

/// Proves that a triangle is covered by connected faces of a surface, which are seen along its normal.
class Patch {
 public:
  explicit Patch(const TargetSurface& surface) : surface_(surface) {}

  /// Whether faces connected with `seed` are proven to have a point over each point of the triangle, at `height` at
  /// most. By the degree modulo 2: where no open edge of the faces lies over the triangle, and an odd number of faces
  /// lies over one of its points, an odd number does over each.
  bool covers(const Corners& triangle, Index seed, double height);

 private:
  /// A point seen along the normal of the triangle, and its height over the triangle's plane.
  using Seen = Vec3;

  /// A side of the triangle as it is seen.
  struct Side {
    Seen from;
    Seen outward;  ///< perpendicular to it, of unit length

    double distance(const Seen& p) const { return outward.dot(p - from); }  ///< positive outside
  };

  bool set_view(const Corners& triangle);
  std::array<Seen, 3> seen(const Corners& corners) const;
  bool is_apart(const std::array<Seen, 3>& face) const;
  bool is_apart(const Seen& a, const Seen& b) const;
  bool is_within(const std::array<Seen, 3>& face, double height) const;
  bool is_odd_somewhere() const;

  const TargetSurface& surface_;
  Vec3 origin_ = Vec3::Zero();
  std::array<Vec3, 3> axes_;
  std::array<Seen, 3> triangle_;
  std::array<Side, 3> sides_;
  std::vector<Index> faces_;
  NumberSet known_;
};

}  // namespace whittle::metrics
