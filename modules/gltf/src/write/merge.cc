#include "write/merge.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/instances.hh"
#include "model/extensions.hh"
#include "whittle/core/pieces.hh"
#include "whittle/core/transform.hh"
#include "write/references.hh"

namespace whittle::gltf {
namespace {

bool has_any(const Json& object, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return member(object, name) != nullptr; });
}

const Json& json_of(const Json& document, std::size_t mesh, std::size_t primitive) {
  return document["meshes"][mesh]["primitives"][primitive];
}

/// Whether other primitives may be drawn together with those of a material: blended ones are sorted one by one.
bool has_blending(const Json& document, const Primitive& primitive) {
  const Json& materials = elements_of(document, "materials");
  if (!primitive.material || *primitive.material >= materials.size()) return false;
  const Json* const mode = member(materials[*primitive.material], "alphaMode");
  return mode && *mode == "BLEND";
}

/// Material, attributes and their types, as far as two primitives must have the same. Empty: merged with none.
std::string key_of(const Json& document, const Model& model, std::size_t mesh, std::size_t number) {
  const Primitive& primitive = model.meshes[mesh].primitives[number];
  const Json& json = json_of(document, mesh, number);
  const Json* const extensions = member(json, "extensions");
  const bool has_others = extensions && !(extensions->size() == 1 && member(*extensions, draco_extension));
  if (!primitive.is_surface() || has_others || json.contains("extras") || has_blending(document, primitive)) return {};
  std::set<std::string> parts;
  const auto add = [&](const std::string& target, const NamedNumbers& attributes) {
    for (const auto& [name, accessor] : attributes) {
      const Accessor& values = model.accessors[accessor];
      parts.insert(target + name + ' ' + name_of(values.shape) + ' ' + std::to_string(component_type(values.type)) +
                   (values.is_normalized ? "n" : ""));
    }
  };
  add("", primitive.attributes);
  for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
    add("target " + std::to_string(t) + ' ', primitive.targets[t]);
  }
  std::string key = primitive.material ? std::to_string(*primitive.material) : "none";
  for (const std::string& part : parts) key += ' ' + part;
  return key;
}

/// Gives the faces of primitives of one mesh that share a key to the first of them.
void merge_primitives(const Json& document, const Model& model, std::size_t mesh, IndexedMesh& triangles) {
  std::vector<Index> first(model.meshes[mesh].primitives.size());
  std::map<std::string, Index> primitives;
  for (Index p = 0; p < first.size(); ++p) {
    const std::string key = key_of(document, model, mesh, p);
    first[p] = key.empty() ? p : primitives.emplace(key, p).first->second;
  }
  for (Index& group : triangles.face_groups) group = first[group];
}

/// The nodes that animations move.
std::set<std::size_t> animated_nodes(const Json& document) {
  std::set<std::size_t> nodes;
  for (const Json& animation : elements_of(document, "animations")) {
    for (const Json& channel : elements_of(animation, "channels")) {
      const Json* const target = member(channel, "target");
      const Json* const node = target ? member(*target, "node") : nullptr;
      if (const auto number = node ? as_whole(*node) : std::nullopt) nodes.insert(*number);
    }
  }
  return nodes;
}

/// Whether nothing but the document's matrices moves a node or shows it in another way.
bool stands_still(const Json& document, const Model& model, const std::set<std::size_t>& animated, std::size_t node) {
  for (std::optional<std::size_t> n = node; n; n = model.nodes[*n].parent) {
    if (animated.contains(*n) || document["nodes"][*n].contains("extensions")) return false;
  }
  return true;
}

bool has_thickness_in(const Json& document, const Primitive& primitive) {
  const Json& materials = elements_of(document, "materials");
  return primitive.material && *primitive.material < materials.size() && has_thickness(materials[*primitive.material]);
}

/// Whether the triangles of a mesh may be another's.
bool is_movable(const Json& document, const Model& model, std::size_t mesh, std::size_t node) {
  const Json& json = document["meshes"][mesh];
  const Json& place = document["nodes"][node];
  if (has_any(json, {"extensions", "extras", "weights"}) || has_any(place, {"skin", "weights", "extras"})) return false;
  if (!model.nodes[node].is_shown) return false;
  const std::vector<Primitive>& primitives = model.meshes[mesh].primitives;
  return std::all_of(primitives.begin(), primitives.end(), [&](const Primitive& primitive) {
    return primitive.is_surface() && primitive.targets.empty() && !has_thickness_in(document, primitive) &&
           !primitive.attribute("JOINTS_0");
  });
}

/// Whether meshes can be told from their numbers alone: no animation by pointers, no other scene, nothing unknown.
bool is_understood(const Json& document) {
  if (elements_of(document, "scenes").size() > 1) return false;
  const std::set<std::string> names = extensions_in(document);
  return std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return is_known_extension(name) && name != "KHR_animation_pointer" && !name.starts_with("VRM") &&
           !name.starts_with("AGI_");
  });
}

