#pragma once

#include <cstdint>
#include <vector>

#include "whittle/core/detail/compiler.hh"

namespace whittle::detail {

/// A bit per element. Unlike std::vector<bool>, it can be prefetched.
class BitSet {
 public:
  BitSet() = default;
  explicit BitSet(std::size_t n, bool value = false) { assign(n, value); }

  void assign(std::size_t n, bool value) { words_.assign(n / 64 + 1, value ? ~std::uint64_t{0} : 0); }

  bool test(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }
  void set(std::size_t i) { words_[i / 64] |= bit(i); }
  void reset(std::size_t i) { words_[i / 64] &= ~bit(i); }
  void prefetch(std::size_t i) const { prefetch_line(&words_[i / 64]); }

 private:
  static std::uint64_t bit(std::size_t i) { return std::uint64_t{1} << (i % 64); }

  std::vector<std::uint64_t> words_;
};

}  // namespace whittle::detail
