#pragma once

#include "complex/restraints.hh"
#include "cost/quadric/summed_quadrics_cost.hh"

namespace whittle {

/// Garland–Heckbert, blended with the length of the edge (edge_length_term.hh). Edges only.
class IsotropicCost final : public SummedQuadricsCost {
 public:
  IsotropicCost(const TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options,
                double isotropy)
      : SummedQuadricsCost(complex, options, false), restraints_(restraints), isotropy_(isotropy) {}

  void see_attributes(SurfaceAttributes&& /*attributes*/) override {}  // it looks at positions alone
  SurfaceAttributes attributes_at(std::span<const Index> /*vertices*/) const override { return {}; }
  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override;
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) override;
  Reach reach() const override { return Reach::ends; }

 private:
  const Restraints& restraints_;
  double isotropy_;
};

}  // namespace whittle
