#pragma once

#include "cost/pair_cost.hh"

namespace whittle {

/// A cost that knows nothing of a surface but what can be told from it at any time. It may keep sums of what it sees.
class StatelessCost : public PairCost {
 public:
  explicit StatelessCost(const TriangleComplex& complex) : complex_(complex) {}

  void see_faces(unsigned /*threads*/) override {}
  void see_seams(std::span<const Memory::Remembered> /*planes*/) final {}
  void see_attributes(SurfaceAttributes&& /*attributes*/) final {}
  void start(unsigned /*threads*/) override {}
  void resume(const DecimationState& /*state*/) final {}
  void recall(const Memory& /*memory*/) final {}
  void merge(ContractionProfile& /*profile*/, const PairEvaluation& /*ranked*/, const Change& /*change*/) override {}

  PlacedQuadric quadric(Index v) const final { return {complex_.position(v), {}}; }
  bool remembers(Index /*v*/) const final { return false; }
  const Quadric* remembered_seams(Index /*v*/) const final { return nullptr; }
  SurfaceAttributes attributes_at(std::span<const Index> /*vertices*/) const final { return {}; }
  MeanFaceArea face_area() const final { return {}; }
  VertexState vertex_state() const override { return {}; }
  bool changes_neighbours() const final { return false; }

 protected:
  const TriangleComplex& complex_;
};

}  // namespace whittle
