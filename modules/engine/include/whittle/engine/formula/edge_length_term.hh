#pragma once

#include "whittle/engine/formula/pair_evaluation.hh"

// Costs that make edges evenly long, L = |v1 − v0|:
//
//   midpoint         cost = L,  v̄ the middle
//   isotropic, W     cost = E(v̄)^(1−W) (L²)^W,  v̄ where E(x) + μ tr(A) (|x − v0|² + |x − v1|²) is least,
//                    μ = W / (1 − W) / 1000
//
// E is the sum of both quadrics (quadric_term.hh), A its matrix. At W = 0 that is the quadric's cost and placement, at
// W = 1 the order is by length and v̄ the middle; with Placement::endpoint it is the end where E is less. Any unit of E
// or L gives the same order; tr(A), in the unit of E over that of L², keeps μ without one.

// Both are defined in the library, so that a user's floating-point flags have no influence.

namespace whittle {

/// Contracting an edge for its length: to its middle, or where it may go; to the first end if it may go to either.
PairEvaluation evaluate_midpoint(const Vec3& first, const Vec3& second, PairConstraint constraint);

/// \param isotropy W, [0, 1]
/// \return `bound` is the cost: there is no lower bound, as an edge may get shorter.
PairEvaluation evaluate_isotropic(const PlacedQuadric& v0, const PlacedQuadric& v1, double isotropy,
                                  Placement placement, PairConstraint constraint);

/// The power of a length that is the unit of its cost. \param of_quadric that of E
inline double isotropic_dimension(double of_quadric, double isotropy) {
  return (1 - isotropy) * of_quadric + isotropy * 2;
}

}  // namespace whittle
