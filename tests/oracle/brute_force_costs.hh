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

/// Properties of a cost besides its formula.
struct CostFacts {
  double dimension;  ///< the unit of the cost is a length to this power
  double max_normal_flip_deg;
};
CostFacts facts_of(const DecimateOptions& options);

/// What costs need to know about the current surface, computed anew from its faces. Sums have the order that the engine
/// promises, by vertex numbers, so they agree to the bit. The arithmetic of one pair is the engine's.
class SurfaceNow {
 public:
  /// \param positions of the vertices; not copied
  SurfaceNow(std::span<const Vec3> positions, std::span<const Triangle> faces);

  PairEvaluation lindstrom_turk(Index a, Index b, PairConstraint constraint) const;
  ValenceChange valence_change(Index a, Index b) const;

 private:
  /// The other two corners of a face at a vertex, in the face's order.
  struct OtherCorners {
    Index x, y;
    auto operator<=>(const OtherCorners&) const = default;
  };
  struct Vertex {
    std::vector<OtherCorners> corners;  ///< for one closed fan: in ring order from the lowest number; otherwise sorted
    VolumeSums volume;                  ///< about the vertex
    NeighbourSums link;             ///< about the vertex; for one closed fan in the order of `corners`, else ascending
    std::vector<Index> neighbours;  ///< ascending
    bool on_border = false;         ///< its faces are not one closed fan
  };
  /// The third corner of a face at two vertices. `turn` is 1 if these are in the face's order, else −1.
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
