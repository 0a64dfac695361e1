#pragma once

namespace whittle {

/// Least cosine between a face's normals before and after its corners were moved.
constexpr double least_turn_cosine = 0.2;

/// Cosine between neighbouring faces' normals below which no move may take it.
constexpr double least_fold_cosine = -0.5;

}  // namespace whittle
