#include "pictures/read_scene.hh"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "files/gltf_file.hh"
#include "whittle/io/materials.hh"

namespace whittle::app {
namespace {

namespace fs = std::filesystem;

/// Reads the textures of a mesh file, each once.
class MeshTextures {
 public:
  MeshTextures(fs::path folder, std::vector<std::string>& warnings) : folder_(std::move(folder)), warnings_(warnings) {}

  /// \return null if it can't be read, with a warning
  std::shared_ptr<const render::Texture> at(const fs::path& path) {
    const auto [slot, is_new] = textures_.try_emplace(path);
    if (!is_new) return slot->second;
    try {
      slot->second = std::make_shared<render::Texture>(render::read_image(bytes_of(folder_ / path)));
    } catch (const std::runtime_error& error) {
      warnings_.push_back("texture " + path.string() + " is not drawn: " + error.what());
    }
    return slot->second;
  }

 private:
  static std::string bytes_of(const fs::path& path) {
    std::error_code error;
    std::ifstream file(path, std::ios::binary);
    if (!fs::is_regular_file(path, error) || !file) throw std::runtime_error("the file can't be read");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_;
  std::vector<std::string>& warnings_;
  std::map<fs::path, std::shared_ptr<const render::Texture>> textures_;
};

/// The look of a surface of which the file says nothing: white, and seen from both sides.
render::Material plain_material(const IndexedMesh& mesh) {
  render::Material material;
  material.double_sided = true;
  const auto uv = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                               [](const Attribute& a) { return a.kind == AttributeKind::texcoord; });
  if (uv != mesh.attributes.end()) material.texcoord = uv->name;
  // v points up in these formats.
  material.texcoord_transform = Eigen::Translation2d(0, 1) * Eigen::Scaling(1.0, -1.0);
  return material;
}

/// A texture hides Kd, as in most programs.
render::Material drawn(const io::SurfaceMaterial& from, render::Material to, MeshTextures& textures) {
  if (!from.texture.empty()) to.base_color_texture = textures.at(from.texture);
  if (!to.base_color_texture) std::copy(from.diffuse.begin(), from.diffuse.end(), to.base_color.begin());
  to.base_color[3] = from.opacity;
  if (from.opacity < 1) to.alpha_mode = render::AlphaMode::blend;
  return to;
}

/// Materials by face group. A PLY file with one texture has it on all faces.
std::vector<render::Material> materials_of(const io::ReadResult& file, const io::SurfaceMaterials& from,
                                           MeshTextures& textures) {
  render::Material plain = plain_material(file.mesh);
  if (from.textures.size() == 1) plain.base_color_texture = textures.at(from.textures.front());
  std::vector<render::Material> materials(std::max<std::size_t>(1, file.mesh.group_names.size()), plain);
  for (std::size_t g = 0; g < file.mesh.group_names.size(); ++g) {
    const auto found = std::find_if(from.materials.begin(), from.materials.end(),
                                    [&](const auto& material) { return material.name == file.mesh.group_names[g]; });
    if (found != from.materials.end()) materials[g] = drawn(*found, plain, textures);
  }
  return materials;
}

}  // namespace

ReadScene read_scene(const Input& input) {
  if (input.gltf) return scene_of(input.gltf->asset());
  const fs::path folder = input.path == standard_stream ? fs::path() : fs::path(input.path).parent_path();
  const io::SurfaceMaterials from = io::read_materials(input.read.notes, folder);
  ReadScene read;
  for (const fs::path& library : from.missing) {
    read.warnings.push_back("material library " + library.string() + " can't be read, its materials are not drawn");
  }
  if (from.textures.size() > 1) read.warnings.emplace_back("it has several textures, none of them is drawn");
  MeshTextures textures(folder, read.warnings);
  render::Part part;
  part.mesh = &input.read.mesh;
  part.materials = materials_of(input.read, from, textures);
  part.vertex_colors = render::ColorEncoding::srgb;
  read.scene.parts.push_back(std::move(part));
  return read;
}

}  // namespace whittle::app
