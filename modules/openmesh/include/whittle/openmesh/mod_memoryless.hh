#pragma once

#include <vector>

#include "whittle/engine/formula/merged_ring.hh"
#include "whittle/engine/formula/plane_changes.hh"
#include "whittle/openmesh/quadric_module.hh"

// Memoryless quadrics as a cost module for OpenMesh's decimaters: the engine's term (memoryless_term.hh), with the same
// numbers in every bit.
//
//   cost = E sqrt(W + 2 a₀), E the minimum of E₀ + E₁, W their weight, a₀ the mean area of faces;  unit: length⁵
//   v̄ = x*, where E is least, and a step that keeps the volume
//
// At thin parts the cost is more. With a valence weight it is multiplied by a penalty (valence_term.hh).
//
// E₀ and E₁ are of the planes of the faces as they are. A contraction changes those of the merged vertex and of its
// neighbours, and so the costs of all pairs at these. `PairDecimaterT` ranks them anew. OpenMesh's own decimaters rank
// anew the pairs at v0's former neighbours, in a heap with one entry a vertex; others keep the place of an old cost.
//
// Rejects what costs more than `max_cost`, nothing else: add ModFlipGuardT beside it.
// \cite lindstrom_1998_fast (volume preservation), \cite hoppe_1999_attributes (memoryless quadrics)

namespace whittle {

/// What it does in which decimater, and the options it shares with our other cost modules: `PlacingModuleT`.
///
/// Border vertices remember the planes of all they have merged, as with `ModGarlandHeckbertT`. Where v̄ is refused,
/// `PairDecimaterT` tries x*; OpenMesh's own decimaters refuse the collapse.
template <class MeshT>
class ModMemorylessT : public QuadricModuleT<MeshT> {
 public:
  DECIMATING_MODULE(ModMemorylessT, MeshT, Memoryless);

  explicit ModMemorylessT(MeshT& mesh) : QuadricModuleT<MeshT>(mesh) {}

  /// Used from the next `initialize()` on.
  /// \throw std::invalid_argument where regularization or boundary_weight is negative or not finite, or weights aren't
  ///        by area
  void set_options(const QuadricOptions& options);

  /// \throw std::invalid_argument for a coordinate that is not finite
  void initialize() override;
  double cost_dimension() const override { return 5; }
  MeanFaceArea face_area() const override { return face_area_; }
  void postprocess_collapse(const CollapseInfo& collapse) override;

  Vec3 place(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second,
             const PairEvaluation& evaluation) const override;
  /// More at thin parts, the more the fewer faces are left.
  double final_cost(OpenMesh::VertexHandle first, OpenMesh::VertexHandle second, const PairEvaluation& evaluation,
                    const Vec3& position) const override;
  /// Contractions that the mesh couldn't have made itself leave vertices inside that remember: from these on it goes by
  /// the faces as they are.
  void adopt(const std::vector<Index>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses) override;

 private:
  using QuadricModule = QuadricModuleT<MeshT>;
  using QuadricModule::active;
  using QuadricModule::placed;
  using QuadricModule::surface;
  using typename QuadricModule::VertexHandle;

  PairEvaluation evaluate_plain(VertexHandle first, VertexHandle second, Pinned pinned) const override;
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

  // The ring of the pair last looked at; scratch.
  mutable MergedRing ring_;
  std::vector<PlaneChanges::Change> changes_;  ///< at neighbours that don't remember, by the collapse under way
  MeanFaceArea face_area_;                     ///< in the module's frame
  std::size_t n_faces_ = 0;                    ///< left now
};

template <class MeshT>
inline constexpr bool is_engine_cost<ModMemorylessT<MeshT>> = true;

}  // namespace whittle

#include "whittle/openmesh/mod_memoryless_impl.hh"
