#pragma once

#include <array>
#include <span>

#include "whittle/engine/formula/pair_evaluation.hh"

// The Lindstrom–Turk cost of a pair from the sums of its two stars (lindstrom_turk.hh). Whoever knows the mesh walks
// over its faces; all that is computed from them is here.

namespace whittle {

/// Sums over the faces at a vertex and over its neighbours, about the vertex, where the faces' planes have no offset;
/// and its position. Two cache lines, in the order in which lanes load them (volume_sums.hh).
struct alignas(64) StarSums {
  /// Σ n nᵀ as xx, xy, xz, yy, yz, zz; Σ n; the position; Σ of the neighbours' positions, and their number.
  std::array<double, 16> values;
};

/// The other two corners of a face at a vertex, in the face's order.
struct LinkEdgePoints {
  Vec3 x, y;
};

/// \param position of the vertex \param faces, neighbours sums have their order
StarSums sum_star(const Vec3& position, std::span<const LinkEdgePoints> faces, std::span<const Vec3> neighbours);

/// A face that both vertices of a pair have, by its third corner.
struct CommonFace {
  Index vertex;
  Vec3 position;
  int turn;  ///< 1 where the face is (first, second, vertex), −1 where it is (second, first, vertex)
};

/// A border edge at a pair, in the order of its face.
struct BorderEdge {
  Vec3 from, to;
};

/// The cost and the placement of a pair.
/// \param common those of the same third corner follow each other \param border the edge of the pair itself once
PairEvaluation evaluate_lindstrom_turk(const StarSums& first, const StarSums& second,
                                       std::span<const CommonFace> common, std::span<const BorderEdge> border,
                                       PairConstraint constraint);

}  // namespace whittle
