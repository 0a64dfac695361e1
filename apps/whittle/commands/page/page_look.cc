#include "commands/page/page_look.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <utility>

#include "files/gltf_file.hh"
#include "files/materials.hh"

namespace whittle::app {
namespace {

/// The images that a page shows, by their numbers; null where it is another one, with a warning.
std::vector<std::shared_ptr<const std::string>> shown_images(const std::vector<MaterialImage>& images,
                                                             const std::string& name,
                                                             std::vector<std::string>& warnings) {
  std::vector<std::shared_ptr<const std::string>> shown;
  for (const MaterialImage& image : images) {
    const bool is_shown = image.bytes && report::is_page_image(*image.bytes);
    shown.push_back(is_shown ? image.bytes : nullptr);
    if (is_shown) continue;
    const std::string problem = image.bytes ? "it is neither PNG nor JPEG nor WebP" : image.problem;
    warnings.push_back(about(name, image.name + " is not shown: " + problem));
  }
  return shown;
}

report::PageMaterial shown(const FileMaterial& material, std::shared_ptr<const std::string> image) {
  report::PageMaterial to;
  to.base_color = image ? material.base_color : material.imageless_color;
  to.image = std::move(image);
  to.texcoord = material.texcoord;
  to.texcoord_transform = material.texcoord_transform;
  to.wrap = {wrap_as<report::PageWrap>(material.wrap[0]), wrap_as<report::PageWrap>(material.wrap[1])};
  to.alpha = alpha_as<report::PageAlpha>(material.alpha_mode);
  to.alpha_cutoff = material.alpha_cutoff;
  return to;
}

}  // namespace

PageLook::PageLook(const Input& input, std::vector<std::string>& warnings) {
  const FileMaterials materials = read_materials(input);
  for (const std::string& warning : materials.warnings) warnings.push_back(about(input.name, warning));
  if (!materials.are_told) return;
  const auto images = shown_images(materials.images, input.name, warnings);
  const std::vector<std::string>& groups = input.read.mesh.group_names;
  const auto add = [&](const FileMaterial& material) {
    materials_.push_back(shown(material, material.image ? images[*material.image] : nullptr));
    if (materials_.size() <= groups.size()) materials_.back().name = groups[materials_.size() - 1];
  };
  if (input.gltf) {
    for (const auto& [mesh, primitive, scale] : input.gltf->groups()) add(materials.of_meshes[mesh][primitive]);
    colors_ = report::PageColors::linear;
    read_places(*input.gltf);
  } else {
    for (const FileMaterial& material : materials.of_meshes[0]) add(material);
  }
}

void PageLook::read_places(const GltfFile& file) {
  for (const auto& [mesh, primitive, scale] : file.groups()) {
    const std::vector<Eigen::Matrix4d> transforms = file.asset().world_transforms(mesh);
    const Eigen::Affine3d place = transforms.empty() ? Eigen::Affine3d::Identity() : Eigen::Affine3d(transforms[0]);
    places_.push_back(place * Eigen::Scaling(1 / scale));
  }
  const auto stays = [](const Eigen::Affine3d& place) { return place.matrix().isIdentity(0); };
  if (std::all_of(places_.begin(), places_.end(), stays)) places_.clear();
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
