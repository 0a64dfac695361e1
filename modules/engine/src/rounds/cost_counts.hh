#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace whittle {

/// How much a part contracts in a round.
struct RoundLimit {
  float cost;             ///< nothing that costs more
  std::uint64_t n_pairs;  ///< at most
};

/// How much a round contracts of a whole.
struct RoundSize {
  std::uint64_t n_pairs;  ///< at most
  double slack;  ///< and nothing that costs more than so many times what the last of that many pairs costs. Some pairs
                 ///< can't be contracted in the round, as one of their vertices has been merged; with slack others may
                 ///< take their places. [1, inf)
};

/// Of the vertices left, and the slack, of a round that is far from the target. Measured: docs/dev/rounds.md.
inline constexpr double share_of_large_round = 0.4;
inline constexpr double slack_of_large_round = 3;

/// How many pairs there are of each class of costs.
class CostCounts {
  static constexpr int shift = 17;

 public:
  static constexpr float highest = 1e30F;
  static constexpr float never = 2e30F;  ///< of pairs that aren't contracted, whatever they cost
  /// A cost in single precision. Greater ones than the highest, and what is no number, become that.
  static float in_range(double cost) {
    return cost < highest ? static_cast<float>(std::max(cost, 0.0)) + 0.0F : highest;
  }
  /// 64 classes an octave: the exponent and the first six bits. \param cost in range
  static std::uint32_t class_of(float cost) { return std::bit_cast<std::uint32_t>(cost) >> shift; }
  /// Just above the greatest cost of a class.
  static float end_of(std::uint32_t cost_class) { return std::bit_cast<float>((cost_class + 1) << shift); }
  static constexpr std::uint32_t n_classes = (std::bit_cast<std::uint32_t>(never) >> shift) + 1;

  void count(std::span<const float> costs) {
    clear();
    add(costs);
  }
  void clear() {
    if (counts_.empty()) counts_.resize(n_classes);
    for (std::uint32_t k = first_; k < end_; ++k) counts_[k] = 0;
    first_ = n_classes;
    end_ = 0;
  }
  /// \pre clear
  void add(std::span<const float> costs) {
    std::uint32_t first = first_;
    std::uint32_t end = end_;
    for (const float cost : costs) {
      const std::uint32_t k = class_of(cost);
      ++counts_[k];
      first = std::min(first, k);
      end = std::max(end, k + 1);
    }
    first_ = first;
    end_ = end;
  }
  CostCounts& operator+=(const CostCounts& o) {
    if (counts_.empty()) clear();
    for (std::uint32_t k = o.first_; k < o.end_; ++k) counts_[k] += o.counts_[k];
    first_ = std::min(first_, o.first_);
    end_ = std::max(end_, o.end_);
    return *this;
  }
  std::uint32_t operator[](std::size_t cost_class) const { return counts_[cost_class]; }
  /// Lower classes have no pairs.
  std::uint32_t first() const { return first_; }

 private:
  std::vector<std::uint32_t> counts_;  ///< by class
  std::uint32_t first_ = n_classes;    ///< lower classes have no pairs
  std::uint32_t end_ = 0;              ///< neither have this one and higher ones
};

/// The limits of parts in one round: all have one limit of the cost. Of the pairs that cost least in all, each may
/// contract as many as it has; of equal ones the parts that come first.
std::vector<RoundLimit> limits_of_parts(std::span<const CostCounts* const> parts, const RoundSize& size);

}  // namespace whittle
