#pragma once

#include <optional>
#include <span>

#include "complex/triangle_complex.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle {

/// Evaluates pairs by their minimum, several at once. Where a pair's vertices are level and its minimum is near, as
/// they mostly are, `evaluations` gets what `evaluate_pair` would give; else one with `is_minimum` false, and the pair
/// is to be evaluated by itself.
///
/// \param pairs all edges, or all threshold pairs
/// \param first_area if given, costs are multiplied by `memoryless_factor`
void find_minima(const TriangleComplex& complex, std::span<const Pair> pairs, std::span<PairEvaluation> evaluations,
                 std::optional<double> first_area);

}  // namespace whittle
