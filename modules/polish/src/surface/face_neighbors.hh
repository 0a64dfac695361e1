#pragma once

#include <array>
#include <span>
#include <vector>

#include "surface/vertex_corners.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// A side of a face, from one corner to the next.
struct Side {
  Index face = invalid_index;
  Index slot = 0;  ///< of its first corner
};

/// How the faces at a vertex are connected over the edges there.
enum class Fan {
  closed,  ///< in one ring
  open,    ///< in one row, from border edge to border edge
  none     ///< in neither, or there are no faces: the surface is not manifold there
};

/// The neighbours of a mesh's faces.
class FaceNeighbors {
 public:
  /// Keeps references to faces and corners. \throw Cancelled
  FaceNeighbors(std::span<const Triangle> faces, const VertexCorners& corners, const detail::Workers& workers);

  std::size_t n_faces() const { return faces_.size(); }

  /// The same edge as a side of its other face. Without a face unless the edge has exactly one other.
  const Side& beyond(Index face, Index slot) const { return beyond_[face][slot]; }
  /// Whether the edge has no other face.
  bool is_border(Index face, Index slot) const { return beyond(face, slot).slot == border; }
  /// Whether the face beyond runs along the edge in the same direction: one of the two is turned over.
  /// \pre there is a face beyond
  bool is_twisted(Index face, Index slot) const {
    const auto& [other, other_slot] = beyond(face, slot);
    return faces_[other][other_slot] == faces_[face][slot];
  }

  /// A side between two vertices that has a face beyond. Without a face where there is none.
  Side inner_side(Index v, Index w) const;

  Fan fan(Index v) const;

 private:
  // Slots of sides without a face: the reason.
  static constexpr Index border = 3;   ///< the edge has no second face
  static constexpr Index crowded = 4;  ///< the edge has more than two faces, or the face has two equal corners

  /// From face to face around a vertex, up to an edge without a face beyond, or once around.
  struct Walk {
    std::size_t n_faces;
    Side end;  ///< the side beyond the last face
  };

  /// A side of a face, at the edge to some vertex.
  struct EdgeSide {
    Index vertex;
    Side side;
  };

  void connect_at(Index v, std::vector<EdgeSide>& sides);
  Walk walk_around(Index v, const Side& start) const;

  std::span<const Triangle> faces_;
  const VertexCorners& corners_;
  std::vector<std::array<Side, 3>> beyond_;
};

}  // namespace whittle::polishing
