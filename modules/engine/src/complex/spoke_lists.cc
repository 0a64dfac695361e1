#include "complex/spoke_lists.hh"

namespace whittle {
namespace {

constexpr Index exact_up_to = 64;  ///< longer lists have room for a power of two

}  // namespace

SpokeLists::SpokeLists(std::size_t n_spokes, std::size_t n_lists) {
  const std::size_t n_rounded = n_spokes + n_lists * (spokes_per_unit - 1);
  spokes_.reserve(2 * n_rounded);  // what is never written to takes no memory
}

Index SpokeLists::rounded(Index size) {
  return size <= exact_up_to ? (size + spokes_per_unit - 1) / spokes_per_unit * spokes_per_unit : std::bit_ceil(size);
}

std::size_t SpokeLists::size_class(Index capacity) {
  return capacity <= exact_up_to
             ? capacity / spokes_per_unit
             : exact_up_to / spokes_per_unit + static_cast<std::size_t>(std::bit_width(capacity / exact_up_to));
}

SpokeLists::List SpokeLists::allocate(Index size) {
  const Index capacity = rounded(size);
  std::vector<Index>& free = free_[size_class(capacity)];
  if (!free.empty()) {
    const Index begin = free.back();
    free.pop_back();
    return {begin, 0, capacity};
  }
  const auto begin = static_cast<Index>(spokes_.size() / spokes_per_unit);
  spokes_.resize(spokes_.size() + capacity);
  return {begin, 0, capacity};
}

void SpokeLists::release(const List& list) {
  if (list.capacity > 0) free_[size_class(list.capacity)].push_back(list.begin);
}

}  // namespace whittle
