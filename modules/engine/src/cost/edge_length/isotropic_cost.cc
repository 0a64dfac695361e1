#include "cost/edge_length/isotropic_cost.hh"

#include <algorithm>

#include "whittle/engine/formula/edge_length_term.hh"

namespace whittle {

void IsotropicCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double /*enough*/) const {
  std::transform(pairs.begin(), pairs.end(), ranks.begin(), [this](const Pair& pair) {
    return evaluate_isotropic(quadrics_.placed(pair.a), quadrics_.placed(pair.b), isotropy_, options_.placement,
                              constraints_.of(pair).value_or(PairConstraint::first));
  });
}

}  // namespace whittle
