#include "write/mesh_nodes.hh"

#include <string>
#include <utility>

#include "model/extensions.hh"
#include "write/references.hh"

namespace whittle::gltf {

void for_each_channel(Json& document, std::size_t node, const std::function<void(Json&, std::size_t)>& function) {
  if (elements_of(document, "animations").empty()) return;
  for (Json& animation : document["animations"]) {
    const std::size_t n_channels = elements_of(animation, "channels").size();
    for (std::size_t i = 0; i < n_channels; ++i) {
      Json& channels = animation["channels"];
      const Json* const target = member(channels[i], "target");
      const Json* const moved = target == nullptr ? nullptr : member(*target, "node");
      if (moved != nullptr && as_whole(*moved) == node) function(channels, i);
    }
  }
}

std::size_t pass_mesh_on(Json& document, std::size_t number) {
  Json& nodes = document["nodes"];
  const std::size_t child_number = nodes.size();
  Json child = Json::object();
  Json& node = nodes[number];
  if (node.contains("name")) child["name"] = node["name"];
  for (const char* const key : {"mesh", "skin", "weights"}) {
    if (!node.contains(key)) continue;
    child[key] = std::move(node[key]);
    node.erase(key);
  }
  if (node.contains("extensions") && node["extensions"].contains(instancing_extension)) {
    child["extensions"][std::string(instancing_extension)] = node["extensions"][std::string(instancing_extension)];
    node["extensions"].erase(std::string(instancing_extension));
    if (node["extensions"].empty()) node.erase("extensions");
  }
  node["children"].push_back(child_number);
  nodes.push_back(std::move(child));
  for_each_channel(document, number, [&](Json& channels, std::size_t i) {
    Json& target = channels[i]["target"];
    if (target.value("path", "") == "weights") target["node"] = child_number;
  });
  return child_number;
}

}  // namespace whittle::gltf
