#pragma once

#include <vector>

#include "cost/memoryless/planes_of_seams.hh"
#include "cost/quadric/quadric_cost.hh"
#include "whittle/engine/formula/plane_changes.hh"

namespace whittle {

/// Memoryless quadrics (memoryless_term.hh). A contraction changes those of the merged vertex and of its neighbours.
///
/// At borders and where the surface isn't manifold vertices remember, as with Garland–Heckbert, and so do the
/// neighbours of vertices that are joined. Thin parts are not looked at there. Vertices on seams and rims remember the
/// planes of these, besides those of their faces.
class MemorylessCost final : public PairCost {
 public:
  MemorylessCost(TriangleComplex& complex, const Restraints& restraints, const QuadricOptions& options,
                 bool has_threshold_pairs)
      : complex_(complex),
        options_(options),
        ranks_(complex, restraints, options, has_threshold_pairs),
        changes_(options) {}

  void see_faces(unsigned threads) override { ranks_.see_faces(threads); }
  void see_seams(std::span<const Memory::Remembered> planes) override;
  void see_attributes(SurfaceAttributes&& attributes) override { ranks_.see_attributes(std::move(attributes)); }
  void start(unsigned threads) override;
  void resume(const DecimationState& state) override;
  void recall(const Memory& memory) override;
  bool remembers(Index v) const override { return !has_planes_of_faces_[v]; }
  const Quadric* remembered_seams(Index v) const override { return seams_.find(v); }
  SurfaceAttributes attributes_at(std::span<const Index> vertices) const override {
    return ranks_.attributes_at(vertices);
  }
  MeanFaceArea face_area() const override { return face_area_; }

  using PairCost::rank;
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override { ranks_.rank(pairs, ranks); }
  void rank_up_to(double enough, std::span<const Pair> pairs, std::span<PairEvaluation> ranks) const override {
    ranks_.rank_up_to(enough, pairs, ranks);
  }
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
  void remember_all(Index v);

  TriangleComplex& complex_;
  QuadricOptions options_;
  MeanFaceArea face_area_;
  QuadricCost ranks_;
  /// Per vertex, whether of its live faces and of no others, those of seams aside.
  std::vector<bool> has_planes_of_faces_;
  PlanesOfSeams seams_;   ///< of vertices that have planes of faces, and of seams: the latter
  PlaneChanges changes_;  ///< scratch
};

}  // namespace whittle
