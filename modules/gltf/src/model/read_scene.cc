#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "model/extensions.hh"
#include "model/read_model.hh"

namespace whittle::gltf {
namespace {

/// The nodes that stand in place of others from afar.
std::vector<std::size_t> roots_of_levels(const Model& model, const Part& root) {
  std::vector<std::size_t> roots;
  for (const Part& node : root.array("nodes", "node")) {
    const std::optional<Part> levels = node.extension(lod_extension);
    if (!levels) continue;
    for (const std::size_t level : levels->indices("ids", model.nodes.size(), "node")) roots.push_back(level);
  }
  return roots;
}

/// Roots of the scene that viewers show first. Without scenes, all roots.
std::vector<std::size_t> roots_of_scene(const Model& model, const Part& root) {
  const std::vector<Part> scenes = root.array("scenes", "scene");
  if (!scenes.empty()) {
    return scenes[root.index("scene", scenes.size(), "scene").value_or(0)].indices("nodes", model.nodes.size(), "node");
  }
  std::vector<std::size_t> roots;
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    if (!model.nodes[n].parent) roots.push_back(n);
  }
  return roots;
}

using Children = std::vector<std::vector<std::size_t>>;

Children children_of(const Model& model) {
  Children children(model.nodes.size());
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    if (model.nodes[n].parent) children[*model.nodes[n].parent].push_back(n);
  }
  return children;
}

/// Calls `mark` with nodes, and, if it returns true, with their descendants.
template <class Mark>
void mark_below(std::vector<std::size_t> nodes, const Children& children, const Mark& mark) {
  while (!nodes.empty()) {
    const std::size_t n = nodes.back();
    nodes.pop_back();
    if (mark(n)) nodes.insert(nodes.end(), children[n].begin(), children[n].end());
  }
}

/// Nodes that KHR_node_visibility hides, with all below them.
std::vector<bool> hidden_nodes(const Part& root) {
  std::vector<bool> is_hidden;
  for (const Part& node : root.array("nodes", "node")) {
    const std::optional<Part> visibility = node.extension(visibility_extension);
    is_hidden.push_back(visibility && visibility->has("visible") && !visibility->flag("visible"));
  }
  return is_hidden;
}

}  // namespace

void read_scene(Model& model, const Part& root) {
  const Children children = children_of(model);
  mark_below(roots_of_levels(model, root), children,
             [&](std::size_t n) { return !std::exchange(model.nodes[n].is_level, true); });
  const std::vector<bool> is_hidden = hidden_nodes(root);
  mark_below(roots_of_scene(model, root), children, [&](std::size_t n) {
    return !model.nodes[n].is_level && !is_hidden[n] && !std::exchange(model.nodes[n].is_shown, true);
  });
}

}  // namespace whittle::gltf
