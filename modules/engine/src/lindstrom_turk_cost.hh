#pragma once

#include <vector>

#include "pair_cost.hh"
#include "restraints.hh"
#include "whittle/engine/large_array.hh"
#include "whittle/engine/lindstrom_turk.hh"

namespace whittle {

/// Lindstrom–Turk (lindstrom_turk.hh). The sums over each vertex's faces are kept, those of a pair are the sums of its
/// two vertices without the faces that both have: so a pair takes a constant time.
///
/// Every sum has one order, by original vertex numbers.
class LindstromTurkCost final : public PairCost {
 public:
  LindstromTurkCost(const TriangleComplex& complex, const Restraints& restraints, unsigned threads);

  using PairCost::evaluate;
  void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const override;
  PlacedQuadric merged(const Pair& pair, const PairEvaluation& evaluation) const override;
  double dimension() const override { return 6; }
  Reach reach() const override { return Reach::ring; }
  void note_contraction(std::span<const Index> changed) override;

 private:
  /// Over the faces at a vertex, about it. There their planes have no offset.
  struct StarSums {
    SymmetricMatrix squares;
    Vec3 normal;
  };

  PairEvaluation evaluate_one(const Pair& pair) const;
  VolumeSums volume_of(const Pair& pair) const;
  BorderSums border_of(const Pair& pair) const;
  NeighbourSums neighbours_of(const Pair& pair) const;
  StarSums sum_star(Index v) const;

  const TriangleComplex& complex_;
  const Restraints& restraints_;
  LargeArray<StarSums> stars_;  ///< per vertex
};

}  // namespace whittle
