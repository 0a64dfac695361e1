#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/core/geometry/proof/linked_faces.hh"

namespace whittle {

/// A set of numbers that is cleared in constant time.
class NumberSet {
 public:
  /// \return whether it was new
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
    std::uint32_t turn = 0;  ///< turn in which the slot was filled
  };

  /// The slot of the number, or a free slot for it.
  Slot& slot_of(Index number) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = (number * std::uint64_t{0x9e3779b97f4a7c15U}) >> 32 & mask;
    while (slots_[slot].turn == turn_ && slots_[slot].number != number) slot = (slot + 1) & mask;
    return slots_[slot];
  }
  void grow();

  std::vector<Slot> slots_ = std::vector<Slot>(256);
  std::size_t size_ = 0;
  std::uint32_t turn_ = 1;  ///< number of times that the set was cleared
};

/// Proves that connected faces of a surface cover a triangle, seen along its normal.
class Patch {
 public:
  /// Sets the triangle, and walks over the surface towards a face over its center.
  /// \param surface must not change until `covers` is called
  /// \param from first face of the walk
  /// \return last face of the walk; `invalid_index` if the triangle is too thin
  Index look_from(const LinkedFaces& surface, const Corners& triangle, Index from);

  /// Whether faces connected with that face provably have a point over each point of the triangle, at most `height`
  /// away. By the degree modulo 2: if no open edge of the faces lies over the triangle, and an odd number of faces lies
  /// over one of its points, an odd number lies over each.
  bool covers(double height);
  /// The faces over the triangle, once it is covered: the proof is of these, and of no others.
  const std::vector<Index>& faces_over() const { return faces_over_; }

  /// A face too high over the triangle, so that the faces don't cover it.
  struct Obstacle {
    Index face;
    Vec3 below;  ///< the point of the triangle under the highest point of the face: likely far from the surface
  };
  /// The obstacle of the last triangle, if `covers` or `is_obstacle` found one.
  const std::optional<Obstacle>& obstacle() const { return obstacle_; }
  /// Whether a face is too high over the triangle. \param height as for `covers`
  bool is_obstacle(Index face, double height) { return !is_within(face, corners(face), height - margin_); }

 private:
  /// A point seen along the normal of the triangle, and its height over the triangle's plane.
  using Seen = Vec3;

  /// A corner of a face, projected.
  struct SeenCorner {
    Seen at;
    unsigned outside;  ///< bit i: the corner is certainly outside of side i of the triangle
  };
  /// Corners of a face among `seen_`.
  using SeenFace = std::array<Index, 3>;

  /// Index of a vertex in `seen_`, unless another vertex took its slot.
  struct CacheSlot {
    Index vertex = invalid_index;
    std::uint32_t turn = 0;
    Index seen = 0;
  };
  static constexpr std::size_t cache_size = 1024;

  /// A side of the triangle, projected.
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
  /// Index of the vertex in `seen_`.
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
  std::vector<Index> faces_;       ///< queue of faces to check
  std::vector<SeenFace> over_;     ///< faces over the triangle, or nearly
  std::vector<Index> faces_over_;  ///< their numbers
  NumberSet known_;
  std::vector<SeenCorner> seen_;  ///< corners checked for this triangle
  std::vector<CacheSlot> cache_ = std::vector<CacheSlot>(cache_size);
  std::uint32_t turn_ = 0;  ///< counts the triangles
  std::optional<Obstacle> obstacle_;
};

}  // namespace whittle
