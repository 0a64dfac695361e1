#pragma once

#include "whittle/engine/formula/edge_length_term.hh"
#include "whittle/openmesh/placing_module.hh"

// The length of an edge, and its middle, as a cost module for OpenMesh's decimaters.
//
//   cost = |v1 − v0|,  v̄ = (v0 + v1) / 2;  unit: length.
//
// Rejects what is longer than `max_cost`, nothing else: add ModFlipGuardT beside it. Fast and even, but blind to the
// shape: what it costs in error is for other modules to limit.

namespace whittle {

/// What it does in which decimater, and the options it shares with our other cost modules: `PlacingModuleT`. Where v1
/// or another vertex stays, v̄ is there.
template <class MeshT>
class ModMidpointT : public PlacingModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModMidpointT, MeshT, Midpoint);

  explicit ModMidpointT(MeshT& mesh) : PlacingModuleT<MeshT>(mesh) {}

  double cost_dimension() const override { return 1; }

 private:
  using typename PlacingModuleT<MeshT>::VertexHandle;

  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, Pinned pinned) const override {
    return evaluate_midpoint(this->position(first), this->position(second), pinned);
  }
  Reach plain_reach() const override { return Reach::ends; }
  CostOptions plain_options() const override { return {Cost::midpoint, {}, 0, 0}; }
};

template <class MeshT>
inline constexpr bool is_engine_cost<ModMidpointT<MeshT>> = true;

}  // namespace whittle
