#pragma once

#include <vector>

#include "complex/restraints.hh"
#include "cost/cost_state.hh"
#include "loop/pass.hh"

namespace whittle {

/// What passes have left of the input, for others to go on from.
struct Remainder {
  std::vector<Vec3> positions;  ///< in the frame
  std::vector<Triangle> faces;
  std::vector<Index> origins;       ///< vertices of the input, ascending
  std::vector<Index> face_origins;  ///< faces of the input, ascending
  std::vector<Index> vertex_map;    ///< the input's vertices → those here; `invalid_index` where it was in no face
  FeatureLines lines;
  std::vector<PlacedQuadric> quadrics;  ///< a vertex, where they are asked for

  // For another pass.
  CostState cost_state;
  std::vector<VertexPair> threshold_pairs;  ///< that may still be contracted
  std::vector<GuardedPair> refusals;        ///< that still hold, if the order is exact

  /// A copy without what is for another pass.
  Remainder geometry() const;

  /// The flags of the vertices here. \param flags per vertex of the input, or empty
  std::vector<std::uint8_t> of_vertices(const std::vector<std::uint8_t>& flags) const {
    std::vector<std::uint8_t> here;
    if (flags.empty()) return here;
    here.reserve(origins.size());
    for (const Index v : origins) here.push_back(flags[v]);
    return here;
  }
};

/// What is wanted of a pass besides what it leaves of the mesh.
struct Gathering {
  bool what_to_go_on_from = false;  ///< if another pass follows
  bool quadrics = false;
};

/// What a pass leaves after its contractions.
/// \param faces that it began with \param before what it began with; null if that was the input
Remainder remainder_of(Pass& pass, std::span<const Triangle> faces, const Remainder* before,
                       const Gathering& gathering);

}  // namespace whittle
