#pragma once

#include <array>
#include <vector>

#include "complex/constraints.hh"
#include "cost/pair_cost.hh"
#include "whittle/core/detail/lanes.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/engine/formula/lindstrom_turk_pair.hh"

namespace whittle {

/// Lindstrom–Turk (lindstrom_turk.hh). The sums over each vertex's faces and over its neighbours are kept. Those of a
/// pair are the sums of its two vertices without the faces that both have: so a pair takes constant time.
///
/// Every sum has one order, by original vertex numbers.
class LindstromTurkCost final : public StatelessCost {
 public:
  LindstromTurkCost(const TriangleComplex& complex, const Constraints& constraints)
      : complex_(complex), constraints_(constraints) {}

  void start(CostState&& before, unsigned threads) override;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const override;
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) override;
  KeptOfVertices kept() const override { return {reinterpret_cast<const std::byte*>(stars_.data()), sizeof(StarSums)}; }
  Reach affects() const override { return Reach::ring; }
  Reach reads() const override { return Reach::ring; }

 private:
  struct Sides;

  void rank_four_at_once(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const;
  template <class Real>
  void rank_in_lanes(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const;
  template <class Real>
  void rank_group(const std::array<Sides, n_lanes<Real>>& group, std::span<const Pair> pairs,
                  std::span<PairEvaluation> ranks) const;
  bool find_sides(const Pair& pair, Sides& sides) const;
  PairEvaluation rank_one(const Pair& pair) const;
  void add_border_at(Index v, Index but, std::vector<BorderEdge>& border) const;
  void sum_around(std::span<const Index> vertices);
  void sum_around_with_double4(std::span<const Index> vertices);
  void sum_around_each(std::span<const Index> vertices);
  void sum_around_ring(Index v);
  void sum_around_irregular(Index v);

  const TriangleComplex& complex_;
  const Constraints& constraints_;
  LargeArray<StarSums> stars_;  ///< per vertex
};

}  // namespace whittle
