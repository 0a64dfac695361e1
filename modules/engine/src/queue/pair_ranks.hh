#pragma once

#include <algorithm>
#include <span>

#include "cost/pair_cost.hh"

namespace whittle {

/// The ranks of pairs by which queues order them: those of the cost, times a penalty for the valences that a
/// contraction leaves (valence_term.hh), if there is one.
class PairRanks {
 public:
  /// All must outlive it. \param valence_weight of the penalty, [0, inf); 0 = none
  PairRanks(const TriangleComplex& complex, const PairCost& cost, double valence_weight)
      : complex_(complex), cost_(cost), valence_weight_(valence_weight) {}

  /// As those of `PairCost`.
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const;
  void rank_up_to(double enough, std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const;
  PairEvaluation rank(const Pair& pair) const {
    PairEvaluation ranked;
    rank({&pair, 1}, {&ranked, 1});
    return ranked;
  }
  Reach reach() const { return has_penalty() ? Reach::opposite_rings : cost_.reach(); }
  Reach sight() const { return has_penalty() ? Reach::opposite_rings : cost_.sight(); }
  const CostState& state() const { return cost_; }

 private:
  bool has_penalty() const { return valence_weight_ != 0; }
  void penalize(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const;

  const TriangleComplex& complex_;
  const PairCost& cost_;
  double valence_weight_;
};

}  // namespace whittle
