#pragma once

#include <span>

#include "whittle/core/frame.hh"
#include "whittle/engine/options.hh"

namespace whittle {

/// Gives a decimated mesh the attributes of the input, as `decimate` does: each wedge has the mean of those merged into
/// it, by kind of attribute; each face has what its origin has.
/// \param frame of the input \param vertex_map, face_origins as those of `Decimation`
/// \param mesh has positions and faces. If the input has wedges, the corners of each face are in their first order
void carry_attributes(const IndexedMesh& input, const Frame& frame, Normals normals, std::span<const Index> vertex_map,
                      std::span<const Index> face_origins, IndexedMesh& mesh);

/// Fits the attributes of a simplified mesh to those of its input, by least squares over samples of the input
/// (attribute_fit.cc). Each is compared within its chart. Categories and joint weights are those of the nearest point.
/// \param face_origins as that of `Decimation`
/// \param mesh has the attributes of the input, as `carry_attributes` gives them \param threads 0 = all cores
void fit_attributes(const IndexedMesh& input, std::span<const Index> face_origins, Normals normals, IndexedMesh& mesh,
                    unsigned threads);

}  // namespace whittle
