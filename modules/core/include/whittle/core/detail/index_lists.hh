#pragma once

#include <cstddef>
#include <span>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::detail {

/// A list of values for each index below a number, all in one array. Two passes of counting, no sort: O(lists +
/// values). \tparam Offset counts the values of all lists; std::size_t where they may be more than `Index` can count.
template <class T, class Offset = Index>
class IndexLists {
 public:
  IndexLists() = default;
  /// \param for_each called twice with a function emit(index, value). It calls emit for the same values each time, in
  ///        the order of each list.
  template <class ForEach>
  IndexLists(std::size_t n_lists, const ForEach& for_each) : first_(n_lists + 2, 0) {
    // Counts are stored two slots further on. While the lists are filled, first_[i + 1] is the end of list i.
    for_each([this](Index i, const T&) { ++first_[std::size_t{i} + 2]; });
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    values_.resize(first_.back());
    for_each([this](Index i, const T& value) { values_[first_[std::size_t{i} + 1]++] = value; });
  }

  std::size_t size() const { return first_.size() - 2; }  ///< number of lists
  std::size_t n_values() const { return values_.size(); }
  std::span<const T> of(Index i) const { return std::span(values_).subspan(first_[i], length(i)); }
  std::span<T> of(Index i) { return std::span(values_).subspan(first_[i], length(i)); }

 private:
  std::size_t length(Index i) const { return first_[std::size_t{i} + 1] - first_[i]; }

  LargeArray<Offset> first_ = LargeArray<Offset>(2, 0);  ///< Start of each list. Two more at the end.
  LargeArray<T> values_;
};

}  // namespace whittle::detail
