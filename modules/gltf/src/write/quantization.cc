#include "write/quantization.hh"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "geometry/elements.hh"
#include "geometry/layout.hh"
#include "geometry/split.hh"
#include "model/extensions.hh"
#include "write/mesh_nodes.hh"
#include "write/references.hh"

namespace whittle::gltf {
namespace {

/// Extensions of nodes that mean the same where a child has the mesh, and where its scale is another.
constexpr std::string_view harmless_extensions[] = {lod_extension, visibility_extension, "KHR_lights_punctual",
                                                    "KHR_node_hoverability", "KHR_node_selectability"};

using Kept = std::map<std::size_t, std::string>;

std::optional<std::size_t> number_in(const Json& object, std::string_view name) {
  const Json* const value = member(object, name);
  return value ? as_whole(*value) : std::nullopt;
}

const Json* skin_of(const Json& document, const Json& node) {
  const Json& skins = elements_of(document, "skins");
  const std::optional<std::size_t> number = number_in(node, "skin");
  return number && *number < skins.size() ? &skins[*number] : nullptr;
}

/// Null: all are the identity. \pre `is_valid`
const Accessor* inverse_bind_of(const Model& model, const Json& skin) {
  const std::optional<std::size_t> number = number_in(skin, "inverseBindMatrices");
  return number ? &model.accessors[*number] : nullptr;
}

bool is_valid(const Model& model, const Json& skin) {
  if (elements_of(skin, "joints").empty()) return false;
  if (!skin.contains("inverseBindMatrices")) return true;
  const std::optional<std::size_t> number = number_in(skin, "inverseBindMatrices");
  if (!number || *number >= model.accessors.size()) return false;
  const Accessor& accessor = model.accessors[*number];
  return accessor.shape == ElementShape{4, 4} && accessor.count >= elements_of(skin, "joints").size();
}

/// Whether a material that a primitive has, or may be given, has a thickness.
bool may_have_thickness(const Json& document, const Json& primitive) {
  const Json& materials = elements_of(document, "materials");
  const Json* const extensions = member(primitive, "extensions");
  if (extensions && member(*extensions, "KHR_materials_variants")) {
    return std::any_of(materials.begin(), materials.end(), has_thickness);
  }
  const std::optional<std::size_t> number = number_in(primitive, "material");
  return number && *number < materials.size() && has_thickness(materials[*number]);
}

std::string why_node_forbids(const Model& model, const Json& document, std::size_t number, bool has_joints) {
  const Json& node = elements_of(document, "nodes")[number];
  if (!model.nodes[number].instances.empty()) return std::string(instancing_extension) + " places it";
  if (const Json* const skin = skin_of(document, node)) {
    return has_joints && is_valid(model, *skin) ? "" : "its skin is invalid";
  }
  const Json* const extensions = member(node, "extensions");
  if (!extensions || !extensions->is_object()) return {};
  for (const auto& [name, value] : extensions->items()) {
    const auto end = std::end(harmless_extensions);
    if (std::find(std::begin(harmless_extensions), end, name) == end) return "its node has " + printable(name);
  }
  return {};
}

/// Whether something besides animations and nodes may blend the morph targets of a mesh, by the number of its node.
bool has_foreign_weights(const Json& document, const Mesh& mesh) {
  const bool has_targets = std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                                       [](const Primitive& primitive) { return !primitive.targets.empty(); });
  if (!has_targets) return false;
  const std::set<std::string> names = extensions_in(document);
  return names.contains("KHR_animation_pointer") || names.contains("VRMC_vrm");
}

/// Why the positions of a mesh can't become integers; empty if they can.
std::string why_kept(const Json& document, const Model& model, std::size_t mesh, const IndexedMesh& triangles) {
  const std::vector<bool> with_faces = primitives_with_faces(model.meshes[mesh], triangles);
  const std::vector<bool> lost = lost_primitives(model, model.meshes[mesh], triangles);
  for (std::size_t p = 0; p < lost.size(); ++p) {
    if (!with_faces[p] && !lost[p]) return "it has lines, points or something else";
    if (may_have_thickness(document, document["meshes"][mesh]["primitives"][p])) return "its material has a thickness";
  }
  const bool has_joints = n_joint_sets(model.meshes[mesh]) > 0;
  if (!has_joints && has_foreign_weights(document, model.meshes[mesh]))
    return "an extension may blend its morph targets";
  bool is_used = false;
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    if (model.nodes[n].mesh != mesh) continue;
    is_used = true;
    if (std::string why = why_node_forbids(model, document, n, has_joints); !why.empty()) return why;
  }
  return is_used ? "" : "no node uses it";
}

/// The skins of a scene, each with the meshes that it moves.
std::map<std::size_t, std::set<std::size_t>> meshes_of_skins(const Json& document, const Model& model) {
  std::map<std::size_t, std::set<std::size_t>> meshes;
  const Json& nodes = elements_of(document, "nodes");
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    if (model.nodes[n].mesh && skin_of(document, nodes[n])) {
      meshes[*number_in(nodes[n], "skin")].insert(*model.nodes[n].mesh);
    }
  }
  return meshes;
}