/// The matrix of each mesh that may be merged with others, to the scene's coordinates.
std::map<std::size_t, Eigen::Affine3d> movable_meshes(const Json& document, const Model& model,
                                                      const Replacements& replacements) {
  std::map<std::size_t, Eigen::Affine3d> places;
  if (!is_understood(document)) return places;
  std::map<std::size_t, std::vector<std::size_t>> nodes;
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    if (model.nodes[n].mesh) nodes[*model.nodes[n].mesh].push_back(n);
  }
  const std::set<std::size_t> animated = animated_nodes(document);
  const std::vector<Eigen::Matrix4d> worlds = world_matrices(model, local_matrices(model));
  for (const auto& [mesh, users] : nodes) {
    const auto found = replacements.find(mesh);
    if (users.size() != 1 || found == replacements.end() || found->second.face_groups.empty()) continue;
    const bool is_still = stands_still(document, model, animated, users.front());
    if (!is_still || !is_movable(document, model, mesh, users.front())) continue;
    const Eigen::Affine3d place(worlds[users.front()]);
    if (place.inverse().matrix().allFinite()) places.emplace(mesh, place);
  }
  return places;
}

/// Whether the attributes of a mesh can stand beside those of another.
bool can_append(const IndexedMesh& to, const IndexedMesh& from) {
  return std::all_of(from.attributes.begin(), from.attributes.end(), [&](const Attribute& attribute) {
    const auto same = std::find_if(to.attributes.begin(), to.attributes.end(),
                                   [&](const Attribute& other) { return other.name == attribute.name; });
    return same == to.attributes.end() || is_same_kind(*same, attribute);
  });
}

/// Appends triangles to a primitive of a mesh.
void append_to(IndexedMesh& mesh, Index primitive, IndexedMesh triangles) {
  triangles.group_names.clear();
  const std::size_t n_before = mesh.faces.size();
  append_mesh(mesh, std::move(triangles));
  std::fill(mesh.face_groups.begin() + static_cast<std::ptrdiff_t>(n_before), mesh.face_groups.end(), primitive);
}

/// A primitive that gets the faces of others.
struct Home {
  std::size_t mesh = 0;
  Index primitive = 0;
};

/// Moves the primitives of a mesh to earlier meshes that have one of the same key.
class Mover {
 public:
  Mover(const Json& document, const Model& model, Replacements& replacements)
      : document_(document),
        model_(model),
        replacements_(replacements),
        places_(movable_meshes(document, model, replacements)) {}

  void move_all() {
    for (const auto& [mesh, place] : places_) move(mesh);
  }

 private:
  void move(std::size_t mesh) {
    IndexedMesh& triangles = replacements_.at(mesh);
    std::vector<MeshPiece> pieces = split_mesh(triangles, triangles.face_groups, model_.meshes[mesh].primitives.size());
    std::vector<bool> has_moved(pieces.size());
    for (Index p = 0; p < pieces.size(); ++p) {
      if (!pieces[p].mesh.faces.empty()) has_moved[p] = try_to_move({mesh, p}, std::move(pieces[p].mesh));
    }
    std::vector<Index> stays(triangles.faces.size());
    for (std::size_t f = 0; f < stays.size(); ++f) stays[f] = has_moved[triangles.face_groups[f]] ? 1 : 0;
    if (std::find(has_moved.begin(), has_moved.end(), true) == has_moved.end()) return;
    triangles = std::move(split_mesh(triangles, stays, 2).front().mesh);
  }

  bool try_to_move(const Home& from, IndexedMesh triangles) {
    const std::string key = key_of(document_, model_, from.mesh, from.primitive);
    if (key.empty()) return false;
    const Home home = homes_.emplace(key, from).first->second;
    if (home.mesh == from.mesh) return false;
    IndexedMesh& to = replacements_.at(home.mesh);
    if (!can_append(to, triangles)) return false;
    transform_mesh(triangles, places_.at(home.mesh).inverse() * places_.at(from.mesh));
    append_to(to, home.primitive, std::move(triangles));
    return true;
  }

  const Json& document_;
  const Model& model_;
  Replacements& replacements_;
  std::map<std::size_t, Eigen::Affine3d> places_;
  std::map<std::string, Home> homes_;
};

}  // namespace

Replacements merged(const Json& document, const Model& model, Replacements replacements) {
  for (auto& [mesh, triangles] : replacements) merge_primitives(document, model, mesh, triangles);
  Mover(document, model, replacements).move_all();
  return replacements;
}

void drop_empty_meshes(Json& document, const Replacements& replacements) {
  std::vector<std::optional<std::size_t>> numbers;
  Json kept = Json::array();
  for (std::size_t m = 0; m < elements_of(document, "meshes").size(); ++m) {
    Json& mesh = document["meshes"][m];
    const bool is_empty = replacements.contains(m) && elements_of(mesh, "primitives").empty();
    numbers.push_back(is_empty ? std::nullopt : std::optional(kept.size()));
    if (!is_empty) kept.push_back(std::move(mesh));
  }
  document["meshes"] = std::move(kept);
  if (document["meshes"].size() == numbers.size()) return;
  for (Json& node : document["nodes"]) {
    if (!node.contains("mesh")) continue;
    const std::optional<std::size_t> number = numbers[*as_whole(node["mesh"])];
    if (number) node["mesh"] = *number;
    if (!number) node.erase("mesh");
  }
}

}  // namespace whittle::gltf
