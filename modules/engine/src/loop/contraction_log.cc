#include "loop/contraction_log.hh"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace whittle {

void tell_by_input(std::span<const Vec3> positions, const Frame& frame, std::span<const Index> origins,
                   std::span<Contraction> log) {
  for (Contraction& contraction : log) {
    if (!origins.empty()) {
      contraction.survivor = origins[contraction.survivor];
      contraction.removed = origins[contraction.removed];
    }
    contraction.position = to_output(contraction.position, positions[contraction.survivor], frame);
  }
}

namespace {

/// Contractions of a list that follow each other, of about the same cost.
struct CostRun {
  std::uint32_t cost_class;
  std::span<const Contraction> contractions;
};

/// Numbers whose exponents and first four bits are the same.
std::uint32_t class_of(double cost) {
  constexpr int n_bits_left_out = 52 - 4;
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(std::max(cost, 0.0)) >> n_bits_left_out);
}

void add_runs(std::span<const Contraction> list, std::vector<CostRun>& runs) {
  std::uint32_t greatest = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::uint32_t cost_class = class_of(list[i].cost);
    if (cost_class <= greatest) continue;
    if (i > begin) runs.push_back({greatest, list.subspan(begin, i - begin)});
    greatest = cost_class;
    begin = i;
  }
  if (begin < list.size()) runs.push_back({greatest, list.subspan(begin)});
}

}  // namespace

void add_by_cost(std::span<const std::span<const Contraction>> lists, std::vector<Contraction>& all) {
  std::vector<CostRun> runs;
  for (const std::span<const Contraction> list : lists) add_runs(list, runs);
  std::stable_sort(runs.begin(), runs.end(),
                   [](const CostRun& a, const CostRun& b) { return a.cost_class < b.cost_class; });
  for (const CostRun& run : runs) all.insert(all.end(), run.contractions.begin(), run.contractions.end());
}

}  // namespace whittle
