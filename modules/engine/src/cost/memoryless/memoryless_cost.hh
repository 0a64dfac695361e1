#pragma once

#include <vector>

#include "cost/quadric/quadric_cost.hh"
#include "cost/sparse_quadrics.hh"
#include "whittle/engine/formula/plane_changes.hh"

namespace whittle {

/// Memoryless quadrics (memoryless_term.hh). A contraction changes those of the merged vertex and of its neighbours.
///
/// At borders and where the surface isn't manifold vertices remember, as with Garland–Heckbert, and so do the
/// neighbours of vertices that are joined. Thin parts are not looked at there. Vertices on seams and folds remember the
/// planes of these, besides those of their faces.
class MemorylessCost final : public PairCost {
 public:
  MemorylessCost(TriangleComplex& complex, const Constraints& constraints, const QuadricOptions& options,
                 bool has_threshold_pairs, unsigned threads)
      : complex_(complex),
        options_(options),
        ranks_(complex, constraints, options, has_threshold_pairs, threads),
        changes_(options) {}

  void start(CostState&& before, unsigned threads) override;
  CostState state(std::span<const Index> vertices) const override;
  Quadric quadric(Index v) const override { return ranks_.quadric(v); }

  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks, double enough) const override {
    ranks_.rank(pairs, ranks, enough);
  }
  Reach affects() const override { return Reach::ring; }
  KeptOfVertices kept() const override;
  CandidatePositions place(ContractionProfile& profile, const PairEvaluation& ranked) const override;
  double final_cost(const ContractionProfile& profile, const PairEvaluation& ranked,
                    const Vec3& position) const override;
  void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) override;

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
  void remember_all(Index v);

  TriangleComplex& complex_;
  QuadricOptions options_;
  MeanFaceArea face_area_;
  QuadricCost ranks_;
  /// Per vertex, whether of its live faces and of no others, those of seams aside.
  std::vector<bool> has_planes_of_faces_;
  SparseQuadrics seams_;  ///< of vertices that have planes of faces, and of seams: the latter
  PlaneChanges changes_;  ///< scratch
};

}  // namespace whittle
