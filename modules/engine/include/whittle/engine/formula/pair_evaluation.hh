#pragma once

#include "whittle/engine/formula/pair_minimum.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {

/// Where constraints let the merged vertex of a pair go.
enum class PairConstraint {
  none,    ///< anywhere
  first,   ///< where the first vertex is
  second,  ///< where the second vertex is
  either   ///< where the one is or the other
};

/// What contracting two vertices with quadrics E₀, E₁ would cost.
struct PairEvaluation {
  double bound;  ///< min over all x of E₀ + E₁. Never falls when either end merges with others, so an old bound is a
                 ///< lower bound of every later cost. At least 0.
  double cost;              ///< E₀ + E₁ at `position`; at least `bound`.
  Vec3 position;            ///< v̄
  bool is_minimum = false;  ///< whether that is where E₀ + E₁ is least
};

/// The evaluation if there is no minimum, or it may not be used: the best of the positions allowed.
PairEvaluation evaluate_at_candidates(const PlacedQuadric& v0, const PlacedQuadric& v1, double bound,
                                      Placement placement, PairConstraint constraint);

/// The evaluation with its minimum found.
inline PairEvaluation evaluate_with_minimum(const PlacedQuadric& v0, const PlacedQuadric& v1, double bound,
                                            const Vec3& minimum, bool is_near, Placement placement,
                                            PairConstraint constraint) {
  if (is_near && placement == Placement::optimal && constraint == PairConstraint::none)
    return {bound, bound, minimum, true};
  return evaluate_at_candidates(v0, v1, bound, placement, constraint);
}

/// Cost and placement of contracting two vertices. Swapping them changes the rounding, and which end is taken where
/// both cost the same: callers pass the vertex of the lower original number first.
inline PairEvaluation evaluate_pair(const PlacedQuadric& v0, const PlacedQuadric& v1, Placement placement,
                                    PairConstraint constraint = PairConstraint::none) {
  const PairMinimum<double> m = pair_minimum(quadric_lanes(v0), quadric_lanes(v1));
  return evaluate_with_minimum(v0, v1, m.value, {m.x, m.y, m.z}, m.is_near != 0, placement, constraint);
}

/// The merged vertex. At a minimum its quadric has no slope: b = 0 but for rounding, which is dropped.
inline PlacedQuadric merged(const PlacedQuadric& v0, const PlacedQuadric& v1, const Vec3& position, bool is_minimum) {
  Quadric q = v0.quadric.about(position - v0.position);
  q += v1.quadric.about(position - v1.position);
  if (is_minimum) q.b.setZero();
  q.c = std::max(0.0, q.c);
  return {position, q};
}

}  // namespace whittle
