#pragma once

#include "cost/pair_cost.hh"
#include "cost/quadric/vertex_quadrics.hh"

namespace whittle {

/// A cost of quadrics: those of the faces, seams, rims and borders at first, and a merged vertex has the sum of its
/// two.
class SummedQuadricsCost : public PairCost {
 public:
  SummedQuadricsCost(const TriangleComplex& complex, const QuadricOptions& options, bool has_threshold_pairs)
      : complex_(complex), options_(options), quadrics_(complex, options, has_threshold_pairs) {}

  void see_faces(unsigned threads) final { quadrics_.sum_faces(threads); }
  void see_seams(std::span<const Memory::Remembered> planes) final {
    for_each_remembered(planes, complex_, [this](Index v, const Quadric& sum) { quadrics_.add_planes(v, sum.a); });
  }
  void start(unsigned /*threads*/) final { quadrics_.add_borders(); }
  void resume(const DecimationState& state) final { quadrics_.resume(state); }
  void recall(const Memory& memory) final { quadrics_.recall(memory); }
  bool remembers(Index /*v*/) const final { return true; }
  const Quadric* remembered_seams(Index /*v*/) const final { return nullptr; }  // they are among all that v remembers
  MeanFaceArea face_area() const final { return {}; }
  PlacedQuadric quadric(Index v) const final { return quadrics_.placed(v); }
  VertexState vertex_state() const final { return quadrics_.state(); }
  bool changes_neighbours() const final { return false; }

 protected:
  const TriangleComplex& complex_;
  QuadricOptions options_;
  VertexQuadrics quadrics_;
};

}  // namespace whittle
