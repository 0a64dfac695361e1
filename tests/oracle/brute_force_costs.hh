#pragma once

#include <functional>
#include <span>
#include <vector>

#include "oracle/volume_sums.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/lindstrom_turk.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/formula/valence_term.hh"

namespace whittle::test {

/// What costs see of a surface at one moment, all of it found anew from its faces. Sums have the order that the engine
/// promises, by vertex numbers, so that they agree to the bit; the arithmetic of one pair is the engine's.
class SurfaceNow {
 public:
  /// \param positions those of vertices; not copied
  SurfaceNow(std::span<const Vec3> positions, std::span<const Triangle> faces);

  PairEvaluation lindstrom_turk(Index a, Index b, Pinned pinned) const;
  ValenceChange valence_change(Index a, Index b) const;

 private:
  /// Of a face at a vertex, in its order.
  struct OtherCorners {
    Index x, y;
    auto operator<=>(const OtherCorners&) const = default;
  };
  struct Vertex {
    std::vector<OtherCorners> corners;  ///< of a ring from the lowest number on, of anything else sorted
    VolumeSums volume;                  ///< about the vertex
    NeighbourSums link;                 ///< about the vertex; of a ring in the order of `corners`, else ascending
    std::vector<Index> neighbours;      ///< ascending
    bool on_border = false;             ///< its faces are not one closed fan
  };
  /// The third corner of a face of two vertices, 1 if these are in the face's order, else −1.
  struct Third {
    Index corner;
    int turn;
  };

  std::vector<Third> common_faces(Index a, Index b) const;
  VolumeSums volume_of(Index a, Index b) const;
  BorderSums border_of(Index a, Index b) const;
  NeighbourSums neighbours_of(Index a, Index b) const;

  std::span<const Vec3> positions_;
  std::vector<Vertex> vertices_;
};

}  // namespace whittle::test
