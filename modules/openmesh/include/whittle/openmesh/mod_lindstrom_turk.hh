#pragma once

#include <utility>
#include <vector>

#include "whittle/engine/formula/lindstrom_turk_pair.hh"
#include "whittle/openmesh/placing_module.hh"

// Lindstrom–Turk cost and placement as a module for OpenMesh's decimaters: the engine's term (lindstrom_turk.hh), with
// the same numbers in every bit.
//
//   v̄ keeps the volume and the outline of the border, then makes f least;  cost = f(v̄) and a trace of spread, unit:
//   length⁶
//   f = ½ Σ V_t(v̄)² + ½ L² Σ |A_e(v̄)|², over the faces t and border edges e at v0 or v1
//
// Nothing is remembered: a cost is that of the faces as they are, so that a contraction changes those of all pairs at
// the merged vertex and at its neighbours. `PairDecimaterT` ranks all these anew. OpenMesh's own decimaters rank anew
// the pairs at v0's former neighbours, in a heap with one entry a vertex; others keep the place of an old cost.
//
// Rejects what costs more than `max_cost`, nothing else: add ModFlipGuardT beside it, and let
// it turn faces up to 110°: Lindstrom–Turk keeps volumes, and is more accurate where it may do so.
// \cite lindstrom_1998_fast (sections 4 and 5), \cite lindstrom_1999_evaluation

namespace whittle {

/// What it does in which decimater, and the options it shares with our other cost modules: `PlacingModuleT`. Its float
/// priority is the cube root of the cost.
///
/// Sums have the order of the engine: faces at a vertex counter-clockwise from the neighbour of lowest index on, at a
/// border vertex by the indices of their other corners; its neighbours likewise; everything else by index.
template <class MeshT>
class ModLindstromTurkT : public PlacingModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModLindstromTurkT, MeshT, LindstromTurk);

  explicit ModLindstromTurkT(MeshT& mesh) : PlacingModuleT<MeshT>(mesh) {}

  double cost_dimension() const override { return 6; }

 private:
  using typename PlacingModuleT<MeshT>::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using PlacingModuleT<MeshT>::surface;

  /// The other corners of a face at a vertex, in its order.
  using OtherCorners = std::pair<VertexHandle, VertexHandle>;
  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, Pinned pinned) const override;
  Reach plain_reach() const override { return Reach::ring; }
  CostOptions plain_options() const override { return {Cost::lindstrom_turk, {}, 0, 0}; }

  std::vector<CommonFace> common_faces(VertexHandle first, VertexHandle second) const;
  std::vector<OtherCorners> faces_at(VertexHandle v) const;
  StarSums star_of(VertexHandle v) const;
  void add_border_at(VertexHandle v, VertexHandle but, std::vector<BorderEdge>& border) const;
};

template <class MeshT>
inline constexpr bool is_engine_cost<ModLindstromTurkT<MeshT>> = true;

}  // namespace whittle

#include "whittle/openmesh/mod_lindstrom_turk_impl.hh"
