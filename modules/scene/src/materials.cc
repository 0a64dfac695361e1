#include "whittle/scene/materials.hh"

#include <filesystem>

#include "whittle/io/materials.hh"
#include "whittle/io/path_of.hh"
#include "whittle/scene/scene_document.hh"

namespace whittle {
namespace {

namespace fs = std::filesystem;

SceneMaterials materials_beside(const Scene& scene) {
  const fs::path folder = scene.path == standard_stream ? fs::path() : io::path_of(scene.path).parent_path();
  io::SurfaceMaterials from = io::read_materials(scene.read.notes, folder, scene.read.mesh);
  io::read_images(from.materials, folder);
  SceneMaterials materials{.of_groups = std::move(from.materials), .are_told = from.are_told};
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

SceneMaterials read_materials(const Scene& scene) {
  if (!scene.document) return materials_beside(scene);
  SceneMaterials materials{.of_groups = scene.document->materials(), .are_told = true, .colors = ColorEncoding::linear};
  const std::vector<std::string>& groups = scene.read.mesh.group_names;
  for (std::size_t i = 0; i < materials.of_groups.size(); ++i) {
    materials.of_groups[i].name = i < groups.size() ? groups[i] : "";
  }
  return materials;
}

}  // namespace whittle
