#pragma once

#include "complex/restraints.hh"
#include "cost/pair_cost.hh"
#include "cost/quadric/vertex_quadrics.hh"

namespace whittle {

/// Garland–Heckbert, blended with the length of the edge (edge_length_term.hh). Edges only.
class IsotropicCost final : public PairCost {
 public:
  IsotropicCost(const TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options,
                double isotropy)
      : restraints_(restraints), options_(options), isotropy_(isotropy), quadrics_(complex, options, false) {}

  void see_faces(unsigned threads) override { quadrics_.sum_faces(threads); }
  void start(unsigned /*threads*/) override { quadrics_.add_borders(); }
  void resume(const DecimationState& state) override { quadrics_.resume(state); }

  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override;
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) override;
  PlacedQuadric quadric(Index v) const override { return quadrics_.placed(v); }
  VertexState vertex_state() const override { return quadrics_.state(); }
  Reach reach() const override { return Reach::ends; }

 private:
  const Restraints& restraints_;
  QuadricOptions options_;
  double isotropy_;
  VertexQuadrics quadrics_;
};

}  // namespace whittle
