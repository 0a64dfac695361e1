#include "pictures/read_scene.hh"

#include <Eigen/Geometry>
#include <utility>

#include "whittle/scene/gltf_file.hh"
#include "whittle/scene/materials.hh"

namespace whittle::app {
namespace {

/// Adds all nodes of an asset that have meshes.
void add_parts(const gltf::Asset& asset, const SceneMaterials& materials, ReadScene& read) {
  const bool has_nodes = shows_meshes(asset);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) == 0) continue;
    std::vector<Eigen::Matrix4d> transforms = asset.world_transforms(m);
    if (!has_nodes) transforms.push_back(Eigen::Matrix4d::Identity());
    if (transforms.empty()) continue;
    render::Part part;
    part.mesh = &read.meshes.emplace_back(asset.triangles(m));
    part.materials = materials.of_meshes[m];
    for (const Eigen::Matrix4d& transform : transforms) {
      part.transform = Eigen::Affine3d(transform);
      read.scene.parts.push_back(part);
    }
  }
}

}  // namespace

ReadScene read_scene(const Scene& input) {
  const SceneMaterials materials = read_materials(input);
  ReadScene read;
  read.warnings = materials.warnings;
  if (input.gltf) {
    add_parts(input.gltf->asset(), materials, read);
  } else {
    render::Part& part = read.scene.parts.emplace_back();
    part.mesh = &input.read.mesh;
    part.materials = materials.of_meshes[0];
    part.vertex_colors = ColorEncoding::srgb;
  }
  for (std::string& problem : render::decode_images(read.scene)) read.warnings.push_back(std::move(problem));
  return read;
}

}  // namespace whittle::app
