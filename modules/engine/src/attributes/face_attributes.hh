#pragma once

#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Gives faces the attributes and groups of others. \param face_origins of the faces of `mesh`, in `input`
void carry_face_attributes(const IndexedMesh& input, std::span<const Index> face_origins, IndexedMesh& mesh);

}  // namespace whittle
