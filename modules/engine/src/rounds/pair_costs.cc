#include "rounds/pair_costs.hh"

#include <algorithm>

#include "rounds/cost_counts.hh"
#include "rounds/lane_points.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

struct PairCosts::Kernels {
  const PairCosts& costs;

  template <class VertexAt>
  WHITTLE_INLINE SymmetricLanes<Double4> matrices(const VertexAt& vertex) const {
    const auto load = [&](std::size_t first) WHITTLE_INLINE_LAMBDA {
      return transposed_lanes<Double4>([&](std::size_t lane)
                                           WHITTLE_INLINE_LAMBDA { return &costs.stars_[vertex(lane)].sums[first]; });
    };
    const FourLanes<Double4> first = load(0);
    const FourLanes<Double4> second = load(4);
    return {first.first, first.second, first.third, first.fourth, second.first, second.second};
  }

  /// \param pairs four
  WHITTLE_INLINE void rank_four(const VertexPair* pairs, float* ranks) const {
    const auto first = [pairs](std::size_t lane) WHITTLE_INLINE_LAMBDA { return pairs[lane].a; };
    const auto second = [pairs](std::size_t lane) WHITTLE_INLINE_LAMBDA { return pairs[lane].b; };
    const SymmetricLanes<Double4> a = matrices(first);
    const SymmetricLanes<Double4> b = matrices(second);
    const LanePoint* const points = costs.points_.data();
    PairMinimum<Double4> minimum = level_pair_minimum(a, lane_points(points, first), b, lane_points(points, second));
    const Double4 weight = (a.xx + a.yy + a.zz) + (b.xx + b.yy + b.zz);
    minimum.value *= memoryless_factor(weight, costs.first_area_);
    constexpr double highest = CostCounts::highest;
    const Double4 in_range = select_lanes(minimum.value < highest, minimum.value, Double4{} + highest);
    for (std::size_t lane = 0; lane < n_lanes<Double4>; ++lane) ranks[lane] = static_cast<float>(in_range[lane]);
    if (!any_lane(minimum.is_near == 0)) return;
    for (std::size_t lane = 0; lane < n_lanes<Double4>; ++lane) {
      if (minimum.is_near[lane] == 0) ranks[lane] = CostCounts::in_range(costs.of(pairs[lane]).cost);
    }
  }

  WHITTLE_INLINE void rank(std::span<const VertexPair> pairs, float* ranks) const {
    constexpr std::size_t n = n_lanes<Double4>;
    std::size_t i = 0;
    for (; i + n <= pairs.size(); i += n) rank_four(&pairs[i], &ranks[i]);
    for (; i < pairs.size(); ++i) ranks[i] = CostCounts::in_range(costs.of(pairs[i]).cost);
  }

  WHITTLE_AVX2 void rank_in_wide_registers(std::span<const VertexPair> pairs, float* ranks) const {
    rank(pairs, ranks);
  }
};

void PairCosts::rank(std::span<const VertexPair> pairs, std::span<float> costs) const {
  const Kernels kernels{*this};
  has_double4 ? kernels.rank_in_wide_registers(pairs, costs.data()) : kernels.rank(pairs, costs.data());
}

PairEvaluation PairCosts::of(const VertexPair& pair) const {
  const auto lanes = [this](Index v) {
    const SymmetricMatrix a = stars_[v].matrix();
    return SymmetricLanes<double>{a.xx, a.xy, a.xz, a.yy, a.yz, a.zz};
  };
  const SymmetricLanes<double> a = lanes(pair.a);
  const SymmetricLanes<double> b = lanes(pair.b);
  const PairMinimum<double> minimum =
      level_pair_minimum(a, point_lanes(points_[pair.a]), b, point_lanes(points_[pair.b]));
  if (!minimum.is_near) return of(placed(pair.a), placed(pair.b));
  const double cost = minimum.value * memoryless_factor((a.xx + a.yy + a.zz) + (b.xx + b.yy + b.zz), first_area_);
  return {cost, cost, {minimum.x, minimum.y, minimum.z}, true};
}

PairEvaluation PairCosts::of(const PlacedQuadric& first, const PlacedQuadric& second, PairConstraint constraint) const {
  PairEvaluation evaluation = evaluate_pair(first, second, Placement::optimal, constraint);
  const double factor = memoryless_factor(first.quadric.a.trace() + second.quadric.a.trace(), first_area_);
  evaluation.bound *= factor;
  evaluation.cost *= factor;
  return evaluation;
}

}  // namespace whittle
