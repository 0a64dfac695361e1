#pragma once

#include <vector>

#include "surface/line_samples.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Puts vertices back to where they were if their lines are now further from the original's than any line was before.
/// \param before the mesh, and where its vertices were
/// \param samples points on the original's lines, with feet on the mesh as it was. They get new feet
/// \param positions where the vertices are now
/// \return the vertices that were put back
std::vector<Index> take_back_strayed_lines(const Surface& before, const MeshLines& lines, LineSamples& samples,
                                           std::vector<Vec3>& positions, const detail::Workers& workers);

}  // namespace whittle::polishing
