#pragma once

#include "complex/constraints.hh"
#include "cost/pair_cost.hh"

namespace whittle {

/// The length of the edge; the merged vertex goes to its middle.
class MidpointCost final : public StatelessCost {
 public:
  MidpointCost(const TriangleComplex& complex, const Constraints& constraints)
      : complex_(complex), constraints_(constraints) {}

  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const override;
  Reach affects() const override { return Reach::ends; }

 private:
  const TriangleComplex& complex_;
  const Constraints& constraints_;
};

}  // namespace whittle
