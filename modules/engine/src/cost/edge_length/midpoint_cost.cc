#include "cost/edge_length/midpoint_cost.hh"

#include <algorithm>

#include "whittle/engine/formula/edge_length_term.hh"

namespace whittle {

void MidpointCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double /*enough*/) const {
  std::transform(pairs.begin(), pairs.end(), ranks.begin(), [this](const Pair& pair) {
    return evaluate_midpoint(complex_.position(pair.a), complex_.position(pair.b),
                             constraints_.of(pair).value_or(PairConstraint::first));
  });
}

}  // namespace whittle
