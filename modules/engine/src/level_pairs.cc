#include "level_pairs.hh"

#include "whittle/engine/lanes.hh"

namespace whittle {
namespace {

template <class Real>
[[gnu::always_inline]] inline void find_minima_in_lanes(const TriangleComplex& complex, std::span<const Pair> pairs,
                                                        std::span<PairEvaluation> evaluations) {
  std::size_t i = 0;
  for (; i + n_lanes<Real> <= pairs.size(); i += n_lanes<Real>) {
    const Pair* const group = &pairs[i];
    const auto minima = pair_minimum(complex.placed_level<Real>([group](std::size_t lane) { return group[lane].a; }),
                                     complex.placed_level<Real>([group](std::size_t lane) { return group[lane].b; }));
    for (std::size_t lane = 0; lane < n_lanes<Real>; ++lane) {
      PairEvaluation& evaluation = evaluations[i + lane];
      evaluation.bound = evaluation.cost = minima.value[lane];
      evaluation.position = Vec3(minima.x[lane], minima.y[lane], minima.z[lane]);
      const bool is_near = minima.is_near[lane] != 0;
      evaluation.is_minimum = is_near && complex.is_level(group[lane].a) && complex.is_level(group[lane].b);
    }
  }
  for (; i < pairs.size(); ++i) evaluations[i].is_minimum = false;
}

WHITTLE_DOUBLE4 void find_minima_of_four(const TriangleComplex& complex, std::span<const Pair> pairs,
                                         std::span<PairEvaluation> evaluations) {
  find_minima_in_lanes<Double4>(complex, pairs, evaluations);
}

}  // namespace

void find_minima(const TriangleComplex& complex, std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) {
  if (has_double4) {
    find_minima_of_four(complex, pairs, evaluations);
  } else {
    find_minima_in_lanes<Double2>(complex, pairs, evaluations);
  }
}

}  // namespace whittle
