#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/io/file_notes.hh"

namespace whittle::io {

/// What a mesh file says of how its surface looks.
struct SurfaceMaterials {
  /// By face group, or one where there are no groups; seen from both sides. Of a file that says nothing they are white.
  std::vector<Material> materials;
  bool are_told = false;                       ///< Whether the file says anything of them.
  std::vector<std::filesystem::path> missing;  ///< Libraries that can't be read.
  bool has_several_textures = false;           ///< Of a PLY file, whose faces then have none.
};

/// Reads the material libraries (MTL) that a mesh file names: of a name that comes twice, the first counts; numbers
/// that aren't valid count as absent. Kd (red, green, blue) is the base colour, and hidden by a texture (map_Kd); d is
/// the opacity. Tr is not read: programs disagree on what it means. The one texture that a PLY file names is on all
/// faces whose material isn't in a library. Images are named, not read.
/// \param folder of the mesh file \param mesh of it, or what has become of that: with its groups and attributes
SurfaceMaterials read_materials(const FileNotes& notes, const std::filesystem::path& folder, const IndexedMesh& mesh);

/// Reads the images that materials name, each once. \param folder that their files are relative to
void read_images(std::span<Material> materials, const std::filesystem::path& folder);

}  // namespace whittle::io
