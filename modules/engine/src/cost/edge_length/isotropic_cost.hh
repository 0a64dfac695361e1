#pragma once

#include "cost/pair_cost.hh"
#include "guard/restraints.hh"

namespace whittle {

/// Garland–Heckbert, blended with the length of the edge (edge_length_term.hh).
class IsotropicCost final : public PairCost {
 public:
  IsotropicCost(const TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options,
                double isotropy)
      : complex_(complex), restraints_(restraints), options_(options), isotropy_(isotropy) {}

  using PairCost::evaluate;
  void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const override;
  PlacedQuadric merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) override;
  double dimension() const override;
  Reach reach() const override { return Reach::ends; }

 private:
  const TriangleComplex& complex_;
  const Restraints& restraints_;
  QuadricOptions options_;
  double isotropy_;
};

}  // namespace whittle
