#pragma once

#include "whittle/engine/formula/edge_length_term.hh"
#include "whittle/openmesh/placing_module.hh"

// The length of an edge, and its middle, as a cost module for OpenMesh's decimaters.
//
//   cost = |v1 − v0|,  v̄ = (v0 + v1) / 2;  unit: length.
//
// The module refuses only edges longer than `max_cost`. Add ModFlipGuardT beside it. It is fast and gives even
// triangles, but doesn't look at the shape. Other modules must limit the error.

namespace whittle {

/// `PlacingModuleT` says what the module does in which decimater, and has the options that all our cost modules share.
/// If a vertex of the pair must stay, v̄ is its position.
template <class MeshT>
class ModMidpointT : public PlacingModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModMidpointT, MeshT, Midpoint);

  explicit ModMidpointT(MeshT& mesh) : PlacingModuleT<MeshT>(mesh) {}

  double cost_dimension() const override { return 1; }

 private:
  using typename PlacingModuleT<MeshT>::VertexHandle;

  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const override {
    return evaluate_midpoint(this->position(first), this->position(second), constraint);
  }
  Reach plain_reach() const override { return Reach::ends; }
  CostOptions plain_options() const override { return {Cost::midpoint, {}, 0, 0}; }
};

template <class MeshT>
inline constexpr bool is_engine_cost<ModMidpointT<MeshT>> = true;

}  // namespace whittle
