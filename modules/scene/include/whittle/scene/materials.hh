#pragma once

#include <string>
#include <vector>

#include "whittle/core/material/material.hh"
#include "whittle/scene/scene.hh"

// Materials of a mesh file, for programs that show it.

namespace whittle {

struct SceneMaterials {
  /// In glTF by mesh of the file and primitive; none for meshes without triangles. In other formats of one mesh, by
  /// face group, or one without groups.
  std::vector<std::vector<Material>> of_meshes;
  bool are_told = false;              ///< whether the file has materials
  std::vector<std::string> warnings;  ///< a line each, without the name of the file: unreadable files except images
};

/// Reads materials from glTF, the material libraries of an OBJ file, or the texture of a PLY file, with images.
/// \throw io::ReadError for invalid materials of glTF
SceneMaterials read_materials(const Scene& scene);

}  // namespace whittle
