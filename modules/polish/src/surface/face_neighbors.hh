#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/detail/vertex_corners.hh"

namespace whittle {

/// A face's side from a corner to the next one.
struct Side {
  Index face = invalid_index;
  Index place = 0;  ///< of that corner
};

/// How the faces at a vertex hang together over its edges.
enum class Fan {
  closed,  ///< in one ring
  open,    ///< in one row, from border edge to border edge
  none     ///< not in one, or there are none: the surface is no manifold there
};

/// What lies beyond the sides of a mesh's faces.
class FaceNeighbors {
 public:
  /// Keeps references to both.
  FaceNeighbors(std::span<const Triangle> faces, const VertexCorners& corners);

  std::size_t n_faces() const { return faces_.size(); }

  /// The same edge as a side of its other face; without a face where it hasn't exactly one.
  const Side& beyond(Index face, Index place) const { return beyond_[face][place]; }
  /// Whether no other face is at the edge.
  bool is_border(Index face, Index place) const { return beyond(face, place).place == border; }
  /// Whether the face beyond runs along the edge the same way: one of both is turned.
  bool is_twisted(Index face, Index place) const {
    const auto& [other, other_place] = beyond(face, place);
    return faces_[other][other_place] == faces_[face][place];
  }

  /// A side between two vertices that has a face beyond; without a face where there is none.
  Side inner_side(Index v, Index w) const;

  Fan fan(Index v) const;

 private:
  static constexpr Index border = 3;   ///< the place of no face: there is none
  static constexpr Index crowded = 4;  ///< there are several, or the edge has no length

  /// From face to face around a vertex, until there is no way on or it has come around.
  struct Walk {
    std::size_t n_faces;
    Side end;  ///< what lies beyond the last one
  };

  Side find_beyond(Index face, Index place) const;
  Walk walk_around(Index v, const Side& start) const;

  std::span<const Triangle> faces_;
  const VertexCorners& corners_;
  std::vector<std::array<Side, 3>> beyond_;
};

}  // namespace whittle
