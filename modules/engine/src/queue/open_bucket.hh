#pragma once

#include <algorithm>
#include <optional>
#include <queue>
#include <vector>

#include "queue/pair_queue.hh"
#include "whittle/core/detail/large_array.hh"

namespace whittle {

/// The candidates of the bucket that was opened last, and those added to it or to an earlier one since.
class OpenBucket {
 public:
  /// Begins with the next bucket. \pre all candidates have been taken
  /// \param most how many candidates it may have
  void open(std::size_t most) {
    sorted_.clear();
    sorted_.reserve(most);
    n_taken_ = 0;
  }
  /// Adds one of its members. They come in any order; `sort` must follow.
  void add(const Candidate& candidate) { sorted_.push_back(candidate); }
  void sort() {
    std::sort(sorted_.begin(), sorted_.end(), [](const Candidate& x, const Candidate& y) { return is_before(x, y); });
  }
  /// Drops members whose neighbour in order is the same. \param is_same is asked once a member, of it and the one
  /// before
  template <class IsSame>
  void drop_repeated(const IsSame& is_same) {
    sorted_.erase(std::unique(sorted_.begin(), sorted_.end(), is_same), sorted_.end());
  }
  /// Adds a pair whose cost came to lie in this bucket, or in an earlier one, after it was opened.
  void add_late(const Candidate& candidate) { late_.push(candidate); }

  /// The first in order; nullopt when all have been taken.
  std::optional<Candidate> take() {
    const bool has_sorted = n_taken_ < sorted_.size();
    if (has_sorted && (late_.empty() || is_before(sorted_[n_taken_], late_.top()))) return sorted_[n_taken_++];
    if (late_.empty()) return std::nullopt;
    const Candidate candidate = late_.top();
    late_.pop();
    return candidate;
  }

  /// The member that comes n after the next one; null behind the last. For prefetching.
  const Candidate* ahead(std::size_t n) const {
    return n_taken_ + n < sorted_.size() ? &sorted_[n_taken_ + n] : nullptr;
  }

 private:
  LargeArray<Candidate> sorted_;
  std::size_t n_taken_ = 0;  ///< how many of them
  std::priority_queue<Candidate, std::vector<Candidate>, IsAfter> late_;
};

}  // namespace whittle
