#include "files/materials.hh"

#include <filesystem>

#include "whittle/scene/gltf_file.hh"
#include "whittle/io/materials.hh"

namespace whittle::app {
namespace {

namespace fs = std::filesystem;

FileMaterials materials_beside(const Scene& input) {
  const fs::path folder = input.path == standard_stream ? fs::path() : fs::path(input.path).parent_path();
  io::SurfaceMaterials from = io::read_materials(input.read.notes, folder, input.read.mesh);
  io::read_images(from.materials, folder);
  FileMaterials materials{.of_meshes = {std::move(from.materials)}, .are_told = from.are_told, .warnings = {}};
  for (const fs::path& library : from.missing) {
    materials.warnings.push_back("material library " + library.string() +
                                 " can't be read, its materials are not shown");
  }
  if (from.has_several_textures) {
    materials.warnings.emplace_back("it has several textures, none of them is shown");
  }
  return materials;
}

}  // namespace

FileMaterials read_materials(const Scene& input) {
  if (!input.gltf) return materials_beside(input);
  return {.of_meshes = input.gltf->asset().materials(), .are_told = true, .warnings = {}};
}

}  // namespace whittle::app
