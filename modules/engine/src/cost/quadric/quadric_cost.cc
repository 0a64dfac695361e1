#include "cost/quadric/quadric_cost.hh"

#include <algorithm>
#include <utility>

#include "cost/quadric/level_pairs.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

void QuadricCost::start(CostState&& before, unsigned /*threads*/) {
  quadrics_.start(before);
  SurfaceAttributes& attributes = before.attributes;
  if (!attributes.wedges.any()) return;
  const std::vector<Index> vertices = complex_.vertices_by_origin();
  for (Index& v : attributes.vertex_of) v = vertices[v];
  attributes_ = AttributeQuadrics(std::move(attributes), vertices.size());
}

CostState QuadricCost::state(std::span<const Index> vertices) const {
  CostState state;
  reserve_large(state.quadrics, vertices.size());
  for (Index i = 0; i < vertices.size(); ++i) state.quadrics.push_back({i, quadric(vertices[i])});
  state.attributes = attributes_.at(vertices);
  return state;
}

void QuadricCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const {
  rank_planes(pairs, ranks);
  if (!attributes_.any()) return;
  constexpr std::size_t ahead = 4;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i + ahead < pairs.size() && ranks[i + ahead].cost < enough) attributes_.prefetch(pairs[i + ahead]);
    if (ranks[i].cost < enough) ranks[i] = rank_with_attributes(pairs[i], ranks[i].bound);
  }
}

void QuadricCost::rank_planes(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const {
  if (options_.placement != Placement::optimal) {
    std::transform(pairs.begin(), pairs.end(), ranks.begin(),
                   [this](const Pair& pair) { return rank_planes_of(pair); });
    return;
  }
  const auto is_edge = [this](const Pair& pair) { return !complex_.is_threshold_pair(pair.id); };
  const auto n_edges =
      static_cast<std::size_t>(std::partition_point(pairs.begin(), pairs.end(), is_edge) - pairs.begin());
  find_minima(quadrics_, Points::without, pairs.first(n_edges), ranks, first_area_);
  find_minima(quadrics_, Points::with, pairs.subspan(n_edges), ranks.subspan(n_edges), first_area_);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!ranks[i].is_minimum || constraints_.of(pairs[i]) != PairConstraint::none) ranks[i] = rank_planes_of(pairs[i]);
  }
}

/// One end of a pair, as the pair's cost sees it.
WHITTLE_INLINE PlacedQuadric QuadricCost::placed(const Pair& pair, Index v, const Vec3& position) const {
  const PlacedQuadric placed = quadrics_.placed(v, position);
  return complex_.is_threshold_pair(pair.id) ? quadrics_.with_points(v, placed) : placed;
}

/// Memoryless costs have a factor by the weight of the planes.
PairEvaluation QuadricCost::in_unit(PairEvaluation evaluation, const PlacedQuadric& first,
                                    const PlacedQuadric& second) const {
  if (!first_area_) return evaluation;
  const double factor = memoryless_factor(first.quadric.a.trace() + second.quadric.a.trace(), *first_area_);
  evaluation.bound *= factor;
  evaluation.cost *= factor;
  return evaluation;
}

PairEvaluation QuadricCost::rank_planes_of(const Pair& pair) const {
  const PlacedQuadric first = placed(pair, pair.a, complex_.position(pair.a));
  const PlacedQuadric second = placed(pair, pair.b, complex_.position(pair.b));
  const PairConstraint constraint = constraints_.of(pair).value_or(PairConstraint::first);
  return in_unit(evaluate_pair(first, second, options_.placement, constraint), first, second);
}

PairEvaluation QuadricCost::rank_with_attributes(const Pair& pair, double bound_of_planes) const {
  const PlacedQuadric first = placed(pair, pair.a, complex_.position(pair.a));
  const PlacedQuadric second = placed(pair, pair.b, complex_.position(pair.b));
  const PairConstraint constraint = constraints_.of(pair).value_or(PairConstraint::first);
  const PairAttributes attributes =
      attributes_.of(pair, !complex_.is_threshold_pair(pair.id), second.position - first.position);
  PairEvaluation evaluation = evaluate_with_attributes(first, second, attributes, options_.placement, constraint);
  if (first_area_) return in_unit(evaluation, first, second);
  if (!attributes.never_falls) evaluation.bound = bound_of_planes;
  return evaluation;
}

void QuadricCost::merge(ContractionProfile& /*profile*/, const PairEvaluation& ranked, const Change& change) {
  const PlacedQuadric sum =
      merged(placed(change.pair, change.pair.a, change.before[0]), placed(change.pair, change.pair.b, change.before[1]),
             change.position, ranked.is_minimum && !attributes_.any());
  quadrics_.merge(change, sum.quadric);
  merge_attributes(change);
}

}  // namespace whittle
