#pragma once

#include <span>

#include "cost/cost_state.hh"
#include "cost/placer.hh"
#include "cost/ranker.hh"

namespace whittle {

/// A cost: it ranks pairs for the queue, and places merged vertices for the loop. It is made when the faces of each
/// vertex are listed, and started when neighbours and edges are known.
class PairCost : public Ranker, public Placer {
 public:
  /// \param before what the stage before left, by number in the input
  virtual void start(CostState&& before, unsigned threads) = 0;

  /// What the next stage starts from, of some vertices, which get their places as numbers.
  virtual CostState state(std::span<const Index> vertices) const = 0;

  /// What is kept of v as a quadric about it: zero, unless the cost has quadrics.
  virtual Quadric quadric(Index v) const = 0;
};

/// A cost that knows nothing of a surface but what can be told from it at any time. It may keep sums of what it sees.
class StatelessCost : public PairCost {
 public:
  void start(CostState&& /*before*/, unsigned /*threads*/) override {}
  CostState state(std::span<const Index> /*vertices*/) const final { return {}; }
  Quadric quadric(Index /*v*/) const final { return {}; }
  void merge(ContractionProfile& /*profile*/, const PairEvaluation& /*ranked*/, const Change& /*change*/) override {}
};

}  // namespace whittle
