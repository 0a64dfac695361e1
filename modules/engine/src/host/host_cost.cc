#include "host/host_cost.hh"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {

HostedContraction hosted(const TriangleComplex& complex, const ContractionProfile& profile,
                         const PairEvaluation& ranked, const Vec3& position) {
  const auto [survivor, removed] = complex.identities_after(profile.pair, profile.survivor, position);
  return {complex.identity(profile.pair.a),
          complex.identity(profile.pair.b),
          survivor,
          removed,
          {complex.position(profile.pair.a), complex.position(profile.pair.b)},
          ranked,
          position};
}

void HostCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double /*enough*/) const {
  std::transform(pairs.begin(), pairs.end(), ranks.begin(), [this](const Pair& pair) {
    PairEvaluation rank = cost_.rank(complex_.identity(pair.a), complex_.identity(pair.b),
                                     restraints_.pinned(pair).value_or(Pinned::first));
    if (!(rank.cost >= 0)) rank.cost = std::numeric_limits<double>::infinity();
    rank.cost = std::abs(rank.cost);  // queues sort by bits, in which -0 is not 0
    return rank;
  });
}

Settlement HostCost::place(ContractionProfile& profile, const PairEvaluation& ranked) const {
  const auto& [id, a, b] = profile.pair;
  const Index first = complex_.identity(a);
  Settlement settlement =
      cost_.settle(first, complex_.identity(b), restraints_.pinned(profile.pair).value_or(Pinned::first), ranked);
  for (std::size_t i = 0; i < settlement.n; ++i) {
    Index& survivor = settlement.options[i].survivor;
    if (survivor != invalid_index) survivor = survivor == first ? a : b;
  }
  return settlement;
}

double HostCost::final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                            const Vec3& position) const {
  const double cost = cost_.final_cost(hosted(complex_, profile, ranked, position));
  return cost >= 0 ? cost : std::numeric_limits<double>::infinity();
}

}  // namespace whittle
