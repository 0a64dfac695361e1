#pragma once

#include <optional>

#include "whittle/openmesh/detail/run_input.hh"

namespace whittle {

template <class MeshT>
class PairDecimaterT;

/// One call of `decimate` with the mesh driver: the engine's loop, in which OpenMesh's modules take part. The cost
/// module ranks and places; binary modules are guards. Each contraction of the engine is made on the mesh at once, so
/// that modules and observers see the mesh as it is.
template <class MeshT>
class MeshRunT final : private DecimationHost, private HostedCost {
 public:
  /// \param target with the limit of the cost module
  MeshRunT(PairDecimaterT<MeshT>& decimater, const DecimateTarget& target, bool only_selected);

  DecimateResult run();

 private:
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using Module = typename PairDecimaterT<MeshT>::Module;
  using CollapseInfo = typename PairDecimaterT<MeshT>::CollapseInfo;

  // DecimationHost
  bool keeps_topology() const override { return true; }
  bool refuses(const HostedContraction& contraction) override;
  void count_refusal() override;
  bool follow(const HostedContraction& made, const Contraction& contraction) override;
  HostedCost* cost() override { return this; }
  const DecimationState* state() const override { return &state_; }

  // HostedCost
  PairEvaluation rank(Index first, Index second, Pinned pinned) override;
  Settlement settle(Index first, Index second, Pinned pinned, const PairEvaluation& rank) override;
  double final_cost(const HostedContraction& contraction) override;
  Reach reach() const override;
  bool stays_at_vertices() const override;
  double dimension() const override;

  /// A collapse that a foreign cost ranks: v1 keeps its position.
  struct Collapse {
    double priority;
    Index survivor;
  };
  struct Collapses {
    std::array<Collapse, 2> legal;  ///< the cheaper one first
    std::size_t n = 0;
  };
  Collapses legal_collapses(Index first, Index second, Pinned pinned);
  std::optional<Collapse> legal_collapse(Index removed, Index survivor);

  DecimateOptions options() const;
  DecimationState initial_state() const;
  static std::vector<bool> vertices_with_copies(const MeshT& mesh);
  bool is_foreign() const;
  bool is_fixed(VertexHandle v) const;
  Vec3 position(Index v) const { return state_.vertices[v].position; }
  HalfedgeHandle halfedge(Index from, Index to) const {
    return mesh_.find_halfedge(input_.handle(from), input_.handle(to));
  }
  void collapse(const HostedContraction& made);

  PairDecimaterT<MeshT>& decimater_;
  MeshT& mesh_;
  DecimateTarget target_;
  bool only_selected_;
  std::vector<bool> has_copies_;  ///< by handle; empty if there are no copies
  RunInputT<MeshT> input_;
  DecimationState state_;  ///< positions as they are now
  std::uint64_t n_contractions_ = 0;
  Module* refusing_module_ = nullptr;  ///< the one that refused last; null if a vertex was locked
  Rejections rejections_;              ///< that the engine doesn't count
};

}  // namespace whittle

#include "whittle/openmesh/detail/mesh_run_impl.hh"
