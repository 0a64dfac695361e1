#include "commands/page/page_look.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>
#include <utility>

#include "files/gltf_file.hh"
#include "files/gltf_materials.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/materials.hh"

namespace whittle::app {
namespace {

using Image = std::shared_ptr<const std::string>;

/// Reads each image once. `Key` names it, and `read(key)` gives its bytes.
template <class Key>
class Images {
 public:
  explicit Images(std::vector<std::string>& warnings) : warnings_(warnings) {}

  /// \return null if it can't be read, with a warning
  template <class Read>
  Image of(const Key& key, const Read& read) {
    const auto [slot, is_new] = images_.try_emplace(key);
    if (!is_new) return slot->second;
    try {
      std::string bytes = read(key);
      if (!report::is_page_image(bytes)) throw io::ReadError(name(key), "is neither PNG nor JPEG nor WebP");
      slot->second = std::make_shared<const std::string>(std::move(bytes));
    } catch (const io::ReadError& error) {
      warnings_.push_back(std::string(error.what()) + "; it isn't shown");
    }
    return slot->second;
  }

 private:
  static std::string name(std::size_t image) { return "image " + std::to_string(image); }
  static std::string name(const std::filesystem::path& path) { return path.string(); }

  std::vector<std::string>& warnings_;
  std::map<Key, Image> images_;
};

std::string bytes_of(const std::filesystem::path& path) {
  std::error_code error;
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, error) || !file) throw io::ReadError(path.string(), "cannot be opened");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// In the image, rows are counted from above, in these files from below.
Eigen::Affine2d from_below() {
  Eigen::Affine2d flip = Eigen::Affine2d::Identity();
  flip(1, 1) = -1;
  flip(1, 2) = 1;
  return flip;
}

report::PageMaterial shown(const gltf::Material& material, const std::string& name) {
  report::PageMaterial to;
  to.name = name;
  to.base_color = material.base_color;
  to.alpha = alpha_as<report::PageAlpha>(material.alpha_mode);
  to.alpha_cutoff = material.alpha_cutoff;
  if (const auto& use = material.base_color_texture) {
    to.texcoord = "TEXCOORD_" + std::to_string(use->texcoord);
    to.texcoord_transform = use->transform;
    to.wrap = {wrap_as<report::PageWrap>(use->wrap_u), wrap_as<report::PageWrap>(use->wrap_v)};
  }
  return to;
}

}  // namespace

PageLook::PageLook(const Input& input, std::vector<std::string>& warnings) {
  if (input.gltf) {
    read_gltf(input, warnings);
  } else {
    read_library(input, warnings);
  }
}

void PageLook::read_gltf(const Input& input, std::vector<std::string>& warnings) {
  colors_ = report::PageColors::linear;
  const gltf::Asset& asset = input.gltf->asset();
  Images<std::size_t> images(warnings);
  std::map<std::size_t, std::vector<gltf::Material>> of_meshes;
  for (const auto& [mesh, primitive, scale] : input.gltf->groups()) {
    const auto [found, is_new] = of_meshes.try_emplace(mesh);
    if (is_new) found->second = asset.materials(mesh);
    const gltf::Material& material = found->second[primitive];
    materials_.push_back(shown(material, input.read.mesh.group_names[materials_.size()]));
    if (const auto& use = material.base_color_texture) {
      materials_.back().image = images.of(use->image, [&](std::size_t i) { return asset.image(i); });
    }
    const std::vector<Eigen::Matrix4d> transforms = asset.world_transforms(mesh);
    const Eigen::Affine3d place = transforms.empty() ? Eigen::Affine3d::Identity() : Eigen::Affine3d(transforms[0]);
    places_.push_back(place * Eigen::Scaling(1 / scale));
  }
  const auto stays = [](const Eigen::Affine3d& place) { return place.matrix().isIdentity(0); };
  if (std::all_of(places_.begin(), places_.end(), stays)) places_.clear();
}

