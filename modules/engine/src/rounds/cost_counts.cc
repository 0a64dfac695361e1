#include "rounds/cost_counts.hh"

namespace whittle {

std::vector<RoundLimit> limits_of_parts(std::span<const CostCounts* const> parts, const RoundSize& size) {
  CostCounts all;
  if (parts.size() > 1) {
    for (const CostCounts* part : parts) all += *part;
  }
  const CostCounts& counts = parts.size() > 1 ? all : *parts.front();
  std::uint64_t n_left = size.n_pairs;
  std::uint32_t last = std::min(counts.first(), CostCounts::n_classes - 1);
  while (last + 1 < CostCounts::n_classes && counts[last] < n_left) n_left -= counts[last++];
  const double most = size.slack * static_cast<double>(CostCounts::end_of(last));
  std::vector<RoundLimit> limits;
  limits.reserve(parts.size());
  for (const CostCounts* part : parts) {
    std::uint64_t n_pairs = 0;
    for (std::uint32_t k = part->first(); k < last; ++k) n_pairs += (*part)[k];
    const std::uint64_t n_last = std::min<std::uint64_t>(n_left, (*part)[last]);
    n_left -= n_last;
    const auto cost = static_cast<float>(std::min(most, static_cast<double>(CostCounts::highest)));
    limits.push_back({cost, n_pairs + n_last});
  }
  return limits;
}

}  // namespace whittle
