#pragma once

#include <string>
#include <vector>

#include "whittle/core/material/material.hh"
#include "whittle/scene/scene.hh"

// Materials of a mesh file, for programs that show it.

namespace whittle {

struct SceneMaterials {
  std::vector<Material> of_groups;             ///< by face group of the scene's mesh, or one without groups
  bool are_told = false;                       ///< whether the file has materials
  ColorEncoding colors = ColorEncoding::srgb;  ///< of the mesh's vertex colours
  std::vector<std::string> warnings{};  ///< a line each, without the name of the file: unreadable files except images
};

/// Reads materials from a document, the material libraries of an OBJ file, or the texture of a PLY file, with images.
/// \throw io::ReadError for invalid materials of a document
SceneMaterials read_materials(const Scene& scene);

}  // namespace whittle
