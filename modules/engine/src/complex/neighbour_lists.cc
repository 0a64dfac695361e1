#include "complex/neighbour_lists.hh"

namespace whittle {
namespace {

constexpr Index exact_up_to = 64;  ///< longer lists have room for a power of two

}  // namespace

NeighbourLists::NeighbourLists(std::size_t n_neighbours, std::size_t n_lists) {
  const std::size_t n_rounded = n_neighbours + n_lists * (neighbours_per_unit - 1);
  neighbours_.reserve(2 * n_rounded);  // what is never written to takes no memory
}

Index NeighbourLists::rounded(Index size) {
  return size <= exact_up_to ? (size + neighbours_per_unit - 1) / neighbours_per_unit * neighbours_per_unit
                             : std::bit_ceil(size);
}

std::size_t NeighbourLists::size_class(Index capacity) {
  return capacity <= exact_up_to
             ? capacity / neighbours_per_unit
             : exact_up_to / neighbours_per_unit + static_cast<std::size_t>(std::bit_width(capacity / exact_up_to));
}

NeighbourLists::List NeighbourLists::allocate(Index size) {
  const Index capacity = rounded(size);
  std::vector<Index>& free = free_[size_class(capacity)];
  if (!free.empty()) {
    const Index begin = free.back();
    free.pop_back();
    return {begin, 0, capacity};
  }
  const auto begin = static_cast<Index>(neighbours_.size() / neighbours_per_unit);
  neighbours_.resize(neighbours_.size() + capacity);
  return {begin, 0, capacity};
}

void NeighbourLists::release(const List& list) {
  if (list.capacity > 0) free_[size_class(list.capacity)].push_back(list.begin);
}

}  // namespace whittle
