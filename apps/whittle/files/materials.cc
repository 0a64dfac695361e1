#include "files/materials.hh"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "whittle/scene/gltf_file.hh"
#include "whittle/io/materials.hh"
#include "whittle/io/whole_file.hh"

namespace whittle::app {
namespace {

namespace fs = std::filesystem;

/// The images of a file, each once. `Key` names one.
template <class Key>
class Images {
 public:
  explicit Images(std::vector<MaterialImage>& images) : images_(images) {}

  /// \param read gives the image that isn't there yet \return its number
  template <class Read>
  std::size_t number_of(const Key& key, const Read& read) {
    const auto [found, is_new] = numbers_.try_emplace(key, images_.size());
    if (is_new) images_.push_back(read(key));
    return found->second;
  }

 private:
  std::vector<MaterialImage>& images_;
  std::map<Key, std::size_t> numbers_;
};

MaterialImage image_of(const gltf::Asset& asset, std::size_t number) {
  MaterialImage image{"image " + std::to_string(number)};
  try {
    image.bytes = std::make_shared<const std::string>(asset.image(number));
  } catch (const io::ReadError& error) {
    image.problem = error.what();
  }
  return image;
}

FileMaterial material_of(const gltf::Material& from) {
  FileMaterial material;
  material.base_color = material.imageless_color = from.base_color;
  material.alpha_mode = from.alpha_mode;
  material.alpha_cutoff = from.alpha_cutoff;
  material.double_sided = from.double_sided;
  if (const auto& use = from.base_color_texture) {
    material.texcoord = "TEXCOORD_" + std::to_string(use->texcoord);
    material.texcoord_transform = use->transform;
    material.wrap = {use->wrap_u, use->wrap_v};
  }
  return material;
}

FileMaterials materials_of(const gltf::Asset& asset) {
  FileMaterials materials;
  materials.are_told = true;
  materials.of_meshes.resize(asset.n_meshes());
  Images<std::size_t> images(materials.images);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    if (asset.n_triangles(m) == 0) continue;
    for (const gltf::Material& from : asset.materials(m)) {
      FileMaterial& material = materials.of_meshes[m].emplace_back(material_of(from));
      if (const auto& use = from.base_color_texture) {
        material.image = images.number_of(use->image, [&](std::size_t i) { return image_of(asset, i); });
      }
    }
  }
  return materials;
}

MaterialImage image_at(const fs::path& folder, const fs::path& file) {
  MaterialImage image{"texture " + file.string()};
  if (auto bytes = io::content_of(folder / file)) {
    image.bytes = std::make_shared<const std::string>(*std::move(bytes));
  } else {
    image.problem = "the file can't be read";
  }
  return image;
}

/// Of a surface of which the file says nothing: white, and seen from both sides.
FileMaterial plain_material(const IndexedMesh& mesh) {
  FileMaterial material;
  material.double_sided = true;
  const auto uv = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                               [](const Attribute& a) { return a.kind == AttributeKind::texcoord; });
  if (uv != mesh.attributes.end()) material.texcoord = uv->name;
  // In the image, rows are counted from above, in these files from below.
  material.texcoord_transform = Eigen::Translation2d(0, 1) * Eigen::Scaling(1.0, -1.0);
  return material;
}

/// A texture hides Kd, as in most programs.
void set_color(const io::SurfaceMaterial& from, FileMaterial& material) {
  std::copy(from.diffuse.begin(), from.diffuse.end(), material.imageless_color.begin());
  if (!material.image) material.base_color = material.imageless_color;
  material.base_color[3] = material.imageless_color[3] = from.opacity;
  if (from.opacity < 1) material.alpha_mode = gltf::AlphaMode::blend;
}

void warn_of_what_is_not_shown(const io::SurfaceMaterials& from, std::vector<std::string>& warnings) {
  for (const fs::path& library : from.missing) {
    warnings.push_back("material library " + library.string() + " can't be read, its materials are not shown");
  }
  if (from.textures.size() > 1) warnings.emplace_back("it has several textures, none of them is shown");
}

/// A PLY file with one texture has it on all faces.
FileMaterials materials_beside(const Scene& input) {
  const fs::path folder = input.path == standard_stream ? fs::path() : fs::path(input.path).parent_path();
  const io::SurfaceMaterials from = io::read_materials(input.read.notes, folder);
  FileMaterials materials;
  materials.are_told = !from.materials.empty() || from.textures.size() == 1;
  warn_of_what_is_not_shown(from, materials.warnings);
  Images<fs::path> images(materials.images);
  const auto number_of = [&](const fs::path& path) {
    return images.number_of(path, [&](const fs::path& file) { return image_at(folder, file); });
  };
  FileMaterial plain = plain_material(input.read.mesh);
  if (from.textures.size() == 1) plain.image = number_of(from.textures.front());
  const std::vector<std::string>& groups = input.read.mesh.group_names;
  std::vector<FileMaterial>& of_groups =
      materials.of_meshes.emplace_back(std::max<std::size_t>(1, groups.size()), plain);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const auto found = std::find_if(from.materials.begin(), from.materials.end(),
                                    [&](const io::SurfaceMaterial& one) { return one.name == groups[group]; });
    if (found == from.materials.end()) continue;
    if (!found->texture.empty()) of_groups[group].image = number_of(found->texture);
    set_color(*found, of_groups[group]);
  }
  return materials;
}

}  // namespace

FileMaterials read_materials(const Scene& input) {
  return input.gltf ? materials_of(input.gltf->asset()) : materials_beside(input);
}

}  // namespace whittle::app
