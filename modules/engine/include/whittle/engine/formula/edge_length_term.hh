#pragma once

#include <cmath>

#include "whittle/engine/formula/pair_evaluation.hh"

// Costs that make edges evenly long, L = |v1 − v0|:
//
//   midpoint         cost = L,  v̄ the middle
//   isotropic, W     cost = E(v̄)^(1−W) (L²)^W,  v̄ where E(x) + μ tr(A) (|x − v0|² + |x − v1|²) is least,
//                    μ = W / (1 − W) / 1000
//
// E is the sum of both quadrics (quadric_term.hh), A its matrix. At W = 0 that is the quadric's cost and placement, at
// W = 1 the order is by length and v̄ the middle. Any unit of E or L gives the same order; tr(A), in the unit of E over
// that of L², keeps μ without one.

namespace whittle {

/// Contracting an edge to its middle, or where it may go, for its length; where it may go to either end, to the first.
inline PairEvaluation evaluate_midpoint(const Vec3& first, const Vec3& second, Pinned pinned) {
  const double length = (second - first).norm();
  if (pinned == Pinned::first || pinned == Pinned::either) return {length, length, first, false};
  if (pinned == Pinned::second) return {length, length, second, false};
  return {length, length, 0.5 * (first + second), false};
}

/// \param isotropy W, [0, 1]
/// \return `bound` is the cost, for there is none: an edge may get shorter.
inline PairEvaluation evaluate_isotropic(const PlacedQuadric& v0, const PlacedQuadric& v1, double isotropy,
                                         Placement placement, Pinned pinned) {
  const double length_sq = (v1.position - v0.position).squaredNorm();
  Quadric sum = v1.quadric.about(v0.position - v1.position);
  sum += v0.quadric;
  PairEvaluation evaluation = evaluate_midpoint(v0.position, v1.position, pinned);
  if (isotropy < 1) {
    const double mu = 1e-3 * isotropy / (1 - isotropy) * sum.a.trace();
    PlacedQuadric held0 = v0;
    PlacedQuadric held1 = v1;
    held0.quadric.a += SymmetricMatrix::identity(mu);
    held1.quadric.a += SymmetricMatrix::identity(mu);
    evaluation = evaluate_pair(held0, held1, placement, pinned);
  }
  const double error = std::max(0.0, sum(evaluation.position - v0.position));
  evaluation.cost = std::pow(error, 1 - isotropy) * std::pow(length_sq, isotropy);
  evaluation.bound = evaluation.cost;
  evaluation.is_minimum = false;
  return evaluation;
}

/// The power of a length that is the unit of its cost. \param of_quadric that of E
inline double isotropic_dimension(double of_quadric, double isotropy) {
  return (1 - isotropy) * of_quadric + isotropy * 2;
}

}  // namespace whittle
