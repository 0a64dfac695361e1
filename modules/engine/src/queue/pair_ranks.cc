#include "queue/pair_ranks.hh"

#include "complex/face_walk.hh"
#include "whittle/engine/formula/valence_term.hh"

namespace whittle {
namespace {

/// \pre the lists of both vertices and of the opposite ones are compact
ValenceChange valence_change(const TriangleComplex& complex, const Pair& pair) {
  const auto on_border = [&complex](Index v) { return complex.kind(v) != VertexKind::regular; };
  ValenceChange change;
  int n_opposite = 0;
  Index last = invalid_index;
  for_each_common_face(complex, pair.a, pair.b, [&](Index opposite, int) {
    if (opposite == last) return;  // of two faces on the same corners
    last = opposite;
    ++n_opposite;
    change.add_before(complex.valence(opposite), on_border(opposite));
    change.add_after(complex.valence(opposite) - 1, on_border(opposite));
  });
  const int valence_a = complex.valence(pair.a);
  const int valence_b = complex.valence(pair.b);
  change.add_before(valence_a, on_border(pair.a));
  change.add_before(valence_b, on_border(pair.b));
  change.add_after(valence_a + valence_b - 2 - n_opposite, on_border(pair.a) || on_border(pair.b));
  return change;
}

}  // namespace

/// A penalty may make a rank less, so a rank that is only known to be at least `enough` doesn't do.
void PairRanks::rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const {
  if (!has_penalty()) return ranker_.rank(pairs, ranks, enough);
  ranker_.rank(pairs, ranks, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ranks[i].cost = valence_change(complex_, pairs[i]).penalize(ranks[i].cost, valence_weight_);
  }
}

}  // namespace whittle
