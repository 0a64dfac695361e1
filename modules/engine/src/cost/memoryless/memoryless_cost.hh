#pragma once

#include <vector>

#include "cost/quadric/quadric_cost.hh"
#include "whittle/engine/formula/merged_ring.hh"

namespace whittle {

/// Memoryless quadrics (memoryless_term.hh). A contraction changes those of the merged vertex and of its neighbours; at
/// borders and where the surface isn't manifold they remember, as they would with Garland–Heckbert, and so do
/// neighbours of vertices that are joined. There thin parts aren't looked at, either.
class MemorylessCost final : public PairCost {
 public:
  MemorylessCost(TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options);

  using PairCost::evaluate;
  void evaluate(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations) const override {
    quadric_cost_.evaluate(pairs, evaluations);
  }
  Vec3 place(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) override;
  std::optional<bool> turns_a_face(const Vec3& position, const FlipLimit& limit) override;
  double final_cost(const PairEvaluation& evaluation) const override;
  PlacedQuadric merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) override;
  double dimension() const override { return quadric_cost_.dimension(); }
  Reach reach() const override { return Reach::ring; }
  bool changes_neighbours() const override { return true; }

 private:
  /// What the planes at a vertex change by, because of one face.
  struct Change {
    Index vertex;
    SymmetricMatrix planes;
  };
  bool forgets(const Pair& pair, const PairStar& star) const;
  void change_neighbours_on_ring();
  void change_neighbours(const Pair& pair, const Vec3& position, const PairStar& star);
  void remember_around(const PairStar& star);

  TriangleComplex& complex_;
  QuadricOptions options_;
  MeanFaceArea face_area_;
  QuadricCost quadric_cost_;
  bool has_ring_ = false;                  ///< whether the pair placed last forgets
  MergedRing ring_;                        ///< of that pair, then
  Vec3 ring_origin_;                       ///< what it is seen from
  std::vector<bool> has_planes_of_faces_;  ///< per vertex, whether of those there are, and no others
  std::vector<Change> changes_;            ///< scratch
};

}  // namespace whittle
