#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/core/geometry/proof/linked_faces.hh"

namespace whittle {

/// A set of numbers that is emptied at once.
class NumberSet {
 public:
  /// \return whether it wasn't there
  bool insert(Index number) {
    Slot& slot = slot_of(number);
    if (slot.turn == turn_) return false;
    slot = {number, turn_};
    if (2 * ++size_ > slots_.size()) grow();
    return true;
  }
  void clear();

 private:
  struct Slot {
    Index number = 0;
    std::uint32_t turn = 0;  ///< the one in which the slot was taken
  };

  /// Where the number is, or is to go.
  Slot& slot_of(Index number) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = (number * std::uint64_t{0x9e3779b97f4a7c15U}) >> 32 & mask;
    while (slots_[slot].turn == turn_ && slots_[slot].number != number) slot = (slot + 1) & mask;
    return slots_[slot];
  }
  void grow();

  std::vector<Slot> slots_ = std::vector<Slot>(256);
  std::size_t size_ = 0;
  std::uint32_t turn_ = 1;  ///< counts how often the set was emptied
};

/// Proves that a triangle is covered by connected faces of a surface, which are seen along its normal.
class Patch {
 public:
  /// Looks at a triangle, and walks over the surface to a face that is seen over its center, as far as there is a way.
  /// \param surface must stay as it is until `covers` is called
  /// \param from where to begin
  /// \return the face; `invalid_index` if the triangle is too thin to be seen
  Index look_from(const LinkedFaces& surface, const Corners& triangle, Index from);

  /// Whether faces connected with that face are proven to have a point over each point of the triangle, at `height` at
  /// most. By the degree modulo 2: where no open edge of the faces lies over the triangle, and an odd number of faces
  /// lies over one of its points, an odd number does over each.
  bool covers(double height);

  /// Why the faces don't cover the triangle: one of them is too high over it.
  struct Obstacle {
    Index face;
    Vec3 below;  ///< the point of the triangle under the highest point of the face: likely far from the surface
  };
  /// That of the triangle looked at last, if `covers` or `is_obstacle` found one.
  const std::optional<Obstacle>& obstacle() const { return obstacle_; }
  /// Whether a face is too high over the triangle. \param height as for `covers`
  bool is_obstacle(Index face, double height) { return !is_within(face, corners(face), height - margin_); }

 private:
  /// A point seen along the normal of the triangle, and its height over the triangle's plane.
  using Seen = Vec3;

  /// A corner of a face as it is seen.
  struct SeenCorner {
    Seen at;
    unsigned outside;  ///< a bit for each side of the triangle that the corner surely lies outside of
  };
  /// Corners of a face among `seen_`.
  using SeenFace = std::array<Index, 3>;

  /// Where a vertex is among `seen_`, unless another vertex took its slot.
  struct CacheSlot {
    Index vertex = invalid_index;
    std::uint32_t turn = 0;
    Index seen = 0;
  };
  static constexpr std::size_t cache_size = 1024;

  /// A side of the triangle as it is seen.
  struct Side {
    Seen from;
    Seen outward;  ///< perpendicular to it, of unit length

    /// Positive outside.
    double distance(const Seen& p) const { return outward.x() * (p.x() - from.x()) + outward.y() * (p.y() - from.y()); }
  };

  bool set_view(const Corners& triangle);
  void shrink();
  Index face_over_center(Index face);
  Seen seen(const Vec3& point) const;
  /// Where the vertex is among `seen_`.
  Index corner(Index vertex) {
    const CacheSlot& slot = cache_[vertex % cache_size];
    return slot.vertex == vertex && slot.turn == turn_ ? slot.seen : see(vertex);
  }
  Index see(Index vertex);
  SeenFace corners(Index face) {
    const auto& [a, b, c] = surface_.faces[face];
    return {corner(a), corner(b), corner(c)};
  }
  bool is_apart(const SeenCorner& a, const SeenCorner& b) const;
  bool is_within(Index face, const SeenFace& corners, double height);
  bool is_part_within(Index face, const SeenFace& corners, double most);
  bool is_odd_somewhere() const;

  LinkedFaces surface_;
  Index seed_ = invalid_index;
  Vec3 origin_ = Vec3::Zero();
  std::array<Vec3, 3> axes_;
  double margin_ = 0;
  std::array<Seen, 3> triangle_;  ///< without the margin
  std::array<Side, 3> sides_;
  std::vector<Index> faces_;    ///< to be looked at
  std::vector<SeenFace> over_;  ///< faces that lie over the triangle, or almost
  NumberSet known_;
  std::vector<SeenCorner> seen_;  ///< corners looked at for this triangle
  std::vector<CacheSlot> cache_ = std::vector<CacheSlot>(cache_size);
  std::uint32_t turn_ = 0;  ///< counts the triangles
  std::optional<Obstacle> obstacle_;
};

}  // namespace whittle
