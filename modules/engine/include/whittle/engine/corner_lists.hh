#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <span>
#include <vector>

#include "whittle/engine/indexed_mesh.hh"
#include "whittle/engine/large_array.hh"
#include "whittle/engine/prefetch.hh"

namespace whittle {

/// A face as one of its corners v sees it: (v, next, previous) is counter-clockwise.
struct Corner {
  Index next, previous;  ///< vertices
  Index edge;            ///< from v to `next`
};

/// Lists of corners in one array. What a list gives back is taken by the next one of that size: lately used, so near.
class CornerLists {
 public:
  /// A list's place. Empty lists need none.
  struct List {
    Index begin = 0;     ///< in units of two corners, so that 2³¹ faces fit
    Index size = 0;      ///< corners
    Index capacity = 0;  ///< corners
  };

  CornerLists() = default;
  /// Reserves room for lists of these sizes, and for more to come.
  explicit CornerLists(std::span<const Index> sizes);

  std::span<Corner> of(const List& list) { return {corners_.data() + place(list), list.size}; }
  std::span<const Corner> of(const List& list) const { return {corners_.data() + place(list), list.size}; }

  /// An empty list with room for `size` corners. Spans of other lists end here.
  List allocate(Index size);
  void release(const List& list);
  /// Copies `from` to the end of `to`, which has room for it.
  void append(List& to, const List& from) {
    assert(from.size <= to.capacity - to.size);
    std::copy_n(corners_.data() + place(from), from.size, corners_.data() + place(to) + to.size);
    to.size += from.size;
  }

  void prefetch(const List& list) const {
    const Corner* corners = corners_.data() + place(list);
    whittle::prefetch(corners);
    whittle::prefetch(corners + 5);
  }

 private:
  static constexpr Index corners_per_unit = 2;
  static std::size_t place(const List& list) { return std::size_t{list.begin} * corners_per_unit; }
  static Index rounded(Index size);
  static std::size_t size_class(Index capacity);

  LargeArray<Corner> corners_;
  std::array<std::vector<Index>, 64> free_;  ///< begins of lists given back, by size class
};

}  // namespace whittle
