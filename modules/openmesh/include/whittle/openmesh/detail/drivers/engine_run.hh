#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "whittle/engine/decimate.hh"
#include "whittle/openmesh/detail/attributes/vertex_attributes.hh"
#include "whittle/openmesh/detail/bulk_collapse.hh"
#include "whittle/openmesh/detail/drivers/run_input.hh"
#include "whittle/openmesh/detail/face_relinker.hh"

namespace whittle {

template <class MeshT>
class PairDecimaterT;

/// One call of `decimate` with the engine driver. It runs `whittle::decimate` on a copy of the geometry, in which
/// copies of a vertex are one. Then it makes the same contractions on the mesh, all at once. If the error is limited,
/// the engine takes contractions back; then it follows those that the engine tells at the end.
template <class MeshT>
class EngineRunT final : private DecimationHost {
 public:
  /// \param target with the limit of the cost module
  EngineRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected);

  DecimateResult run();

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using Copy = typename FaceRelinkerT<MeshT>::Copy;
  struct Shape {
    std::size_t n_further_fans;  ///< fans beyond the first of each vertex
    std::ptrdiff_t euler_number;
    bool operator==(const Shape&) const = default;
  };

  // DecimationHost
  bool may_refuse() const override { return false; }
  bool follow(const HostedContraction& made, const Contraction& contraction) override;
  const DecimationState* state() const override { return state_ ? &*state_ : nullptr; }

  std::optional<DecimationState> state_of_module() const;
  Decimation contract();
  Decimation contract_within_error(DecimateOptions options);
  DecimateTarget target_before_rounding() const;
  bool notify_observer(std::uint64_t n_contractions);
  void note(const Contraction& contraction);
  static std::uint64_t count_vertices(const IndexedMesh& mesh);

  void write_back(Decimation& small);
  bool are_collapses(const Decimation& small) const;
  static Shape shape_of(const IndexedMesh& mesh);
  std::vector<Copy> relink(const Decimation& small);
  std::vector<Copy> collapse(const Decimation& small);
  void update_face_normals(const std::vector<Copy>& vertices, const std::vector<Index>& origins);
  void hand_over_quadrics(const std::vector<Copy>& vertices, std::vector<PlacedQuadric> quadrics, bool were_collapses);

  IndexedMesh vertex_attributes_of(const Decimation& small) const;

  PairDecimaterT<MeshT>& decimater_;
  MeshT& mesh_;
  DecimateTarget target_;
  RunInputT<MeshT> input_;
  std::optional<DecimationState> state_;
  std::vector<VertexMerge> merges_;  ///< by first copies
  std::uint64_t n_notified_ = 0;     ///< contractions that the observer was told of last, if the error is limited
  VertexAttributesT<MeshT> attributes_;
};

}  // namespace whittle

#include "whittle/openmesh/detail/drivers/engine_run_impl.hh"
