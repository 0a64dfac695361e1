#pragma once

#include <span>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::detail {

/// A list of values for each index below some number, all in one array.
template <class T>
class IndexLists {
 public:
  IndexLists() = default;
  /// \param for_each calls its argument with an index and a value, once for each value of each list, in the order that
  ///        the values shall have there. It is called twice: for counting, and for storing.
  /// \pre fewer than 2³² values
  template <class ForEach>
  IndexLists(std::size_t n_lists, const ForEach& for_each) : first_(n_lists + 1, 0) {
    for_each([this](Index i, const T&) { ++first_[i + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    values_.resize(first_.back());
    LargeArray<Index> end(first_.begin(), first_.end() - 1);
    for_each([&](Index i, const T& value) { values_[end[i]++] = value; });
  }

  std::size_t size() const { return first_.size() - 1; }  ///< number of lists
  std::size_t n_values() const { return values_.size(); }
  std::span<const T> of(Index i) const { return std::span(values_).subspan(first_[i], first_[i + 1] - first_[i]); }
  std::span<T> of(Index i) { return std::span(values_).subspan(first_[i], first_[i + 1] - first_[i]); }

 private:
  LargeArray<Index> first_ = LargeArray<Index>(1, 0);  ///< where each list begins; one more at the end
  LargeArray<T> values_;
};

}  // namespace whittle::detail
