#include "pictures/read_scene.hh"

#include <utility>

#include "whittle/scene/materials.hh"
#include "whittle/scene/scene_document.hh"

namespace whittle::app {
namespace {

/// Adds each mesh at all its places.
void add_parts(const SceneDocument& document, ReadScene& read) {
  for (PlacedMesh& shown : document.shown_meshes()) {
    render::Part part;
    part.mesh = &read.meshes.emplace_back(std::move(shown.mesh));
    part.materials = std::move(shown.materials);
    for (const Eigen::Affine3d& place : shown.places) {
      part.transform = place;
      read.scene.parts.push_back(part);
    }
  }
}

}  // namespace

ReadScene read_scene(const Scene& input) {
  ReadScene read;
  if (input.document) {
    add_parts(*input.document, read);
  } else {
    SceneMaterials materials = read_materials(input);
    read.warnings = std::move(materials.warnings);
    render::Part& part = read.scene.parts.emplace_back();
    part.mesh = &input.read.mesh;
    part.materials = std::move(materials.of_groups);
    part.vertex_colors = ColorEncoding::srgb;
  }
  for (std::string& problem : render::decode_images(read.scene)) read.warnings.push_back(std::move(problem));
  return read;
}

}  // namespace whittle::app
