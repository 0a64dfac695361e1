#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// A face with its bounding box.
struct FaceBox {
  Vec3 min, max;
  Index face;

  bool meets(const FaceBox& other) const {
    return (min.array() <= other.max.array()).all() && (max.array() >= other.min.array()).all();
  }
};

/// Finds the pairs of faces whose boxes meet: closed boxes, so touching counts. A tree that halves the faces at the
/// median of their centers is compared with itself. That takes a fraction of what a search from each face takes.
class BoxPairs {
 public:
  explicit BoxPairs(std::vector<FaceBox> boxes);

  /// The pairs are spread over so many tasks.
  std::size_t n_tasks() const { return boxes_.empty() ? 0 : std::size_t{1} << task_depth(); }

  /// Calls `visit(f, g)` for each pair of a task, in either order. Each pair belongs to one task.
  template <class Visitor>
  void visit(std::size_t task, const Visitor& visit) const;

 private:
  /// A box around the faces of a subtree. The children of node n are 2n + 1 and 2n + 2; all leaves are equally deep.
  struct Node {
    FaceBox box;
    std::size_t begin, end;  ///< in `boxes_`
  };
  static constexpr std::size_t most_in_a_leaf = 4;
  static constexpr unsigned most_task_depth = 8;

  unsigned task_depth() const { return std::min(depth_, most_task_depth); }
  bool is_leaf(std::size_t node) const { return 2 * node + 1 >= nodes_.size(); }
  void build(std::size_t node, std::size_t begin, std::size_t end);
  template <class Visitor>
  void visit_within(std::size_t node, const Visitor& visit) const;
  template <class Visitor>
  void visit_across(std::size_t node, std::size_t other, const Visitor& visit) const;

  std::vector<FaceBox> boxes_;
  unsigned depth_ = 0;
  std::vector<Node> nodes_;
};

template <class Visitor>
void BoxPairs::visit(std::size_t task, const Visitor& visit) const {
  const std::size_t first = (std::size_t{1} << task_depth()) - 1;  // of this depth
  visit_within(first + task, visit);
  for (std::size_t other = first + task + 1; other <= 2 * first; ++other) visit_across(first + task, other, visit);
}

template <class Visitor>
void BoxPairs::visit_within(std::size_t node, const Visitor& visit) const {
  if (!is_leaf(node)) {
    visit_within(2 * node + 1, visit);
    visit_within(2 * node + 2, visit);
    visit_across(2 * node + 1, 2 * node + 2, visit);
    return;
  }
  for (std::size_t i = nodes_[node].begin; i < nodes_[node].end; ++i) {
    for (std::size_t j = i + 1; j < nodes_[node].end; ++j) {
      if (boxes_[i].meets(boxes_[j])) visit(boxes_[i].face, boxes_[j].face);
    }
  }
}

/// \pre both nodes are equally deep
template <class Visitor>
void BoxPairs::visit_across(std::size_t node, std::size_t other, const Visitor& visit) const {
  if (!nodes_[node].box.meets(nodes_[other].box)) return;
  if (!is_leaf(node)) {
    for (const std::size_t child : {2 * node + 1, 2 * node + 2}) {
      for (const std::size_t other_child : {2 * other + 1, 2 * other + 2}) visit_across(child, other_child, visit);
    }
    return;
  }
  for (std::size_t i = nodes_[node].begin; i < nodes_[node].end; ++i) {
    if (!boxes_[i].meets(nodes_[other].box)) continue;
    for (std::size_t j = nodes_[other].begin; j < nodes_[other].end; ++j) {
      if (boxes_[i].meets(boxes_[j])) visit(boxes_[i].face, boxes_[j].face);
    }
  }
}

}  // namespace whittle::metrics
