#include "pictures/read_scene.hh"

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "whittle/scene/gltf_file.hh"
#include "files/materials.hh"

namespace whittle::app {
namespace {

using Texture = std::shared_ptr<const render::Texture>;

/// Decodes each image once.
class Textures {
 public:
  Textures(const std::vector<MaterialImage>& images, std::vector<std::string>& warnings)
      : images_(images), warnings_(warnings) {}

  /// \return null if there is none, or if it can't be drawn, with a warning
  Texture of(const FileMaterial& material) {
    if (!material.image) return nullptr;
    const auto [slot, is_new] = textures_.try_emplace({*material.image, material.wrap[0], material.wrap[1]});
    if (!is_new) return slot->second;
    const Texture image = decoded(*material.image);
    if (!image) return nullptr;
    auto texture = std::make_shared<render::Texture>(*image);
    texture->wrap_u = wrap_as<render::Wrap>(material.wrap[0]);
    texture->wrap_v = wrap_as<render::Wrap>(material.wrap[1]);
    return slot->second = std::move(texture);
  }

 private:
  Texture decoded(std::size_t number) {
    const auto [slot, is_new] = decoded_.try_emplace(number);
    if (!is_new) return slot->second;
    const MaterialImage& image = images_[number];
    try {
      if (!image.bytes) throw std::runtime_error(image.problem);
      slot->second = std::make_shared<render::Texture>(render::read_image(*image.bytes));
    } catch (const std::runtime_error& error) {
      warnings_.push_back(image.name + " is not drawn: " + error.what());
    }
    return slot->second;
  }

  const std::vector<MaterialImage>& images_;
  std::vector<std::string>& warnings_;
  std::map<std::size_t, Texture> decoded_;
  std::map<std::tuple<std::size_t, gltf::Wrap, gltf::Wrap>, Texture> textures_;
};

render::Material drawn(const FileMaterial& material, Textures& textures) {
  render::Material to;
  to.base_color_texture = textures.of(material);
  to.base_color = to.base_color_texture ? material.base_color : material.imageless_color;
  to.texcoord = material.texcoord;
  to.texcoord_transform = material.texcoord_transform;
  to.alpha_mode = alpha_as<render::AlphaMode>(material.alpha_mode);
  to.alpha_cutoff = material.alpha_cutoff;
  to.double_sided = material.double_sided;
  return to;
}

/// Adds all nodes of an asset that have meshes.
void add_parts(const gltf::Asset& asset, const FileMaterials& materials, Textures& textures, ReadScene& read) {
  const bool has_nodes = shows_meshes(asset);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) == 0) continue;
    std::vector<Eigen::Matrix4d> transforms = asset.world_transforms(m);
    if (!has_nodes) transforms.push_back(Eigen::Matrix4d::Identity());
    if (transforms.empty()) continue;
    render::Part part;
    part.mesh = &read.meshes.emplace_back(asset.triangles(m));
    for (const FileMaterial& material : materials.of_meshes[m]) part.materials.push_back(drawn(material, textures));
    for (const Eigen::Matrix4d& transform : transforms) {
      part.transform = Eigen::Affine3d(transform);
      read.scene.parts.push_back(part);
    }
  }
}

}  // namespace

ReadScene read_scene(const Scene& input) {
  const FileMaterials materials = read_materials(input);
  ReadScene read;
  read.warnings = materials.warnings;
  Textures textures(materials.images, read.warnings);
  if (input.gltf) {
    add_parts(input.gltf->asset(), materials, textures, read);
    return read;
  }
  render::Part part;
  part.mesh = &input.read.mesh;
  for (const FileMaterial& material : materials.of_meshes[0]) part.materials.push_back(drawn(material, textures));
  part.vertex_colors = render::ColorEncoding::srgb;
  read.scene.parts.push_back(std::move(part));
  return read;
}

}  // namespace whittle::app
