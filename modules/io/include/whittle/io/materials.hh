#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "whittle/io/file_notes.hh"

namespace whittle::io {

/// How a surface looks without light.
struct SurfaceMaterial {
  std::string name;                           ///< As `IndexedMesh::group_names` has it; empty in PLY.
  std::array<double, 3> diffuse = {1, 1, 1};  ///< MTL's Kd: red, green, blue, each in [0, 1].
  double opacity = 1;                         ///< MTL's d, [0, 1]. Tr is not read: programs disagree on what it means.
  std::filesystem::path texture;              ///< MTL's map_Kd, relative to the mesh file's folder; or empty.
};

/// What a mesh file says of how its surface looks.
struct SurfaceMaterials {
  std::vector<SurfaceMaterial> materials;  ///< Those of all libraries; of a name that comes twice the first counts.
  std::vector<std::filesystem::path> textures;  ///< Those that the header of a PLY file names, in its order.
  std::vector<std::filesystem::path> missing;   ///< Libraries that can't be read.
};

/// Reads the material libraries (MTL) that a mesh file names. Numbers that aren't valid count as absent.
/// \param folder of the mesh file
SurfaceMaterials read_materials(const FileNotes& notes, const std::filesystem::path& folder);

}  // namespace whittle::io
