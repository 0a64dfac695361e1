#pragma once

#include <vector>

#include "original/backward_offsets.hh"

namespace whittle::polishing {

/// Moves vertices back that drifted: now further than `most` from the original, and further than before. The sums of a
/// fit miss this where a face extends beyond the original's edge: no point has its closest point there.
/// \param before offsets before the moves
/// \param most largest distance, at least the `near` of `before`
/// \param positions current positions
/// \return the vertices moved back
/// \throw Cancelled
std::vector<Index> take_back_drifted_vertices(const BackwardOffsets& before, double most, std::vector<Vec3>& positions,
                                              const detail::Workers& workers);

}  // namespace whittle::polishing
