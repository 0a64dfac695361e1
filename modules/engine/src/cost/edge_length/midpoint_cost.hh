#pragma once

#include "cost/pair_cost.hh"
#include "guard/restraints.hh"

namespace whittle {

/// The length of the edge, to its middle.
class MidpointCost final : public PairCost {
 public:
  MidpointCost(const TriangleComplex& complex, const Restraints& restraints)
      : complex_(complex), restraints_(restraints) {}

  using PairCost::evaluate;
  void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const override;
  PlacedQuadric merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) override;
  double dimension() const override { return 1; }
  Reach reach() const override { return Reach::ends; }

 private:
  const TriangleComplex& complex_;
  const Restraints& restraints_;
};

}  // namespace whittle
