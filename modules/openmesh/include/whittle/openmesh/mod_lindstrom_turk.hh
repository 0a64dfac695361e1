#pragma once

#include <utility>
#include <vector>

#include "whittle/engine/formula/lindstrom_turk_pair.hh"
#include "whittle/openmesh/placing_module.hh"

// Lindstrom–Turk cost and placement as a module for OpenMesh's decimaters. It computes the engine's term
// (lindstrom_turk.hh), bit for bit.
//
//   v̄ keeps the volume and the outline of the border, then makes f least
//   f = ½ Σ V_t(v̄)² + ½ L² Σ |A_e(v̄)|², over the faces t and border edges e at v0 or v1
//   cost = f(v̄) and a trace of spread, unit: length⁶
//
// Nothing is remembered: costs depend only on the faces as they are. So a contraction changes the costs of all pairs at
// the merged vertex and at its neighbours. `PairDecimaterT` ranks all these pairs again. OpenMesh's `DecimaterT` has a
// heap with one entry per vertex. It ranks only v0's former neighbours again; the other entries keep an old cost.
//
// The module refuses only collapses that cost more than `max_cost`. Add ModFlipGuardT beside it, and let it turn faces
// up to 110°: with this limit Lindstrom–Turk, which keeps volumes, is more accurate.
// \cite lindstrom_1998_fast (sections 4 and 5), \cite lindstrom_1999_evaluation

namespace whittle {

/// `PlacingModuleT` says what the module does in which decimater, and has the options that all our cost modules share.
/// The float priority is the cube root of the cost.
///
/// Sums have the order of the engine. Faces at an inner vertex are taken counter-clockwise, from the neighbour of
/// lowest index on. Faces at a border vertex are taken by the indices of their other corners. Neighbours are taken in
/// the same way, everything else by index.
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

  /// The other corners of a face at a vertex, in the face's order.
  using OtherCorners = std::pair<VertexHandle, VertexHandle>;
  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const override;
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
