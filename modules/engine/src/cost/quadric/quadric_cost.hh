#pragma once

#include <optional>

#include "complex/constraints.hh"
#include "cost/attributes/attribute_quadrics.hh"
#include "cost/pair_cost.hh"
#include "cost/quadric/vertex_quadrics.hh"

namespace whittle {

/// Garland–Heckbert (quadric_term.hh): quadrics of the faces, seams, folds and borders at first, and a merged vertex
/// has the sum of its two. Where the minimum of a pair is wanted and exists, as is mostly so, several pairs are ranked
/// at once.
class QuadricCost : public PairCost {
 public:
  QuadricCost(const TriangleComplex& complex, const Constraints& constraints, const QuadricOptions& options,
              bool has_threshold_pairs, unsigned threads)
      : complex_(complex),
        constraints_(constraints),
        options_(options),
        quadrics_(complex, options, has_threshold_pairs, threads) {}

  void start(CostState&& before, unsigned threads) final;
  CostState state(std::span<const Index> vertices) const final;
  Quadric quadric(Index v) const final { return quadrics_.placed(v).quadric; }

  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const override;
  Reach affects() const override { return Reach::none; }
  KeptOfVertices kept() const final { return quadrics_.kept(); }
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) final;

  // For memoryless quadrics, which are ranked likewise.
  void merge_attributes(const Change& change) {
    if (attributes_.any()) attributes_.merge(change, !complex_.is_threshold_pair(change.pair.id));
  }
  SurfaceAttributes attributes_at(std::span<const Index> vertices) const { return attributes_.at(vertices); }
  VertexQuadrics& quadrics() { return quadrics_; }
  const VertexQuadrics& quadrics() const { return quadrics_; }
  /// From now on costs are those of memoryless quadrics (memoryless_term.hh). \param first_area a₀
  void multiply_by_memoryless_factor(double first_area) { first_area_ = first_area; }

 protected:
  const TriangleComplex& complex_;
  const Constraints& constraints_;
  QuadricOptions options_;
  VertexQuadrics quadrics_;

 private:
  PlacedQuadric placed(const Pair& pair, Index v, const Vec3& position) const;
  void rank_planes(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const;
  PairEvaluation rank_planes_of(const Pair& pair) const;
  PairEvaluation rank_with_attributes(const Pair& pair, double bound_of_planes) const;
  PairEvaluation in_unit(PairEvaluation evaluation, const PlacedQuadric& first, const PlacedQuadric& second) const;

  std::optional<double> first_area_;
  AttributeQuadrics attributes_;
};

}  // namespace whittle
