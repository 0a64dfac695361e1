#pragma once

#include <limits>
#include <vector>

#include "whittle/core/parts.hh"

namespace whittle {

struct GapSearch {
  /// Gaps not below this are not looked for and given as ∞, model units. [0, ∞]. Where two surfaces run in parallel, a
  /// vertex is compared with the more of the other's the wider the gap is beside its edges.
  double max_gap = std::numeric_limits<double>::infinity();
  unsigned threads = 0;  ///< 0 = all cores. The result does not depend on it.
};

/// Of each part the least distance from one of its vertices to a vertex of another, model units; ∞ if there is none.
/// Distances between vertices, not between faces: where parts are coarse, their surfaces may be much nearer.
///
/// By a kd-tree that knows which of its branches lie in one part.
/// \param parts those of `mesh`
/// \throw std::invalid_argument for a `max_gap` that is negative or not a number, or, if there are several parts, a
///        coordinate that isn't finite.
std::vector<double> gaps_between_parts(const IndexedMesh& mesh, const Parts& parts, const GapSearch& search = {});

}  // namespace whittle
