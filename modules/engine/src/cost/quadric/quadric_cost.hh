#pragma once

#include <limits>
#include <optional>

#include "complex/restraints.hh"
#include "cost/attributes/attribute_quadrics.hh"
#include "cost/quadric/summed_quadrics_cost.hh"

namespace whittle {

/// Garland–Heckbert (quadric_term.hh). Where the minimum of a pair is wanted and exists, as is mostly so, several pairs
/// are ranked at once.
class QuadricCost final : public SummedQuadricsCost {
 public:
  QuadricCost(const TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options,
              bool has_threshold_pairs)
      : SummedQuadricsCost(complex, options, has_threshold_pairs), restraints_(restraints) {}

  void see_attributes(SurfaceAttributes&& attributes) override {
    attributes_ = AttributeQuadrics(complex_, std::move(attributes));
  }
  SurfaceAttributes attributes_at(std::span<const Index> vertices) const override { return attributes_.at(vertices); }
  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override {
    rank_up_to(std::numeric_limits<double>::infinity(), pairs, ranks);
  }
  void rank_up_to(double enough, std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override;
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) override;
  Reach reach() const override { return Reach::none; }

  void merge_attributes(const Change& change) {
    if (attributes_.any()) attributes_.merge(change, !complex_.is_threshold_pair(change.pair.id));
  }

  VertexQuadrics& quadrics() { return quadrics_; }
  const VertexQuadrics& quadrics() const { return quadrics_; }
  /// From now on costs are those of memoryless quadrics (memoryless_term.hh). \param first_area a₀
  void multiply_by_memoryless_factor(double first_area) { first_area_ = first_area; }

 private:
  PlacedQuadric placed(const Pair& pair, Index v, const Vec3& position) const;
  void rank_planes(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const;
  PairEvaluation rank_planes_of(const Pair& pair) const;
  PairEvaluation rank_with_attributes(const Pair& pair, double bound_of_planes) const;
  PairEvaluation in_unit(PairEvaluation evaluation, const PlacedQuadric& first, const PlacedQuadric& second) const;

  const Restraints& restraints_;
  std::optional<double> first_area_;
  AttributeQuadrics attributes_;
};

}  // namespace whittle
