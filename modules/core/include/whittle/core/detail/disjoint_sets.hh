#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <numeric>
#include <vector>

namespace whittle::detail {

/// Union-find over 0 … n − 1 with path halving. The root of a set is its least number.
template <std::unsigned_integral Number>
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Number{0}); }

  Number find(Number x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Returns whether the two sets were different.
  bool join(Number x, Number y) {
    x = find(x), y = find(y);
    if (x == y) return false;
    parent_[std::max(x, y)] = std::min(x, y);
    return true;
  }

 private:
  std::vector<Number> parent_;
};

}  // namespace whittle::detail
