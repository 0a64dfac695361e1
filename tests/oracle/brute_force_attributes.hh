#pragma once

#include <span>
#include <utility>
#include <vector>

#include "cost/attributes/input_attributes.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/quadric.hh"

namespace whittle::test {

/// What attributes cost, with the wedges of each vertex in a list. The arithmetic of wedges is the engine's.
class BruteForceAttributes {
 public:
  struct PairCost {
    Quadric quadric;  ///< about the first vertex
    double most = 0;  ///< it counts for no more
  };

  BruteForceAttributes() = default;
  BruteForceAttributes(const IndexedMesh& mesh, const Frame& frame, const DecimateOptions& options);

  bool any() const { return surface_.wedges.any(); }
  /// \pre a < b \param a_to_b the way between both
  PairCost of(Index a, Index b, bool is_edge, const Vec3& a_to_b) const;
  /// \pre a < b, one of them is the survivor \param positions before \param position of the merged vertex
  void contract(Index a, Index b, Index survivor, bool is_edge, std::span<const Vec3> positions, const Vec3& position);

 private:
  /// A wedge at a and one at b, which become one; `invalid_index` where the other joins none.
  using Match = std::pair<Index, Index>;

  /// Each wedge of the end with fewer, a if both have as many, takes the nearest of those that are left at the other.
  /// \return first the matches of that end, in its order; then the wedges that nobody took
  std::vector<Match> matches(Index a, Index b, bool is_edge, const Vec3& a_to_b) const;

  SurfaceAttributes surface_;
  std::vector<std::vector<Index>> wedges_of_;  ///< a vertex, ascending
};

}  // namespace whittle::test
