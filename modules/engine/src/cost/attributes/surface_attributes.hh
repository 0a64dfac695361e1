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
  std::vector<Index> vertex_of;  ///< of each wedge
  double farthest = 0;           ///< in the frame
};

/// The faces of the input, each in the wedges that it has now. \param wedge_of the input's wedges → the surface's, or
/// `invalid_index` \param vertex_of of the surface's wedges \param positions of the surface's vertices, in the frame
SurfaceAttributes sum_attributes(const IndexedMesh& input, const Frame& frame, const ScaledAttributes& attributes,
                                 std::span<const Index> wedge_of, std::vector<Index> vertex_of,
                                 std::span<const Vec3> positions, unsigned threads);

}  // namespace whittle
