#pragma once

#include "complex/restraints.hh"
#include "cost/stateless_cost.hh"

namespace whittle {

/// The length of the edge; the merged vertex goes to its middle.
class MidpointCost final : public StatelessCost {
 public:
  MidpointCost(const TriangleComplex& complex, const Restraints& restraints)
      : StatelessCost(complex), restraints_(restraints) {}

  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override;
  Reach reach() const override { return Reach::ends; }

 private:
  const Restraints& restraints_;
};

}  // namespace whittle
