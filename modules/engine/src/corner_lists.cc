#include "whittle/engine/corner_lists.hh"

namespace whittle {
namespace {

constexpr Index exact_up_to = 64;  ///< longer lists have room for a power of two

}  // namespace

CornerLists::CornerLists(std::span<const Index> sizes) {
  std::size_t n_corners = 0;
  for (const Index size : sizes) n_corners += rounded(size);
  corners_.reserve(n_corners + n_corners / 4);
}

Index CornerLists::rounded(Index size) {
  return size <= exact_up_to ? (size + corners_per_unit - 1) / corners_per_unit * corners_per_unit
                             : std::bit_ceil(size);
}

std::size_t CornerLists::size_class(Index capacity) {
  return capacity <= exact_up_to
             ? capacity / corners_per_unit
             : exact_up_to / corners_per_unit + static_cast<std::size_t>(std::bit_width(capacity / exact_up_to));
}

CornerLists::List CornerLists::allocate(Index size) {
  const Index capacity = rounded(size);
  std::vector<Index>& free = free_[size_class(capacity)];
  if (!free.empty()) {
    const Index begin = free.back();
    free.pop_back();
    return {begin, 0, capacity};
  }
  const auto begin = static_cast<Index>(corners_.size() / corners_per_unit);
  corners_.resize(corners_.size() + capacity);
  return {begin, 0, capacity};
}

void CornerLists::release(const List& list) {
  if (list.capacity > 0) free_[size_class(list.capacity)].push_back(list.begin);
}

}  // namespace whittle
