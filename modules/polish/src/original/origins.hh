#pragma once

#include <span>

#include "original/original_surface.hh"
#include "surface/vertex_corners.hh"
#include "whittle/core/detail/index_lists.hh"

namespace whittle::polishing {

/// Vertices and corners of the original that were merged into each vertex of a mesh.
class Origins {
 public:
  /// Keeps references to the original and the map.
  /// \param vertex_map as for `polish`
  /// \param n_vertices number of vertices of the mesh
  /// \param points_per_face 1 or 4 points represent a face of the original (merged_points.hh)
  /// \throw Cancelled
  Origins(const OriginalSurface& original, std::span<const Index> vertex_map, std::size_t n_vertices,
          std::size_t points_per_face, const detail::Workers& workers);

  const OriginalSurface& original() const { return original_; }
  std::size_t n_vertices() const { return vertices_.size(); }  ///< of the mesh
  /// The vertex of the mesh that a vertex of the original was merged into, or `invalid_index`.
  Index mapped(Index original_vertex) const { return vertex_map_[original_vertex]; }
  std::size_t points_per_face() const { return points_per_face_; }
  /// Vertices of the original that were merged into v, ascending.
  std::span<const Index> of(Index v) const { return vertices_.of(v); }
  /// The one nearest to a point, or `invalid_index`.
  Index nearest(Index v, const Vec3& point) const;
  /// Corners of the original's faces that were merged into v, ascending. With one point per face, first corners alone.
  std::span<const Corner> corners_of(Index v) const { return corners_.of(v); }

 private:
  const OriginalSurface& original_;
  std::span<const Index> vertex_map_;
  std::size_t points_per_face_;
  detail::IndexLists<Index> vertices_;
  VertexCorners corners_;
};

}  // namespace whittle::polishing
