#pragma once

#include <span>
#include <vector>

#include "surface/backward_offsets.hh"

namespace whittle::polishing {

/// Puts vertices back to where they were if they stick out now: if they are further than `most` from the original, and
/// further than before. The sums of a fit don't see this, where a face leaves the original's edge behind: no point has
/// its foot there.
/// \param before where the vertices were \param offsets from the original then
/// \param positions where the vertices are now
/// \return the vertices that were put back
/// \throw Cancelled
std::vector<Index> take_back_outliers(const BackwardOffsets& original, std::span<const Vec3> before,
                                      std::span<const Vec3> offsets, double most, std::vector<Vec3>& positions,
                                      const detail::Workers& workers);

}  // namespace whittle::polishing
