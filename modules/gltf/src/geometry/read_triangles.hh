#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "document/json.hh"
#include "model/model.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::gltf {

/// `Asset::triangles` of the file's mesh. \throw io::ReadError
IndexedMesh read_triangles(const Model& model, const Json& document, std::size_t mesh);

/// The name of each primitive's material: "material 3" if it has none, "no material".
std::vector<std::string> material_names(const Model& model, const Json& document, std::size_t mesh);

}  // namespace whittle::gltf
