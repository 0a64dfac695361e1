#pragma once

#include <span>

#include "index_lists.hh"
#include "surface_walk.hh"

namespace whittle {

/// How far two surfaces are apart, both ways, at some points of each: for comparing what a mesh was with what it has
/// become.
class TwoSidedError {
 public:
  /// Keeps references to all.
  /// \param vertex_map vertices of `original` → vertices of a mesh that has so many, or `invalid_index`
  TwoSidedError(const Surface& original, std::span<const Index> vertex_map, std::size_t n_mesh_vertices);

  /// Half the sum of both ways' mean squared distances.
  double mean_square(const Surface& mesh, unsigned threads) const;

 private:
  Surface original_;
  std::span<const Index> vertex_map_;
  IndexLists<Index> origins_;  ///< vertices of the original, by what they are mapped to
};

}  // namespace whittle
