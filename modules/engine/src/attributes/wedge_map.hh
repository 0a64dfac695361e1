#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// What has become of the input's wedges (`wedge_map`).
struct WedgeMap {
  std::vector<Index> of_input;    ///< input wedges → those of the result; `invalid_index` where it has no such corner
  std::vector<Index> vertex_of;   ///< wedges of the result → its vertices, ascending
  std::vector<Index> of_corners;  ///< `IndexedMesh::wedges` of the result
};

/// \param vertex_map, face_origins as those of `Decimation` \pre faces of the result begin with the same corner as
/// those of the input that they come from
WedgeMap map_wedges(const IndexedMesh& input, std::span<const Index> vertex_map, std::span<const Index> face_origins);

}  // namespace whittle
