#pragma once

#include <span>
#include <vector>

#include "guard/face_limits.hh"
#include "original/closest_point_sums.hh"
#include "surface/mesh_lines.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// Limits of flips.
struct FlipLimits {
  std::span<const Index> regions;  ///< per face, or empty; edges between two regions stay
  /// Whether no flip makes its two faces less round, or the valences of its four corners less regular: 5 to 7 edges, on
  /// the border 3 to 5.
  bool keeps_shape = false;
};

/// Flips edges of a mesh: the common side of two faces is replaced by the other diagonal of their four corners. An edge
/// is flipped where that lowers the sum of the squared distances of the points whose closest points are in the two
/// faces. It stays where the flip would turn a face over, turn neighbours in a forbidden way, make an edge that exists
/// already, make a vertex with fewer than four or more than nine faces, or make faces intersect. Edges of lines stay,
/// too.
/// \param origins of the mesh; the faces are fitted to their points
/// \return all faces, by the same numbers
/// \throw Cancelled
std::vector<Triangle> flip_edges(const Surface& mesh, const FaceNeighbors& neighbors, const FaceLimits& limits,
                                 const MeshLines& lines, const FlipLimits& flip_limits, const Origins& origins,
                                 const detail::Workers& workers);

}  // namespace whittle::polishing
