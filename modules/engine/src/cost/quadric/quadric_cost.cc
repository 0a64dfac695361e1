#include "cost/quadric/quadric_cost.hh"

#include <algorithm>

#include "cost/quadric/level_pairs.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

void QuadricCost::evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const {
  if (options_.placement == Placement::optimal && !restraints_.any()) {
    const auto is_edge = [this](const Pair& pair) { return !complex_.is_threshold_pair(pair.id); };
    const auto n_edges =
        static_cast<std::size_t>(std::partition_point(pairs.begin(), pairs.end(), is_edge) - pairs.begin());
    find_minima(complex_, pairs.first(n_edges), evaluations, first_area_);
    find_minima(complex_, pairs.subspan(n_edges), evaluations.subspan(n_edges), first_area_);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!evaluations[i].is_minimum) evaluations[i] = evaluate_one(pairs[i]);
    }
  } else {
    std::transform(pairs.begin(), pairs.end(), evaluations.begin(),
                   [this](const Pair& pair) { return evaluate_one(pair); });
  }
}

/// One end of a pair, as the pair's cost sees it.
PlacedQuadric QuadricCost::placed(const Pair& pair, Index v) const {
  return complex_.is_threshold_pair(pair.id) ? complex_.placed_with_points(v) : complex_.placed(v);
}

PairEvaluation QuadricCost::evaluate_one(const Pair& pair) const {
  const Pinned pinned = restraints_.pinned(pair).value_or(Pinned::first);
  const PlacedQuadric first = placed(pair, pair.a);
  const PlacedQuadric second = placed(pair, pair.b);
  PairEvaluation evaluation = evaluate_pair(first, second, options_.placement, pinned);
  if (!first_area_) return evaluation;
  const double factor = memoryless_factor(first.quadric.a.trace() + second.quadric.a.trace(), *first_area_);
  evaluation.bound *= factor;
  evaluation.cost *= factor;
  return evaluation;
}

PlacedQuadric QuadricCost::merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar&) {
  return whittle::merged(placed(pair, pair.a), placed(pair, pair.b), evaluation.position, evaluation.is_minimum);
}

}  // namespace whittle
