#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::test {

/// Writes a glTF file. Meshes are named "mesh N" by readers: they have no names, and positions alone.
/// \param nodes of the document \param roots of its scene, by number
void write_gltf_scene(const std::string& path, const std::vector<IndexedMesh>& meshes, const nlohmann::json& nodes,
                      const nlohmann::json& roots);

}  // namespace whittle::test
