#include "rounds/pair_costs.hh"

#include <algorithm>
#include <array>
#include <utility>

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

  /// Up to four simple pairs, and where their costs are written.
  struct Four {
    std::array<VertexPair, n_lanes<Double4>> pairs;
    std::array<float*, n_lanes<Double4>> ranks;
    std::size_t n = 0;
  };

  WHITTLE_INLINE void rank(Four& four, const AttributeQuadrics& attributes) const {
    for (std::size_t lane = four.n; lane < four.pairs.size(); ++lane) four.pairs[lane] = four.pairs[0];
    const VertexPair* const pairs = four.pairs.data();
    const auto first = [pairs](std::size_t lane) WHITTLE_INLINE_LAMBDA { return pairs[lane].a; };
    const auto second = [pairs](std::size_t lane) WHITTLE_INLINE_LAMBDA { return pairs[lane].b; };
    const SymmetricLanes<Double4> a = matrices(first);
    const SymmetricLanes<Double4> b = matrices(second);
    const PointLanes<Double4> from = lane_points(costs.points_.data(), first);
    const PointLanes<Double4> to = lane_points(costs.points_.data(), second);
    const auto [q, most] = attributes.of_four(pairs, to - from);
    const Double4 zero{};
    const PairMinimum<Double4> minimum =
        pair_minimum<Double4>({from.x, from.y, from.z, a.xx + q.xx, a.xy + q.xy, a.xz + q.xz, a.yy + q.yy, a.yz + q.yz,
                               a.zz + q.zz, q.bx, q.by, q.bz, q.c},
                              {to.x, to.y, to.z, b.xx, b.xy, b.xz, b.yy, b.yz, b.zz, zero, zero, zero, zero});
    const PointLanes<Double4> x = PointLanes<Double4>{minimum.x, minimum.y, minimum.z} - from;
    const PointLanes<Double4> slope{q.bx + q.bx + (q.xx * x.x + q.xy * x.y + q.xz * x.z),
                                    q.by + q.by + (q.xy * x.x + q.yy * x.y + q.yz * x.z),
                                    q.bz + q.bz + (q.xz * x.x + q.yz * x.y + q.zz * x.z)};
    const LaneMask<Double4> holds = minimum.is_near & (q.c + x.dot(slope) <= most);
    const Double4 weight = (a.xx + a.yy + a.zz) + (b.xx + b.yy + b.zz);
    const Double4 values = minimum.value * memoryless_factor(weight, costs.first_area_);
    for (std::size_t lane = 0; lane < four.n; ++lane) {
      const double cost = holds[lane] != 0 ? values[lane] : costs.of(pairs[lane], attributes).cost;
      *four.ranks[lane] = CostCounts::in_range(cost);
    }
    four.n = 0;
  }

  WHITTLE_INLINE void rank(std::span<const VertexPair> pairs, const AttributeQuadrics& attributes, float* ranks) const {
    Four four{};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!attributes.is_simple(pairs[i])) {
        ranks[i] = CostCounts::in_range(costs.of(pairs[i], attributes).cost);
        continue;
      }
      four.pairs[four.n] = pairs[i];
      four.ranks[four.n++] = &ranks[i];
      if (four.n == four.pairs.size()) rank(four, attributes);
    }
    if (four.n > 0) rank(four, attributes);
  }
  WHITTLE_AVX2 void rank_in_wide_registers(std::span<const VertexPair> pairs, const AttributeQuadrics& attributes,
                                           float* ranks) const {
    rank(pairs, attributes, ranks);
  }
};

void PairCosts::rank(std::span<const VertexPair> pairs, std::span<float> costs) const {
  if (placement_ != Placement::optimal) {
    std::transform(pairs.begin(), pairs.end(), costs.begin(),
                   [this](const VertexPair& pair) { return CostCounts::in_range(of(pair).cost); });
    return;
  }
  const Kernels kernels{*this};
  has_double4 ? kernels.rank_in_wide_registers(pairs, costs.data()) : kernels.rank(pairs, costs.data());
}

void PairCosts::rank(std::span<const VertexPair> pairs, const AttributeQuadrics& attributes,
                     std::span<float> costs) const {
  if (placement_ != Placement::optimal) {
    std::transform(pairs.begin(), pairs.end(), costs.begin(),
                   [&](const VertexPair& pair) { return CostCounts::in_range(of(pair, attributes).cost); });
    return;
  }
  const Kernels kernels{*this};
  has_double4 ? kernels.rank_in_wide_registers(pairs, attributes, costs.data())
              : kernels.rank(pairs, attributes, costs.data());
}

PairEvaluation PairCosts::of(const VertexPair& pair) const {
  if (placement_ != Placement::optimal) return of(placed(pair.a), placed(pair.b));
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

PairEvaluation PairCosts::of(const VertexPair& pair, const AttributeQuadrics& attributes) const {
  return of(pair, placed(pair.a), placed(pair.b), attributes);
}

PairEvaluation PairCosts::of(const PlacedQuadric& first, const PlacedQuadric& second, PairConstraint constraint) const {
  return in_unit(evaluate_pair(first, second, placement_, constraint), first, second);
}

PairEvaluation PairCosts::of(const VertexPair& pair, const PlacedQuadric& first, const PlacedQuadric& second,
                             const AttributeQuadrics& attributes, PairConstraint constraint) const {
  const PairAttributes of_pair = attributes.of({invalid_index, pair.a, pair.b}, true, second.position - first.position);
  return in_unit(evaluate_with_attributes(first, second, of_pair, placement_, constraint), first, second);
}

PairEvaluation PairCosts::in_unit(PairEvaluation evaluation, const PlacedQuadric& first,
                                  const PlacedQuadric& second) const {
  const double factor = memoryless_factor(first.quadric.a.trace() + second.quadric.a.trace(), first_area_);
  evaluation.bound *= factor;
  evaluation.cost *= factor;
  return evaluation;
}

}  // namespace whittle
