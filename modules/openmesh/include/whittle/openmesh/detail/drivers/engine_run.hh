#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/engine/host.hh"
#include "whittle/openmesh/detail/attributes/vertex_properties.hh"
#include "whittle/openmesh/detail/bulk_collapse.hh"
#include "whittle/openmesh/detail/drivers/run_input.hh"
#include "whittle/openmesh/detail/face_relinker.hh"

namespace whittle {

template <class MeshT>
class PairDecimaterT;

/// The part of `EngineRunT` that needs no type of a mesh: its connectivity, and what vertices carry.
class EngineRun {
 protected:
  using VertexHandle = OpenMesh::VertexHandle;
  using Copy = FaceRelinker::Copy;

  template <class MeshT>
  EngineRun(MeshT& mesh, const DecimateTarget& target, const RunInput::IsFixed& is_fixed)
      : target_(target), input_(mesh, Copies::joined, is_fixed), connectivity_(mesh), attributes_(mesh) {}

  /// The limits less what rounding to a scalar may add. \param epsilon of the scalar
  DecimateTarget target_before_rounding(double epsilon) const;
  std::uint64_t n_vertices_of_input() const;

  /// Whether the contractions are legal collapses on the mesh as it is. \param firsts of copies (`first_copies`)
  bool are_collapses(const Decimation& small, const std::vector<Index>& firsts) const;
  /// Gives the mesh the connectivity of the result. \return the vertices of the result, as the mesh has them
  std::vector<Copy> collapse(const Decimation& small);
  std::vector<Copy> relink(const Decimation& small, const std::vector<Index>& firsts);
  /// What vertices carry, at the places where they are now. Without anything, an empty mesh.
  IndexedMesh vertex_attributes_of(const Decimation& small, unsigned threads) const;
  /// Of each handle, the vertex of the result.
  std::vector<Index> vertices_by_handle(const std::vector<Copy>& vertices) const;
  /// By handle, whether something was merged into the vertex. \param origins handles of the vertices' first copies
  std::vector<bool> merged_vertices(const std::vector<Copy>& vertices, const std::vector<Index>& origins) const;

  DecimateTarget target_;
  RunInput input_;
  std::vector<VertexMerge> merges_;  ///< by first copies
  OpenMesh::TriConnectivity& connectivity_;
  VertexProperties attributes_;
};

/// One call of `decimate` with the engine driver. It runs `whittle::decimate` on a copy of the geometry, in which
/// copies of a vertex are one. Then it makes the same contractions on the mesh, all at once. If the error is limited,
/// the engine takes contractions back; then it follows those that the engine tells at the end.
template <class MeshT>
class EngineRunT final : private EngineRun, private DecimationHost {
 public:
  /// \param target with the limit of the cost module
  EngineRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected);

  DecimateResult run();

 private:
  // DecimationHost
  bool may_refuse() const override { return false; }
  bool follow(const HostedContraction& made, const Contraction& contraction) override;
  const DecimationState* state() const override { return state_ ? &*state_ : nullptr; }

  std::optional<DecimationState> state_of_module() const;
  Decimation contract();
  Decimation contract_within_error(DecimateOptions options);
  bool notify_observer(std::uint64_t n_contractions);
  void note(const Contraction& contraction);

  void write_back(Decimation& small);
  void update_face_normals(const std::vector<bool>& is_merged);
  void hand_over_quadrics(const std::vector<Copy>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses);

  PairDecimaterT<MeshT>& decimater_;
  MeshT& mesh_;
  std::optional<DecimationState> state_;
  std::uint64_t n_notified_ = 0;  ///< contractions that the observer was told of last, if the error is limited
};

}  // namespace whittle

#include "whittle/openmesh/detail/drivers/engine_run_impl.hh"
