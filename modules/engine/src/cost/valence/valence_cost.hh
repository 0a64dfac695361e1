#pragma once

#include <memory>
#include <utility>

#include "cost/pair_cost.hh"
#include "whittle/engine/formula/valence_term.hh"

namespace whittle {

/// Another cost, times a penalty for the valences that a contraction leaves (valence_term.hh).
class ValenceCost final : public PairCost {
 public:
  ValenceCost(const TriangleComplex& complex, std::unique_ptr<PairCost> cost, double weight)
      : complex_(complex), cost_(std::move(cost)), weight_(weight) {}

  void see_faces(unsigned threads) override { cost_->see_faces(threads); }
  void see_seams(std::span<const Memory::Remembered> planes) override { cost_->see_seams(planes); }
  SurfaceAttributes attributes_at(std::span<const Index> vertices) const override {
    return cost_->attributes_at(vertices);
  }
  void see_attributes(SurfaceAttributes&& attributes) override { cost_->see_attributes(std::move(attributes)); }
  void start(unsigned threads) override { cost_->start(threads); }
  void resume(const DecimationState& state) override { cost_->resume(state); }
  void recall(const Memory& memory) override { cost_->recall(memory); }
  bool remembers(Index v) const override { return cost_->remembers(v); }
  MeanFaceArea face_area() const override { return cost_->face_area(); }

  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override;
  Settlement settle(ContractionProfile& profile, const PairEvaluation& ranked) const override {
    return cost_->settle(profile, ranked);
  }
  double final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                    const Vec3& position) const override {
    return cost_->final_cost(profile, ranked, position);
  }
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) override {
    cost_->merge(profile, ranked, change);
  }
  PlacedQuadric quadric(Index v) const override { return cost_->quadric(v); }
  VertexState vertex_state() const override { return cost_->vertex_state(); }
  Reach reach() const override { return Reach::opposite_rings; }
  Reach sight() const override { return Reach::opposite_rings; }

 private:
  ValenceChange valence_change(const Pair& pair) const;

  const TriangleComplex& complex_;
  std::unique_ptr<PairCost> cost_;
  double weight_;
};

}  // namespace whittle
