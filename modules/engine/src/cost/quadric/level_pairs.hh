#pragma once

#include <optional>
#include <span>

#include "cost/quadric/vertex_quadrics.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle {

/// Whether the point quadrics of threshold pairs count.
enum class Points { without, with };

/// Ranks pairs by their minimum, several at once. Where a pair's vertices are level and its minimum is near, as is
/// mostly so, `ranks` gets what `evaluate_pair` would give. Elsewhere `is_minimum` is false, and the pair is to be
/// ranked by itself. \param first_area if given, costs are multiplied by `memoryless_factor`
void find_minima(const VertexQuadrics& quadrics, Points points, std::span<const Pair> pairs,
                 std::span<PairEvaluation> ranks, std::optional<double> first_area);

}  // namespace whittle
