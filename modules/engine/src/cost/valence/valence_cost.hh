#pragma once

#include <memory>
#include <utility>

#include "cost/pair_cost.hh"
#include "whittle/engine/formula/valence_term.hh"

namespace whittle {

/// \pre the lists of both vertices and of those opposite are tidy
ValenceChange valence_change(const TriangleComplex& complex, const Pair& pair);

/// Another cost, times a penalty for the valences that a contraction leaves (valence_term.hh).
class ValenceCost final : public PairCost {
 public:
  ValenceCost(const TriangleComplex& complex, std::unique_ptr<PairCost> cost, double weight)
      : complex_(complex), cost_(std::move(cost)), weight_(weight) {}

  using PairCost::evaluate;
  void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const override;
  Vec3 place(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) override {
    return cost_->place(pair, evaluation, star);
  }
  std::optional<bool> turns_a_face(const Vec3& position, const FlipLimit& limit) override {
    return cost_->turns_a_face(position, limit);
  }
  double final_cost(const PairEvaluation& evaluation) const override { return cost_->final_cost(evaluation); }
  PlacedQuadric merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) override {
    return cost_->merge(pair, evaluation, star);
  }
  double dimension() const override { return cost_->dimension(); }
  Reach reach() const override { return Reach::wings; }
  Reach sight() const override { return Reach::wings; }
  void note_contraction(std::span<const Index> changed) override { cost_->note_contraction(changed); }

 private:
  const TriangleComplex& complex_;
  std::unique_ptr<PairCost> cost_;
  double weight_;
};

}  // namespace whittle
