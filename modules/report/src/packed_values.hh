#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace whittle::report {

/// Bytes in groups of four, for `PageBytes`.
class ByteGroups {
 public:
  void add(std::uint8_t byte) {
    if (n_++ % 4 == 0) groups_.emplace_back();
    groups_.back()[(n_ - 1) % 4] = byte;
  }
  const std::vector<std::array<std::uint8_t, 4>>& groups() const { return groups_; }

 private:
  std::vector<std::array<std::uint8_t, 4>> groups_;
  std::size_t n_ = 0;
};

/// The end of a scale, and where its even part ends.
struct ValueRange {
  double max, usual;
};

/// 0, 1, 2, … 127 for values of 0 and above: in even steps up to the usual value, then in even factors up to the
/// largest. Values below 0 have 128 more. The page's `shareOfMax` is the inverse.
std::uint8_t packed_value(double value, const ValueRange& range);

}  // namespace whittle::report
