#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "whittle/metrics/closest_point.hh"

namespace whittle {

/// Finds closest points of a surface in one of its regions.
class RegionTrees {
 public:
  /// Where a region comes nearest to a point.
  struct Foot {
    Index face = invalid_index;       ///< `invalid_index` if the mesh has no such region
    std::array<double, 3> weights{};  ///< barycentric coordinates in that face
  };

  /// \param regions of each face
  RegionTrees(const IndexedMesh& mesh, std::span<const Index> regions);

  /// \param hint an earlier foot in this region, or any other: only the time depends on it
  Foot nearest(Index region, const Vec3& point, const Foot& hint) const;

 private:
  struct Part {
    std::vector<Index> faces;  ///< of the mesh
    metrics::TriangleTree tree;
  };

  const IndexedMesh& mesh_;
  std::vector<Part> parts_;
  std::unordered_map<Index, std::size_t> part_of_region_;
  std::vector<Index> places_;  ///< of each face among those of its part
  std::vector<Index> regions_;
};

}  // namespace whittle
