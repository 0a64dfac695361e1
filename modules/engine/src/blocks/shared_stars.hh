#pragma once

#include "blocks/partition.hh"

namespace whittle {

/// What blocks don't know of their shared vertices: the faces of several blocks at them.
class SharedStars {
 public:
  /// \param surface must outlive this
  SharedStars(const WorkingSurface& surface, const Partition& partition);

  /// Shared vertices that aren't manifold, and edges between two shared ones with three faces or more.
  NonmanifoldCounts count_nonmanifold() const;
  /// The quadrics of shared vertices, by vertex of the surface.
  std::vector<VertexQuadric> quadrics(const DecimateOptions& options) const;

 private:
  std::vector<Index> vertices_;       ///< of the surface, ascending: shared ones and their neighbours
  std::vector<Vec3> positions_;       ///< theirs, in the frame
  std::vector<Triangle> faces_;       ///< those that have a shared vertex, by these numbers
  std::vector<std::uint8_t> frozen_;  ///< per vertex, whether it isn't shared
};

}  // namespace whittle
