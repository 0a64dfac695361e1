#pragma once

#include "complex/constraints.hh"
#include "cost/quadric/quadric_cost.hh"

namespace whittle {

/// Garland–Heckbert, blended with the length of the edge (edge_length_term.hh). Edges only.
class IsotropicCost final : public QuadricCost {
 public:
  IsotropicCost(const TriangleComplex& complex, const Constraints& constraints, const QuadricOptions& options,
                double isotropy, unsigned threads)
      : QuadricCost(complex, constraints, options, false, threads), isotropy_(isotropy) {}

  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const override;
  Reach affects() const override { return Reach::ends; }

 private:
  double isotropy_;
};

}  // namespace whittle
