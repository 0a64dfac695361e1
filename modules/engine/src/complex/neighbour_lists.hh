#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <vector>

#include "whittle/core/detail/compiler.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// An edge as one of its ends sees it.
struct Neighbour {
  Index vertex;  ///< at the other end
  Index edge;
};

/// Lists of neighbours in one array. What a list gives back is taken by the next one of that size: lately used, so
/// near.
class NeighbourLists {
 public:
  /// A list's place. Empty lists need none.
  struct List {
    Index begin = 0;     ///< in units of two neighbours, so that 2³¹ faces fit
    Index size = 0;      ///< neighbours
    Index capacity = 0;  ///< neighbours
  };

  NeighbourLists() = default;
  /// Reserves room for lists with so many neighbours together, and for more to come.
  NeighbourLists(std::size_t n_neighbours, std::size_t n_lists);

  std::span<Neighbour> of(const List& list) { return {neighbours_.data() + place(list), list.size}; }
  std::span<const Neighbour> of(const List& list) const { return {neighbours_.data() + place(list), list.size}; }

  /// An empty list with room for `size` neighbours. Spans of other lists end here.
  List allocate(Index size);
  void release(const List& list);
  /// \pre list.size < list.capacity
  void push_back(List& list, const Neighbour& neighbour) { neighbours_[place(list) + list.size++] = neighbour; }

  void prefetch(const List& list) const {
    const Neighbour* neighbours = neighbours_.data() + place(list);
    prefetch_line(neighbours);
    prefetch_line(neighbours + 7);
  }

 private:
  static constexpr Index neighbours_per_unit = 2;
  static std::size_t place(const List& list) { return std::size_t{list.begin} * neighbours_per_unit; }
  static Index rounded(Index size);
  static std::size_t size_class(Index capacity);

  LargeArray<Neighbour> neighbours_;
  std::array<std::vector<Index>, 64> free_;  ///< begins of lists given back, by size class
};

}  // namespace whittle
