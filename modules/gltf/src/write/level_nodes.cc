#include "write/level_nodes.hh"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "model/extensions.hh"
#include "write/mesh_nodes.hh"
#include "write/references.hh"

namespace whittle::gltf {
namespace {

bool uses_mesh(const Json& node, std::size_t mesh) {
  const Json* const used = member(node, "mesh");
  return used != nullptr && as_whole(*used) == mesh;
}

/// Whether a node uses a mesh, or passes it on to a child (`pass_mesh_on`).
bool shows_mesh(const Json& nodes, const Json& node, std::size_t mesh) {
  if (uses_mesh(node, mesh)) return true;
  const Json& children = elements_of(node, "children");
  return std::any_of(children.begin(), children.end(), [&](const Json& child) {
    const std::optional<std::size_t> number = as_whole(child);
    return number && *number < nodes.size() && uses_mesh(nodes[*number], mesh);
  });
}

const Json* levels_of(const Json& node) {
  const Json* const extensions = member(node, "extensions");
  return extensions == nullptr ? nullptr : member(*extensions, lod_extension);
}

/// Whether a level in place of a node would hide more than its mesh.
bool has_more_than_mesh(const Json& node) {
  if (!elements_of(node, "children").empty() || node.contains("camera")) return true;
  const Json* const extensions = member(node, "extensions");
  if (extensions == nullptr || !extensions->is_object()) return false;
  const auto items = extensions->items();
  return std::any_of(items.begin(), items.end(), [](const auto& item) { return item.key() != instancing_extension; });
}

void name_level(Json& object, std::size_t level) {
  if (!object.contains("name") || !object["name"].is_string()) return;
  object["name"] = object["name"].get<std::string>() + "_LOD" + std::to_string(level);
}

/// Adds a node like another one, but with another mesh. \return its number
std::size_t add_level_node(Json& document, std::size_t number, std::size_t mesh, std::size_t level) {
  const std::size_t added = document["nodes"].size();
  Json node = document["nodes"][number];
  node["mesh"] = mesh;
  node.erase("extras");
  name_level(node, level);
  document["nodes"].push_back(std::move(node));
  for_each_channel(document, number, [&](Json& channels, std::size_t i) {
    Json channel = channels[i];
    channel["target"]["node"] = added;
    channels.push_back(std::move(channel));
  });
  return added;
}

void note_extension(Json& document) {
  Json& used = document["extensionsUsed"];
  if (std::find(used.begin(), used.end(), lod_extension) == used.end()) used.push_back(std::string(lod_extension));
}

}  // namespace

bool has_levels(const Json& document, std::size_t mesh) {
  const Json& nodes = elements_of(document, "nodes");
  const auto is_level_of = [&](const Json& node) {
    const Json* const levels = levels_of(node);
    if (levels == nullptr) return false;
    const Json& ids = elements_of(*levels, "ids");
    return shows_mesh(nodes, node, mesh) || std::any_of(ids.begin(), ids.end(), [&](const Json& id) {
             const std::optional<std::size_t> number = as_whole(id);
             return number && *number < nodes.size() && shows_mesh(nodes, nodes[*number], mesh);
           });
  };
  return std::any_of(nodes.begin(), nodes.end(), is_level_of);
}

std::size_t add_mesh_copy(Json& document, std::size_t mesh, std::size_t level) {
  Json copy = document["meshes"][mesh];
  name_level(copy, level);
  document["meshes"].push_back(std::move(copy));
  return document["meshes"].size() - 1;
}

void add_level_nodes(Json& document, std::size_t mesh, std::span<const std::size_t> coarser,
                     std::span<const double> coverage) {
  const std::size_t n_nodes = elements_of(document, "nodes").size();
  for (std::size_t i = 0; i < n_nodes; ++i) {
    if (!uses_mesh(document["nodes"][i], mesh)) continue;
    const std::size_t finest = has_more_than_mesh(document["nodes"][i]) ? pass_mesh_on(document, i) : i;
    Json ids = Json::array();
    for (std::size_t level = 0; level < coarser.size(); ++level) {
      ids.push_back(add_level_node(document, finest, coarser[level], level + 1));
    }
    Json& node = document["nodes"][finest];
    node["extensions"][std::string(lod_extension)]["ids"] = std::move(ids);
    if (!node.contains("extras")) node["extras"] = Json::object();
    // Extras may be any value. Only an object has room for the hint.
    if (node["extras"].is_object()) node["extras"]["MSFT_screencoverage"] = coverage;
    note_extension(document);
  }
}

}  // namespace whittle::gltf
