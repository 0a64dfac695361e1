#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Items grouped by a small number, such as edges by their lower vertex: two passes of counting instead of a sort.
template <class Item>
class Buckets {
 public:
  /// \param visit called twice with a function emit(bucket, item), which it calls for the same items each time.
  template <class Visit>
  Buckets(std::size_t buckets, const Visit& visit) : end_(buckets + 1, 0) {
    visit([this](Index bucket, const Item&) { ++end_[bucket]; });
    std::size_t total = 0;
    for (std::size_t& begin : end_) {
      const std::size_t count = begin;
      begin = total;
      total += count;
    }
    items_.resize(total);
    visit([this](Index bucket, const Item& item) { items_[end_[bucket]++] = item; });
  }

  std::size_t size() const { return end_.size() - 1; }

  /// In the order they were emitted.
  std::span<Item> operator[](std::size_t bucket) {
    const std::size_t begin = bucket == 0 ? 0 : end_[bucket - 1];
    return std::span<Item>(items_).subspan(begin, end_[bucket] - begin);
  }

 private:
  std::vector<std::size_t> end_;  // of each bucket, once filled
  std::vector<Item> items_;
};

}  // namespace whittle::io
