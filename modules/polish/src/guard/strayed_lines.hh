#pragma once

#include <vector>

#include "surface/line_samples.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Puts vertices back to where they were if their lines are now further from the original's than any line of their kind
/// was before, or features further than they may be. Features that were too far off before don't get further off.
class StrayedLines {
 public:
  /// Keeps references to all but the tolerance.
  /// \param before the mesh, and where its vertices were
  /// \param samples points on the original's lines, with feet on the mesh as it was. They get new feet
  /// \param feature_tolerance how far features may be from the original's, in the frame
  StrayedLines(const Surface& before, const MeshLines& lines, LineSamples& samples, double feature_tolerance);

  /// \param positions where the vertices are now
  /// \return the vertices that were put back
  std::vector<Index> take_back(std::vector<Vec3>& positions, const detail::Workers& workers);

 private:
  std::vector<Index> moved_at(Index v, const std::vector<Vec3>& positions) const;

  const Surface& before_;
  const MeshLines& lines_;
  LineSamples& samples_;
  std::vector<double> limits_;  ///< per vertex, how far its lines may be off; empty without lines
};

}  // namespace whittle::polishing
