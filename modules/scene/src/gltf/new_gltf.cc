#include "gltf/new_gltf.hh"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "companions.hh"
#include "gltf/screen_coverage.hh"
#include "whittle/scene/gltf_file.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/gltf/make_asset.hh"
#include "whittle/core/text/text.hh"
#include "whittle/io/file_notes.hh"
#include "whittle/io/materials.hh"
#include "whittle/io/whole_file.hh"

namespace whittle {
namespace {

namespace fs = std::filesystem;

/// What is found beside the mesh file, and what isn't.
class Looks {
 public:
  /// \param embeds_all whether all images become part of the asset
  Looks(const Scene& scene, bool embeds_all) : folder_(folder_of(scene.path)), embeds_all_(embeds_all) {
    if (scene.path == standard_stream) return;
    known_ = io::read_materials(scene.read.notes, folder_);
    for (const fs::path& file : io::referenced_files(scene.read.notes, folder_)) {
      std::error_code error;
      if (!fs::exists(folder_ / file, error)) missing_.push_back(file);
    }
  }

  gltf::NewMaterial material(const std::string& name, bool has_texcoords) {
    gltf::NewMaterial material{.name = name};
    const auto& all = known_.materials;
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& known) { return known.name == name; });
    fs::path texture = known_.textures.empty() ? fs::path() : known_.textures.front();
    if (found != all.end()) {
      texture = found->texture;
      // A black one would leave nothing of a texture.
      for (std::size_t i = 0; i < 3 && texture.empty(); ++i) material.color[i] = static_cast<float>(found->diffuse[i]);
      material.color[3] = static_cast<float>(found->opacity);
    }
    if (has_texcoords && !texture.empty()) material.image = image(texture);
    return material;
  }

  const std::vector<gltf::NewImage>& images() const { return images_; }
  /// Files that are named and aren't there.
  const std::vector<fs::path>& missing() const { return missing_; }
  /// Images of formats that glTF doesn't have.
  const std::vector<fs::path>& foreign() const { return foreign_; }

 private:
  std::optional<std::size_t> image(const fs::path& file) {
    const auto known =
        std::find_if(images_.begin(), images_.end(), [&](const gltf::NewImage& image) { return image.file == file; });
    if (known != images_.end()) return static_cast<std::size_t>(known - images_.begin());
    std::optional<std::string> bytes = io::content_of(folder_ / file);
    if (!bytes) return std::nullopt;
    if (!gltf::is_image(*bytes)) {
      if (std::find(foreign_.begin(), foreign_.end(), file) == foreign_.end()) foreign_.push_back(file);
      return std::nullopt;
    }
    const bool is_embedded = embeds_all_ || !is_inside(file);
    images_.push_back({file, is_embedded ? *std::move(bytes) : std::string()});
    return images_.size() - 1;
  }

  fs::path folder_;
  bool embeds_all_;
  io::SurfaceMaterials known_;
  std::vector<gltf::NewImage> images_;
  std::vector<fs::path> missing_;
  std::vector<fs::path> foreign_;
};

std::string listed_paths(const std::vector<fs::path>& paths) {
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const fs::path& path : paths) names.push_back(path.generic_string());
  return listed(names);
}

/// Those that a face is in; all are one if there are none.
std::set<std::size_t> used_groups(const IndexedMesh& mesh) {
  if (mesh.face_groups.empty()) return {0};
  return {mesh.face_groups.begin(), mesh.face_groups.end()};
}

std::vector<std::string> names_of_lost(const IndexedMesh& mesh) {
  std::vector<std::string> names;
  for (const Attribute& attribute : mesh.attributes) {
    if (attribute.kind != AttributeKind::texcoord || attribute.n_components < 2) names.push_back(attribute.name);
  }
  for (const Attribute& attribute : mesh.face_attributes) names.push_back(attribute.name);
  return names;
}

std::vector<std::string> problems_of(const Looks& looks, const IndexedMesh& mesh) {
  std::vector<std::string> problems;
  if (const auto lost = names_of_lost(mesh); !lost.empty()) problems.push_back("left out: " + listed(lost));
  if (!looks.missing().empty())
    problems.push_back("files of the input that aren't there: " + listed_paths(looks.missing()));
  if (!looks.foreign().empty()) {
    problems.push_back("images that are neither PNG nor JPEG are left out: " + listed_paths(looks.foreign()));
  }
  return problems;
}

/// As glTF has it.
IndexedMesh turned(IndexedMesh mesh) {
  if (mesh.face_groups.empty()) mesh.group_names = {""};
  flip_texcoords(mesh);
  return mesh;
}

/// The meshes of an asset, without names and materials.
gltf::NewAsset new_asset_of(const IndexedMesh& mesh, CoarserLevels levels) {
  gltf::NewAsset asset;
  asset.mesh = turned(mesh);
  for (const IndexedMesh* const level : levels) asset.coarser.push_back(turned(*level));
  if (!levels.empty()) asset.screen_coverage = screen_coverages(asset.mesh, asset.coarser);
  return asset;
}

}  // namespace

void write_new_gltf(io::OutputFiles& files, const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                    CoarserLevels levels, SceneMessages& messages) {
  const bool is_binary = fs::path(output.path).extension() != ".gltf";
  Looks looks(scene, is_binary);
  gltf::NewAsset asset = new_asset_of(mesh, levels);
  // For all that is made of an input the same, if it is there.
  if (!scene.read.mesh.positions.empty()) asset.translation = float32_origin(scene.read.mesh.positions);
  asset.name = scene.mesh_name;
  const auto is_texcoord = [](const Attribute& attribute) { return attribute.kind == AttributeKind::texcoord; };
  const bool has_texcoords = std::any_of(asset.mesh.attributes.begin(), asset.mesh.attributes.end(), is_texcoord);
  for (const std::size_t group : used_groups(asset.mesh)) {
    asset.materials.resize(group + 1);
    asset.materials[group] = looks.material(asset.mesh.group_names[group], has_texcoords);
  }
  asset.images = looks.images();
  for (const std::string& problem : problems_of(looks, asset.mesh)) {
    messages.warnings.push_back(about(output.path, problem));
  }
  try {
    write_asset(files, output.path, gltf::make_asset(std::move(asset)), output.compress);
  } catch (const std::range_error& error) {
    throw io::WriteError(output.path, error.what());
  }
  std::vector<fs::path> beside;
  for (const gltf::NewImage& image : looks.images()) {
    if (image.bytes.empty()) beside.push_back(image.file);
  }
  copy_companions(files, scene.path, output.path, beside, messages);
}

}  // namespace whittle
