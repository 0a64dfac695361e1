#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "whittle/engine/threshold_pairs.hh"

// Compares every two vertices of a mesh.

namespace whittle::test {

class BruteForcePairs {
 public:
  /// \param threshold in model units
  BruteForcePairs(const IndexedMesh& mesh, double threshold, bool across_walls);

  /// \param max_pairs of each vertex; 0 = no limit
  ThresholdPairs pairs(std::size_t max_pairs) const;

 private:
  double distance_sq(Index v, Index w) const { return (mesh_.positions[v] - mesh_.positions[w]).squaredNorm(); }
  bool is_near(Index v, Index w, double threshold) const;
  bool is_across_wall(Index v, Index w) const;

  const IndexedMesh& mesh_;
  std::vector<Vec3> normals_;
  std::vector<std::vector<std::pair<double, Index>>> partners_;  ///< of each vertex, by distance, then number
};

/// Of each part, the least distance of its vertices from those of others; infinite without any.
std::vector<double> gaps_by_brute_force(const IndexedMesh& mesh);

}  // namespace whittle::test
