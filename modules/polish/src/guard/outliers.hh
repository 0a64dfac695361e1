#pragma once

#include <vector>

#include "original/backward_offsets.hh"

namespace whittle::polishing {

/// Puts vertices back to where they were if they stick out now: if they are further than `most` from the original, and
/// further than before. The sums of a fit don't see this, where a face leaves the original's edge behind: no point has
/// its foot there.
/// \param before of the vertices before they moved \param most at least what is near there
/// \param positions where the vertices are now
/// \return the vertices that were put back
/// \throw Cancelled
std::vector<Index> take_back_outliers(const BackwardOffsets& before, double most, std::vector<Vec3>& positions,
                                      const detail::Workers& workers);

}  // namespace whittle::polishing
