#pragma once

#include <cstddef>

#include "document/json.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::gltf {

/// `Asset::triangles` of what the file has. \throw io::ReadError
IndexedMesh read_triangles(const Model& model, const Json& document, std::size_t mesh);

}  // namespace whittle::gltf
