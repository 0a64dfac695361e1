#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle {
PairEvaluation evaluate_at_candidates(const PlacedQuadric& v0, const PlacedQuadric& v1, double bound,
                                      Placement placement, PairConstraint constraint) {
  const Vec3 d = v1.position - v0.position;
  Quadric sum = v1.quadric.about(-d);
  sum += v0.quadric;
  const auto at = [&](const Vec3& offset, const Vec3& position) {
    return PairEvaluation{bound, std::max(bound, sum(offset)), position, false};
  };
  PairEvaluation first = at(Vec3::Zero(), v0.position);
  PairEvaluation second = at(d, v1.position);
  if (constraint == PairConstraint::first) return first;
  if (constraint == PairConstraint::second) return second;
  const PairEvaluation& better_end = first.cost <= second.cost ? first : second;
  if (placement == Placement::endpoint || constraint == PairConstraint::either) return better_end;
  PairEvaluation middle = at(0.5 * d, 0.5 * (v0.position + v1.position));
  if (placement == Placement::midpoint) return middle;
  return middle.cost <= better_end.cost ? middle : better_end;
}

}  // namespace whittle
