#pragma once

#include "complex/restraints.hh"
#include "cost/pair_cost.hh"

namespace whittle {

/// The length of the edge; the merged vertex goes to its middle.
class MidpointCost final : public PairCost {
 public:
  MidpointCost(const TriangleComplex& complex, const Restraints& restraints)
      : complex_(complex), restraints_(restraints) {}

  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override;
  PlacedQuadric quadric(Index v) const override { return {complex_.position(v), {}}; }
  Reach reach() const override { return Reach::ends; }

 private:
  const TriangleComplex& complex_;
  const Restraints& restraints_;
};

}  // namespace whittle
