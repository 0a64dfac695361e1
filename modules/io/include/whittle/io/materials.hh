#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/io/file_notes.hh"

namespace whittle::io {

/// Materials of a mesh file.
struct SurfaceMaterials {
  /// Per face group, or one without groups; seen from both sides. White if the file has none.
  std::vector<Material> materials;
  bool are_told = false;                       ///< Whether the file has materials.
  std::vector<std::filesystem::path> missing;  ///< Unreadable libraries.
  bool has_several_textures = false;           ///< Whether a PLY file names several textures; then faces have none.
};

/// Reads the material libraries (MTL) of a mesh file. Of repeated names the first counts; invalid numbers count as
/// absent. Kd (red, green, blue) is the base colour, and hidden by a texture (map_Kd); d is the opacity. Tr is not
/// read: programs disagree on its meaning. The single texture of a PLY file is on all faces whose material isn't in a
/// library. Images are named, not read.
/// \param folder of the mesh file
/// \param mesh the file's mesh, or one made from it, with its groups and attributes
SurfaceMaterials read_materials(const FileNotes& notes, const std::filesystem::path& folder, const IndexedMesh& mesh);

/// Reads the images of materials, each once. \param folder base of relative paths
void read_images(std::span<Material> materials, const std::filesystem::path& folder);

}  // namespace whittle::io
