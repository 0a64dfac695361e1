#pragma once

#include "whittle/core/geometry/box.hh"

namespace whittle {

/// The box around the vertices that have a face, in model units.
/// \throw std::invalid_argument if the mesh has no faces, a face names a missing vertex, or a position of a used vertex
///        is not finite or above 3e150.
Box bounds_of(const IndexedMesh& mesh);

}  // namespace whittle
