#pragma once

#include <vector>

#include "cost/quadric/quadric_cost.hh"
#include "whittle/engine/formula/plane_changes.hh"

namespace whittle {

/// Memoryless quadrics (memoryless_term.hh). A contraction changes those of the merged vertex and of its neighbours.
///
/// At borders, on seams and where the surface isn't manifold vertices remember, as with Garland–Heckbert, and so do the
/// neighbours of vertices that are joined. Thin parts are not looked at there.
class MemorylessCost final : public PairCost {
 public:
  MemorylessCost(TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options,
                 bool has_threshold_pairs)
      : complex_(complex),
        restraints_(restraints),
        options_(options),
        ranks_(complex, restraints, options, has_threshold_pairs),
        changes_(options) {}

  void see_faces(unsigned threads) override { ranks_.see_faces(threads); }
  void see_seams(std::span<const VertexPair> seams, double weight) override { ranks_.see_seams(seams, weight); }
  void see_attributes(const AttributeSums& sums) override { ranks_.see_attributes(sums); }
  void start(unsigned threads) override;
  void resume(const DecimationState& state) override;
  void recall(const Memory& memory) override;
  bool remembers(Index v) const override { return !has_planes_of_faces_[v]; }
  MeanFaceArea face_area() const override { return face_area_; }

  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override { ranks_.rank(pairs, ranks); }
  Settlement settle(ContractionProfile& profile, const PairEvaluation& ranked) const override;
  double final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                    const Vec3& position) const override;
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) override;
  PlacedQuadric quadric(Index v) const override { return ranks_.quadric(v); }
  VertexState vertex_state() const override { return ranks_.vertex_state(); }
  Reach reach() const override { return Reach::ring; }
  bool changes_neighbours() const override { return true; }

 private:
  bool forgets(const ContractionProfile& profile) const;
  /// Of a neighbour of the merged vertex.
  void change_planes(Index v, const SymmetricMatrix& change) {
    ranks_.quadrics().change_planes(v, change);
    complex_.note_change(v);
  }
  void change_ring(const MergedRing& ring);
  void change_neighbours(const ContractionProfile& profile, const Change& change);
  void remember_around(const ContractionProfile& profile);

  TriangleComplex& complex_;
  const Restraints& restraints_;
  QuadricOptions options_;
  MeanFaceArea face_area_;
  QuadricCost ranks_;
  std::vector<bool> has_planes_of_faces_;  ///< per vertex, whether of its live faces and of no others
  PlaneChanges changes_;                   ///< scratch
};

}  // namespace whittle
