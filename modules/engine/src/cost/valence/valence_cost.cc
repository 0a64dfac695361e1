#include "cost/valence/valence_cost.hh"

#include <algorithm>

#include "complex/face_walk.hh"

namespace whittle {

void ValenceCost::evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const {
  cost_->evaluate(pairs, evaluations);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    double& cost = evaluations[i].cost;
    cost = valence_change(complex_, pairs[i]).penalize(cost, weight_);
  }
}

ValenceChange valence_change(const TriangleComplex& complex, const Pair& pair) {
  const auto on_border = [&](Index v) { return complex.order(v) != VertexOrder::regular; };
  ValenceChange change;
  int n_wings = 0;
  Index last = invalid_index;
  for_each_common_face(complex, pair.a, pair.b, [&](Index wing, int) {
    if (wing == last) return;  // of two faces on the same corners
    last = wing;
    ++n_wings;
    change.add_before(complex.valence(wing), on_border(wing));
    change.add_after(complex.valence(wing) - 1, on_border(wing));
  });
  const int valence_a = complex.valence(pair.a);
  const int valence_b = complex.valence(pair.b);
  change.add_before(valence_a, on_border(pair.a));
  change.add_before(valence_b, on_border(pair.b));
  change.add_after(valence_a + valence_b - 2 - n_wings, on_border(pair.a) || on_border(pair.b));
  return change;
}

}  // namespace whittle
