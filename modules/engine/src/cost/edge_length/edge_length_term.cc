#include "whittle/engine/formula/edge_length_term.hh"

#include <algorithm>

#include "whittle/core/detail/portable_math.hh"

namespace whittle {

PairEvaluation evaluate_midpoint(const Vec3& first, const Vec3& second, PairConstraint constraint) {
  const double length = (second - first).norm();
  if (constraint == PairConstraint::first || constraint == PairConstraint::either)
    return {length, length, first, false};
  if (constraint == PairConstraint::second) return {length, length, second, false};
  return {length, length, 0.5 * (first + second), false};
}

PairEvaluation evaluate_isotropic(const PlacedQuadric& v0, const PlacedQuadric& v1, double isotropy,
                                  Placement placement, PairConstraint constraint) {
  const double length_sq = (v1.position - v0.position).squaredNorm();
  Quadric sum = v1.quadric.about(v0.position - v1.position);
  sum += v0.quadric;
  PairEvaluation evaluation = evaluate_midpoint(v0.position, v1.position, constraint);
  if (isotropy < 1 || placement == Placement::endpoint) {
    const double mu = isotropy < 1 ? 1e-3 * isotropy / (1 - isotropy) * sum.a.trace()
                                   : 0;  // |x − v0|² + |x − v1|² is the same at both ends
    PlacedQuadric held0 = v0;
    PlacedQuadric held1 = v1;
    held0.quadric.a += SymmetricMatrix::identity(mu);
    held1.quadric.a += SymmetricMatrix::identity(mu);
    evaluation = evaluate_pair(held0, held1, placement, constraint);
  }
  const double error = std::max(0.0, sum(evaluation.position - v0.position));
  evaluation.cost = detail::power(error, 1 - isotropy) * detail::power(length_sq, isotropy);
  evaluation.bound = evaluation.cost;
  evaluation.is_minimum = false;
  return evaluation;
}

}  // namespace whittle
