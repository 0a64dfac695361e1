#pragma once

#include <limits>
#include <span>

#include "complex/triangle_complex.hh"
#include "cost/ranker.hh"

namespace whittle {

/// The ranks of pairs by which queues order them: those of the cost, times a penalty for the valences that a
/// contraction leaves (valence_term.hh), if there is one.
class PairRanks {
 public:
  /// All must outlive it. \param valence_weight of the penalty, [0, inf); 0 = none
  PairRanks(const TriangleComplex& complex, const Ranker& ranker, double valence_weight)
      : complex_(complex), ranker_(ranker), valence_weight_(valence_weight) {}

  /// As that of `Ranker`.
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks,
            double enough = std::numeric_limits<double>::infinity()) const;
  PairEvaluation rank(const Pair& pair) const {
    PairEvaluation ranked;
    rank({&pair, 1}, {&ranked, 1});
    return ranked;
  }
  Reach affects() const { return has_penalty() ? Reach::opposite_rings : ranker_.affects(); }
  Reach reads() const { return has_penalty() ? Reach::opposite_rings : ranker_.reads(); }
  KeptOfVertices kept() const { return ranker_.kept(); }

 private:
  bool has_penalty() const { return valence_weight_ != 0; }

  const TriangleComplex& complex_;
  const Ranker& ranker_;
  double valence_weight_;
};

}  // namespace whittle
