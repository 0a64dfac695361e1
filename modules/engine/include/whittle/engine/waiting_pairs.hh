#pragma once

#include <vector>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle {

/// Pairs that wait for one of their vertices, or of those vertices' neighbours, to change: a list per vertex.
class WaitingPairs {
 public:
  explicit WaitingPairs(std::size_t n_vertices) : heads_(n_vertices, invalid_index) {}

  bool any_at(Index v) const { return heads_[v] != invalid_index; }

  void add(Index v, Index pair) {
    Index node;
    if (free_ == invalid_index) {
      node = static_cast<Index>(nodes_.size());
      nodes_.push_back({});
    } else {
      node = free_;
      free_ = nodes_[node].next;
    }
    nodes_[node] = {pair, heads_[v]};
    heads_[v] = node;
  }

  /// Appends the pairs waiting at v to `pairs` and forgets them here.
  void take(Index v, std::vector<Index>& pairs) {
    for (Index node = heads_[v]; node != invalid_index;) {
      pairs.push_back(nodes_[node].pair);
      const Index next = nodes_[node].next;
      nodes_[node].next = free_;
      free_ = node;
      node = next;
    }
    heads_[v] = invalid_index;
  }

 private:
  struct Node {
    Index pair = 0;
    Index next = invalid_index;
  };
  std::vector<Index> heads_;
  std::vector<Node> nodes_;
  Index free_ = invalid_index;
};

}  // namespace whittle
