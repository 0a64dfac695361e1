#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::detail {

/// The numbers 0 … n − 1 sorted into groups, ascending in each; a number may be in several groups. All threads sort. So
/// one thread can write for one group, in one order.
class ItemGroups {
 public:
  ItemGroups() = default;
  /// \param for_each_group calls its second argument with each group of an item, each once. It is called twice for
  ///        each item, by any thread.
  template <class ForEachGroup>
  ItemGroups(std::size_t n_items, std::size_t n_groups, unsigned threads, const ForEachGroup& for_each_group) {
    const std::size_t length = std::max(range_length, (n_items + most_ranges - 1) / most_ranges);
    const std::size_t n_ranges = (n_items + length - 1) / length;
    std::vector<std::size_t> places(n_ranges * n_groups);  // by range and group; counts at first
    const auto for_each_place = [&](const auto& use) {
      for_each_block(n_ranges, threads, [&](std::size_t range) {
        const std::span of_range = std::span(places).subspan(range * n_groups, n_groups);
        const auto end = static_cast<Index>(std::min(n_items, (range + 1) * length));
        for (auto item = static_cast<Index>(range * length); item < end; ++item) {
          for_each_group(item, [&](std::size_t group) { use(of_range[group], item); });
        }
      });
    };
    for_each_place([](std::size_t& place, Index) { ++place; });
    begins_.clear();
    begins_.reserve(n_groups + 1);
    std::size_t sum = 0;
    for (std::size_t group = 0; group < n_groups; ++group) {
      begins_.push_back(sum);
      for (std::size_t range = 0; range < n_ranges; ++range) {
        sum += std::exchange(places[range * n_groups + group], sum);
      }
    }
    begins_.push_back(sum);
    items_.resize(sum);
    for_each_place([this](std::size_t& place, Index item) { items_[place++] = item; });
  }

  std::size_t size() const { return begins_.size() - 1; }  ///< number of groups
  std::span<const Index> of(std::size_t group) const {
    return std::span(items_).subspan(begins_[group], begins_[group + 1] - begins_[group]);
  }

 private:
  static constexpr std::size_t most_ranges = 256;  ///< enough for all threads; more need more memory for places

  std::vector<std::size_t> begins_ = std::vector<std::size_t>(1);  ///< of each group, and the end
  LargeArray<Index> items_;
};

/// Calls `work(begin, end, for_each_face)` for ranges that together make up all vertices, on all threads, in any order.
/// `for_each_face(use)` calls `use(face)` for each face that has a corner from begin to end, in ascending order. So
/// sums over vertices have one order, for any number of threads.
template <class Work>
void for_each_vertex_range(std::span<const Triangle> faces, std::size_t n_vertices, unsigned threads,
                           const Work& work) {
  if (n_threads(threads) == 1 || n_vertices <= range_length) {
    work(Index{0}, static_cast<Index>(n_vertices), [n = static_cast<Index>(faces.size())](const auto& use) {
      for (Index f = 0; f < n; ++f) use(f);
    });
    return;
  }
  const std::size_t n_ranges = (n_vertices + range_length - 1) / range_length;
  const ItemGroups groups(faces.size(), n_ranges, threads, [faces](Index f, const auto& use) {
    const auto& [a, b, c] = faces[f];
    const std::size_t of_a = a / range_length;
    const std::size_t of_b = b / range_length;
    const std::size_t of_c = c / range_length;
    use(of_a);
    if (of_b != of_a) use(of_b);
    if (of_c != of_a && of_c != of_b) use(of_c);
  });
  for_each_range(n_vertices, threads, [&](std::size_t begin, std::size_t end) {
    work(static_cast<Index>(begin), static_cast<Index>(end), [&](const auto& use) {
      for (const Index f : groups.of(begin / range_length)) use(f);
    });
  });
}

}  // namespace whittle::detail
