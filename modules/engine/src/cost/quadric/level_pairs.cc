#include "cost/quadric/level_pairs.hh"

#include "whittle/core/detail/lanes.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {
namespace {

template <class Real, bool with_points, class VertexAt>
WHITTLE_INLINE QuadricLanes<Real> placed(const VertexQuadrics& quadrics, const VertexAt& vertex) {
  if constexpr (with_points) {
    return quadrics.placed_level_with_points<Real>(vertex);
  } else {
    return quadrics.placed_level<Real>(vertex);
  }
}

template <class Real, bool with_points>
WHITTLE_INLINE void find_minima_in_lanes(const VertexQuadrics& quadrics, std::span<const Pair> pairs,
                                         std::span<PairEvaluation> ranks, const std::optional<double>& first_area) {
  std::size_t i = 0;
  for (; i + n_lanes<Real> <= pairs.size(); i += n_lanes<Real>) {
    const Pair* const group = &pairs[i];
    const auto a = placed<Real, with_points>(quadrics, [group](std::size_t lane) { return group[lane].a; });
    const auto b = placed<Real, with_points>(quadrics, [group](std::size_t lane) { return group[lane].b; });
    auto minima = pair_minimum(a, b);
    if (first_area) {
      const Real weight = (a.xx + a.yy + a.zz) + (b.xx + b.yy + b.zz);
      minima.value *= memoryless_factor(weight, *first_area);
    }
    for (std::size_t lane = 0; lane < n_lanes<Real>; ++lane) {
      PairEvaluation& rank = ranks[i + lane];
      rank.bound = rank.cost = minima.value[lane];
      rank.position = Vec3(minima.x[lane], minima.y[lane], minima.z[lane]);
      const bool is_near = minima.is_near[lane] != 0;
      rank.is_minimum = is_near && quadrics.is_level(group[lane].a) && quadrics.is_level(group[lane].b);
    }
  }
  for (; i < pairs.size(); ++i) ranks[i].is_minimum = false;
}

template <bool with_points>
WHITTLE_AVX2 void find_minima_of_four(const VertexQuadrics& quadrics, std::span<const Pair> pairs,
                                      std::span<PairEvaluation> ranks, const std::optional<double>& first_area) {
  find_minima_in_lanes<Double4, with_points>(quadrics, pairs, ranks, first_area);
}

template <bool with_points>
void find_minima_of(const VertexQuadrics& quadrics, std::span<const Pair> pairs, std::span<PairEvaluation> ranks,
                    const std::optional<double>& first_area) {
  if (has_double4) {
    find_minima_of_four<with_points>(quadrics, pairs, ranks, first_area);
  } else {
    find_minima_in_lanes<Double2, with_points>(quadrics, pairs, ranks, first_area);
  }
}

}  // namespace

void find_minima(const VertexQuadrics& quadrics, Points points, std::span<const Pair> pairs,
                 std::span<PairEvaluation> ranks, std::optional<double> first_area) {
  if (points == Points::with) {
    find_minima_of<true>(quadrics, pairs, ranks, first_area);
  } else {
    find_minima_of<false>(quadrics, pairs, ranks, first_area);
  }
}

}  // namespace whittle
