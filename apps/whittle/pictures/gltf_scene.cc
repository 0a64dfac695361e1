#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "files/gltf_materials.hh"
#include "pictures/read_scene.hh"

namespace whittle::app {
namespace {

/// Reads each image once.
class AssetTextures {
 public:
  AssetTextures(const gltf::Asset& asset, std::vector<std::string>& warnings) : asset_(asset), warnings_(warnings) {}

  /// \return null if the image can't be read, with a warning
  std::shared_ptr<const render::Texture> of(const gltf::TextureUse& use) {
    const auto [slot, is_new] = textures_.try_emplace({use.image, use.wrap_u, use.wrap_v});
    if (!is_new) return slot->second;
    const std::shared_ptr<const render::Texture> image = image_of(use.image);
    if (!image) return nullptr;
    auto texture = std::make_shared<render::Texture>(*image);
    texture->wrap_u = wrap_as<render::Wrap>(use.wrap_u);
    texture->wrap_v = wrap_as<render::Wrap>(use.wrap_v);
    return slot->second = std::move(texture);
  }

 private:
  std::shared_ptr<const render::Texture> image_of(std::size_t image) {
    const auto [slot, is_new] = images_.try_emplace(image);
    if (!is_new) return slot->second;
    try {
      slot->second = std::make_shared<render::Texture>(render::read_image(asset_.image(image)));
    } catch (const std::runtime_error& error) {
      warnings_.push_back("image " + std::to_string(image) + " is not drawn: " + error.what());
    }
    return slot->second;
  }

  const gltf::Asset& asset_;
  std::vector<std::string>& warnings_;
  std::map<std::size_t, std::shared_ptr<const render::Texture>> images_;
  std::map<std::tuple<std::size_t, gltf::Wrap, gltf::Wrap>, std::shared_ptr<const render::Texture>> textures_;
};

render::Material drawn(const gltf::Material& material, AssetTextures& textures) {
  render::Material to;
  to.base_color = material.base_color;
  to.alpha_mode = alpha_as<render::AlphaMode>(material.alpha_mode);
  to.alpha_cutoff = material.alpha_cutoff;
  to.double_sided = material.double_sided;
  if (const auto& use = material.base_color_texture) {
    to.base_color_texture = textures.of(*use);
    to.texcoord = "TEXCOORD_" + std::to_string(use->texcoord);
    to.texcoord_transform = use->transform;
  }
  return to;
}

bool has_instances(const gltf::Asset& asset) {
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) > 0 && asset.n_instances(m) > 0) return true;
  }
  return false;
}

}  // namespace

ReadScene scene_of(const gltf::Asset& asset) {
  ReadScene read;
  AssetTextures textures(asset, read.warnings);
  const bool has_nodes = has_instances(asset);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) == 0) continue;
    std::vector<Eigen::Matrix4d> transforms = asset.world_transforms(m);
    if (!has_nodes) transforms.push_back(Eigen::Matrix4d::Identity());
    if (transforms.empty()) continue;
    render::Part part;
    part.mesh = &read.meshes.emplace_back(asset.triangles(m));
    for (const gltf::Material& material : asset.materials(m)) part.materials.push_back(drawn(material, textures));
    for (const Eigen::Matrix4d& transform : transforms) {
      part.transform = Eigen::Affine3d(transform);
      read.scene.parts.push_back(part);
    }
  }
  return read;
}

}  // namespace whittle::app
