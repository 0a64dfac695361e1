#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Threshold pairs whose vertices share a face. As long as they do, there is an edge, and the edge decides. Each pair
/// is in the list of one of its ends. When vertices merge, their lists are joined in constant time.
class HiddenPairs {
 public:
  /// \param first_pair the lowest id of a threshold pair; there are `n_pairs`. Nothing is allocated for none.
  HiddenPairs(std::size_t n_vertices, Index first_pair, std::size_t n_pairs)
      : first_pair_(first_pair), lists_(n_pairs > 0 ? n_vertices : 0), next_(n_pairs), is_hidden_(n_pairs) {}

  /// Does nothing if it is hidden already.
  void add(Index v, Index pair) {
    if (is_hidden_[pair - first_pair_]) return;
    is_hidden_[pair - first_pair_] = true;
    next(pair) = lists_[v].first;
    if (lists_[v].first == invalid_index) lists_[v].last = pair;
    lists_[v].first = pair;
  }

  void merge(Index survivor, Index removed) {
    if (lists_.empty() || lists_[removed].first == invalid_index) return;
    next(lists_[removed].last) = lists_[survivor].first;
    if (lists_[survivor].first == invalid_index) lists_[survivor].last = lists_[removed].last;
    lists_[survivor].first = lists_[removed].first;
    lists_[removed] = {};
  }

  /// Appends the pairs of v to `pairs` and forgets them here.
  void take(Index v, std::vector<Index>& pairs) {
    if (lists_.empty()) return;
    for (Index pair = lists_[v].first; pair != invalid_index; pair = next(pair)) {
      is_hidden_[pair - first_pair_] = false;
      pairs.push_back(pair);
    }
    lists_[v] = {};
  }

 private:
  struct List {
    Index first = invalid_index;
    Index last = invalid_index;  ///< defined where `first` is
  };
  Index& next(Index pair) { return next_[pair - first_pair_]; }

  Index first_pair_;
  std::vector<List> lists_;
  std::vector<Index> next_;  ///< by pair
  std::vector<bool> is_hidden_;
};

}  // namespace whittle