/// All replaced meshes, in groups that skins join, one or several each.
std::vector<std::set<std::size_t>> groups_of(const Json& document, const Model& model,
                                             const Replacements& replacements) {
  std::vector<std::set<std::size_t>> groups;
  for (const auto& [mesh, triangles] : replacements) groups.push_back({mesh});
  for (const auto& of_skin : meshes_of_skins(document, model)) {
    const std::set<std::size_t>& meshes = of_skin.second;
    std::set<std::size_t> joined = meshes;
    std::vector<std::set<std::size_t>> others;
    for (std::set<std::size_t>& group : groups) {
      const bool is_part = std::any_of(group.begin(), group.end(), [&](auto mesh) { return meshes.contains(mesh); });
      if (is_part) joined.merge(group);
      if (!is_part) others.push_back(std::move(group));
    }
    groups = std::move(others);
    groups.push_back(std::move(joined));
  }
  return groups;
}

/// The reason of the first mesh of a group that has one, in the numbers of the file.
std::string why_group_kept(const std::set<std::size_t>& group, const Replacements& replacements, const Kept& kept) {
  for (const std::size_t mesh : group) {
    if (!replacements.contains(mesh)) return "another mesh of its skin has no triangles";
    if (const auto found = kept.find(mesh); found != kept.end()) return found->second;
  }
  return {};
}

bool has_faces(const Replacements& replacements, std::size_t mesh) {
  const auto found = replacements.find(mesh);
  return found != replacements.end() && !found->second.faces.empty();
}

std::optional<Grid> grid_of_group(const std::set<std::size_t>& group, const Replacements& replacements) {
  std::vector<const IndexedMesh*> meshes;
  meshes.reserve(group.size());
  for (const std::size_t mesh : group) meshes.push_back(&replacements.at(mesh));
  return integer_grid_of(meshes);
}

/// The matrix from integers to a mesh's coordinates.
Eigen::Matrix4d matrix_of(const Grid& grid) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() *= grid.step();
  matrix.topRightCorner<3, 1>() = *grid.origin;
  return matrix;
}

Encoded encode_matrices(const Accessor* old, std::size_t n_joints, const Eigen::Matrix4d& before) {
  Encoded encoded;
  encoded.shape = {4, 4};
  encoded.count = old ? old->count : n_joints;
  encoded.stride = encoded.shape.packed_stride(encoded.type);
  const std::optional<Elements> elements = old ? std::optional<Elements>(*old) : std::nullopt;
  for (std::size_t j = 0; j < encoded.count; ++j) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    if (elements) elements->read(j, std::span(matrix.data(), 16));
    matrix = (matrix * before).eval();
    for (const double value : std::span(matrix.data(), 16)) append_real(encoded.bytes, value, encoded.type, false);
  }
  return encoded;
}

}  // namespace

Quantization quantization_of(const Json& document, const Model& model, const Replacements& replacements) {
  Quantization quantization;
  Kept kept;
  for (const auto& [mesh, triangles] : replacements) {
    if (std::string why = why_kept(document, model, mesh, triangles); !why.empty()) kept[mesh] = std::move(why);
  }
  for (const std::set<std::size_t>& group : groups_of(document, model, replacements)) {
    std::string why = why_group_kept(group, replacements, kept);
    const std::optional<Grid> grid = why.empty() ? grid_of_group(group, replacements) : std::nullopt;
    if (why.empty() && !grid) why = "it has no size, or is too far from the origin";
    for (const std::size_t mesh : group) {
      if (grid) quantization.of_mesh[mesh] = *grid;
      if (!grid && has_faces(replacements, mesh)) quantization.kept[mesh] = why;
    }
  }
  for (const auto& [skin, meshes] : meshes_of_skins(document, model)) {
    const auto found = quantization.of_mesh.find(*meshes.begin());
    if (found != quantization.of_mesh.end()) quantization.of_skin[skin] = found->second;
  }
  return quantization;
}

void strip_skins(Json& document, const Quantization& quantization) {
  for (const auto& [skin, grid] : quantization.of_skin) {
    Json& json = document["skins"][skin];
    if (json.contains("inverseBindMatrices")) json["inverseBindMatrices"] = nullptr;
  }
}

std::vector<NewAccessor> quantized_skins(const Json& document, const Model& model, const Quantization& quantization) {
  std::vector<NewAccessor> all;
  for (const auto& [number, grid] : quantization.of_skin) {
    const Json& skin = document["skins"][number];
    NewAccessor accessor;
    accessor.skin = number;
    accessor.old = number_in(skin, "inverseBindMatrices");
    accessor.values =
        encode_matrices(inverse_bind_of(model, skin), elements_of(skin, "joints").size(), matrix_of(grid));
    all.push_back(std::move(accessor));
  }
  return all;
}

void place_grids(Json& document, const Quantization& quantization) {
  const std::size_t n_nodes = elements_of(document, "nodes").size();
  for (std::size_t n = 0; n < n_nodes; ++n) {
    const Json& node = document["nodes"][n];
    const std::optional<std::size_t> mesh = number_in(node, "mesh");
    if (!mesh || skin_of(document, node)) continue;
    const auto grid = quantization.of_mesh.find(*mesh);
    if (grid == quantization.of_mesh.end()) continue;
    Json& child = document["nodes"][pass_mesh_on(document, n)];
    const Vec3 origin = *grid->second.origin;
    const double step = grid->second.step();
    child["translation"] = {origin.x(), origin.y(), origin.z()};
    child["scale"] = {step, step, step};
  }
}

}  // namespace whittle::gltf
