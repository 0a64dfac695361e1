#pragma once

#include <span>
#include <vector>

#include "surface/surface_walk.hh"
#include "whittle/core/detail/index_lists.hh"

namespace whittle {

/// A surface, and what became of its vertices: vertices of a mesh, or `invalid_index`.
struct SimplifiedSurface {
  std::span<const Triangle> faces;
  std::span<const Vec3> positions;
  std::span<const Index> vertex_map;
};

/// How far two surfaces are apart, both ways, at some points of each: for comparing what a mesh was with what it has
/// become.
class TwoSidedError {
 public:
  /// Keeps what `original` refers to.
  TwoSidedError(const SimplifiedSurface& original, std::span<const Triangle> mesh_faces, std::size_t n_mesh_vertices);

  struct Distance {
    double square;
    double weight;  ///< those of each side add up to one half
  };
  /// At the same points every time. \param mesh has the faces that this was made for
  std::vector<Distance> distances(const Surface& mesh, unsigned threads) const;

 private:
  SimplifiedSurface original_;
  IndexLists<Index> origins_;  ///< vertices of the original, by those that they are mapped to, of faces with points
  VertexCorners original_corners_;  ///< at those
};

}  // namespace whittle
