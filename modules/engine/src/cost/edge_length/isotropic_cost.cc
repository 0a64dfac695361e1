#include "cost/edge_length/isotropic_cost.hh"

#include <algorithm>

#include "whittle/engine/formula/edge_length_term.hh"

namespace whittle {

void IsotropicCost::evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const {
  std::transform(pairs.begin(), pairs.end(), evaluations.begin(), [this](const Pair& pair) {
    return evaluate_isotropic(complex_.placed(pair.a), complex_.placed(pair.b), isotropy_, options_.placement,
                              restraints_.pinned(pair).value_or(Pinned::first));
  });
}

double IsotropicCost::dimension() const {
  return isotropic_dimension(options_.weights == Weights::uniform ? 2 : 4, isotropy_);
}

PlacedQuadric IsotropicCost::merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar&) {
  return whittle::merged(complex_.placed(pair.a), complex_.placed(pair.b), evaluation.position, false);
}

}  // namespace whittle
