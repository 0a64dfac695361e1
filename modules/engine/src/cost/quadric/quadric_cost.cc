#include "cost/quadric/quadric_cost.hh"

#include <algorithm>

#include "cost/quadric/level_pairs.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

void QuadricCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const {
  if (options_.placement == Placement::optimal) {
    const auto is_edge = [this](const Pair& pair) { return !complex_.is_threshold_pair(pair.id); };
    const auto n_edges =
        static_cast<std::size_t>(std::partition_point(pairs.begin(), pairs.end(), is_edge) - pairs.begin());
    find_minima(quadrics_, Points::without, pairs.first(n_edges), ranks, first_area_);
    find_minima(quadrics_, Points::with, pairs.subspan(n_edges), ranks.subspan(n_edges), first_area_);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!ranks[i].is_minimum || restraints_.pinned(pairs[i]) != Pinned::none) ranks[i] = rank_one(pairs[i]);
    }
  } else {
    std::transform(pairs.begin(), pairs.end(), ranks.begin(), [this](const Pair& pair) { return rank_one(pair); });
  }
  if (!attributes_.any()) return;
  for (std::size_t i = 0; i < pairs.size(); ++i) add_attributes(pairs[i], ranks[i]);
}

/// What attributes cost at the position that the planes like.
void QuadricCost::add_attributes(const Pair& pair, PairEvaluation& rank) const {
  double error = attributes_.error(pair, !complex_.is_threshold_pair(pair.id), rank.position);
  if (first_area_) {
    error *= memoryless_factor(quadrics_.matrix(pair.a).trace() + quadrics_.matrix(pair.b).trace(), *first_area_);
    rank.bound += error;  // which is no lower bound then in any case; above it, the pair would be ranked over and over
  }
  rank.cost += error;
}

/// One end of a pair, as the pair's cost sees it.
WHITTLE_INLINE PlacedQuadric QuadricCost::placed(const Pair& pair, Index v, const Vec3& position) const {
  const PlacedQuadric placed = quadrics_.placed(v, position);
  return complex_.is_threshold_pair(pair.id) ? quadrics_.with_points(v, placed) : placed;
}

PairEvaluation QuadricCost::rank_one(const Pair& pair) const {
  const Pinned pinned = restraints_.pinned(pair).value_or(Pinned::first);
  const PlacedQuadric first = placed(pair, pair.a, complex_.position(pair.a));
  const PlacedQuadric second = placed(pair, pair.b, complex_.position(pair.b));
  PairEvaluation evaluation = evaluate_pair(first, second, options_.placement, pinned);
  if (!first_area_) return evaluation;
  const double factor = memoryless_factor(first.quadric.a.trace() + second.quadric.a.trace(), *first_area_);
  evaluation.bound *= factor;
  evaluation.cost *= factor;
  return evaluation;
}

void QuadricCost::merge(ContractionProfile& /*profile*/, const PairEvaluation& ranked, const Change& change) {
  const PlacedQuadric sum =
      merged(placed(change.pair, change.pair.a, change.before[0]), placed(change.pair, change.pair.b, change.before[1]),
             change.position, ranked.is_minimum);
  quadrics_.merge(change, sum.quadric);
  merge_attributes(change);
}

}  // namespace whittle
