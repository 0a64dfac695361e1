#pragma once

#include "cost/pair_cost.hh"
#include "guard/restraints.hh"

namespace whittle {

/// Garland–Heckbert (quadric_term.hh). Where the minimum of a pair is wanted and to be had, as it mostly is, several
/// pairs at once.
class QuadricCost final : public PairCost {
 public:
  /// \param first_area if given, costs are those of memoryless quadrics (memoryless_term.hh)
  QuadricCost(const TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options,
              std::optional<double> first_area = std::nullopt)
      : complex_(complex), restraints_(restraints), options_(options), first_area_(first_area) {}

  using PairCost::evaluate;
  void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const override;
  PlacedQuadric merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) override;
  double dimension() const override { return first_area_ ? 5 : options_.weights == Weights::uniform ? 2 : 4; }
  Reach reach() const override { return Reach::none; }

 private:
  PlacedQuadric placed(const Pair& pair, Index v) const;
  PairEvaluation evaluate_one(const Pair& pair) const;

  const TriangleComplex& complex_;
  const Restraints& restraints_;
  QuadricOptions options_;
  std::optional<double> first_area_;
};

}  // namespace whittle
