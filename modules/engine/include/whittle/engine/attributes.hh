#pragma once

#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// Gives a decimated mesh the colours and normals of the input's vertices, as `decimate` does: the mean of those
/// merged. \param frame of the input \param vertex_map as that of `Decimation` \param mesh has positions and faces
void carry_attributes(const IndexedMesh& input, const Frame& frame, Normals normals,
                      const std::vector<Index>& vertex_map, IndexedMesh& mesh);

}  // namespace whittle
