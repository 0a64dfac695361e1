#pragma once

#include <span>
#include <vector>

#include "whittle/engine/pair_evaluation.hh"
#include "whittle/engine/reach.hh"
#include "whittle/engine/triangle_complex.hh"

namespace whittle {

/// What ranks and places contractions, as the order of contractions sees it.
class PairCost {
 public:
  virtual ~PairCost() = default;

  /// Of pairs whose lower original vertex comes first, edges before threshold pairs. Several threads may ask at once.
  virtual void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const = 0;
  PairEvaluation evaluate(const Pair& pair) const {
    PairEvaluation evaluation;
    evaluate({&pair, 1}, {&evaluation, 1});
    return evaluation;
  }

  /// What the vertex that a pair becomes is to keep.
  virtual PlacedQuadric merged(const Pair& pair, const PairEvaluation& evaluation) const = 0;

  /// The power of a length that is the cost's unit.
  virtual double dimension() const = 0;

  virtual Reach reach() const = 0;

  /// Told after each contraction. \param changed vertices whose pairs are within reach, the merged one first, all with
  /// tidy lists
  virtual void note_contraction(std::span<const Index> changed) = 0;
};

}  // namespace whittle