/// As pictures have them (pictures/read_scene.cc).
void PageLook::read_library(const Input& input, std::vector<std::string>& warnings) {
  const IndexedMesh& mesh = input.read.mesh;
  const std::filesystem::path folder = std::filesystem::path(input.path).parent_path();
  const io::SurfaceMaterials known = io::read_materials(input.read.notes, folder);
  for (const std::filesystem::path& library : known.missing) {
    warnings.push_back(about(input.name, "material library " + library.string() + " can't be read"));
  }
  if (known.materials.empty() && known.textures.size() != 1) return;
  const auto texcoord = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                                     [](const Attribute& a) { return a.kind == AttributeKind::texcoord; });
  Images<std::filesystem::path> images(warnings);
  report::PageMaterial plain;
  if (texcoord != mesh.attributes.end()) plain.texcoord = texcoord->name;
  plain.texcoord_transform = from_below();
  if (known.textures.size() == 1) plain.image = images.of(folder / known.textures.front(), bytes_of);
  materials_.assign(std::max<std::size_t>(1, mesh.group_names.size()), plain);
  for (std::size_t group = 0; group < mesh.group_names.size(); ++group) {
    report::PageMaterial& material = materials_[group];
    material.name = mesh.group_names[group];
    const auto found = std::find_if(known.materials.begin(), known.materials.end(),
                                    [&](const io::SurfaceMaterial& one) { return one.name == material.name; });
    if (found == known.materials.end()) continue;
    if (!found->texture.empty()) material.image = images.of(folder / found->texture, bytes_of);
    if (!material.image) std::copy(found->diffuse.begin(), found->diffuse.end(), material.base_color.begin());
    material.base_color[3] = found->opacity;
    if (found->opacity < 1) material.alpha = report::PageAlpha::blend;
  }
}

void PageLook::dress(report::PageSurface& surface) const {
  surface.materials = materials_;
  surface.colors = colors_;
}

/// Vertices without a face are in no group.
std::vector<Index> PageLook::groups_of_vertices(const IndexedMesh& mesh) const {
  std::vector<Index> groups(mesh.positions.size(), invalid_index);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) groups[v] = mesh.face_groups[f];
  }
  return groups;
}

void PageLook::put_in_scene(IndexedMesh& mesh) const {
  if (places_.empty()) return;
  const std::vector<Index> groups = groups_of_vertices(mesh);
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (groups[v] != invalid_index) mesh.positions[v] = places_[groups[v]] * mesh.positions[v];
  }
  std::vector<std::uint8_t> is_turned(mesh.normals.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Eigen::Affine3d& place = places_[mesh.face_groups[f]];
    for (std::size_t k = 0; k < 3 && !mesh.normals.empty(); ++k) {
      const Index w = mesh.wedge(f, k);
      if (std::exchange(is_turned[w], std::uint8_t{1}) != 0) continue;
      auto& [x, y, z] = mesh.normals[w];
      const Vec3 normal = (place.linear().inverse().transpose() * Vec3(x, y, z)).normalized();
      if (normal.allFinite())
        mesh.normals[w] = {static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                           static_cast<float>(normal.z())};
    }
    if (!is_mirrored(mesh.face_groups[f])) continue;
    std::swap(mesh.faces[f][1], mesh.faces[f][2]);
    if (!mesh.wedges.empty()) std::swap(mesh.wedges[3 * f + 1], mesh.wedges[3 * f + 2]);
  }
}

void PageLook::put_in_scene(const IndexedMesh& input, RunSteps& steps) const {
  if (places_.empty()) return;
  const std::vector<Index> groups = groups_of_vertices(input);
  const auto move = [&](Index vertex, Vec3& position) { position = places_[groups[vertex]] * position; };
  for (Contraction& contraction : steps.contractions) move(contraction.survivor, contraction.position);
  for (PassEnd& end : steps.pass_ends) {
    for (auto& [vertex, position] : end.moved) move(vertex, position);
    for (auto& [face, corners] : end.turned) {
      if (is_mirrored(input.face_groups[face])) std::swap(corners[1], corners[2]);
    }
  }
}

}  // namespace whittle::app
