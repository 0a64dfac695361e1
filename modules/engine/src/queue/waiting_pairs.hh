#pragma once

#include <vector>

#include "whittle/core/detail/bit_set.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Pairs that wait for one of their vertices, or of those vertices' neighbours, to change: a list per vertex.
class WaitingPairs {
 public:
  explicit WaitingPairs(std::size_t n_vertices) : n_vertices_(n_vertices), any_(n_vertices) {}

  bool any_at(Index v) const { return any_.test(v); }
  /// For `any_at`.
  void prefetch(Index v) const { any_.prefetch(v); }

  void add(Index v, Index pair) {
    if (heads_.empty()) heads_.resize(n_vertices_);
    if (!any_.test(v)) heads_[v] = invalid_index;
    any_.set(v);
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

  /// Calls `use(pair)` for those that wait at v.
  template <class Use>
  void for_each_at(Index v, const Use& use) const {
    if (!any_.test(v)) return;
    for (Index node = heads_[v]; node != invalid_index; node = nodes_[node].next) use(nodes_[node].pair);
  }

  /// Moves the pairs that wait at v to the end of `pairs`.
  void take(Index v, std::vector<Index>& pairs) {
    if (!any_.test(v)) return;
    any_.reset(v);
    for (Index node = heads_[v]; node != invalid_index;) {
      pairs.push_back(nodes_[node].pair);
      const Index next = nodes_[node].next;
      nodes_[node].next = free_;
      free_ = node;
      node = next;
    }
  }

 private:
  struct Node {
    Index pair = 0;
    Index next = invalid_index;
  };
  std::size_t n_vertices_;
  detail::BitSet any_;        ///< a bit per vertex, as every contraction asks for its whole neighbourhood
  std::vector<Index> heads_;  ///< defined where `any_` is set; empty until something waits
  std::vector<Node> nodes_;
  Index free_ = invalid_index;
};

}  // namespace whittle
