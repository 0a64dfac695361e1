#include "cost/valence/valence_cost.hh"

#include "complex/face_walk.hh"

namespace whittle {

void ValenceCost::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const {
  cost_->rank(pairs, ranks);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ranks[i].cost = valence_change(pairs[i]).penalize(ranks[i].cost, weight_);
  }
}

/// \pre the lists of both vertices and of the opposite ones are compact
ValenceChange ValenceCost::valence_change(const Pair& pair) const {
  const auto on_border = [this](Index v) { return complex_.kind(v) != VertexKind::regular; };
  ValenceChange change;
  int n_opposite = 0;
  Index last = invalid_index;
  for_each_common_face(complex_, pair.a, pair.b, [&](Index opposite, int) {
    if (opposite == last) return;  // of two faces on the same corners
    last = opposite;
    ++n_opposite;
    change.add_before(complex_.valence(opposite), on_border(opposite));
    change.add_after(complex_.valence(opposite) - 1, on_border(opposite));
  });
  const int valence_a = complex_.valence(pair.a);
  const int valence_b = complex_.valence(pair.b);
  change.add_before(valence_a, on_border(pair.a));
  change.add_before(valence_b, on_border(pair.b));
  change.add_after(valence_a + valence_b - 2 - n_opposite, on_border(pair.a) || on_border(pair.b));
  return change;
}

}  // namespace whittle
