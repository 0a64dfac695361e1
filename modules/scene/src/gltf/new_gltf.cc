#include "gltf/new_gltf.hh"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "companions.hh"
#include "gltf/gltf_file.hh"
#include "gltf/screen_coverage.hh"
#include "whittle/core/float32_positions.hh"
#include "whittle/core/text/text.hh"
#include "whittle/gltf/make_asset.hh"
#include "whittle/io/file_notes.hh"
#include "whittle/io/materials.hh"
#include "whittle/io/path_of.hh"

namespace whittle {
namespace {

namespace fs = std::filesystem;

/// Materials beside a mesh file, and missing files.
struct Looks {
  std::vector<Material> materials;  ///< by face group
  bool has_several_textures;        ///< as `io::SurfaceMaterials` has it, if the mesh has coordinates for them
  std::vector<fs::path> missing{};  ///< named files that don't exist
  std::vector<fs::path> foreign{};  ///< images of formats that glTF doesn't have
};

std::string listed_paths(const std::vector<fs::path>& paths) {
  std::vector<std::string> names;
  names.reserve(paths.size());
  for (const fs::path& path : paths) names.push_back(path.generic_string());
  return listed(names);
}

/// Groups with faces; one group if the mesh has none.
std::set<std::size_t> used_groups(const IndexedMesh& mesh) {
  if (mesh.face_groups.empty()) return {0};
  return {mesh.face_groups.begin(), mesh.face_groups.end()};
}

/// Whether it can be a TEXCOORD_n.
bool is_texcoord(const Attribute& attribute) {
  return attribute.kind == AttributeKind::texcoord && attribute.n_components >= 2;
}

std::vector<std::string> names_of_lost(const IndexedMesh& mesh) {
  std::vector<std::string> names;
  for (const Attribute& attribute : mesh.attributes) {
    if (!is_texcoord(attribute)) names.push_back(attribute.name);
  }
  for (const Attribute& attribute : mesh.face_attributes) names.push_back(attribute.name);
  return names;
}

std::vector<std::string> problems_of(const Looks& looks, const IndexedMesh& mesh) {
  std::vector<std::string> problems;
  if (const auto lost = names_of_lost(mesh); !lost.empty()) problems.push_back("left out: " + listed(lost));
  if (!looks.missing.empty()) {
    problems.push_back("files of the input that aren't there: " + listed_paths(looks.missing));
  }
  if (!looks.foreign.empty()) {
    problems.push_back("images that are neither PNG nor JPEG are left out: " + listed_paths(looks.foreign));
  }
  if (looks.has_several_textures) {
    problems.emplace_back("left out: the textures, as nothing says which faces have which");
  }
  return problems;
}

/// The mesh with glTF's direction of texture coordinates.
IndexedMesh turned(IndexedMesh mesh) {
  if (mesh.face_groups.empty()) mesh.group_names = {""};
  flip_texcoords(mesh);
  return mesh;
}

/// The meshes of an asset, without names and materials.
gltf::NewAsset new_asset_of(const Scene& scene, const IndexedMesh& mesh, CoarserLevels levels,
                            const SceneOutput& output) {
  gltf::NewAsset asset;
  asset.mesh = turned(mesh);
  // For all that is made of an input the same, if it is there.
  if (!scene.read.mesh.positions.empty()) asset.translation = float32_origin(scene.read.mesh.positions);
  for (const IndexedMesh* const level : levels) asset.coarser.push_back(turned(*level));
  if (!levels.empty()) asset.screen_coverage = screen_coverages(asset.mesh, asset.coarser, {}, output);
  return asset;
}

/// Reads the images of groups with faces, and drops images that glTF doesn't support.
void read_images_for_gltf(const IndexedMesh& mesh, const fs::path& folder, Looks& looks) {
  const std::set<std::size_t> used = used_groups(mesh);
  for (std::size_t group = 0; group < looks.materials.size(); ++group) {
    if (!used.contains(group)) looks.materials[group].base_color_texture.reset();
  }
  io::read_images(looks.materials, folder);
  for (Material& material : looks.materials) {
    if (!material.base_color_texture) continue;
    const std::shared_ptr<const Image> image = material.base_color_texture->image;
    const std::string_view type = media_type(image->bytes);
    if (type == "image/png" || type == "image/jpeg") continue;
    material.base_color_texture.reset();
    const bool is_known = std::find(looks.foreign.begin(), looks.foreign.end(), image->file) != looks.foreign.end();
    if (image->problem.empty() && !is_known) looks.foreign.push_back(image->file);
  }
}

/// \param mesh with the groups and attributes of the output
Looks looks_of(const Scene& scene, const IndexedMesh& mesh) {
  const io::FileNotes notes = scene.path == standard_stream ? io::FileNotes{} : scene.read.notes;
  const fs::path folder = folder_of(scene.path);
  io::SurfaceMaterials from = io::read_materials(notes, folder, mesh);
  const bool has_texcoords = std::any_of(mesh.attributes.begin(), mesh.attributes.end(), is_texcoord);
  Looks looks{std::move(from.materials), has_texcoords && from.has_several_textures};
  if (scene.document) {  // its materials are left out, so that the format's default holds
    for (Material& material : looks.materials) material.double_sided = false;
  }
  for (const fs::path& file : io::referenced_files(notes, folder)) {
    std::error_code error;
    if (!fs::exists(folder / file, error)) looks.missing.push_back(file);
  }
  if (has_texcoords) {
    read_images_for_gltf(mesh, folder, looks);
  } else {
    for (Material& material : looks.materials) material.base_color_texture.reset();
  }
  return looks;
}

/// \throw io::WriteError if a coordinate is too large for glTF
gltf::Asset asset_of(gltf::NewAsset asset, const SceneOutput& output) {
  try {
    return gltf::make_asset(std::move(asset));
  } catch (const std::range_error& error) {
    throw io::WriteError(output.path, error.what());
  }
}

}  // namespace

void write_new_gltf(io::OutputFiles& files, const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh,
                    CoarserLevels levels, SceneMessages& messages) {
  gltf::NewAsset asset = new_asset_of(scene, mesh, levels, output);
  asset.name = scene.mesh_name;
  asset.embeds_images = io::path_of(output.path).extension() != ".gltf";
  Looks looks = looks_of(scene, asset.mesh);
  for (const std::string& problem : problems_of(looks, asset.mesh)) {
    messages.warnings.push_back(about(output.path, problem));
  }
  asset.materials = std::move(looks.materials);
  const gltf::Asset made = asset_of(std::move(asset), output);
  write_asset(files, output, made);
  copy_companions(files, scene.path, output.path, made.image_files(), messages);
}

gltf::Asset new_gltf_as_written(const SceneOutput& output, const Scene& scene, const IndexedMesh& mesh) {
  gltf::NewAsset asset = new_asset_of(scene, mesh, {}, output);
  asset.materials.resize(asset.mesh.group_names.size());
  return asset_of(std::move(asset), output).as_written({}, output.gltf);
}

}  // namespace whittle
