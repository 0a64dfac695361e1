#pragma once

#include <vector>

#include "whittle/engine/formula/merged_ring.hh"
#include "whittle/engine/formula/plane_changes.hh"
#include "whittle/openmesh/detail/quadric_module.hh"

// Memoryless quadrics as a cost module for OpenMesh's decimaters. It computes the engine's term (memoryless_term.hh),
// bit for bit.
//
//   cost = E sqrt(W + 2 a₀), E the minimum of E₀ + E₁, W their weight, a₀ the mean area of faces;  unit: length⁵
//   v̄ = x* plus a step that keeps the volume; x* is where E₀ + E₁ is least
//
// The cost is higher at thin parts. With a valence weight it is multiplied by a penalty (valence_term.hh).
//
// E₀ and E₁ have the planes of the faces as they are. A contraction changes those of the merged vertex and of its
// neighbours, and so the costs of all pairs at these. `PairDecimaterT` ranks these pairs again. OpenMesh's `DecimaterT`
// has a heap with one entry per vertex. It ranks only v0's former neighbours again; the other entries keep an old cost.
//
// The module refuses only collapses that cost more than `max_cost`. Add ModFlipGuardT beside it.
// \cite lindstrom_1998_fast (volume preservation), \cite hoppe_1999_attributes (memoryless quadrics)

namespace whittle {

/// `PlacingModuleT` says what the module does in which decimater, and has the options that all our cost modules share.
///
/// Border vertices remember the planes of all vertices merged into them, as with `ModGarlandHeckbertT`. If v̄ is
/// refused, `PairDecimaterT` tries x*. OpenMesh's own decimaters refuse the collapse.
template <class MeshT>
class ModMemorylessT : public QuadricModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModMemorylessT, MeshT, Memoryless);

  explicit ModMemorylessT(MeshT& mesh) : QuadricModuleT<MeshT>(mesh) {}

  /// Takes effect at the next `initialize()`.
  /// \throw std::invalid_argument if regularization or boundary_weight is negative or not finite, or weights aren't by
  ///        area
  void set_options(const QuadricOptions& options);

  /// \throw std::invalid_argument for a coordinate that is not finite
  void initialize() override;
  double cost_dimension() const override { return 5; }
  MeanFaceArea face_area() const override { return face_area_; }
  void postprocess_collapse(const CollapseInfo& collapse) override;

  Vec3 place(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second,
             const PairEvaluation& evaluation) const override;
  /// Higher at thin parts, and the more so the fewer faces are left.
  double final_cost(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second, const PairEvaluation& evaluation,
                    const Vec3& position) const override;
  /// Contractions that were no collapses may leave inner vertices that remember merged planes. Then the quadrics are
  /// computed again from the faces as they are.
  void adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses) override;

 private:
  using QuadricModule = QuadricModuleT<MeshT>;
  using QuadricModule::active;
  using QuadricModule::placed;
  using QuadricModule::surface;
  using typename QuadricModule::VertexHandle;

  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, PairConstraint constraint) const override;
  Reach plain_reach() const override { return Reach::ring; }
  CostOptions plain_options() const override { return {Cost::memoryless, active(), 0, 0}; }
  PlacedQuadric merge(VertexHandle first, VertexHandle second, const PairEvaluation& evaluation,
                      const Vec3& position) override;

  bool remembers(VertexHandle v) const { return surface().is_boundary(v); }
  bool forgets(VertexHandle first, VertexHandle second) const { return !remembers(first) && !remembers(second); }
  std::size_t count_faces() const;
  void measure_area();
  void find_ring(VertexHandle first, VertexHandle second, const Vec3& origin) const;
  void find_changes_around(VertexHandle first, VertexHandle second, const Vec3& position);
  void add_changes_at(VertexHandle v, VertexHandle other, const Vec3& position, PlaneChanges& found) const;
  PlaneChanges::Corner corner(VertexHandle v) const { return {static_cast<Index>(v.idx()), this->position(v)}; }

  // Scratch: the merged ring of the last pair.
  mutable MergedRing ring_;
  std::vector<PlaneChanges::Change> changes_;  ///< by the collapse under way, at neighbours that don't remember
  MeanFaceArea face_area_;                     ///< in the module's frame
  std::size_t n_faces_ = 0;                    ///< left now
};

template <class MeshT>
inline constexpr bool is_engine_cost<ModMemorylessT<MeshT>> = true;

}  // namespace whittle

#include "whittle/openmesh/mod_memoryless_impl.hh"
