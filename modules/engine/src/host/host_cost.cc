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
                                     constraints_.of(pair).value_or(PairConstraint::first));
    if (!(rank.cost >= 0)) rank.cost = std::numeric_limits<double>::infinity();
    rank.cost = std::abs(rank.cost);  // queues sort by bits, in which -0 is not 0
    return rank;
  });
}

CandidatePositions HostCost::place(ContractionProfile& profile, const PairEvaluation& ranked) const {
  const auto& [id, a, b] = profile.pair;
  const Index first = complex_.identity(a);
  CandidatePositions candidates =
      cost_.place(first, complex_.identity(b), constraints_.of(profile.pair).value_or(PairConstraint::first), ranked);
  for (std::size_t i = 0; i < candidates.n; ++i) {
    Index& survivor = candidates.options[i].survivor;
    if (survivor != invalid_index) survivor = survivor == first ? a : b;
  }
  return candidates;
}

double HostCost::final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                            const Vec3& position) const {
  const double cost = cost_.final_cost(hosted(complex_, profile, ranked, position));
  return cost >= 0 ? cost : std::numeric_limits<double>::infinity();
}

}  // namespace whittle
