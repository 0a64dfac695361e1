#pragma once

#include <span>
#include <vector>

#include "surface/simplified_surface.hh"
#include "surface/surface_walk.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/progress_meter.hh"

namespace whittle::polishing {

/// The distance between two surfaces, both ways, at some points of each. For comparing a mesh before and after a pass.
class TwoSidedError {
 public:
  /// Keeps references to what `original` refers to. \throw Cancelled
  TwoSidedError(const SimplifiedSurface& original, std::span<const Triangle> mesh_faces, std::size_t n_mesh_vertices,
                const detail::Workers& workers);

  struct Distance {
    double square;
    double weight;  ///< the weights of each direction add up to one half
  };
  /// At the same points in every call. \param mesh has the faces that this was made for
  /// \throw Cancelled
  std::vector<Distance> distances(const Surface& mesh, const detail::Workers& workers) const;

 private:
  SimplifiedSurface original_;
  /// For each vertex of faces with points, the original's vertices that are mapped to it.
  detail::IndexLists<Index> origins_;
  VertexCorners original_corners_;  ///< of those vertices of the original
};

}  // namespace whittle::polishing
