#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// A monotone queue of ids by cost, in buckets 1/128 of an octave wide. It holds no costs: whoever opens a bucket
/// ranks its members again.
///
/// Push and open cost a constant; memory is 4 to 8.3 bytes a member.
class BucketQueue {
 public:
  using Bucket = std::uint32_t;
  static constexpr Bucket no_bucket = ~Bucket{0};

  /// The bucket of a cost: monotone. Costs below 2⁻²⁰⁰ (of a frame 1 in size: rounding) share the first bucket, those
  /// above 2⁵⁶ the last.
  static Bucket bucket_of(double cost) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(cost) >> (52 - mantissa_bits);
    return bits <= first_bits ? 0 : static_cast<Bucket>(std::min<std::uint64_t>(bits - first_bits, n_buckets - 1));
  }

  /// The least cost of a bucket.
  static double least_cost_in(Bucket bucket) {
    return bucket == 0 ? 0 : std::bit_cast<double>((first_bits + bucket) << (52 - mantissa_bits));
  }
  /// No cost from there on is past.
  double end_of_past() const { return least_cost_in(next_bucket_); }

  /// Puts in the first members. \param buckets of members 0, 1, …; `no_bucket` leaves one out
  void fill(std::span<const Bucket> buckets) {
    starts_.assign(n_buckets + 1, 0);
    for (const Bucket bucket : buckets) {
      if (bucket != no_bucket) ++starts_[bucket + 1];
    }
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    first_members_.resize(starts_.back());
    std::vector<Index> ends(starts_.begin(), starts_.end() - 1);
    for (Index member = 0; member < buckets.size(); ++member) {
      if (buckets[member] != no_bucket) first_members_[ends[buckets[member]]++] = member;
    }
    blocks_.reserve(buckets.size() / (block_capacity / 2));  // what is never written to takes no memory
  }

  /// \pre !is_past(bucket)
  void push(Index member, Bucket bucket) {
    assert(!is_past(bucket));
    Head& head = heads_[bucket];
    if (head.n_in_block == 0 || head.n_in_block == block_capacity) {
      const Index block = allocate();
      blocks_[block].next = head.n_in_block == 0 ? invalid_index : head.block;
      head = {block, 0};
    }
    blocks_[head.block].members[head.n_in_block++] = member;
  }

  /// Opens the first bucket that has members, and moves these to `members`. From now on only later buckets take
  /// members. \return false when the queue is empty
  bool open_next(std::vector<Index>& members) {
    members.clear();
    while (next_bucket_ < n_buckets && is_empty(next_bucket_)) ++next_bucket_;
    if (next_bucket_ == n_buckets) return false;
    const auto first = first_members_.begin();
    members.assign(first + starts_[next_bucket_], first + starts_[next_bucket_ + 1]);
    const Head head = heads_[next_bucket_];
    heads_[next_bucket_] = {};
    std::size_t n = head.n_in_block;
    for (Index block = head.block; block != invalid_index;) {
      for (std::size_t i = 0; i < n; ++i) members.push_back(blocks_[block].members[i]);
      n = block_capacity;
      const Index next = blocks_[block].next;
      free_blocks_.push_back(block);
      block = next;
    }
    ++next_bucket_;
    return true;
  }

  /// True once this bucket, or a later one, has been opened. It takes no members any more.
  bool is_past(Bucket bucket) const { return bucket < next_bucket_; }

 private:
  static constexpr int mantissa_bits = 7;
  static constexpr std::uint64_t first_bits = std::uint64_t{1023 - 200} << mantissa_bits;
  static constexpr Bucket n_buckets = 256 * 128;
  static constexpr std::size_t block_capacity = 15;
  struct alignas(64) Block {
    std::array<Index, block_capacity> members;
    Index next;
  };
  struct Head {
    Index block = invalid_index;
    std::uint32_t n_in_block = 0;  ///< 0 only when the bucket is empty
  };

  bool is_empty(Bucket bucket) const {
    return heads_[bucket].n_in_block == 0 && starts_[bucket] == starts_[bucket + 1];
  }
  Index allocate() {
    if (free_blocks_.empty()) {
      blocks_.emplace_back();
      return static_cast<Index>(blocks_.size() - 1);
    }
    const Index block = free_blocks_.back();
    free_blocks_.pop_back();
    return block;
  }

  std::vector<Index> starts_ = std::vector<Index>(n_buckets + 1);  ///< of each bucket's first members
  LargeArray<Index> first_members_;
  std::vector<Head> heads_ = std::vector<Head>(n_buckets);
  LargeArray<Block> blocks_;
  std::vector<Index> free_blocks_;
  Bucket next_bucket_ = 0;  ///< the first that has not been opened
};

}  // namespace whittle
