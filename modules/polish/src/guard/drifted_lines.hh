#pragma once

#include <vector>

#include "surface/line_samples.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Finds lines that drifted: further from the original's than any line of their kind was before, or features beyond
/// their tolerance. Moves their vertices back. Features beyond their tolerance before don't get further off.
class DriftedLines {
 public:
  /// Keeps references to all but the tolerance.
  /// \param before the mesh, and where its vertices were
  /// \param samples points on the original's lines, with closest points on `before`. They get new closest points
  /// \param feature_tolerance largest distance of features from the original's, in the frame
  DriftedLines(const Surface& before, const MeshLines& lines, LineSamples& samples, double feature_tolerance);

  /// Moves vertices of drifted lines back. \param positions current positions \return these vertices
  std::vector<Index> take_back(std::vector<Vec3>& positions, const detail::Workers& workers);

 private:
  std::vector<Index> moved_at(Index v, const std::vector<Vec3>& positions) const;

  const Surface& before_;
  const MeshLines& lines_;
  LineSamples& samples_;
  std::vector<double> limits_;  ///< per vertex, largest distance of its lines; empty without lines
};

}  // namespace whittle::polishing
