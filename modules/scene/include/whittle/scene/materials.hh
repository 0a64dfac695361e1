#pragma once

#include <string>
#include <vector>

#include "whittle/core/material/material.hh"
#include "whittle/scene/scene.hh"

// How the surfaces in a mesh file look, for what shows them.

namespace whittle {

struct SceneMaterials {
  /// Of glTF by mesh of the file and primitive; of meshes without triangles none. Of other formats those of one mesh,
  /// by face group, or one where it has no groups.
  std::vector<std::vector<Material>> of_meshes;
  bool are_told = false;              ///< whether the file says anything of how it looks
  std::vector<std::string> warnings;  ///< a line each, without the name of the file: what can't be read but images
};

/// From glTF, from the material libraries of an OBJ file, or the texture that a PLY file names; with images.
/// \throw io::ReadError for wrong materials of glTF
SceneMaterials read_materials(const Scene& scene);

}  // namespace whittle
