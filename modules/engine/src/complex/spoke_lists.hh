#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/prefetch.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// An edge as one of its ends sees it.
struct Spoke {
  Index vertex;  ///< at the other end
  Index edge;
};

/// Lists of spokes in one array. What a list gives back is taken by the next one of that size: lately used, so near.
class SpokeLists {
 public:
  /// A list's place. Empty lists need none.
  struct List {
    Index begin = 0;     ///< in units of two spokes, so that 2³¹ faces fit
    Index size = 0;      ///< spokes
    Index capacity = 0;  ///< spokes
  };

  SpokeLists() = default;
  /// Reserves room for lists with so many spokes together, and for more to come.
  SpokeLists(std::size_t n_spokes, std::size_t n_lists);

  std::span<Spoke> of(const List& list) { return {spokes_.data() + place(list), list.size}; }
  std::span<const Spoke> of(const List& list) const { return {spokes_.data() + place(list), list.size}; }

  /// An empty list with room for `size` spokes. Spans of other lists end here.
  List allocate(Index size);
  void release(const List& list);
  /// \pre list.size < list.capacity
  void push_back(List& list, const Spoke& spoke) { spokes_[place(list) + list.size++] = spoke; }

  void prefetch(const List& list) const {
    const Spoke* spokes = spokes_.data() + place(list);
    whittle::prefetch(spokes);
    whittle::prefetch(spokes + 7);
  }

 private:
  static constexpr Index spokes_per_unit = 2;
  static std::size_t place(const List& list) { return std::size_t{list.begin} * spokes_per_unit; }
  static Index rounded(Index size);
  static std::size_t size_class(Index capacity);

  LargeArray<Spoke> spokes_;
  std::array<std::vector<Index>, 64> free_;  ///< begins of lists given back, by size class
};

}  // namespace whittle
