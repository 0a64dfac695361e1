#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "whittle/core/vertex_pair.hh"

// Why pairs are refused: one row a reason. Counts, reports and messages are loops over the rows.

namespace whittle {

/// Why a guard refuses a contraction.
enum class Refusal : std::uint8_t {
  link,          ///< It would change the topology (link condition).
  flip,          ///< It would turn a face over, or make one without area.
  shape,         ///< It would make a face thinner than allowed.
  feature,       ///< It would take a vertex off its feature line or seam, or a line away.
  area,          ///< It would take the last face of a chart, or of a piece of a region.
  locked,        ///< Both vertices are locked.
  intersection,  ///< It would make faces intersect that didn't before.
  error          ///< It would take the surface farther from the input than `max_error`, or might.
};

/// One row of the table of reasons.
struct RefusalRow {
  Refusal refusal;
  std::string_view key;    ///< in reports
  std::string_view words;  ///< follow a number of pairs
  bool is_always_told;     ///< in messages; others only where pairs were refused for them
};

/// The table: a row a reason, in the order of the enumeration.
inline constexpr std::array<RefusalRow, 8> all_refusals{
    {{Refusal::link, "link", "by topology", true},
     {Refusal::flip, "flip", "by turning a face", true},
     {Refusal::shape, "shape", "by shape", false},
     {Refusal::feature, "feature", "by features or seams", false},
     {Refusal::area, "area", "by the last face of a chart or region", false},
     {Refusal::locked, "locked", "locked", true},
     {Refusal::intersection, "intersection", "by intersecting", false},
     {Refusal::error, "error", "by error", false}}};

/// How often pairs were refused, by reason.
class RefusalCounts {
 public:
  std::uint64_t& operator[](Refusal refusal) { return counts_[static_cast<std::size_t>(refusal)]; }
  std::uint64_t operator[](Refusal refusal) const { return counts_[static_cast<std::size_t>(refusal)]; }

  RefusalCounts& operator+=(const RefusalCounts& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
    return *this;
  }
  std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : counts_) sum += count;
    return sum;
  }
  friend bool operator==(const RefusalCounts&, const RefusalCounts&) = default;

 private:
  std::array<std::uint64_t, all_refusals.size()> counts_{};
};

/// A pair that may not be contracted.
struct RefusedPair {
  VertexPair pair;
  Refusal reason;
};

}  // namespace whittle
