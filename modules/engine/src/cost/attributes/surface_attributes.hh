#pragma once

#include <span>
#include <vector>

#include "cost/attributes/scaled_attributes.hh"
#include "cost/attributes/wedge_quadrics.hh"

namespace whittle {

/// The wedges of a surface, for a stage to begin with. Noise in an attribute must not hold geometry, so a wedge costs
/// at most `farthest`² times its weight, and the slopes of its functions are cut.
struct SurfaceAttributes {
  WedgeQuadrics wedges;          ///< each about its vertex
  std::vector<Index> vertex_of;  ///< of each wedge; ascending
  double farthest = 0;           ///< in the frame

  /// Those of some vertices, which get their places as numbers. \param vertices ascending
  SurfaceAttributes at(std::span<const Index> vertices) const;
};

}  // namespace whittle
